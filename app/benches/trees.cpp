// SPDX-License-Identifier: Apache-2.0
// Beside each figure what others need for the same: the paper's own (2003), and peers measured on a machine of this
// class.
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <time.h>

#include <algorithm>
#include <limits>

#include "benches/benches.hpp"
#include "genome/parameter_ids.hpp"
#include "scene/parameters.hpp"
#include "synthesis/compose/planting.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/trees/colonisation.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/self_organising.hpp"
#include "synthesis/trees/species.hpp"
#include "synthesis/trees/turtle.hpp"

namespace quadrat::benches {
namespace {

using namespace synthesis::trees;

// Of this thread's own time, which other programs do not lengthen as they do the clock's.
double own_ms(int runs, const std::function<void()>& work) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const auto now_ms = [] {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
    };
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < runs; ++i) {
        const double before = now_ms();
        work();
        least = std::min(least, now_ms() - before);
    }
    return least;
}

TreeSkeleton honda_skeleton(int steps) {
    static const Grammar kGrammar = library_grammar("changed-c");
    TurtleOptions options = options_of(kGrammar);
    options.length = 2;
    options.radius_per_width = 0.03F;
    DeriveOptions how;
    how.steps = steps;
    return interpret(derive(kGrammar, how).word, options, base::Seed{1});
}

// Skeleton and tubes of a tree of about twenty thousand triangles.
void tubes(Results& results) {
    scene::Wood wood;
    TubeDetail detail;
    detail.trunk_sides = 10;
    const auto tree = [&] { wood = sweep_tubes(honda_skeleton(11), detail); };
    const double ms = own_ms(40, tree);
    const auto triangles = static_cast<double>(wood.mesh.triangle_count());
    results.push_back({"trees.tube_ms", ms, "ms", 1, "paper 2000-3000; ez-tree 16.5 (22.6k triangles)"});
    results.push_back({"trees.tube_mtris", triangles / ms / 1e3, "Mtri/s", 1, "ez-tree 1.4; proctree 16-35"});
    results.push_back({"trees.tube_triangles", triangles, "triangles", 1});
}

// 300 limbs, every one in the field, in cells of a 256th of the tree.
void smooth(Results& results) {
    TreeSkeleton skeleton = honda_skeleton(10);
    if (skeleton.limbs.size() > 300) {
        skeleton.limbs.resize(300);
        std::erase_if(skeleton.sites, [](const Site& site) { return site.limb >= 300; });
    }
    set_pipe_radii(skeleton, {});
    measure(skeleton);
    const glm::vec3 size = skeleton.high_m - skeleton.low_m;
    MetaTubeDetail detail;
    detail.cell_m = std::max({size.x, size.y, size.z}) / 256;
    detail.sweeps_twigs = false;
    scene::Wood wood;
    const auto surface = [&] { wood = mesh_meta_tubes(skeleton, detail); };
    results.push_back({"trees.smooth_ms", own_ms(12, surface), "ms", 1,
                       "paper: minutes; VTK, the field given: flying edges 25, marching cubes 77"});
    results.push_back({"trees.smooth_triangles", static_cast<double>(wood.mesh.triangle_count()), "triangles", 1});
}

void species(Results& results) {
    constexpr std::uint64_t kScenes = 24;
    std::size_t most_bytes = 0;
    std::vector<double> samples;
    for (std::uint64_t i = 1; i <= kScenes; ++i) {
        const genome::Recipe r = genome::random_recipe(base::Seed{i});
        const Form form = form_of(scene::realise(r.values).trees, Rank::First);
        samples.push_back(own_ms(1, [&] {
            most_bytes = std::max(most_bytes, scene::bytes_of(make_species(form, r.seeds[genome::Aspect::Trees])));
        }));
    }
    results.push_back({"trees.species_ms", machine::percentile(samples, 0.5), "ms", 1});
    results.push_back({"trees.species_p95_ms", machine::percentile(samples, 0.95), "ms", 1});
    results.push_back({"trees.species_most_ms", machine::percentile(samples, 1), "ms", 1});
    results.push_back({"trees.species_mb", static_cast<double>(most_bytes) / 1e6, "MB", 1});
}

