// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <utility>

#include "synthesis/lsystem/grammar.hpp"

namespace quadrat::synthesis::lsystem {
namespace {

using Pattern = Production::Pattern;
using Modules = std::set<std::pair<std::uint8_t, std::uint8_t>>;  // letter, arguments

bool is_bracket(const Pattern& pattern) { return pattern.letter == '[' || pattern.letter == ']'; }

// Whether a context may ever find what it asks for: among the modules there can be, or beyond an axis's ends.
bool can_be_found(const Grammar& grammar, const Modules& there, const Pattern& pattern) {
    if (is_bracket(pattern)) return true;
    const bool is_any = pattern.letter == 0;
    if (grammar.outside != 0 && pattern.arguments == 0 && (is_any || pattern.letter == grammar.outside)) return true;
    if (is_any) return true;
    return !grammar.ignored[pattern.letter] && there.count({pattern.letter, pattern.arguments}) > 0;
}

bool can_apply(const Grammar& grammar, const Modules& there, const Production& p) {
    const auto found = [&](const Pattern& pattern) { return can_be_found(grammar, there, pattern); };
    const bool is_there = p.predecessor.letter == 0 || there.count({p.predecessor.letter, p.predecessor.arguments}) > 0;
    return is_there && std::ranges::all_of(p.left, found) && std::ranges::all_of(p.right, found);
}

// All modules that a word of this grammar can hold, at the most.
Modules modules_of(const Grammar& grammar) {
    Modules there;
    for (const Word::Symbol& symbol : grammar.axiom.symbols) there.insert({symbol.letter, symbol.arguments});
    for (std::size_t before = 0; before != there.size();) {
        before = there.size();
        for (const Production& p : grammar.productions) {
            if (!can_apply(grammar, there, p)) continue;
            for (const Production::Module& module : p.successor)
                there.insert({module.letter, static_cast<std::uint8_t>(module.arguments.size())});
        }
    }
    return there;
}

}  // namespace

std::vector<const Production*> contexts_in_vain(const Grammar& grammar) {
    const Modules there = modules_of(grammar);
    std::vector<const Production*> vain;
    for (const Production& p : grammar.productions)
        if ((!p.left.empty() || !p.right.empty()) && !can_apply(grammar, there, p)) vain.push_back(&p);
    return vain;
}

}  // namespace quadrat::synthesis::lsystem
