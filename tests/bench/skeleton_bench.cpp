// SPDX-License-Identifier: Apache-2.0
// Roofs over polygons of rising size, and CGAL's skeleton of the same.
#include <benchmark/benchmark.h>

#include "support/plans.hpp"
#ifdef QUADRAT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/create_straight_skeleton_2.h>
#endif

namespace {

using namespace quadrat;
using namespace quadrat::tests;

mesh::Plan star(int corners) {
    base::RandomStream chance{base::Seed{3}};
    const double rough = std::min(1.0, 300.0 / corners);
    return {star_loop(corners, 10 - 2 * rough, 10, {0, 0}, chance), {}};
}

mesh::Plan maze(int corners) {
    base::RandomStream chance{base::Seed{4}};
    return {maze_loop(static_cast<int>(std::sqrt(corners / 1.7)), 0.1, chance), {}};
}

void ours(benchmark::State& state, mesh::Plan (*plan_of)(int)) {
    const mesh::Plan plan = plan_of(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(mesh::straight_skeleton(plan).vertices.data());
    state.counters["edges"] = static_cast<double>(plan.outer.size());
    state.SetComplexityN(static_cast<benchmark::IterationCount>(plan.outer.size()));
}
BENCHMARK_CAPTURE(ours, star, star)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(5000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK_CAPTURE(ours, maze, maze)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(5000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

#ifdef QUADRAT_HAS_CGAL
void cgal(benchmark::State& state, mesh::Plan (*plan_of)(int)) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const mesh::Plan plan = plan_of(static_cast<int>(state.range(0)));
    CGAL::Polygon_2<Kernel> polygon;
    for (const glm::dvec2& p : plan.outer) polygon.push_back({p.x, p.y});
    for (auto _ : state) benchmark::DoNotOptimize(CGAL::create_interior_straight_skeleton_2(polygon));
    state.counters["edges"] = static_cast<double>(plan.outer.size());
}
BENCHMARK_CAPTURE(cgal, star, star)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cgal, maze, maze)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
#endif

}  // namespace
