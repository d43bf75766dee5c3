// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "synthesis/lsystem/grammar.hpp"
#include "synthesis/lsystem/grammar_line.hpp"

namespace quadrat::synthesis::lsystem {
namespace {

using text::Constants;
using text::ExpressionReader;
using text::is_digit;
using text::Line;
using text::Names;

constexpr std::size_t kMostText = 1U << 20U;
constexpr std::size_t kMostProductions = 512;

class GrammarReader {
  public:
    GrammarReader(const std::string& source, std::span<const Redefinition> instead)
        : source_(source), instead_(instead) {}

    Grammar read(std::string_view whole) {
        std::string_view text = whole;
        if (text.size() > kMostText) throw base::InputError(source_ + ": a grammar longer than 1 MB");
        int number = 0;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            line = line.substr(0, std::min(line.find('#'), line.size()));
            read_line(Line(line, ++number, source_));
        }
        if (!has_axiom_)
            throw base::InputError(fmt::format("{}:{}:1: no axiom; write axiom: and a word", source_, number));
        for (const auto& [name, place] : wanted_tables_) {
            const auto found = std::ranges::find(grammar_.tables, name);
            if (found == grammar_.tables.end())
                throw base::InputError(
                    fmt::format("{}:{}:{}: no production belongs to a table {}; write table: {} above them", source_,
                                place.first, place.second, name, name));
            grammar_.schedule.push_back(static_cast<int>(found - grammar_.tables.begin()));
        }
        return std::move(grammar_);
    }

  private:
    void read_line(Line line) {
        if (line.is_over()) return;
        const std::string_view text = line.rest();
        std::size_t letters = 0;
        while (letters < text.size() && ((text[letters] >= 'a' && text[letters] <= 'z') || text[letters] == ' '))
            ++letters;
        if (letters >= 4 && letters < text.size() && text[letters] == ':') {
            const std::string key(text.substr(0, letters));
            line.take(key);
            line.expect(":");
            return directive(key, line);
        }
        production(line);
    }

