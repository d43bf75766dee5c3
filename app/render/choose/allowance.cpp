// SPDX-License-Identifier: Apache-2.0
// The one place that has a curve of alpha: D = alpha E^beta ("Genetic selection of parametric scenes" 2003, section
// 6.2), of which each kind of thing has its own D and beta.
#include "render/choose/allowance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrat::render::choose {
namespace {

constexpr float kLeastAlpha = 0.01F;

using A = Allowance;
using Of = AllowanceRow::Of;

// - A Raspberry Pi 4 draws the frame's triangles at alpha 1 in time. Where little is drawn, leaves need more than their
//   part of it to be leaves.
// - The ground's outline against the sky is missed before leaves are, and it is cheap. Its triangles grow all the same:
//   a software rasteriser shades squares of 16 pixels, whole ones along every edge. The ridge that closes a landscape
//   is seen before much of what is nearer: a peak that is lopped off, a tree over a summit that has sunk, and a shore
//   from which its water has drawn back are no picture any more, whatever the rest costs.
// - Fewer drops than a quarter draw the eye one by one. Of the stars the faintest go, from alpha 0.3 down.
// clang-format off
constexpr std::array kTable{
    //           entry                      name                       of               alpha 1  below   above   least  most
    AllowanceRow{&A::triangles,              "triangles",              Of::Frame,         240'000,  0.80F,  1.0F},
    AllowanceRow{&A::fewest_plant_triangles, "fewest plant triangles", Of::Frame,         140'000,  0.80F,  1.0F, 56'000},
    AllowanceRow{&A::land_triangles,         "land triangles",         Of::SharedByViews,  24'000,  0.75F,  1.0F, 20'000},
    AllowanceRow{&A::surround_triangles,     "surround triangles",     Of::SharedByViews,  24'000,  0.75F,  1.0F, 19'000},
    AllowanceRow{&A::land_error_px,          "land error",             Of::View,             2.4F, -0.80F, -0.5F, 0,     3.6F},
    AllowanceRow{&A::surround_error_px,      "surround error",         Of::View,             1.3F, -0.80F, -0.5F, 0,     3.0F},
    AllowanceRow{&A::stone_error_px,         "stone error",            Of::View,             1.2F, -0.50F, -0.5F},
    AllowanceRow{&A::grain,                  "grain",                  Of::View,                1,  0.50F,  0.0F},
    AllowanceRow{&A::house_fineness,         "houses",                 Of::View,                1,  0.50F,  0.5F},
    AllowanceRow{&A::plant_fineness,         "plants",                 Of::View,                1,  0.50F,  0.5F},
    AllowanceRow{&A::cover_whole,            "whole cover",            Of::View,                1,  0.50F,  0.5F, 0.56F, 1.5F},
    AllowanceRow{&A::cover_reach,            "reach of cover",         Of::View,                1,  0.30F,  0.0F, 0.70F},
    AllowanceRow{&A::water_nearness,         "water",                  Of::View,                1,  0.50F,  0.0F},
    AllowanceRow{&A::drops,                  "drops",                  Of::View,                1,  0.50F,  0.0F, 0.25F},
    AllowanceRow{&A::stars,                  "stars",                  Of::View,         1 / 0.3F,  1.00F,  0.0F, 0.15F, 1}};
// clang-format on
static_assert(kTable.size() == sizeof(Allowance) / sizeof(float), "each entry has its row");

}  // namespace

std::span<const AllowanceRow> allowance_table() { return kTable; }

Allowance allowance_of(const Detail& detail, std::size_t views) {
    const float alpha = std::max(detail.alpha, kLeastAlpha);
    Allowance allowance;
    for (const AllowanceRow& row : kTable) {
        const float whole = row.standard * std::pow(alpha, alpha < 1 ? row.power_below : row.power_above);
        const float sharers = row.of == Of::SharedByViews ? static_cast<float>(std::max<std::size_t>(views, 1)) : 1;
        allowance.*row.entry = std::clamp(whole, row.least, row.most) / sharers;
    }
    return allowance;
}

}  // namespace quadrat::render::choose
