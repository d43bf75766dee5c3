// SPDX-License-Identifier: Apache-2.0
// What a hamlet and a town add to the growing of a land, whole and part by part. Argument: houses::houses_at(age /
// 100).
#include <benchmark/benchmark.h>

#include "scene/land_parameters.hpp"
#include "synthesis/compose/gardens.hpp"
#include "synthesis/compose/settlers.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/houses/bounds.hpp"
#include "synthesis/houses/grounds.hpp"
#include "synthesis/houses/network.hpp"
#include "synthesis/houses/place.hpp"
#include "synthesis/houses/styles.hpp"
#include "synthesis/houses/waterside.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

const scene::Land& wild() {
    static const scene::Land kWild = [] {
        scene::LandParameters level;
        level.land_relief_m = 15;
        level.land_sea_level = 0.0F;
        return grow_land(level, base::Seed{11});
    }();
    return kWild;
}

scene::LandParameters aged(const benchmark::State& state) {
    scene::LandParameters p;
    p.settle_age = 0.01F * static_cast<float>(state.range(0));
    if (state.range(0) < 100) return p;
    // A town that has all of its houses is dense.
    p.settle_density = 1;
    p.settle_house_size = 0.8F;
    return p;
}

void whole(benchmark::State& state) {
    const scene::LandParameters p = aged(state);
    scene::Land land = wild();
    mesh::Image albedo(1024, 1024, 4);
    for (auto _ : state) {
        state.PauseTiming();
        land = wild();  // the ground was levelled
        state.ResumeTiming();
        HouseBuilders builders(p, base::Seed{11});
        builders.build(land);
        mesh::Field to_edge_m;
        builders.keep_clear(land, to_edge_m);
        builders.paint(land, albedo);
    }
    state.counters["houses"] = static_cast<double>(land.settlement.houses.size());
}

void choosing_the_place(benchmark::State& state) {
    const scene::LandParameters p = aged(state);
    for (auto _ : state) benchmark::DoNotOptimize(houses::settling_place(wild(), p));
}

void streets(benchmark::State& state) {
    const scene::LandParameters p = aged(state);
    const glm::vec2 middle = houses::settling_place(wild(), p).value_or(glm::vec2{0});
    for (auto _ : state) benchmark::DoNotOptimize(houses::grow_network(wild(), middle, p, base::Seed{11}));
}

void settling(benchmark::State& state) {
    const scene::LandParameters p = aged(state);
    for (auto _ : state) benchmark::DoNotOptimize(houses::settle(wild(), p, base::Seed{11}));
}

void raising_twenty(benchmark::State& state) {
    const scene::LandParameters p = aged(state);
    for (auto _ : state) benchmark::DoNotOptimize(houses::sample_stock(p, base::Seed{11}, 6));
}

// One part after what it needs.
template <typename Part>
void part_of(benchmark::State& state, const Part& part) {
    const scene::LandParameters p = aged(state);
    scene::Land land = wild();
    houses::Settled settled = houses::settle(land, p, base::Seed{11});
    houses::level_ground(land, settled);
    land.settlement = settled.settlement;
    const std::vector<scene::FieldPlot> fields = houses::lay_fields(land, settled, p, base::Seed{11});
    for (auto _ : state) part(land, settled, fields, p);
}

void levelling(benchmark::State& state) {
    part_of(state, [](scene::Land& land, houses::Settled& settled, const auto&, const auto&) {
        houses::level_ground(land, settled);
    });
}
void fields(benchmark::State& state) {
    part_of(state, [](const scene::Land& land, const houses::Settled& settled, const auto&, const auto& p) {
        benchmark::DoNotOptimize(houses::lay_fields(land, settled, p, base::Seed{11}));
    });
}
void bounds(benchmark::State& state) {
    part_of(state, [](const scene::Land& land, const houses::Settled& settled, const auto& plots, const auto& p) {
        benchmark::DoNotOptimize(houses::add_bounds(land, settled, plots, p, base::Seed{11}));
    });
}
void gardens(benchmark::State& state) {
    part_of(state, [](const scene::Land& land, const houses::Settled&, const auto&, const auto& p) {
        benchmark::DoNotOptimize(lay_gardens(land, p, base::Seed{11}));
    });
}
void jetties(benchmark::State& state) {
    part_of(state, [](const scene::Land& land, const houses::Settled& settled, const auto&, const auto& p) {
        benchmark::DoNotOptimize(houses::add_jetties(land, settled, p, base::Seed{11}));
    });
}
void painting(benchmark::State& state) {
    mesh::Image albedo(1024, 1024, 4);
    part_of(state, [&](const scene::Land& land, const houses::Settled& settled, const auto& plots, const auto&) {
        houses::paint_grounds(albedo, land, settled, plots, 0.5F, base::Seed{11});
    });
}

void hamlet_and_town(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(27)->Arg(100)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}
BENCHMARK(whole)->Apply(hamlet_and_town);
BENCHMARK(choosing_the_place)->Apply(hamlet_and_town);
BENCHMARK(streets)->Apply(hamlet_and_town);
BENCHMARK(settling)->Apply(hamlet_and_town);
BENCHMARK(raising_twenty)->Apply(hamlet_and_town);
BENCHMARK(levelling)->Apply(hamlet_and_town);
BENCHMARK(fields)->Apply(hamlet_and_town);
BENCHMARK(bounds)->Apply(hamlet_and_town);
BENCHMARK(gardens)->Apply(hamlet_and_town);
BENCHMARK(jetties)->Apply(hamlet_and_town);
BENCHMARK(painting)->Apply(hamlet_and_town);

}  // namespace
