// SPDX-License-Identifier: Apache-2.0
#include "fleet/identity.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"

namespace quadrat::fleet {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// FNV-1a of 64 bits, with a zero behind each text so that no two sequences run together.
std::uint64_t hashed(std::uint64_t hash, std::string_view text) {
    constexpr std::uint64_t kPrime = 0x100000001b3;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
    return hash * kPrime;
}

// Of cards that are devices, in order: bridges and tunnels come and go with other addresses.
std::set<std::string> card_addresses(const fs::path& sys) {
    std::set<std::string> found;
    std::error_code error, ignored;
    for (fs::directory_iterator entry{sys / "class/net", error}, end; !error && entry != end; entry.increment(error)) {
        const fs::path& card = entry->path();
        // 3 is "set by hand": such an address may be another the next time. A dongle on USB may be plugged in or not.
        const bool is_built_in = fs::exists(card / "device", ignored) &&
                                 fs::canonical(card / "device", ignored).string().find("/usb") == std::string::npos;
        if (is_built_in && !contents_of(card / "addr_assign_type").starts_with('3'))
            found.insert(contents_of(card / "address"));
    }
    return found;
}

// A folder by one path, whether it is there yet or not.
std::string in_one_spelling(const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::absolute(folder, error).lexically_normal();
    const fs::path bare = whole.has_filename() ? whole : whole.parent_path();
    const fs::path found = fs::weakly_canonical(bare, error);
    return (error ? bare : found).string();
}

std::string something_random() {
    std::random_device chance;
    return fmt::format("{:08x}{:08x}", chance(), chance());
}

}  // namespace

std::string client_id(const fs::path& state, const fs::path& etc, const fs::path& sys) {
    constexpr std::uint64_t kOffset = 0xcbf29ce484222325;
    const std::string machine = contents_of(etc / "machine-id");
    const std::string board = contents_of(sys / "firmware/devicetree/base/serial-number");
    const std::set<std::string> cards = card_addresses(sys);
    std::uint64_t hash = hashed(hashed(kOffset, machine), board);
    for (const std::string& address : cards) hash = hashed(hash, address);
    if (machine.empty() && board.empty() && cards.empty()) hash = hashed(hash, something_random());
    hash = hashed(hash, in_one_spelling(state));
    return fmt::format("quadrat{:016x}", hash);
}

std::string read_named(std::string_view key, const fs::path& file, std::size_t limit_bytes) {
    try {
        return base::read_file(file, limit_bytes);
    } catch (const base::InputError& error) {
        throw base::InputError(
            fmt::format("{}: {}; name a file that the user who publishes may read (quadrat, where it is a service)",
                        key, error.what()));
    }
}

std::string password_in(const fs::path& file) {
    constexpr std::size_t kLargest = 1U << 12U;
    const std::string text = base::text_from(read_named("fleet.password_file", file, kLargest),
                                             "fleet.password_file: " + file.string(), {kLargest, kLargest});
    std::string password = text.substr(0, text.find('\n'));
    if (password.empty())
        throw base::InputError(
            fmt::format("fleet.password_file: the first line of {} is empty; write the password there", file.string()));
    return password;
}

}  // namespace quadrat::fleet
