// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdio>

#include "synthesis/lsystem/grammar.hpp"

namespace quadrat::synthesis::lsystem {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// One step's reading of a word.
class Rewriter {
  public:
    Rewriter(const Grammar& grammar, base::Seed seed) : grammar_(grammar), seed_(seed) {
        for (std::size_t i = 0; i < grammar.productions.size(); ++i) {
            const Production& p = grammar.productions[i];
            by_letter_[p.predecessor.letter].push_back(&p);
            sees_contexts_ = sees_contexts_ || !p.left.empty() || !p.right.empty();
        }
        grown_.resize(grammar.productions.size());
    }

    // False when next would outgrow the budget.
    bool step(const Word& word, Word& next, int number, std::size_t most) {
        word_ = &word;
        table_ =
            grammar_.schedule.empty() ? -1 : grammar_.schedule[number % static_cast<int>(grammar_.schedule.size())];
        if (sees_contexts_) match_brackets();
        std::fill(grown_.begin(), grown_.end(), 0);
        next.symbols.clear();
        next.values.clear();
        for (std::size_t i = 0; i < word.symbols.size(); ++i) {
            const std::vector<const Production*>& candidates = by_letter_[word.symbols[i].letter];
            const Production* chosen = nullptr;
            Chance chance(seed_, number, static_cast<std::int64_t>(i));
            if (!candidates.empty()) chosen = choose(candidates, i, chance);
            if (chosen == nullptr)
                copy(word.symbols[i], next);
            else
                rewrite(*chosen, next, chance);
            if (next.symbols.size() > most) return false;
        }
        return true;
    }

    // Of the last step: the production that made the most of it.
    const Production& most_prolific() const {
        const auto most = std::max_element(grown_.begin(), grown_.end()) - grown_.begin();
        return grammar_.productions[static_cast<std::size_t>(most)];
    }

  private:
    using Parameters = std::array<float, kMostParameters>;

    void copy(const Word::Symbol& symbol, Word& next) const {
        const auto first = static_cast<std::uint32_t>(next.values.size());
        for (std::uint32_t k = 0; k < symbol.arguments; ++k) next.values.push_back(word_->values[symbol.first + k]);
        next.symbols.push_back({symbol.letter, symbol.arguments, first});
    }

    void rewrite(const Production& production, Word& next, Chance& chance) {
        const std::span<const float> parameters(bound_.data(), kMostParameters);
        for (const Production::Module& module : production.successor) {
            const auto first = static_cast<std::uint32_t>(next.values.size());
            for (const Expression& argument : module.arguments)
                next.values.push_back(argument.evaluate(parameters, chance));
            next.symbols.push_back({module.letter, static_cast<std::uint8_t>(module.arguments.size()), first});
        }
        grown_[static_cast<std::size_t>(&production - grammar_.productions.data())] += production.successor.size();
    }

    const Production* choose(const std::vector<const Production*>& candidates, std::size_t at, Chance& chance) {
        const Production* chosen = nullptr;
        Parameters kept{};
        float total = 0;
        for (const Production* p : candidates) {
            if (p->table >= 0 && p->table != table_) continue;
            if (!matches(*p, at, chance)) continue;
            if (p->weight >= 1) return p;  // certain: bound_ holds its parameters
            // Each of the chance ones in turn takes its part of what has been seen so far.
            total += p->weight;
            if (chance.unit() * total < p->weight) {
                chosen = p;
                kept = bound_;
            }
        }
        // Weights that do not fill one leave the symbol as it is for the rest of the time.
        if (chosen != nullptr && total < 0.999F && chance.unit() > total) return nullptr;
        bound_ = kept;
        return chosen;
    }

    bool matches(const Production& p, std::size_t at, Chance& chance) {
        const Word::Symbol& self = word_->symbols[at];
        if (self.arguments != p.predecessor.arguments) return false;
        std::size_t bound = 0;
        for (const Production::Pattern& pattern : p.left) bound += pattern.arguments;
        std::size_t left_bound = bound;
        std::size_t here = at;
        for (std::size_t k = p.left.size(); k-- > 0;) {
            if (here != kNone) here = before(here);
            if (here == kNone && !is_outside(p.left[k])) return false;
            if (here != kNone && !fits(p.left[k], here)) return false;
            left_bound -= p.left[k].arguments;
            if (here != kNone) bind(here, left_bound, p.left[k].arguments);
        }
        bind(at, bound, self.arguments);
        bound += self.arguments;
        if (!p.right.empty() && !matches_right(p.right, at, bound)) return false;
        return p.condition.empty() || p.condition.evaluate(bound_, chance) != 0;
    }

