// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "benches/benches.hpp"
#include "scene/parameters.hpp"
#include "synthesis/compose/light.hpp"
#include "synthesis/compose/openness.hpp"
#include "synthesis/compose/planting.hpp"
#include "synthesis/compose/track.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::benches {
namespace {

constexpr std::size_t kTrees = 5000;

// A scene with just so many trees.
struct Grown {
    scene::Flora flora;
    scene::Land land;
    scene::Sky sky;
    std::vector<scene::Plant> plants;
};

Grown grown(std::uint64_t number) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{number});
    const scene::SceneParameters p = scene::realise(recipe.values);
    Grown g{synthesis::grow_trees(p.trees, recipe.seeds[genome::Aspect::Trees]),
            synthesis::grow_land(p.land, recipe.seeds[genome::Aspect::Land]),
            synthesis::grow_sky(p.sky, recipe.seeds[genome::Aspect::Sky]),
            {}};
    const auto planted = synthesis::plant_land(g.land, g.flora, synthesis::plan_flight(recipe.flight), {},
                                               base::Seed{number}, {.trees = kTrees});
    for (const scene::Plant& plant : planted)
        if (g.flora.species[plant.species].storey == scene::Storey::Tree) g.plants.push_back(plant);
    // Where fewer grow, some stand twice: the light does not mind.
    for (std::size_t i = 0; !g.plants.empty() && g.plants.size() < kTrees; ++i) g.plants.push_back(g.plants[i]);
    g.plants.resize(std::min(g.plants.size(), kTrees));
    return g;
}

}  // namespace

void sky(Results& results) {
    over_threads(results, "sky.scene_ms", [](const genome::Recipe& r) {
        synthesis::grow_sky(scene::realise(r.values).sky, r.seeds[genome::Aspect::Sky]);
    });
    std::vector<double> bakes;
    for (std::uint64_t number = 1; number <= 5; ++number) {
        Grown g = grown(number);
        if (g.plants.size() < kTrees) continue;
        bakes.push_back(least_ms(3, [&] {
            const synthesis::LandShadow shadow(g.land, g.sky.sun_direction, g.sky.shadow_softness);
            synthesis::light_plants(g.plants, g.flora, g.sky, shadow);
            synthesis::bake_light(g.land, synthesis::openness_of(g.land), g.sky, g.flora, g.plants, shadow,
                                  scene::Fineness{}.light_px);
        }));
    }
    results.push_back({"sky.bake_ms", machine::percentile(bakes, 0.5), "ms", cores()});
}

}  // namespace quadrat::benches
