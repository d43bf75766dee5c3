// SPDX-License-Identifier: Apache-2.0
// A limiter that looks ahead: the gain is the mean of the least gains of a window, so it has come down by the time the
// peak is heard, without a step.
#include "sound/levels.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::sound {
namespace {

constexpr float kRelease = 1.0F / (0.25F * static_cast<float>(kRate));
constexpr float kFadeDown = 1.0F / (0.03F * static_cast<float>(kRate));
constexpr float kFadeUp = 1.0F / (0.35F * static_cast<float>(kRate));

}  // namespace

Limiter::Limiter(float ceiling) : ceiling_(ceiling), sum_(kAhead) {
    wanted_.fill(1);
    least_.fill(1);
}

float Limiter::gain_for(float peak) {
    const float wanted = peak > ceiling_ ? ceiling_ / peak : 1.0F;
    released_ = std::min(wanted, released_ + (1.0F - released_) * kRelease);
    wanted_[at_] = released_;
    const float least = *std::ranges::min_element(wanted_);
    sum_ += static_cast<double>(least) - static_cast<double>(least_[at_]);
    least_[at_] = least;
    return static_cast<float>(sum_ / kAhead);
}

void Limiter::limit(Block block) {
    for (Frame& frame : block) {
        if (!std::isfinite(frame.left) || !std::isfinite(frame.right)) frame = {};
        const float gain = gain_for(std::max(std::abs(frame.left), std::abs(frame.right)));
        waiting_[at_] = frame;
        at_ = (at_ + 1) % kAhead;
        const Frame out = waiting_[at_] * gain;  // of all that is in the window, what has waited longest
        frame = {std::clamp(out.left, -ceiling_, ceiling_), std::clamp(out.right, -ceiling_, ceiling_)};
    }
}

float Fader::next(float wanted) {
    gain_ += (wanted - gain_) * (wanted < gain_ ? kFadeDown : kFadeUp);
    return gain_;
}

float decibels(float gain) { return gain > 0 ? std::max(-200.0F, 20.0F * std::log10(gain)) : -200.0F; }

}  // namespace quadrat::sound
