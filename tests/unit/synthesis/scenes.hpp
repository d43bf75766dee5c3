// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "genome/recipe.hpp"
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

}  // namespace quadrat::synthesis::test_scenes
