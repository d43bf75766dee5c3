// SPDX-License-Identifier: Apache-2.0
#include "base/markup.hpp"

#include <algorithm>
#include <cstddef>

#include "base/utf8.hpp"

namespace quadrat::base {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// XML 1.0, section 2.2: of the control characters only these three; and never U+FFFE and U+FFFF.
bool is_forbidden(std::string_view character) {
    const char c = character.front();
    if (character.size() == 1) return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r';
    return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

std::string_view entity_of(char c) {
    switch (c) {
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '&':
            return "&amp;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return {};
    }
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        text.remove_prefix(character.size());
        const std::string_view entity = entity_of(character.front());
        if (length == 0 || is_forbidden(character))
            safe += kReplacement;
        else
            safe += entity.empty() ? character : entity;
    }
    return safe;
}

}  // namespace quadrat::base
