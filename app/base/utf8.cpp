// SPDX-License-Identifier: Apache-2.0
#include "base/utf8.hpp"

#include <cstdint>

namespace quadrat::base {
namespace {

// A first byte, what the second may be, and how many bytes there are.
struct Form {
    std::uint8_t first_low, first_high, second_low, second_high;
    std::size_t length;
};
constexpr Form kForms[] = {{0xC2, 0xDF, 0x80, 0xBF, 2}, {0xE0, 0xE0, 0xA0, 0xBF, 3}, {0xE1, 0xEC, 0x80, 0xBF, 3},
                           {0xED, 0xED, 0x80, 0x9F, 3}, {0xEE, 0xEF, 0x80, 0xBF, 3}, {0xF0, 0xF0, 0x90, 0xBF, 4},
                           {0xF1, 0xF3, 0x80, 0xBF, 4}, {0xF4, 0xF4, 0x80, 0x8F, 4}};

bool lies_in(std::uint8_t low, char c, std::uint8_t high) {
    const auto byte = static_cast<std::uint8_t>(c);
    return low <= byte && byte <= high;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    if (lies_in(0, text.front(), 0x7F)) return 1;
    for (const Form& form : kForms) {
        if (!lies_in(form.first_low, text.front(), form.first_high)) continue;
        if (text.size() < form.length || !lies_in(form.second_low, text[1], form.second_high)) return 0;
        for (std::size_t i = 2; i < form.length; ++i)
            if (!lies_in(0x80, text[i], 0xBF)) return 0;
        return form.length;
    }
    return 0;
}

}  // namespace quadrat::base