// A tree of five thousand buds that compete for light, 25 of them together, and space colonisation of as many limbs.
void light(Results& results) {
    SelfOrganisation p;
    p.years = 40;
    const Seedling one;
    TreeSkeleton tree;
    const double tree_ms = own_ms(8, [&] { tree = grow_together(p, {&one, 1}, base::Seed{1}).front(); });
    Colonisation c;
    c.most_nodes = 20'000;
    c.step = 0.012F;
    c.kill = 0.012F;
    c.points = 6000;
    TreeSkeleton colonised;
    const double colonised_ms = own_ms(8, [&] { colonised = colonise(c, base::Seed{1}); });
    const double ratio =
        tree_ms / static_cast<double>(tree.limbs.size()) / (colonised_ms / static_cast<double>(colonised.limbs.size()));
    const std::vector<Seedling> seedlings = stand_of_seedlings(p.apart, base::Seed{1});
    p.years = 22;
    const double stand_ms = least_ms(5, [&] { grow_together(p, seedlings, base::Seed{1}); });
    results.push_back({"trees.light_ms", tree_ms, "ms", 1, "wished for: 40, for 5000 buds"});
    results.push_back({"trees.light_limbs", static_cast<double>(tree.limbs.size()), "limbs", 1});
    results.push_back({"trees.light_to_colonisation", ratio, "times", 1, "a limb's time, space colonisation 1"});
    results.push_back({"trees.stand_ms", stand_ms, "ms", cores(), "wished for: 250, for 25 trees"});
}

// Four scenes' floras of three species each, as a new generation needs them.
void generation_of_trees(Results& results) {
    std::vector<genome::Recipe> recipes;
    for (std::uint64_t i = 1; i <= 4; ++i) {
        recipes.push_back(genome::random_recipe(base::Seed{i}));
        recipes.back().values.set(genome::ParameterId::second_share, 1);
        recipes.back().values.set(genome::ParameterId::third_share, 1);
    }
    const double ms = least_ms(3, [&] {
        tbb::parallel_for(std::size_t{0}, recipes.size(), [&](std::size_t i) {
            synthesis::grow_trees(scene::realise(recipes[i].values).trees, recipes[i].seeds[genome::Aspect::Trees]);
        });
    });
    results.push_back({"trees.generation_ms", ms, "ms", cores(), "paper 20000 and more"});
}

// A million symbols: the least step of Honda's tree that has them.
void symbols(Results& results) {
    const Grammar grammar = library_grammar("abop-b");
    DeriveOptions how;
    how.steps = 16;
    std::size_t count = 0;
    const double ms = own_ms(5, [&] { count = derive(grammar, how).word.symbols.size(); });
    results.push_back({"trees.lsystem_ms", ms * 1e6 / static_cast<double>(count), "ms", 1});
}

void plants(Results& results) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{3});
    const scene::SceneParameters p = scene::realise({});
    const scene::Flora flora = synthesis::grow_trees(p.trees, recipe.seeds[genome::Aspect::Trees]);
    const scene::Land land = synthesis::grow_land(p.land, recipe.seeds[genome::Aspect::Land]);
    const synthesis::FlightPlan plan = synthesis::plan_flight(recipe.flight);
    synthesis::PlantingBudget budget;
    budget.trees = 5'000;
    budget.undergrowth = 40'000;
    budget.reach_m = 120;
    std::size_t count = 0;
    const double ms =
        least_ms(7, [&] { count = synthesis::plant_land(land, flora, plan, {}, base::Seed{1}, budget).size(); });
    results.push_back({"trees.planting_ms", ms * 20e3 / static_cast<double>(count), "ms", cores()});
    results.push_back({"trees.planted", static_cast<double>(count), "plants", cores()});
}

}  // namespace

void trees(Results& results) {
    tubes(results);
    smooth(results);
    species(results);
    light(results);
    generation_of_trees(results);
    symbols(results);
    plants(results);
    over_threads(results, "trees.scene_ms", [](const genome::Recipe& r) {
        synthesis::grow_trees(scene::realise(r.values).trees, r.seeds[genome::Aspect::Trees]);
    });
}

}  // namespace quadrat::benches
