// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cstdlib>

#include "base/error.hpp"
#include "base/log.hpp"
#include "display/display.hpp"
#include "display/headless/headless_display.hpp"
#include "display/kms/kms_display.hpp"
#include "display/monotonic.hpp"
#include "display/options.hpp"
#include "display/window/window_display.hpp"

namespace quadrat::display {
namespace {

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value;
}

std::unique_ptr<Display> open_what_works(const DisplayOptions& options) {
    std::string why_not_kms;
    if (auto screen = open_kms_if_there_is_a_screen(options, why_not_kms)) return screen;
    std::string why_not_window = "neither DISPLAY nor WAYLAND_DISPLAY is set";
    if (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY")) {
        try {
            return open_window(options,
                               fmt::format("a window, because there is no screen of our own ({})", why_not_kms));
        } catch (const base::InputError& error) {
            why_not_window = error.what();
        }
    }
    return open_headless(
        options, fmt::format("headless, because there is no screen of our own ({}) and no desktop ({})", why_not_kms,
                             why_not_window));
}

std::unique_ptr<Display> open(const DisplayOptions& options) {
    switch (options.kind) {
        case Kind::Window:
            return open_window(options, "a window, as asked for");
        case Kind::Headless:
            return open_headless(options, "headless, as asked for");
        case Kind::Kms:
            return open_kms(options, "the screen itself, as asked for");
        case Kind::Auto:
            break;
    }
    return open_what_works(options);
}

}  // namespace

base::DisplayTime Display::now() const { return display_now(); }

std::unique_ptr<Display> open_display(const DisplayOptions& options) {
    check(options);
    auto display = open(options);
    base::log::info("display: {}; {}", display->why(), display->description());
    return display;
}

}  // namespace quadrat::display
