// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/button_press.hpp"

#include <cstddef>

namespace quadrat::firmware_io {
namespace {

constexpr std::array<std::string_view, kButtons.size()> kNames{"A", "B", "C", "D", "Back"};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_same_word(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (lower(a[i]) != lower(b[i])) return false;
    return true;
}

}  // namespace

std::string_view name_of(Button button) { return kNames[static_cast<std::size_t>(button)]; }

std::optional<Button> button_named(std::string_view name) {
    for (const Button button : kButtons)
        if (is_same_word(name, name_of(button))) return button;
    return std::nullopt;
}

}  // namespace quadrat::firmware_io
