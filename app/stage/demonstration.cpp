// SPDX-License-Identifier: Apache-2.0
#include "stage/demonstration.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrat::stage {
namespace {

constexpr float kRestFirst_s = 8;
constexpr float kEvery_s = 40;
constexpr float kQuestion_s = 3.2F;  // is read, answered, and seen answered
constexpr float kShown_s = 3 * kQuestion_s;
constexpr float kFade_s = 0.8F;
constexpr std::array<std::size_t, 3> kPressed{1, 3, 0};  // as if it had a taste of its own

float smooth(float x) {
    const float t = std::clamp(x, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

}  // namespace

std::optional<Ghost> ghost_at(base::Instant since_attract) {
    const float since = std::chrono::duration<float>(since_attract).count() - kRestFirst_s;
    const float at = since < 0 ? kShown_s : std::fmod(since, kEvery_s);
    if (at >= kShown_s) return std::nullopt;
    const auto which = static_cast<std::size_t>(at / kQuestion_s);
    const float in_question = at - static_cast<float>(which) * kQuestion_s;
    const float down = smooth((in_question - 1.1F) / 0.5F), up = smooth((in_question - 2.0F) / 0.5F);
    const float strength = std::min(smooth(at / kFade_s), smooth((kShown_s - at) / kFade_s));
    return Ghost{genome::kAspects[which], kPressed[which], down - up, strength};
}

}  // namespace quadrat::stage
