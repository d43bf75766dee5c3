// SPDX-License-Identifier: Apache-2.0
// What choosing a flight over a land takes: of lands with little to look at, with rock, with a road and with a town.
#include <benchmark/benchmark.h>

#include "scene/land_parameters.hpp"
#include "synthesis/compose/track.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/grow.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

scene::LandParameters rocky() {
    scene::LandParameters p;
    p.arch_share = p.ledge_share = 1;
    return p;
}

scene::LandParameters with_a_road() {
    scene::LandParameters p = rocky();
    p.road_share = 1;
    return p;
}

scene::LandParameters with_a_town() {
    scene::LandParameters p;
    p.settle_age = 1;
    return p;
}

void choosing_a_flight(benchmark::State& state, scene::LandParameters (*parameters)()) {
    const scene::Land land = grow_land(parameters(), base::Seed{11});
    for (auto _ : state) {
        const base::Seed flight{7};
        const Lookout lookout(land);
        benchmark::DoNotOptimize(fly(fitted_to(lookout, plan_flight(flight)), lookout, flight));
    }
    state.counters["corners"] = static_cast<double>(land.stone.mesh.positions_m.size());
}
BENCHMARK_CAPTURE(choosing_a_flight, bare, [] { return scene::LandParameters{}; })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choosing_a_flight, rock, rocky)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choosing_a_flight, rock_and_a_road, with_a_road)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(choosing_a_flight, town, with_a_town)->Unit(benchmark::kMillisecond);

}  // namespace
