// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/seed.hpp"

namespace quadrat::genome {

// JSON from outside, and what we write of it, in one place: strict, bounded, and exact in its numbers.

inline constexpr std::size_t kDeepestJson = 16;  // objects and lists within one another

// Throws InputError "SOURCE:LINE: …" for text that is not JSON, and "SOURCE: …" for an object that names a key twice,
// for nesting deeper than kDeepestJson, and for numbers no double can hold. Never throws anything else.
nlohmann::json parse_json(std::string_view text, std::string_view source);

// The value as it may stand in a one-line message: short, printable ASCII.
std::string brief(const nlohmann::json& value);

// Throws InputError naming source and the place when the value is not an object, or holds a key that is not among
// known.
void require_object(const nlohmann::json& value, std::initializer_list<std::string_view> known, std::string_view source,
                    std::string_view place);

// The member of an object. Throws InputError when it is missing.
const nlohmann::json& member(const nlohmann::json& object, std::string_view key, std::string_view source);

// The fewest digits that give the same number back. A float keeps its own digits: 41.2, not 41.20000076293945.
std::string shortest(float value);
std::string shortest(double value);

std::string text_of(base::Seed seed);                      // 16 hexadecimal digits
std::optional<base::Seed> seed_of(std::string_view text);  // nothing when it is not 16 hexadecimal digits

}  // namespace quadrat::genome
