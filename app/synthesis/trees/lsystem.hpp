// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace quadrat::synthesis::trees {

// A parametric L-system: words of modules, each a letter with up to two numbers, rewritten all at once
// (Prusinkiewicz & Lindenmayer, "The Algorithmic Beauty of Plants", 1990, section 1.10).
struct Module {
    char letter = 0;
    int arguments = 0;
    std::array<float, 2> values{};

    friend bool operator==(const Module&, const Module&) = default;
};
using Word = std::vector<Module>;

inline Module module(char letter) { return {letter, 0, {}}; }
inline Module module(char letter, float a) { return {letter, 1, {a, 0}}; }
inline Module module(char letter, float a, float b) { return {letter, 2, {a, b}}; }

// What becomes of one module: appended to the new word.
struct Production {
    char predecessor = 0;
    std::function<void(const Module& self, Word& next)> successor;
};

struct Grammar {
    Word axiom;
    std::vector<Production> productions;  // the first for a letter counts; letters without one stay
};

// The word after so many steps. Stops before a step whose word would exceed most_modules: every plant has its budget.
Word derive(const Grammar& grammar, int steps, std::size_t most_modules = 1U << 20U);

std::string text_of(std::span<const Module> word);  // "!(10)F(1)[&(45)B(0.6,7.07)]…"

}  // namespace quadrat::synthesis::trees
