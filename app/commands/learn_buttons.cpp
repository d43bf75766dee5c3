// SPDX-License-Identifier: Apache-2.0
#include "commands/learn_buttons.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "firmware-io/hid/hidraw.hpp"
#include "firmware-io/hid/teaching.hpp"
#include "firmware-io/input_spec.hpp"

namespace quadrat::commands {
namespace {

namespace hid = firmware_io::hid;

hid::HidSelector selector_of(const std::string& device) {
    try {
        const auto spec = firmware_io::parse_input_spec("hid:" + device);
        return std::get<firmware_io::HidSpec>(spec).selector;
    } catch (const std::invalid_argument& error) {
        throw base::InputError(fmt::format("--device {}", error.what()));
    }
}

namespace fs = std::filesystem;

// Before anybody presses anything: what was learned shall not be lost for want of a place.
void require_place(const fs::path& file) {
    const fs::path folder = fs::absolute(file).parent_path();
    std::error_code error;
    fs::create_directories(folder, error);
    if (::access(folder.c_str(), W_OK) != 0)
        throw base::InputError(
            fmt::format("{}: cannot be written; run this as root, or name a file with --map", folder.string()));
}

std::vector<hid::HidMapping> known_in(const fs::path& file) {
    if (!fs::exists(file)) return {};
    try {
        return hid::read_mappings(file);
    } catch (const std::invalid_argument& error) {
        throw base::InputError(error.what());
    }
}

enum class Line { Nothing, Enter, End };

// Waits a moment for a line; what else is on it means nothing.
Line wait_for_line() {
    constexpr int kMoment_ms = 20;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, kMoment_ms) <= 0) return Line::Nothing;
    char bytes[256];
    const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof bytes);
    return count > 0 ? Line::Enter : Line::End;
}

}  // namespace

void keep_mappings(const fs::path& file, std::span<const hid::HidMapping> mappings) {
    using enum fs::perms;
    base::write_file(file, hid::to_text(mappings));
    std::error_code ignored;  // it is somebody else's, who has seen to it
    fs::permissions(file, owner_read | owner_write | group_read | others_read, ignored);
}

int learn_buttons(const std::string& device, const fs::path& file) {
    std::vector<hid::HidMapping> mappings = known_in(file);
    hid::Hidraw host;
    hid::Teaching teaching(host, selector_of(device));
    if (!teaching.has_devices()) throw base::InputError(teaching.trouble());
    require_place(file);
    std::printf("Press and let go what is asked for. Enter: there is no such button. Ctrl+C: forget it all.\n");
    std::optional<firmware_io::Button> told;
    std::string trouble;
    bool has_input = true;
    while (const auto asked = teaching.asked()) {
        if (told != asked) std::printf("button %s?\n", std::string(name_of(*asked)).c_str());
        told = asked;
        if (teaching.trouble() != trouble) {
            trouble = teaching.trouble();
            if (!trouble.empty()) std::printf("  %s\n", trouble.c_str());
        }
        std::fflush(stdout);
        const Line line = has_input ? wait_for_line() : (::poll(nullptr, 0, 20), Line::Nothing);
        if (line == Line::Enter) teaching.skip();
        if (line == Line::End) has_input = false;
        teaching.poll();
    }
    const hid::HidMapping mapping = teaching.mapping();
    if (mapping.bindings.empty())
        throw base::InputError(teaching.trouble().empty() ? "nothing was pressed, so nothing was learned"
                                                          : teaching.trouble());
    hid::remember(mappings, mapping);
    keep_mappings(file, mappings);
    const std::string path = fs::absolute(file).lexically_normal().string();
    std::printf("%zu buttons of %s are kept in %s\nwrite in the configuration: inputs = [\"hid:map=%s\"]\n",
                mapping.bindings.size(), teaching.pupil()->identity.name.c_str(), path.c_str(), path.c_str());
    return 0;
}

}  // namespace quadrat::commands
