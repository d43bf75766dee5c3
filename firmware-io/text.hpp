// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware-io/button_press.hpp"

// The small grammar that scripts, input specs and mappings share. Every function takes arbitrary bytes.
namespace quadrat::firmware_io {

// Cut at every separator; empty pieces are kept, so "a,,b" is three.
std::vector<std::string_view> split(std::string_view text, char separator);

// Cut at blanks and tabs; none of the words is empty.
std::vector<std::string_view> words_of(std::string_view line);

std::string_view trimmed(std::string_view text);

// The whole text as a number; nothing for anything else, and for more than 32 bits.
std::optional<std::uint32_t> parse_unsigned(std::string_view text, int base = 10);

// "80ms", "2.5s", "8us", "1.5min", "2h": at most 1000 hours; nothing for anything else.
std::optional<Instant> parse_duration(std::string_view text);

// Between quotation marks, fit for one line of an error: cut after 40 bytes, what is not printable ASCII as '?'.
std::string quoted(std::string_view text);

// What a device calls itself, as one word of a text file: anything but printable ASCII, and '#', becomes '_'.
std::string one_word(std::string_view text);

}  // namespace quadrat::firmware_io
