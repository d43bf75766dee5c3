// SPDX-License-Identifier: Apache-2.0
// Trees that compete for light, alone and 25 together, beside space colonisation of as many limbs in the same run.
// Asked for: 40 ms for a tree of 5,000 buds, 250 ms for a stand.
#include <benchmark/benchmark.h>

#include "synthesis/trees/colonisation.hpp"
#include "synthesis/trees/self_organising.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis::trees;

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

}  // namespace