    bool matches_right(const std::vector<Production::Pattern>& patterns, std::size_t at, std::size_t bound) {
        const auto& symbols = word_->symbols;
        std::size_t here = at + 1;
        bool has_ended = false;
        for (const Production::Pattern& pattern : patterns) {
            if (has_ended) {
                if (!is_outside(pattern)) return false;
                continue;
            }
            if (pattern.letter == ']') {  // the rest of this branch does not matter
                const std::size_t open = opening(here);
                if (open == kNone) return false;
                here = partner_[open] + 1;
                continue;
            }
            for (;; ++here) {
                has_ended = here >= symbols.size() || symbols[here].letter == ']';
                if (has_ended) break;
                const std::uint8_t letter = symbols[here].letter;
                if (letter == '[' && pattern.letter != '[') {
                    if (partner_[here] == kNone) return false;
                    here = partner_[here];
                    continue;
                }
                if (letter == '[' || !grammar_.ignored[letter]) break;
            }
            if (has_ended) {
                if (!is_outside(pattern)) return false;
                continue;
            }
            if (!fits(pattern, here)) return false;
            bind(here, bound, pattern.arguments);
            bound += pattern.arguments;
            ++here;
        }
        return true;
    }

    // What stands beyond an axis's ends, if the grammar says so.
    bool is_outside(const Production::Pattern& pattern) const {
        if (pattern.arguments > 0 || grammar_.outside == 0) return false;
        return pattern.letter == 0 || pattern.letter == grammar_.outside;
    }

    bool fits(const Production::Pattern& pattern, std::size_t at) const {
        const Word::Symbol& symbol = word_->symbols[at];
        // Any symbol, if it has the arguments that are named.
        if (pattern.letter == 0) return pattern.arguments == 0 || pattern.arguments == symbol.arguments;
        return pattern.letter == symbol.letter && pattern.arguments == symbol.arguments;
    }

    void bind(std::size_t at, std::size_t first, std::size_t count) {
        const Word::Symbol& symbol = word_->symbols[at];
        for (std::size_t k = 0; k < count && first + k < kMostParameters; ++k)
            bound_[first + k] = word_->values[symbol.first + k];
    }

    // The symbol this one grows from: across finished branches, out of its own.
    std::size_t before(std::size_t at) const {
        while (at-- > 0) {
            const std::uint8_t letter = word_->symbols[at].letter;
            if (letter == ']') {
                if (partner_[at] == kNone) return kNone;
                at = partner_[at];
            } else if (letter != '[' && !grammar_.ignored[letter]) {
                return at;
            }
        }
        return kNone;
    }

    // The bracket that this place lies in.
    std::size_t opening(std::size_t at) const {
        while (at-- > 0) {
            const std::uint8_t letter = word_->symbols[at].letter;
            if (letter == '[') return partner_[at] == kNone ? kNone : at;
            if (letter == ']' && partner_[at] != kNone) at = partner_[at];
        }
        return kNone;
    }

    void match_brackets() {
        partner_.assign(word_->symbols.size(), kNone);
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < word_->symbols.size(); ++i) {
            if (word_->symbols[i].letter == '[') open.push_back(i);
            if (word_->symbols[i].letter != ']' || open.empty()) continue;
            partner_[i] = open.back();
            partner_[open.back()] = i;
            open.pop_back();
        }
    }

    const Grammar& grammar_;
    base::Seed seed_;
    std::array<std::vector<const Production*>, 256> by_letter_;
    bool sees_contexts_ = false;
    const Word* word_ = nullptr;
    int table_ = -1;
    std::vector<std::size_t> partner_;
    std::vector<std::size_t> grown_;
    Parameters bound_{};
};

}  // namespace

void Word::add(char letter, std::initializer_list<float> arguments) {
    symbols.push_back({static_cast<std::uint8_t>(letter), static_cast<std::uint8_t>(arguments.size()),
                       static_cast<std::uint32_t>(values.size())});
    values.insert(values.end(), arguments);
}

std::string text_of(const Word& word) {
    std::string text;
    for (const Word::Symbol& symbol : word.symbols) {
        text += static_cast<char>(symbol.letter);
        for (std::uint32_t i = 0; i < symbol.arguments; ++i) {
            char digits[32];
            std::snprintf(digits, sizeof digits, "%c%.4g", i == 0 ? '(' : ',',
                          static_cast<double>(word.values[symbol.first + i]));
            text += digits;
        }
        if (symbol.arguments > 0) text += ')';
    }
    return text;
}

Derivation derive(const Grammar& grammar, const DeriveOptions& options) {
    Derivation result{grammar.axiom, 0, {}, 0};
    Rewriter rewriter(grammar, options.seed);
    Word next;
    const int steps = options.steps < 0 ? grammar.steps : options.steps;
    for (int step = 0; step < steps; ++step) {
        if (!rewriter.step(result.word, next, step, options.most_symbols)) {
            const Production& guilty = rewriter.most_prolific();
            result.stopped_by = guilty.text;
            result.stopped_by_line = guilty.line;
            break;
        }
        std::swap(result.word, next);
        result.steps = step + 1;
    }
    return result;
}

}  // namespace quadrat::synthesis::lsystem
