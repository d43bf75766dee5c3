// SPDX-License-Identifier: Apache-2.0
#include "render/passes/encode.hpp"

#include <gtest/gtest.h>

#include <fmt/core.h>
#include <array>

#include "shaders/sources.hpp"

namespace quadrat::render::passes {
namespace {

double srgb(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055; }

// What the cubic was fitted to: identity to 0.72, then a shoulder that leaves it without a corner and is flat at 1.44.
double shouldered(double linear) {
    const double from = 0.72;
    const double to = 1.44;
    if (linear <= from) return linear;
    if (linear >= to) return 1;
    const double power = (to - from) / (1 - from);
    return from + (1 - from) * (1 - std::pow(1 - (linear - from) / (to - from), power));
}

TEST(Encode, StaysWithinTwoHundredthsOfSrgbWithAShoulder) {
    double worst = 0;
    double sum = 0;
    const int steps = 15'000;
    for (int i = 0; i < steps; ++i) {
        const double linear = 1.5 * i / steps;
        const double ours = std::min(1.0, static_cast<double>(encode(static_cast<float>(linear))));
        const double error = std::abs(ours - srgb(shouldered(linear)));
        worst = std::max(worst, error);
        sum += error;
    }
    EXPECT_LT(worst, 0.021);
    EXPECT_LT(sum / steps, 0.0065);
}

TEST(Encode, NeverFallsAndEndsInWhite) {
    float before = encode(-1);
    EXPECT_EQ(before, 0);
    for (float linear = 0; linear < 3; linear += 0.001F) {
        EXPECT_GE(encode(linear), before);
        before = encode(linear);
    }
    EXPECT_GE(before, 1);
    EXPECT_LT(before, 1.02F);
}

TEST(Encode, IsTheSameCubicAsInTheShaders) {
    const std::string_view text = shaders::source("leaves.vert").text;
    for (const float coefficient : {1.007595F, 0.352583F, 0.406319F})
        EXPECT_NE(text.find(fmt::format("{:.6f}", coefficient)), std::string_view::npos) << coefficient;
}

}  // namespace
}  // namespace quadrat::render::passes
