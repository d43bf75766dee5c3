// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <oneapi/tbb/global_control.h>

#include "genome/recipe.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/land/drainage.hpp"
#include "synthesis/land/erosion.hpp"
#include "synthesis/land/field_methods.hpp"
#include "synthesis/land/overhangs.hpp"
#include "synthesis/land/tile_examples.hpp"
#include "synthesis/lsystem/map_lsystem.hpp"
#include "synthesis/noise/automaton.hpp"
#include "synthesis/noise/lateral_inhibition.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using Threads = oneapi::tbb::global_control;

land::FieldRequest request(int size) {
    land::FieldRequest r;
    r.size = size;
    r.octaves = 8;
    r.features = 2.5F;
    r.seed = base::Seed{5};
    return r;
}

mesh::Field hills(int size) {
    mesh::Field field = land::make_field(*land::field_method("fbm"), request(size));
    for (float& h : field.samples) h = 220 * h + 60;
    return field;
}

void field(benchmark::State& state, const char* name) {
    const Threads one(Threads::max_allowed_parallelism, 1);
    const land::FieldMethod& method = *land::field_method(name);
    const auto size = static_cast<int>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(method.make(request(size)).samples.data());
    state.counters["Msamples/s"] =
        benchmark::Counter(1.0e-6 * size * size * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(field, fbm_8_octaves, "fbm")->Arg(1025)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field, simplex_8_octaves, "fbm-simplex")->Arg(1025)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field, ridged_8_octaves, "ridged")->Arg(1025)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field, diamond_square, "diamond-square")->Arg(2049)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field, square_square, "square-square")->Arg(2049)->Unit(benchmark::kMillisecond);

void water(benchmark::State& state) {
    const Threads one(Threads::max_allowed_parallelism, 1);
    const mesh::Field ground = hills(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const land::Drainage d = land::drain(ground, 0);
        benchmark::DoNotOptimize(land::drained_area_m2(d, 2).data());
    }
    state.SetComplexityN(state.range(0) * state.range(0));
}
BENCHMARK(water)->RangeMultiplier(2)->Range(257, 2049)->Arg(1025)->Unit(benchmark::kMillisecond)->Complexity();

void valleys(benchmark::State& state) {
    const mesh::Field ground = hills(513);
    for (auto _ : state) {
        mesh::Field carved = ground;
        land::carve_valleys(carved, 2, {});
        benchmark::DoNotOptimize(carved.samples.data());
    }
}
BENCHMARK(valleys)->Unit(benchmark::kMillisecond)->UseRealTime();

void finished_land(benchmark::State& state) {
    const Threads some(Threads::max_allowed_parallelism, static_cast<std::size_t>(state.range(0)));
    const genome::Recipe recipe = genome::random_recipe(base::Seed{4});
    const scene::SceneParameters p = scene::realise(recipe.values);
    for (auto _ : state) benchmark::DoNotOptimize(grow_land(p.land, recipe.seeds[genome::Aspect::Land]).albedo);
}
BENCHMARK(finished_land)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void a_map_of_cells(benchmark::State& state) {
    const lsystem::MapGrammar grammar = lsystem::library_map("map-cross");
    const std::vector<glm::vec2> square = lsystem::regular_outline(4);
    const auto steps = static_cast<int>(state.range(0));
    std::size_t cells = 0;
    for (auto _ : state)
        cells = lsystem::derive_map(grammar, square, {.steps = steps, .chance = 0.5F}, base::Seed{1}).cells.size();
    state.counters["cells"] = static_cast<double>(cells);
}
BENCHMARK(a_map_of_cells)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

BENCHMARK_CAPTURE(field, streams_first, "streams")->Arg(513)->Unit(benchmark::kMillisecond);

void lateral_inhibition(benchmark::State& state) {
    mesh::Field peaks;
    for (auto _ : state) peaks = noise::inhibited({}, base::Seed{1}, 64);
}
BENCHMARK(lateral_inhibition)->Unit(benchmark::kMillisecond);

void a_forest_that_burns(benchmark::State& state) {
    mesh::Field ages;
    for (auto _ : state) ages = noise::forest_ages(static_cast<int>(state.range(0)), 0.5F, base::Seed{1});
}
BENCHMARK(a_forest_that_burns)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);

void a_box_of_tiles(benchmark::State& state) {
    const land::TileExample& example = land::tile_examples().front();
    const noise::Tiles tiles = noise::tiles_from(example.text, std::string(example.name));
    const auto side = static_cast<int>(state.range(0));
    noise::Tiles made;
    for (auto _ : state)
        made = noise::synthesise(tiles, {side, side, 4}, land::weights_of(example, 0.5F), base::Seed{1});
}
BENCHMARK(a_box_of_tiles)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

void a_fin_of_layers(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(land::weathered_fin({}, base::Seed{1}));
}
BENCHMARK(a_fin_of_layers)->Unit(benchmark::kMillisecond);

}  // namespace
