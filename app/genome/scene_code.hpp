// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "genome/recipe.hpp"

namespace quadrat::genome {

// A scene as one word that can be written down, typed, or shown as a QR code, and that any Quadrat can draw:
//
//     Q1-AEBAGBAFAYDQQ…        Q, its version, a hyphen, then base 32 (RFC 4648, without padding; case does not matter)
//
// In the base 32: each parameter in so many bits of its range, in the order of the version's layout
// (genome/code_layouts); the seeds of trees, land, sky and flight; a CRC-32 of all before it. So a real number comes
// back within half a 255th of its range, kinds and counts exactly. A version's layout is never changed: a program that
// knows more parameters gives them their defaults, and leaves out what it no longer has. Nothing else is in it.
std::string code_of(const Recipe& recipe);

// What comes back of these. Rounding them is not seen, but a view that is searched for in a landscape may turn out
// another for it: what a code is shown for grows from these, so that it draws exactly that.
ParameterValues rounded_for_code(const ParameterValues& values);

// Whether the text ends in what has the form of a code: the code alone, or an address with one behind it.
bool has_code(std::string_view text);

// The scene of such a text. Throws InputError naming source, what is wrong and what would be right: no code, a version
// that this program does not know, a letter too many, too few or another (the checksum).
Recipe recipe_of_code(std::string_view text, std::string_view source);
Candidate candidate_of_code(std::string_view text, std::string_view source);  // the same, to grow

// One row of a layout.
struct CodeField {
    std::string name;
    float min;
    float max;
    int bits;       // 1 to 16
    bool is_whole;  // min + k; else min + (max - min) k / (2^bits - 1)
    friend bool operator==(const CodeField&, const CodeField&) = default;
};
using CodeLayout = std::vector<CodeField>;

// By version, from 1 on; the last one is written. What the parameter table would be as a layout, to compare it with.
const std::vector<CodeLayout>& code_layouts();
CodeLayout layout_of_the_table();
std::string to_text(const CodeLayout& layout);
CodeLayout layout_from(std::string_view text);

// The same with layouts of one's own.
std::string code_of(const Recipe& recipe, const std::vector<CodeLayout>& layouts);
Recipe recipe_of_code(std::string_view text, std::string_view source, const std::vector<CodeLayout>& layouts);

}  // namespace quadrat::genome
