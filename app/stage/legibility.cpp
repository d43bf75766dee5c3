// SPDX-License-Identifier: Apache-2.0
#include "stage/legibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/lettering.hpp"

namespace quadrat::stage {
namespace {

constexpr std::array<float, 3> kQuestion_arcmin{12, 16, 20};
constexpr float kStatement = 1.2F;  // beside a question
constexpr float kBelow = 0.75F;
constexpr float kLabel = 10.0F / 12.0F;
constexpr int kSmallestBadge_px = 20;

}  // namespace

float capitals_arcmin(Letters letters, TextSize size) {
    const float question = kQuestion_arcmin[static_cast<std::size_t>(size)];
    switch (letters) {
        case Letters::Question:
            return question;
        case Letters::Statement:
            return kStatement * question;
        case Letters::Below:
            return kBelow * question;
        case Letters::Label:
            break;
    }
    return kLabel * question;
}

float em_px(Letters letters, TextSize size, int height_px) {
    const float px_per_arcmin = static_cast<float>(height_px) / kScreen_arcmin;
    return capitals_arcmin(letters, size) * px_per_arcmin / kCapitalOfEm;
}

int badge_px(TextSize size, int height_px) {
    const float side = em_px(Letters::Label, size, height_px) / render::kSmallestLetterOfBadge;
    return std::max(kSmallestBadge_px, static_cast<int>(std::lround(side)));
}

Look look_of(const site::Configuration::Look& look) {
    const TextSize size = look.size == "largest" ? TextSize::Largest
                          : look.size == "large" ? TextSize::Large
                                                 : TextSize::Normal;
    return {size, look.contrast == "high", look.motion == "calm"};
}

glm::vec4 plate_colour(const Look& look) {
    return look.has_high_contrast ? glm::vec4{0, 0, 0, 0.96F} : glm::vec4{0.05F, 0.06F, 0.07F, 0.72F};
}

}  // namespace quadrat::stage