    void directive(const std::string& key, Line& line) {
        if (key == "name") {
            grammar_.name = std::string(line.rest());
            return;
        }
        if (key == "axiom") return axiom(line);
        if (key == "define") return define(line);
        if (key == "table") return table(line);
        if (key == "tables") {
            while (!line.is_over()) {
                const int column = static_cast<int>(line.at()) + 1;
                wanted_tables_.push_back({line.name(), {line.number_of_line(), column}});
            }
            return;
        }
        if (key == "ignore") {
            while (!line.is_over()) grammar_.ignored.set(static_cast<std::uint8_t>(line.symbol()));
            return;
        }
        if (key == "organs") {
            while (!line.is_over()) grammar_.organs.set(organ(line));
            return;
        }
        if (key == "outside") {
            grammar_.outside = static_cast<std::uint8_t>(line.symbol());
        } else if (key == "steps") {
            const float steps = line.number();
            if (steps < 0 || steps > 10'000 || steps != std::floor(steps))
                line.fail("steps are a whole number, 0 to 10000");
            grammar_.steps = static_cast<int>(steps);
        } else if (key == "angle") {
            grammar_.angle_deg = line.number();
        } else if (key == "length") {
            grammar_.length = line.number();
        } else if (key == "width") {
            grammar_.width = line.number();
        } else if (key == "width ratio") {
            grammar_.width_ratio = line.number();
        } else if (key == "tropism") {
            constexpr float kMost = 1.0e3F;
            for (int i = 0; i < 4; ++i) {
                const float number = line.number();
                if (std::abs(number) > kMost) line.fail("a tropism's numbers are -1000 to 1000");
                (i < 3 ? grammar_.tropism[i] : grammar_.elasticity) = number;
            }
        } else {
            line.jump_to(0);
            line.fail(fmt::format(
                "{}: is not known; there are name, axiom, steps, angle, length, width, width ratio, tropism, "
                "define, ignore, organs, outside, table and tables",
                key));
        }
        if (!line.is_over()) line.fail(line.seen() + " after the value");
    }

    std::uint8_t organ(Line& line) {
        const char letter = line.symbol();
        if (letter != 'L' && letter != '~' && letter != 'K')
            line.fail(fmt::format("{} is no organ; L and ~ are leaves, K is a flower", letter));
        return static_cast<std::uint8_t>(letter);
    }

    void axiom(Line& line) {
        if (has_axiom_) line.fail("a second axiom");
        has_axiom_ = true;
        Chance chance(base::Seed{0}, 0, 0);
        for (const Production::Module& module : modules(line, {})) {
            std::vector<float> values;
            for (const Expression& e : module.arguments) values.push_back(e.evaluate({}, chance));
            grammar_.axiom.symbols.push_back({module.letter, static_cast<std::uint8_t>(values.size()),
                                              static_cast<std::uint32_t>(grammar_.axiom.values.size())});
            grammar_.axiom.values.insert(grammar_.axiom.values.end(), values.begin(), values.end());
        }
    }

    void define(Line& line) {
        const std::string name = line.name();
        if (is_digit(name.front())) line.fail("a name does not begin with a digit");
        line.expect("=");
        Chance chance(base::Seed{0}, 0, 0);
        constants_[name] = ExpressionReader(line, {}, constants_).read().evaluate({}, chance);
        if (!line.is_over()) line.fail(line.seen() + " after the value");
        for (const Redefinition& other : instead_)
            if (other.name == name) constants_[name] = other.value;
    }

    void table(Line& line) {
        const std::string name = line.name();
        const auto found = std::ranges::find(grammar_.tables, name);
        table_ = static_cast<int>(found - grammar_.tables.begin());
        if (found == grammar_.tables.end()) grammar_.tables.push_back(name);
    }

    // A module as it is matched: its letter and the names of its numbers.
    Production::Pattern pattern(Line& line, Names& names) {
        Production::Pattern p;
        const char letter = line.symbol();
        p.letter = letter == '*' ? 0 : static_cast<std::uint8_t>(letter);
        if (!line.take("(")) return p;
        do {
            const std::string name = line.name();
            if (is_digit(name.front())) line.fail("a parameter's name does not begin with a digit");
            if (names.contains(name)) line.fail(fmt::format("a second parameter {}", name));
            if (p.arguments >= kMostArguments || names.size() >= kMostParameters) line.fail("too many parameters");
            names.emplace(name, static_cast<std::uint8_t>(names.size()));
            ++p.arguments;
        } while (line.take(","));
        line.expect(")");
        return p;
    }

    static bool is_at_arrow(Line& line) { return line.sees("->") || line.sees("-("); }

    void production(Line& line) {
        Production made;
        made.line = line.number_of_line();
        made.table = table_;
        made.text = std::string(line.rest());
        Names names;
        std::vector<Production::Pattern> read{pattern(line, names)};
        while (!is_at_arrow(line) && line.peek() != '<' && line.peek() != '>' && line.peek() != ':' && !line.is_over())
            read.push_back(pattern(line, names));
        if (line.take("<")) {
            made.left = std::move(read);
            read = {pattern(line, names)};
        }
        if (read.size() != 1) line.fail(line.seen() + " where -> should: a production replaces one symbol");
        made.predecessor = read.front();
        if (made.predecessor.letter == 0)
            line.fail("* stands for any symbol of a context, not for the one that is replaced");
        for (const Production::Pattern& p : made.left)
            if (p.letter == '[' || p.letter == ']') line.fail("brackets have no place in a left context");
        if (line.take(">"))
            while (!is_at_arrow(line) && line.peek() != ':' && !line.is_over())
                made.right.push_back(pattern(line, names));
        if (line.take(":") && !line.take("*")) made.condition = ExpressionReader(line, names, constants_).read();
        if (line.take("-(")) {
            made.weight = ExpressionReader(line, {}, constants_).read().evaluate({}, certain_);
            if (made.weight <= 0 || made.weight > 1) line.fail("a chance is more than 0 and at most 1");
            line.expect(")");
        }
        line.expect("->");
        made.successor = modules(line, names);
        if (grammar_.productions.size() >= kMostProductions) line.fail("too many productions");
        grammar_.productions.push_back(std::move(made));
    }

    std::vector<Production::Module> modules(Line& line, const Names& names) {
        std::vector<Production::Module> made;
        int open = 0;
        while (!line.is_over()) {
            Production::Module module;
            const char letter = line.symbol();
            if (letter == '[') ++open;
            if (letter == ']' && --open < 0) line.fail("a ] without its [");
            module.letter = static_cast<std::uint8_t>(letter);
            if (line.take("(")) {
                do {
                    if (module.arguments.size() >= kMostArguments) line.fail("too many numbers for one symbol");
                    module.arguments.push_back(ExpressionReader(line, names, constants_).read());
                } while (line.take(","));
                line.expect(")");
            }
            made.push_back(std::move(module));
        }
        if (open > 0) line.fail("a [ without its ]");
        return made;
    }

    const std::string& source_;
    std::span<const Redefinition> instead_;
    Grammar grammar_;
    Constants constants_;
    int table_ = -1;
    bool has_axiom_ = false;
    std::vector<std::pair<std::string, std::pair<int, int>>> wanted_tables_;
    Chance certain_{base::Seed{0}, 0, 0};
};

}  // namespace

Grammar read_grammar(std::string_view text, const std::string& source, std::span<const Redefinition> instead) {
    return GrammarReader(source, instead).read(text);
}

}  // namespace quadrat::synthesis::lsystem
