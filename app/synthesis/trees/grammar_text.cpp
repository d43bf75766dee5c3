// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "synthesis/trees/grammar.hpp"

namespace quadrat::synthesis::trees {
namespace {

using Op = Expression::Op;

constexpr std::size_t kMostText = 1U << 20U;
constexpr std::size_t kMostProductions = 512;
constexpr int kDeepestNesting = 64;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c); }
bool is_symbol(char c) {
    return c > ' ' && c < 127 && c != '(' && c != ')' && c != ',' && c != '#' && c != '<' && c != '>' && c != ':';
}

// One line, read from left to right; errors know where they are.
class Line {
  public:
    Line(std::string_view text, int number, const std::string& source)
        : text_(text), number_(number), source_(source) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw base::InputError(fmt::format("{}:{}:{}: {}", source_, number_, at_ + 1, what));
    }
    void skip() {
        while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    }
    bool is_over() {
        skip();
        return at_ >= text_.size();
    }
    char peek() {
        skip();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool sees(std::string_view token) {
        skip();
        return text_.substr(at_).starts_with(token);
    }
    bool take(std::string_view token) {
        if (!sees(token)) return false;
        at_ += token.size();
        return true;
    }
    void expect(std::string_view token) {
        if (!take(token)) fail(fmt::format("{} where {} should stand", seen(), token));
    }
    std::string seen() {
        if (is_over()) return "the line's end stands";
        return fmt::format("'{}' stands", text_[at_]);
    }
    char symbol() {
        const char c = peek();
        if (!is_symbol(c))
            fail(seen() + " where a symbol should: a letter, a digit or one of + - & ^ \\ / | $ [ ] ! { } ' . ~");
        ++at_;
        return c;
    }
    std::string name() {
        skip();
        const std::size_t first = at_;
        while (at_ < text_.size() && is_name(text_[at_])) ++at_;
        if (first == at_) fail(seen() + " where a name should");
        return std::string(text_.substr(first, at_ - first));
    }
    float number() {
        skip();
        const char* first = text_.data() + at_;
        const bool is_plus = at_ < text_.size() && *first == '+';
        float value = 0;
        const auto [end, error] = std::from_chars(first + (is_plus ? 1 : 0), text_.data() + text_.size(), value);
        if (error != std::errc{} || !std::isfinite(value)) fail(seen() + " where a number should");
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }
    std::string_view rest() {
        skip();
        std::string_view left = text_.substr(at_);
        while (!left.empty() && is_space(left.back())) left.remove_suffix(1);
        return left;
    }
    void jump_to(std::size_t at) { at_ = at; }
    std::size_t at() const { return at_; }
    int number_of_line() const { return number_; }

  private:
    std::string_view text_;
    int number_;
    const std::string& source_;
    std::size_t at_ = 0;
};

using Names = std::map<std::string, std::uint8_t, std::less<>>;
using Constants = std::map<std::string, float, std::less<>>;

// Precedence climbing over the usual operators; ^ binds tightest and to the right.
class ExpressionReader {
  public:
    ExpressionReader(Line& line, const Names& parameters, const Constants& constants)
        : line_(line), parameters_(parameters), constants_(constants) {}

    Expression read() {
        either();
        if (made_.deepest() > Expression::kDeepest) line_.fail("this expression is nested too deeply");
        return std::move(made_);
    }

