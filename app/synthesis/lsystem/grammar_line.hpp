// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "synthesis/lsystem/expression.hpp"

// How a line of a grammar is read.
namespace quadrat::synthesis::lsystem::text {

using Op = Expression::Op;
inline constexpr int kDeepestNesting = 64;

inline bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c); }
inline bool is_symbol(char c) {
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

}  // namespace quadrat::synthesis::lsystem::text
