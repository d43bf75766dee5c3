// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/lsystem.hpp"

#include <cstdio>

namespace quadrat::synthesis::trees {

Word derive(const Grammar& grammar, int steps, std::size_t most_modules) {
    std::array<const Production*, 128> by_letter{};
    for (const Production& production : grammar.productions) {
        const auto slot = static_cast<std::size_t>(static_cast<unsigned char>(production.predecessor)) & 127U;
        if (by_letter[slot] == nullptr) by_letter[slot] = &production;
    }
    Word word = grammar.axiom;
    Word next;
    for (int step = 0; step < steps; ++step) {
        next.clear();
        next.reserve(word.size() * 3);
        for (const Module& m : word) {
            const Production* production = by_letter[static_cast<unsigned char>(m.letter) & 127U];
            if (production == nullptr)
                next.push_back(m);
            else
                production->successor(m, next);
            if (next.size() > most_modules) return word;
        }
        word.swap(next);
    }
    return word;
}

std::string text_of(std::span<const Module> word) {
    std::string text;
    for (const Module& m : word) {
        text += m.letter;
        for (int i = 0; i < m.arguments; ++i) {
            char digits[32];
            std::snprintf(digits, sizeof digits, "%c%.4g", i == 0 ? '(' : ',', static_cast<double>(m.values[i]));
            text += digits;
        }
        if (m.arguments > 0) text += ')';
    }
    return text;
}

}  // namespace quadrat::synthesis::trees
