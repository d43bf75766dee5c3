// SPDX-License-Identifier: Apache-2.0
#include "synthesis/lsystem/expression.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrat::synthesis::lsystem {
namespace {

using Op = Expression::Op;

float finite(float value) { return std::isfinite(value) ? value : 0; }
float truth(bool is_so) { return is_so ? 1.0F : 0.0F; }

bool is_unary(Op op) {
    return op == Op::Negate || op == Op::Not || (op >= Op::Sin && op <= Op::Log) || op == Op::Random;
}

float of_one(Op op, float a, Chance& chance) {
    switch (op) {
        case Op::Negate:
            return -a;
        case Op::Not:
            return truth(a == 0);
        case Op::Sin:
            return std::sin(a);
        case Op::Cos:
            return std::cos(a);
        case Op::Tan:
            return std::tan(a);
        case Op::Sqrt:
            return std::sqrt(a);
        case Op::Abs:
            return std::abs(a);
        case Op::Floor:
            return std::floor(a);
        case Op::Exp:
            return std::exp(a);
        case Op::Log:
            return std::log(a);
        case Op::Random:
            return a * chance.unit();
        default:
            return a;
    }
}

float of_two(Op op, float a, float b) {
    switch (op) {
        case Op::Add:
            return a + b;
        case Op::Subtract:
            return a - b;
        case Op::Multiply:
            return a * b;
        case Op::Divide:
            return a / b;
        case Op::Power:
            return std::pow(a, b);
        case Op::Less:
            return truth(a < b);
        case Op::LessEqual:
            return truth(a <= b);
        case Op::Greater:
            return truth(a > b);
        case Op::GreaterEqual:
            return truth(a >= b);
        case Op::Equal:
            return truth(a == b);
        case Op::NotEqual:
            return truth(a != b);
        case Op::And:
            return truth(a != 0 && b != 0);
        case Op::Or:
            return truth(a != 0 || b != 0);
        case Op::Min:
            return std::min(a, b);
        case Op::Max:
            return std::max(a, b);
        default:
            return a;
    }
}

}  // namespace

void Expression::constant(float value) {
    steps_.push_back({Op::Constant, 0, finite(value)});
    deepest_ = std::max(deepest_, ++depth_);
}

void Expression::parameter(std::uint8_t index) {
    steps_.push_back({Op::Parameter, index, 0});
    deepest_ = std::max(deepest_, ++depth_);
}

void Expression::apply(Op op) {
    assert(depth_ >= (is_unary(op) ? 1 : 2));
    const bool is_constant = steps_.back().op == Op::Constant;
    if (is_unary(op)) {
        // What is known while reading is worked out then.
        if (op == Op::Negate && is_constant) {
            steps_.back().value = -steps_.back().value;
            return;
        }
        steps_.push_back({op, 0, 0});
        return;
    }
    --depth_;
    const std::size_t n = steps_.size();
    if (is_constant && steps_[n - 2].op == Op::Constant) {
        steps_[n - 2].value = finite(of_two(op, steps_[n - 2].value, steps_[n - 1].value));
        steps_.pop_back();
        return;
    }
    steps_.push_back({op, 0, 0});
}

float Expression::evaluate(std::span<const float> parameters, Chance& chance) const {
    // Nearly all expressions are a constant, a parameter, or one of two: no stack for them.
    const auto load = [&](const Step& s) { return s.op == Op::Constant ? s.value : parameters[s.index]; };
    if (steps_.size() == 1) return load(steps_[0]);
    if (steps_.size() == 3 && steps_[1].op <= Op::Parameter && steps_[2].op == Op::Multiply)
        return finite(load(steps_[0]) * load(steps_[1]));
    return run(parameters, chance);
}

float Expression::run(std::span<const float> parameters, Chance& chance) const {
    std::array<float, kDeepest + 1> stack{};
    std::size_t top = 0;  // entry 0 is never read
    for (const Step& s : steps_) {
        if (s.op == Op::Constant) {
            stack[++top] = s.value;
        } else if (s.op == Op::Parameter) {
            stack[++top] = parameters[s.index];
        } else if (is_unary(s.op)) {
            stack[top] = finite(of_one(s.op, stack[top], chance));
        } else {
            --top;
            stack[top] = finite(of_two(s.op, stack[top], stack[top + 1]));
        }
    }
    return stack[top];
}

}  // namespace quadrat::synthesis::lsystem
