// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <optional>
#include <string_view>

namespace quadrat::firmware_io {

enum class Button { A, B, C, D, Back };
inline constexpr std::array kButtons{Button::A, Button::B, Button::C, Button::D, Button::Back};

std::string_view name_of(Button button);                    // "A", …, "Back"
std::optional<Button> button_named(std::string_view name);  // letter case does not matter

// A moment on the exhibit's monotonic clock: time since the program started. The kiosk hands the clock in.
using Instant = std::chrono::nanoseconds;

// A contact that closed, or opened again, after debouncing. A held button is one Down, later one Up.
enum class Motion { Down, Up };
struct ButtonEdge {
    Button button;
    Motion motion;
    Instant at;
    friend bool operator==(const ButtonEdge&, const ButtonEdge&) = default;
};

// What the exhibit hears: a Down, as one press.
struct ButtonPress {
    Button button;
    Instant at;
    friend bool operator==(const ButtonPress&, const ButtonPress&) = default;
};

}  // namespace quadrat::firmware_io
