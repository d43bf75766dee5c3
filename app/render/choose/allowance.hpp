// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

// What of a scene a view shows, and how finely: what is in sight and not hidden, which level of each thing, and what
// the GPU is told of each thing that is chosen. Numbers and nouns alone, and no OpenGL: what speaks it (render/gl,
// render/passes and render itself) asks here, and may not be asked.
namespace quadrat::render::choose {

// How finely to draw. alpha is the one knob of speed against quality (D = alpha E^beta, "Genetic selection of
// parametric scenes" 2003, section 6.2): 1 is the standard, 0.25 coarse, 4 as fine as there is.
struct Detail {
    float alpha = 1;
    float scale = 1;  // of each side of the views, 0.25 to 1, drawn smaller and spread; signs stay sharp
    int samples = 1;  // a pixel, 1 or 4: edges are smooth. Not where views are drawn smaller, nor where a GPU has none
};

// How much of each kind of thing a frame may draw, and how closely. What is an error falls as alpha rises; all else
// rises or stays.
struct Allowance {
    // Of all views together.
    float triangles = 0;               // but for plants, of which there may be as many as the next says
    float fewest_plant_triangles = 0;  // whatever all else takes: crowns are whole

    // Of each view.
    float land_triangles = 0;
    float surround_triangles = 0;
    float land_error_px = 0;  // how far off what is drawn may lie
    float surround_error_px = 0;
    float stone_error_px = 0;
    float grain = 0;  // how far the land's grain is seen, to the usual
    float house_fineness = 0;
    float plant_fineness = 0;  // asked for; the triangles limit it where there is much to see
    float cover_whole = 0;     // how far tufts have all their blades, to the usual
    float cover_reach = 0;     // how far they go, to all the way
    float water_nearness = 0;  // its levels are chosen as if it looked so many times as large
    float drops = 0;           // of those that fall, the share
    float stars = 0;           // of those that shine, the share
    friend bool operator==(const Allowance&, const Allowance&) = default;
};

// One entry's curve: standard * alpha^power, between least and most.
struct AllowanceRow {
    float Allowance::*entry;
    std::string_view name;
    enum class Of { Frame, View, SharedByViews } of;  // the last: the views share it out among them
    float standard;                                   // at alpha 1
    float power_below;                                // of alpha, below 1
    float power_above;
    float least = 0;  // of the frame, where it is shared
    float most = std::numeric_limits<float>::max();
};

std::span<const AllowanceRow> allowance_table();  // a row an entry

// Of a frame with so many views. alpha below 0.01 counts as that.
Allowance allowance_of(const Detail& detail, std::size_t views);

}  // namespace quadrat::render::choose
