// SPDX-License-Identifier: Apache-2.0
#include "stage/marks.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::stage {
namespace {

constexpr glm::vec4 kDark{0.02F, 0.03F, 0.04F, 1};
constexpr glm::vec4 kWhite{1, 1, 1, 1};
constexpr float kLinesAHeight = 270;  // of a picture

render::Rect within(const render::Rect& place, float by_px) {
    const int by = static_cast<int>(std::lround(by_px));
    return {place.x + by, place.y + by, place.width - 2 * by, place.height - 2 * by};
}

// Two strokes that meet in each corner.
void add_brackets(render::Frame& frame, const render::Rect& place, float thick_px, float arm_px,
                  const glm::vec4& colour) {
    const int thick = static_cast<int>(std::lround(thick_px));
    const int arm = static_cast<int>(std::lround(arm_px));
    for (const bool is_right : {false, true})
        for (const bool is_top : {false, true}) {
            const int right = place.x + place.width;
            const int top = place.y + place.height;
            render::Sign stroke;
            stroke.colour = colour;
            stroke.place = {is_right ? right - arm : place.x, is_top ? top - thick : place.y, arm, thick};
            frame.signs.push_back(stroke);
            stroke.place = {is_right ? right - thick : place.x, is_top ? top - arm : place.y, thick, arm};
            frame.signs.push_back(stroke);
        }
}

}  // namespace

float mark_line_px(int height_px) { return static_cast<float>(height_px) / kLinesAHeight; }

render::Rect around(const render::Frame& frame, const render::Rect& place) {
    return within(place, static_cast<float>(-mark_reach_px(frame.size.y)));
}

int mark_reach_px(int height_px) { return static_cast<int>(std::lround(8 * mark_line_px(height_px))); }

void add_mark(render::Frame& frame, const render::Rect& place, const glm::vec3& colour, Corners corners,
              float corner_px) {
    const float line = mark_line_px(frame.size.y);
    const auto ring = [&](float from, float lines, const glm::vec4& of) {
        render::Sign sign;
        sign.place = within(place, from * line);
        sign.colour = of;
        sign.border_px = lines * line;
        sign.corner_radius_px = std::max(0.0F, corner_px - from * line);
        frame.signs.push_back(sign);
    };
    ring(0, 7, kDark);
    ring(1, 3, glm::vec4(colour, 1));
    ring(4, 2, kWhite);
    if (corners == Corners::Plain) return;
    const float arm = static_cast<float>(std::min(place.width, place.height)) / 7;
    add_brackets(frame, within(place, 6 * line), 5 * line, arm + line, kDark);
    add_brackets(frame, within(place, 6 * line), 4 * line, arm, kWhite);
}

}  // namespace quadrat::stage
