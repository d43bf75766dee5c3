// SPDX-License-Identifier: Apache-2.0
// Trees that compete for light, alone and 25 together, beside space colonisation of as many limbs in the same run.
// Asked for: 40 ms for a tree of 5,000 buds, 250 ms for a stand.
#include <benchmark/benchmark.h>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/styles.hpp"
#include "synthesis/noise/fairy_rings.hpp"
#include "synthesis/trees/colonisation.hpp"
#include "synthesis/trees/self_organising.hpp"
#include "synthesis/trees/topiary.hpp"
#include "synthesis/trees/year.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis::trees;
namespace houses = quadrat::synthesis::houses;

// Grows until it has so many.
SelfOrganisation of_buds(std::size_t buds) {
    SelfOrganisation p;
    p.years = 40;
    p.most_buds = buds;
    return p;
}

void count_limbs(benchmark::State& state, const TreeSkeleton& skeleton) {
    state.counters["limbs"] = static_cast<double>(skeleton.limbs.size());
    state.counters["leafy"] = static_cast<double>(skeleton.sites.size());
}

void a_tree_of_buds(benchmark::State& state) {
    const Seedling one;
    std::vector<TreeSkeleton> grown;
    const SelfOrganisation p = of_buds(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) grown = grow_together(p, {&one, 1}, base::Seed{1});
    count_limbs(state, grown.front());
}
BENCHMARK(a_tree_of_buds)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond);

void a_stand_of_25(benchmark::State& state) {
    const std::vector<Seedling> seedlings = stand_of_seedlings(14, base::Seed{1});
    std::vector<TreeSkeleton> grown;
    SelfOrganisation p;
    p.years = 22;
    for (auto _ : state) grown = grow_together(p, seedlings, base::Seed{1});
    count_limbs(state, grown[grown.size() / 2]);
}
BENCHMARK(a_stand_of_25)->Unit(benchmark::kMillisecond)->UseRealTime();

void space_colonisation_of_as_many_limbs(benchmark::State& state) {
    Colonisation c;
    c.points = static_cast<int>(state.range(0));
    c.most_nodes = 20'000;
    c.step = 0.012F;
    c.kill = 0.012F;
    TreeSkeleton grown;
    for (auto _ : state) grown = colonise(c, base::Seed{1});
    count_limbs(state, grown);
}
BENCHMARK(space_colonisation_of_as_many_limbs)->Arg(1000)->Arg(3000)->Arg(6000)->Unit(benchmark::kMillisecond);

// Argument: hundredths of a year.
void a_year_of_buds(benchmark::State& state) {
    const Year year{0.01F * static_cast<float>(state.range(0)), 1, 0.3F};
    std::vector<Organ> organs;
    for (auto _ : state) organs = organs_in(year);
    state.counters["buds"] = static_cast<double>(organs.size());
}
BENCHMARK(a_year_of_buds)->Arg(0)->Arg(67)->Arg(100)->Unit(benchmark::kMillisecond);

void a_clipped_tree(benchmark::State& state) {
    TreeSkeleton grown;
    for (auto _ : state) grown = clipped_skeleton({}, base::Seed{1});
    count_limbs(state, grown);
}
BENCHMARK(a_clipped_tree)->Unit(benchmark::kMillisecond);

// A house with climbers and the same without: Argument: hundredths of it that are overgrown.
void a_house_with_climbers(benchmark::State& state) {
    houses::Design design = houses::Stock({}, base::Seed{1}).draw(houses::Use::Dwelling, base::Seed{2}).design;
    design.overgrown = 0.01F * static_cast<float>(state.range(0));
    scene::Building building;
    for (auto _ : state) building = houses::build(design, base::Seed{3});
    state.counters["triangles"] = static_cast<double>(building.levels.front().mesh.indices.size() / 3);
}
BENCHMARK(a_house_with_climbers)->Arg(0)->Arg(100)->Unit(benchmark::kMillisecond);

void fairy_rings(benchmark::State& state) {
    mesh::Field field;
    for (auto _ : state) field = quadrat::synthesis::noise::fairy_rings({}, base::Seed{1}, 96);
}
BENCHMARK(fairy_rings)->Unit(benchmark::kMillisecond);

}  // namespace
