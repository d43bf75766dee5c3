// SPDX-License-Identifier: Apache-2.0
#include "kiosk/fleet/identity.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"

namespace quadrat::kiosk::fleet {
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

}  // namespace

std::string client_id(const fs::path& state, const fs::path& etc, const fs::path& sys) {
    constexpr std::uint64_t kOffset = 0xcbf29ce484222325;
    std::uint64_t hash = hashed(kOffset, contents_of(etc / "machine-id"));
    hash = hashed(hash, contents_of(sys / "firmware/devicetree/base/serial-number"));
    for (const std::string& address : card_addresses(sys)) hash = hashed(hash, address);
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(state, error);
    hash = hashed(hash, (error ? state : folder).string());
    return fmt::format("quadrat{:016x}", hash);
}

std::string password_in(const fs::path& file) {
    const std::string text = base::read_text(file, {1U << 12U, 1U << 12U});
    std::string password = text.substr(0, text.find('\n'));
    if (password.empty())
        throw base::InputError(
            fmt::format("fleet.password_file: the first line of {} is empty; write the password there", file.string()));
    return password;
}

}  // namespace quadrat::kiosk::fleet
