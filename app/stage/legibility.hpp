// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec4.hpp>

#include "site/configuration.hpp"

namespace quadrat::stage {

// How large letters are: the one place where that is decided, by what an eye needs. From three metres a screen of 24
// inches (16:9, 299 mm high) is 5.7 degrees high, 342 arcminutes. A normal eye (20/20) just reads capitals of 5
// arcminutes, one of half its acuity those of 10; ISO 9241-303 asks for 16 at least where one reads for long, and 20 to
// 22 for ease. Heights of capitals in arcminutes, from there:
//
//               question of four   statement over one   below it   labels, letters on the views
//     normal          12                  14.4              9                 10
//     large           16                  19.2             12                 13.3
//     largest         20                  24               15                 16.7
enum class TextSize { Normal, Large, Largest };
enum class Letters { Question, Statement, Below, Label };

inline constexpr float kScreen_arcmin = 342.4F;  // the height of a picture
inline constexpr float kCapitalOfEm = 0.7165F;   // in Lato; Noto Sans has 0.714

float capitals_arcmin(Letters letters, TextSize size);
// Of the em, on a picture of this height.
float em_px(Letters letters, TextSize size, int height_px);
// Each side of a badge, so that the letter in it, in the narrowest of the shapes, is as high as a label's.
int badge_px(TextSize size, int height_px);

// How the site wants to be looked at.
struct Look {
    TextSize size = TextSize::Normal;
    bool has_high_contrast = false;
    bool is_calm = false;  // cameras stand still, and what comes fades in
};
Look look_of(const site::Configuration::Look& look);

// What words stand on. Over the brightest picture, white on it has a contrast of 7:1 at least (WCAG 2.2, AAA); with
// high contrast 18:1.
glm::vec4 plate_colour(const Look& look);

}  // namespace quadrat::stage
