// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::synthesis::lsystem {

// Where an expression's chance comes from: the same numbers for the same symbol of the same step.
class Chance {
  public:
    Chance(base::Seed seed, std::int64_t step, std::int64_t symbol) : seed_(seed), step_(step), symbol_(symbol) {}
    float unit() { return base::unit_of(base::hash_of(seed_, step_, symbol_, draw_++)); }

  private:
    base::Seed seed_;
    std::int64_t step_;
    std::int64_t symbol_;
    std::int64_t draw_ = 0;
};

// Arithmetic over a production's parameters, compiled to a stack machine. Conditions give 1 or 0. A quotient by nothing
// and the root or logarithm of less than nothing give 0, so that no word ever holds what is not a number.
class Expression {
  public:
    enum class Op : std::uint8_t {
        Constant,
        Parameter,
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Negate,
        Not,
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Equal,
        NotEqual,
        And,
        Or,
        Sin,
        Cos,
        Tan,
        Sqrt,
        Abs,
        Floor,
        Exp,
        Log,
        Min,
        Max,
        Random
    };
    static constexpr int kDeepest = 32;  // of the stack

    void constant(float value);
    void parameter(std::uint8_t index);
    void apply(Op op);
    int deepest() const { return deepest_; }
    bool empty() const { return steps_.empty(); }

    float evaluate(std::span<const float> parameters, Chance& chance) const;

  private:
    struct Step {
        Op op;
        std::uint8_t index;
        float value;
    };
    float run(std::span<const float> parameters, Chance& chance) const;

    std::vector<Step> steps_;
    int depth_ = 0;
    int deepest_ = 0;
};

}  // namespace quadrat::synthesis::lsystem
