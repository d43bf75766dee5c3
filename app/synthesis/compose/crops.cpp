// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/crops.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::synthesis {
namespace {

constexpr float kEdge_m = 1.2F;  // left to the grass between fields

using Kind = scene::CoverKind;
// By scene::Crop. A meadow grows as what is wild does, a mown one as lawns do: neither has a stand of its own.
constexpr std::array<Stand, scene::kCrops> kStands{
    {{},
     {},
     {Kind::Grass, 0.26F, 0.26F, 0.9F, 0.42F, {0.88F, 1.06F, 0.82F}},
     {Kind::Grass, 0.78F, 0.36F, 1.0F, 0, {1.06F, 1.0F, 0.86F}},
     {Kind::Grass, 0.17F, 0.24F, 0.85F, 0.42F, {1.1F, 1.06F, 0.95F}},
     {Kind::Stone, 0.11F, 0.24F, 0.8F, 0.8F, {0.95F, 0.93F, 0.9F}},  // clods
     {Kind::Cushion, 0.30F, 0.34F, 0.8F, 0.75F, {0.85F, 1.1F, 0.8F}}}};

}  // namespace

Crops::Crops(const std::vector<scene::FieldPlot>& fields) {
    for (const scene::FieldPlot& field : fields)
        plots_.push_back({&field, houses::extent_of(field.outline_m), houses::Inside(field.outline_m)});
}

const scene::FieldPlot* Crops::at(glm::vec2 at_m) const {
    for (const Plot& plot : plots_) {
        const auto& [low, high] = plot.extent;
        if (at_m.x < low.x || at_m.x > high.x || at_m.y < low.y || at_m.y > high.y) continue;
        if (plot.inside.by_m(at_m) > kEdge_m) return plot.field;
    }
    return nullptr;
}

Stand stand_of(scene::Crop crop) { return kStands[static_cast<std::size_t>(crop)]; }

glm::vec2 in_row(const scene::FieldPlot& field, float rows_m, glm::vec2 at_m) {
    if (rows_m <= 0) return at_m;
    const glm::vec2 across{-field.along.y, field.along.x};
    const float off_m = glm::dot(at_m, across);
    return at_m + (std::round(off_m / rows_m) * rows_m - off_m) * across;
}

}  // namespace quadrat::synthesis
