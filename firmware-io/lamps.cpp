// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/lamps.hpp"

#include <cmath>
#include <numbers>

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;

constexpr Instant kBreath = 3s;
constexpr Instant kBreathLit = 2400ms;
constexpr Instant kBlink = 800ms;
constexpr float kDimmest = 0.15f;

// Where a moment lies within its period, [0, period), for moments before zero too.
Instant phase(Instant at, Instant period) { return (at % period + period) % period; }

}  // namespace

float lamp_brightness(LampPattern pattern, Instant at) {
    if (pattern != LampPattern::Breathing) return is_lamp_lit(pattern, at) ? 1.0f : 0.0f;
    const float turn = static_cast<float>(phase(at, kBreath).count()) / static_cast<float>(kBreath.count());
    const float swing = 0.5f + 0.5f * std::cos(2.0f * std::numbers::pi_v<float> * turn);
    return kDimmest + (1.0f - kDimmest) * swing;
}

bool is_lamp_lit(LampPattern pattern, Instant at) {
    switch (pattern) {
        case LampPattern::Off:
            return false;
        case LampPattern::Steady:
            return true;
        case LampPattern::Breathing:
            return phase(at, kBreath) < kBreathLit;
        case LampPattern::Blinking:
            return phase(at, kBlink) < kBlink / 2;
    }
    return false;
}

}  // namespace quadrat::firmware_io
