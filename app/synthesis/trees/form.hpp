// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <string>

#include "base/seed.hpp"
#include "scene/parameters.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// What kind a tree is; the order is that of the parameter tree.habit. Those not marked are Weber & Penn's.
enum class Habit {
    AsType,  // a grammar: by tree.type, ABOP figure 2.6 a to d, then the same four made less flat
    Oak,
    Fir,
    Palm,
    Cactus,
    Willow,
    Poplar,
    Acacia,
    Birch,
    Lime,       // space colonisation
    StonePine,  // space colonisation
    Elm,
    Ternary,  // a grammar: ABOP figure 2.8 b
    Pine,
    Cherry,
    Cypress
};
inline constexpr int kHabits = 16;

// What a habit is beyond its grower.
struct HabitTraits {
    const char* name;
    float trunk;   // radius at the foot to the height
    float width;   // of the crown to the height where the grower leaves it open; 0: as it grows
    float leaf;    // length of a leaf to the gene's
    float cover;   // of the crown by leaves
    float spread;  // of leaves: 0 along their twigs to 1 every way
    float outward;
    float scatter;     // of leaves about their site, to the height
    int own_leaf;      // LeafKind that the gene cannot change; -1: the gene's
    bool keeps_radii;  // of the grower instead of the pipe model
    float moisture, moisture_width;
    float lowest_m;
    float treeline;   // to the gene's
    float steepness;  // to the gene's
};
const HabitTraits& traits(Habit habit);

// A species' genes, its own and those it shares with the scene's first one.
struct Form {
    Habit habit = Habit::AsType;
    int type = 4;  // ABOP a to d, then the same made less flat
    float branch_angle_deg = 41.25F;
    float trunk_contraction = 0.88F;
    float branch_contraction = 0.74F;
    float height_m = 13;
    float crown_width = 1;
    float clear_stem = 0;
    float girth = 1;
    float taper = 2.3F;
    int stems = 1;
    float lean_deg = 3;
    float gnarl_deg = 4;
    float divergence_deg = 137.5F;
    float limb_rise = 0.04F;
    float leader = 0;
    float sag = 0.25F;
    float light_seeking = 0.2F;
    float wind_lean = 0.1F;
    float wind_from_deg = 240;
    float limb_density = 1;
    float crowding = 0.15F;
    float root_flare = 0.5F;
    float bareness = 0.06F;
    LeafKind leaf = LeafKind::Ovate;
    float leaf_length_m = 0.46F;
    float leaf_density = 1;
    float leaf_width = 1;
    float leaf_fold = 0.35F;
    float leaf_droop = 0.15F;
    float leaf_clumping = 0.4F;
    float blossom = 0;
    float fruit = 0;
    float fruit_m = 0.14F;
    int bark_kind = 0;
    float bark_depth = 0.55F;
    float bark_tile_m = 0.8F;
    LeafColours colours;
    glm::vec3 bark{0.2F};
};

enum class Rank { First, Second, Third };
Form form_of(const scene::TreeParameters& parameters, Rank rank);

// Colours of the scene's plants that go together. Linear.
struct Wear {
    glm::vec3 leaf, second, bark, grass, blossom;
};
Wear wear_of(const scene::TreeParameters& parameters);

// White, pink, red, orange, yellow, violet by 0 to 1. Linear.
glm::vec3 blossom_colour(float hue);

// A grown skeleton in metres: root at the origin, no limb under the ground but the roots' ends, which reach into it by
// less than the trunk's radius.
TreeSkeleton grow_skeleton(const Form& form, base::Seed seed);

}  // namespace quadrat::synthesis::trees
