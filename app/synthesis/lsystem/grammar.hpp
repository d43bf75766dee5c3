// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bitset>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.hpp"
#include "synthesis/lsystem/expression.hpp"

// Lindenmayer systems in full: bracketed, stochastic, parametric with conditions, context-sensitive with an ignore
// list, and with tables (Prusinkiewicz & Lindenmayer, "The Algorithmic Beauty of Plants", 1990, chapter 1).
namespace quadrat::synthesis::lsystem {

// A word of modules, each a letter with numbers.
struct Word {
    struct Symbol {
        std::uint8_t letter = 0;
        std::uint8_t arguments = 0;
        std::uint32_t first = 0;  // of them in values
    };
    std::vector<Symbol> symbols;
    std::vector<float> values;

    void add(char letter, std::initializer_list<float> arguments = {});
};

std::string text_of(const Word& word);  // "!(10)F(1)[&(45)B(0.6,7.07)]…"

inline constexpr std::size_t kMostArguments = 8;    // of a module
inline constexpr std::size_t kMostParameters = 16;  // of a production: of its predecessor and contexts together

struct Production {
    struct Module {
        std::uint8_t letter = 0;
        std::vector<Expression> arguments;
    };
    struct Pattern {
        std::uint8_t letter = 0;  // 0: any
        std::uint8_t arguments = 0;
    };
    std::vector<Pattern> left;  // nearest last
    Pattern predecessor;
    std::vector<Pattern> right;  // nearest first; may hold brackets
    Expression condition;        // empty: always
    float weight = 1;            // against the other productions that match
    std::vector<Module> successor;
    int table = -1;  // -1: of every table
    int line = 0;    // of its grammar
    std::string text;
};

struct Grammar {
    std::string name;
    Word axiom;
    std::vector<Production> productions;  // among those without weights the first that matches counts
    std::bitset<256> ignored;             // letters that contexts do not see
    std::bitset<256> organs;              // letters that are leaves or flowers though productions change them
    std::uint8_t outside = 0;  // what contexts see beyond an axis's ends; 0: nothing, so that they do not match
    std::vector<std::string> tables;
    std::vector<int> schedule;  // which table each step uses, over and over
    int steps = 0;
    // For the turtle: what symbols without a number mean.
    float angle_deg = 90;
    float length = 1;
    float width = 1;
    float width_ratio = 0.707F;
    glm::vec3 tropism{0, -1, 0};
    float elasticity = 0;
};

// Reads a grammar. Throws InputError "SOURCE:LINE:COLUMN: what is wrong; what would be right".
//
//   # ABOP figure 1.25; a comment lasts to the end of its line
//   name: …         steps: 7        angle: 22.5     length: 1    width: 1    width ratio: 0.7
//   tropism: 0 -1 0 0.2             define: r = 0.9*0.8          ignore: + - F     outside: 0
//   organs: L K                      leaves and flowers as long as nothing has become of them; without it, letters that
//                                    have productions draw none
//   axiom: A(1,10)
//   A(l,w) : l > 0.1 -> !(w)F(l)[&(a)B(l*r,w)]/(137.5)A(l*r,w)
//   B(x) < C(y) > D(z)F -> E(x+y+z)                              contexts; * is any symbol
//   F -(0.33)-> F[+F]F                                           by chance
//   table: winter                                                the productions below belong to it
//   tables: summer summer winter                                 one a step, over and over
// A definition that is named in instead has the value given there: genes change a grammar's constants.
struct Redefinition {
    std::string_view name;
    float value;
};
Grammar read_grammar(std::string_view text, const std::string& source, std::span<const Redefinition> instead = {});

// Productions with a context that no word of this grammar can ever offer them: what they wait for is made by nothing,
// is ignored, or lies beyond an axis's ends where the grammar names no "outside".
std::vector<const Production*> contexts_in_vain(const Grammar& grammar);

struct DeriveOptions {
    int steps = -1;  // fewer than 0: the grammar's
    base::Seed seed{1};
    std::size_t most_symbols = 4U << 20U;
};

struct Derivation {
    Word word;
    int steps = 0;           // done
    std::string stopped_by;  // empty, or the production that would have outgrown the budget in the next step
    int stopped_by_line = 0;
};

Derivation derive(const Grammar& grammar, const DeriveOptions& options = {});

}  // namespace quadrat::synthesis::lsystem
