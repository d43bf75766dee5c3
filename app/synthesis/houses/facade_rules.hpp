// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <vector>

#include "synthesis/houses/facade.hpp"

// What a façade's text says, as data. Not for use from outside.
namespace quadrat::synthesis::houses {

struct Place {
    int line = 0;
    int column = 0;
};

// In postfix: a number, a name, or one of + - * / and ~, which negates.
struct Expression {
    struct Part {
        char kind = 'n';  // 'n' number, 'v' name, otherwise the operation
        double number = 0;
        std::string name;
        Place place;
    };
    std::vector<Part> parts;
};

struct Condition {
    std::string choice, word;  // choice is word; or, where choice is empty:
    Expression left, right;
    std::string comparison;
};

struct SplitPart {
    Expression size;
    bool is_relative = false;
    std::string symbol;
};

struct Rule {
    enum class Kind { Split, Repeat, Inset, Free, Panel, Nothing };
    std::string symbol;
    Place place;
    std::vector<Condition> conditions;
    Kind kind = Kind::Nothing;
    int axis = 0;
    bool is_marking = false;   // split
    bool is_snapping = false;  // repeat
    std::vector<SplitPart> parts;
    std::vector<Expression> insets;
    std::string colour;  // #rrggbb or a choice
    Expression depth;
    std::string then, otherwise;  // symbols, empty: none
};

struct Choice {
    std::string name;
    std::vector<std::pair<std::string, double>> words;  // and weights
};

struct FacadeGrammar::Rules {
    std::vector<std::pair<std::string, Expression>> numbers;
    std::vector<Choice> choices;
    std::vector<Rule> rules;
};

[[noreturn]] void refuse_at(const std::string& source, Place place, const std::string& what);

}  // namespace quadrat::synthesis::houses
