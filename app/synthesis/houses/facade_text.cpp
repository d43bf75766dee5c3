// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

#include "base/error.hpp"
#include "synthesis/houses/facade_rules.hpp"

namespace quadrat::synthesis::houses {

void refuse_at(const std::string& source, Place place, const std::string& what) {
    throw base::InputError(fmt::format("{}:{}:{}: {}", source, place.line, place.column, what));
}

namespace {

bool is_colour(const std::string& word) {
    return word.size() == 7 && word[0] == '#' &&
           std::all_of(word.begin() + 1, word.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

// A line's words, numbers and signs.
class Tokens {
  public:
    struct Token {
        std::string text;
        int column;
    };
    Tokens(std::string_view line, int number, std::string source) : line_(number), source_(std::move(source)) {
        for (std::size_t i = 0; i < line.size();) {
            const auto c = static_cast<unsigned char>(line[i]);
            if (std::isspace(c) != 0) {
                ++i;
                continue;
            }
            std::size_t end = i + 1;
            if (std::isalpha(c) != 0 || c == '#') {
                while (end < line.size() &&
                       (std::isalnum(static_cast<unsigned char>(line[end])) != 0 || line[end] == '_'))
                    ++end;
            } else if (std::isdigit(c) != 0 || c == '.') {
                while (end < line.size() &&
                       (std::isdigit(static_cast<unsigned char>(line[end])) != 0 || line[end] == '.'))
                    ++end;
            } else if (line.substr(i, 2) == "->" || line.substr(i, 2) == "<=" || line.substr(i, 2) == ">=") {
                ++end;
            }
            tokens_.push_back({std::string(line.substr(i, end - i)), static_cast<int>(i) + 1});
            i = end;
        }
        past_ = static_cast<int>(line.size()) + 1;
    }

    bool is_at_end() const { return at_ == tokens_.size(); }
    bool is_next(std::string_view text) const { return !is_at_end() && tokens_[at_].text == text; }
    bool take(std::string_view text) {
        if (!is_next(text)) return false;
        ++at_;
        return true;
    }
    Place place() const { return {line_, is_at_end() ? past_ : tokens_[at_].column}; }
    std::string next(const std::string& meant) {
        if (is_at_end()) refuse("the line ends where " + meant + " is meant");
        return tokens_[at_++].text;
    }
    void expect(std::string_view text) {
        if (!take(text)) refuse(fmt::format("{} is meant here", text));
    }
    std::string word(const std::string& meant) {
        const Place where = place();
        std::string text = next(meant);
        if (std::isalpha(static_cast<unsigned char>(text[0])) == 0)
            refuse_at(source_, where, meant + " is meant here, not " + text);
        return text;
    }
    void end() {
        if (!is_at_end()) refuse(fmt::format("nothing more is meant here, but there is {}", tokens_[at_].text));
    }
    [[noreturn]] void refuse(const std::string& what) const { refuse_at(source_, place(), what); }

    Expression expression() {
        Expression made;
        sum(made, 0);
        return made;
    }

  private:
    static constexpr int kDeepest = 64;
    void sum(Expression& into, int depth) {
        product(into, depth);
        while (is_next("+") || is_next("-")) operation(into, depth, &Tokens::product);
    }
    void product(Expression& into, int depth) {
        factor(into, depth);
        while (is_next("*") || is_next("/")) operation(into, depth, &Tokens::factor);
    }
    void operation(Expression& into, int depth, void (Tokens::*right)(Expression&, int)) {
        const Place where = place();
        const char sign = tokens_[at_++].text[0];
        (this->*right)(into, depth);
        into.parts.push_back({sign, 0, {}, where});
    }
    void factor(Expression& into, int depth) {
        if (depth > kDeepest) refuse("parentheses are nested too deep");
        const Place where = place();
        if (take("(")) {
            sum(into, depth + 1);
            expect(")");
            return;
        }
        if (take("-")) {
            factor(into, depth + 1);
            into.parts.push_back({'~', 0, {}, where});
            return;
        }
        const std::string text = next("a number");
        if (std::isalpha(static_cast<unsigned char>(text[0])) != 0) {
            into.parts.push_back({'v', 0, text, where});
            return;
        }
        double number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc{} || stop != text.data() + text.size())
            refuse_at(source_, where, fmt::format("a number is meant here, not {}", text));
        into.parts.push_back({'n', number, {}, where});
    }

    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int line_;
    int past_ = 1;
    std::string source_;
};

class Reader {
  public:
    explicit Reader(std::string source) { grammar_.source = std::move(source); }

    FacadeGrammar read(std::string_view text) {
        grammar_.rules = std::make_unique<FacadeGrammar::Rules>();
        int number = 0;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            line(text.substr(0, end), ++number);
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        check(number);
        return std::move(grammar_);
    }

  private:
    void line(std::string_view line, int number) {
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string_view::npos || line[first] == '#') return;
        if (line.substr(first, 5) == "name ") {
            grammar_.name = line.substr(first + 5);
            return;
        }
        Tokens tokens(line, number, grammar_.source);
        if (tokens.take("set")) {
            const std::string name = tokens.word("a name");
            tokens.expect("=");
            grammar_.rules->numbers.emplace_back(name, tokens.expression());
        } else if (tokens.take("choose")) {
            choice(tokens);
        } else {
            rule(tokens);
        }
        tokens.end();
    }

    void choice(Tokens& tokens) {
        Choice made;
        made.name = tokens.word("a name");
        tokens.expect("=");
        do {
            const std::string word = tokens.next("a word or a colour");
            const Place where = tokens.place();
            const Expression weight = tokens.expression();
            if (weight.parts.size() != 1 || weight.parts[0].kind != 'n' || !(weight.parts[0].number > 0))
                refuse_at(grammar_.source, where, "a weight is a number above 0");
            made.words.emplace_back(word, weight.parts[0].number);
        } while (tokens.take("|"));
        grammar_.rules->choices.push_back(std::move(made));
    }

    void rule(Tokens& tokens) {
        Rule made;
        made.place = tokens.place();
        made.symbol = tokens.word("a symbol, name, set or choose");
        if (tokens.take("when")) {
            do made.conditions.push_back(condition(tokens));
            while (tokens.take("and"));
        }
        tokens.expect("->");
        const Place where = tokens.place();
        const std::string what = tokens.word("what becomes of it");
        if (what == "split") {
            made.kind = Rule::Kind::Split;
            split(tokens, made);
        } else if (what == "repeat") {
            made.kind = Rule::Kind::Repeat;
            made.axis = axis(tokens);
            made.parts.push_back({tokens.expression(), false, symbol(tokens)});
            made.is_snapping = tokens.take("snap");
        } else if (what == "inset") {
            made.kind = Rule::Kind::Inset;
            for (int i = 0; i < 4; ++i) made.insets.push_back(tokens.expression());
            made.then = symbol(tokens);
        } else if (what == "free") {
            made.kind = Rule::Kind::Free;
            made.then = symbol(tokens);
            if (tokens.take("else")) made.otherwise = symbol(tokens);
        } else if (what == "panel") {
            made.kind = Rule::Kind::Panel;
            panel(tokens, made);
        } else if (what != "nothing") {
            refuse_at(grammar_.source, where,
                      fmt::format("{} is none of split, repeat, inset, free, panel, nothing", what));
        }
        grammar_.rules->rules.push_back(std::move(made));
    }

    Condition condition(Tokens& tokens) {
        Condition made;
        made.left = tokens.expression();
        const Place where = tokens.place();
        if (tokens.take("is")) {
            if (made.left.parts.size() != 1 || made.left.parts[0].kind != 'v')
                refuse_at(grammar_.source, where, "before is stands a choice's name");
            made.choice = made.left.parts[0].name;
            made.word = tokens.next("one of its words");
            return made;
        }
        made.comparison = tokens.next("a comparison");
        if (made.comparison != "<" && made.comparison != ">" && made.comparison != "<=" && made.comparison != ">=")
            refuse_at(grammar_.source, where, fmt::format("< > <= >= or is are meant here, not {}", made.comparison));
        made.right = tokens.expression();
        return made;
    }

    int axis(Tokens& tokens) {
        const Place where = tokens.place();
        const std::string name = tokens.word("x or y");
        if (name != "x" && name != "y")
            refuse_at(grammar_.source, where, fmt::format("x or y is meant here, not {}", name));
        return name == "x" ? 0 : 1;
    }

    std::string symbol(Tokens& tokens) {
        const Place where = tokens.place();
        std::string name = tokens.word("a symbol");
        used_.emplace_back(name, where);
        return name;
    }

    void split(Tokens& tokens, Rule& made) {
        made.axis = axis(tokens);
        made.is_marking = tokens.take("mark");
        do {
            SplitPart part;
            part.size = tokens.expression();
            part.is_relative = tokens.take("r");
            part.symbol = symbol(tokens);
            made.parts.push_back(std::move(part));
        } while (tokens.take(","));
    }

    void panel(Tokens& tokens, Rule& made) {
        const Place where = tokens.place();
        made.colour = tokens.next("a colour");
        colours_.emplace_back(made.colour, where);
        if (tokens.take("depth")) made.depth = tokens.expression();
        if (tokens.take("with")) made.then = symbol(tokens);
    }

    const Choice* choice_of(const std::string& name) const {
        for (const Choice& choice : grammar_.rules->choices)
            if (choice.name == name) return &choice;
        return nullptr;
    }

    void check_names(const Expression& expression, std::size_t numbers) const {
        for (const Expression::Part& part : expression.parts) {
            if (part.kind != 'v' || part.name == "width" || part.name == "height" || part.name == "front") continue;
            bool is_known = false;
            for (std::size_t i = 0; i < numbers; ++i)
                is_known = is_known || grammar_.rules->numbers[i].first == part.name;
            if (!is_known) refuse_at(grammar_.source, part.place, fmt::format("{} is set nowhere before", part.name));
        }
    }

    void check(int lines) const {
        const FacadeGrammar::Rules& rules = *grammar_.rules;
        std::set<std::string> known;
        for (const Rule& rule : rules.rules) known.insert(rule.symbol);
        for (const auto& [name, place] : used_)
            if (!known.contains(name))
                refuse_at(grammar_.source, place, fmt::format("no rule says what becomes of {}", name));
        if (!known.contains("Facade"))
            refuse_at(grammar_.source, {std::max(lines, 1), 1}, "no rule says what becomes of Facade");
        for (const auto& [colour, place] : colours_) {
            if (is_colour(colour)) continue;
            const Choice* choice = choice_of(colour);
            if (choice == nullptr)
                refuse_at(grammar_.source, place, fmt::format("{} is neither #rrggbb nor a choice", colour));
            for (const auto& [word, weight] : choice->words)
                if (!is_colour(word))
                    refuse_at(grammar_.source, place, fmt::format("{}, of {}, is no colour", word, colour));
        }
        for (std::size_t i = 0; i < rules.numbers.size(); ++i) check_names(rules.numbers[i].second, i);
        for (const Rule& rule : rules.rules) check_rule(rule);
    }

    void check_rule(const Rule& rule) const {
        const std::size_t all = grammar_.rules->numbers.size();
        for (const Condition& condition : rule.conditions) {
            if (condition.choice.empty()) {
                check_names(condition.left, all);
                check_names(condition.right, all);
            } else if (choice_of(condition.choice) == nullptr) {
                refuse_at(grammar_.source, condition.left.parts[0].place,
                          fmt::format("{} is no choice", condition.choice));
            }
        }
        for (const SplitPart& part : rule.parts) check_names(part.size, all);
        for (const Expression& inset : rule.insets) check_names(inset, all);
        check_names(rule.depth, all);
    }

    FacadeGrammar grammar_;
    std::vector<std::pair<std::string, Place>> used_;
    std::vector<std::pair<std::string, Place>> colours_;
};

}  // namespace

FacadeGrammar::FacadeGrammar() = default;
FacadeGrammar::~FacadeGrammar() = default;
FacadeGrammar::FacadeGrammar(FacadeGrammar&&) noexcept = default;
FacadeGrammar& FacadeGrammar::operator=(FacadeGrammar&&) noexcept = default;

FacadeGrammar read_facade(std::string_view text, std::string_view source) {
    return Reader(std::string(source)).read(text);
}

}  // namespace quadrat::synthesis::houses
