// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "render/choose/plant_kind.hpp"

namespace quadrat::render::choose {

// The coarsest level of wood becomes wider by at most so many radii of its trunk to each side, for a stem that is no
// pixel wide is dots.
inline constexpr float kWidening = 6;

// Of a blade's size, where as many copies of it stand about it as may: as shaders/common/leaf.glsl has it.
inline constexpr float kLeastBlade = 0.5F;

inline constexpr std::size_t kFewestBlades = 4;  // of a crown that has any

// How closely a plant of this many pixels is drawn. Finer for more pixels, never coarser.
struct Closeness {
    std::size_t wood_level = 0;  // the number of levels: none
    float to_coarser = 0;        // 0 that level to 1 the next one; of the coarsest to 1 widened
    bool has_leaves = false;
    float share = 1;             // of the blades; above 1 some or all are drawn more than once
    float enlarged = 1;          // each of them, times its size; below 1 where there are copies
    bool is_plain = false;       // which are too small to show their shape
    std::size_t mass_level = 0;  // the number of levels: none
    float mass_to_coarser = 0;   // as of the wood
    float merged = 0;            // how far the crown is that mass, 0 to 1
    float mass_size = 1;         // 0 where that has dwindled to nothing
    float stand = 1;             // of plants so small, the share that stands for all of them, each larger
};
// looked_at: 1 for the subject of a picture, 0 for the crowd; what is large on the screen is looked at anyway.
Closeness closeness(const PlantKind& kind, float height_px, float fineness, float looked_at = 0);

// Of plants so high on the screen that are but a few blades, the fewest that stand for all of them: near by none is
// left out, and none larger than it is for those that are.
float least_stand(float height_px);

// How far crowns are drawn as leaves, 0 to 1: less where little is drawn of anything.
float leafiness(float fineness);

// 0 at from and before, 1 at to and beyond.
float between(float from, float to, float value);

}  // namespace quadrat::render::choose