  private:
    void either() {
        deeper();
        both();
        while (line_.take("||")) {
            both();
            made_.apply(Op::Or);
        }
        --depth_;
    }
    void both() {
        comparison();
        while (line_.take("&&")) {
            comparison();
            made_.apply(Op::And);
        }
    }
    void comparison() {
        sum();
        static constexpr std::pair<std::string_view, Op> kSigns[] = {
            {"<=", Op::LessEqual}, {">=", Op::GreaterEqual}, {"==", Op::Equal}, {"!=", Op::NotEqual},
            {"<", Op::Less},       {">", Op::Greater},       {"=", Op::Equal}};
        for (const auto& sign : kSigns) {
            if (!line_.take(sign.first)) continue;
            sum();
            made_.apply(sign.second);
            return;
        }
    }
    void sum() {
        product();
        for (;;) {
            if (line_.sees("->") || line_.sees("-(")) {
                // In a condition this is the arrow; a difference with a bracket is written with a space.
                return;
            }
            if (line_.take("+")) {
                product();
                made_.apply(Op::Add);
            } else if (line_.take("-")) {
                product();
                made_.apply(Op::Subtract);
            } else {
                return;
            }
        }
    }
    void product() {
        power();
        for (;;) {
            if (line_.take("*")) {
                power();
                made_.apply(Op::Multiply);
            } else if (line_.take("/")) {
                power();
                made_.apply(Op::Divide);
            } else {
                return;
            }
        }
    }
    void power() {
        deeper();
        one();
        if (line_.take("^")) {
            power();
            made_.apply(Op::Power);
        }
        --depth_;
    }
    void one() {
        deeper();
        if (line_.take("-")) {
            one();
            made_.apply(Op::Negate);
        } else if (line_.sees("!") && !line_.sees("!=")) {
            line_.take("!");
            one();
            made_.apply(Op::Not);
        } else if (line_.take("(")) {
            either();
            line_.expect(")");
        } else if (is_digit(line_.peek()) || line_.peek() == '.') {
            made_.constant(line_.number());
        } else {
            word();
        }
        --depth_;
    }
    void word() {
        const std::size_t at = line_.at();
        const std::string name = line_.name();
        if (const auto found = parameters_.find(name); found != parameters_.end())
            return made_.parameter(found->second);
        if (const auto found = constants_.find(name); found != constants_.end()) return made_.constant(found->second);
        static const std::map<std::string, std::pair<Op, int>, std::less<>> kFunctions{
            {"sin", {Op::Sin, 1}},    {"cos", {Op::Cos, 1}},     {"tan", {Op::Tan, 1}}, {"sqrt", {Op::Sqrt, 1}},
            {"abs", {Op::Abs, 1}},    {"floor", {Op::Floor, 1}}, {"exp", {Op::Exp, 1}}, {"log", {Op::Log, 1}},
            {"ran", {Op::Random, 1}}, {"min", {Op::Min, 2}},     {"max", {Op::Max, 2}}};
        const auto function = kFunctions.find(name);
        if (function == kFunctions.end()) {
            line_.jump_to(at);
            line_.fail(
                fmt::format("{} is not a parameter of this production, nor defined before it, nor one of sin cos tan "
                            "sqrt abs floor exp log ran min max",
                            name));
        }
        line_.expect("(");
        either();
        if (function->second.second == 2) {
            line_.expect(",");
            either();
        }
        line_.expect(")");
        made_.apply(function->second.first);
    }
    void deeper() {
        if (++depth_ > kDeepestNesting) line_.fail("this expression is nested too deeply");
    }

    Line& line_;
    const Names& parameters_;
    const Constants& constants_;
    Expression made_;
    int depth_ = 0;
};

class GrammarReader {
  public:
    GrammarReader(const std::string& source, std::span<const Redefinition> instead)
        : source_(source), instead_(instead) {}

    Grammar read(std::string_view text) {
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
            for (int i = 0; i < 3; ++i) grammar_.tropism[i] = line.number();
            grammar_.elasticity = line.number();
        } else {
            line.jump_to(0);
            line.fail(fmt::format(
                "{}: is not known; there are name, axiom, steps, angle, length, width, width ratio, tropism, "
                "define, ignore, outside, table and tables",
                key));
        }
        if (!line.is_over()) line.fail(line.seen() + " after the value");
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

Grammar library_grammar(std::string_view name, std::span<const Redefinition> instead) {
    std::string known;
    for (const NamedGrammar& one : grammar_library()) {
        if (one.name == name) return read_grammar(one.text, std::string(name), instead);
        known += fmt::format("{}{}", known.empty() ? "" : ", ", one.name);
    }
    throw base::InputError(
        fmt::format("{}: no grammar of this name comes with the program; there are {}", name, known));
}

}  // namespace quadrat::synthesis::trees
