// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

// The one reader of text from outside: settings, scripts of buttons, grammars, scenes, words, heights, passwords.
namespace quadrat::base {

struct TextLimits {
    std::size_t bytes = 64U << 20U;
    std::size_t line_bytes = 64U << 10U;
};

// JSON may stand on one line.
inline constexpr TextLimits kJsonLimits{64U << 20U, 64U << 20U};

// Why these bytes are no UTF-8, with the remedy, where they are UTF-16 (with its mark or without) or UTF-32; else "".
std::string trouble_of_encoding(std::string_view bytes);

// These bytes as text: UTF-8, lines that end with '\n' alone. Takes what editors do to a file: a byte order mark, CRLF,
// and CR alone where there is no other line end. Throws InputError "SOURCE: …" or "SOURCE:LINE: …", with the remedy,
// for UTF-16 and UTF-32, for a NUL byte, for what is no UTF-8, for a line and for a whole that is too long.
std::string text_from(std::string bytes, std::string_view source, const TextLimits& limits = {});

// The same of a file. Throws InputError, too, where it cannot be read or is none.
std::string read_text(const std::filesystem::path& path, const TextLimits& limits = {});

}  // namespace quadrat::base
