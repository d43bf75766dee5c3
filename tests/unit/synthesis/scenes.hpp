// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "genome/parameter_ids.hpp"
#include "genome/recipe.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::synthesis::test_scenes {

// Small enough to grow hundreds.
inline constexpr scene::Fineness kCoarse{.land_samples = 129, .light_px = 64, .albedo_px = 64};

inline scene::Scene grow(const genome::Recipe& recipe, const scene::Fineness& fineness = kCoarse) {
    using genome::Aspect;
    const scene::SceneParameters p = scene::realise(recipe.values);
    return compose(std::make_shared<scene::Flora>(grow_trees(p.trees, recipe.seeds[Aspect::Trees])),
                   std::make_shared<scene::Land>(grow_land(p.land, recipe.seeds[Aspect::Land], fineness)),
                   std::make_shared<scene::Sky>(grow_sky(p.sky, recipe.seeds[Aspect::Sky])),
                   recipe.seeds[Aspect::Trees], recipe.flight, fineness);
}

// A little of every landform, on high land with rivers, so that each of their numbers has something to act on.
inline genome::ParameterValues everything() {
    genome::ParameterValues values;
    using P = genome::ParameterId;
    for (const P id : {P::hill_hybrid, P::hill_hetero, P::hill_cells, P::terrace_share, P::mesa_share, P::dune_share,
                       P::cone_share, P::canyon_share, P::karst_share, P::island_share, P::marsh_share, P::cliff_share,
                       P::hill_warp, P::road_share, P::site_share, P::arch_share})
        values.set(id, 0.3F);
    values.set(P::land_relief_m, 230);
    values.set(P::hill_stretch, 1.5F);
    values.set(P::erosion_slides, 8);
    values.set(P::erosion_age, 3);
    values.set(P::lake_depth_m, 0.6F);
    values.set(P::lake_area_m2, 210);
    values.set(P::ground_lightness, 0.95F);
    values.set(P::ground_snow_line, 0.8F);
    for (const P id : {P::tree_autumn, P::second_autumn, P::third_autumn, P::tree_blossom, P::second_blossom,
                       P::third_blossom, P::tree_fruit, P::shrub_blossom})
        values.set(id, 0.8F);
    return values;
}

}  // namespace quadrat::synthesis::test_scenes
