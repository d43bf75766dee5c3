// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "benches/benches.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/compose/settlers.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/land/deformations.hpp"
#include "synthesis/land/drainage.hpp"
#include "synthesis/land/erosion.hpp"
#include "synthesis/land/field_methods.hpp"
#include "synthesis/land/ground.hpp"
#include "synthesis/land/overhangs.hpp"
#include "synthesis/land/rivers.hpp"
#include "synthesis/land/tile_examples.hpp"
#include "synthesis/lsystem/map_lsystem.hpp"
#include "synthesis/noise/lateral_inhibition.hpp"

namespace quadrat::benches {
namespace {

using namespace synthesis::land;

class Threads {
  public:
    explicit Threads(int count)
        : limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count)) {}

  private:
    tbb::global_control limit_;
};

// The best of several: what the work costs when nothing else is in its way.
double best_ms(int runs, const std::function<void()>& work) {
    double best = milliseconds_of(work);
    for (int i = 1; i < runs; ++i) best = std::min(best, milliseconds_of(work));
    return best;
}

// The same in processor time, for work on one core: what others do on the machine does not count.
double best_cpu_ms(int runs, const std::function<void()>& work) {
    double best = 1.0e30;
    for (int i = 0; i < runs; ++i) {
        const double before = machine::cpu_seconds();
        work();
        best = std::min(best, 1.0e3 * (machine::cpu_seconds() - before));
    }
    return best;
}

FieldRequest request(int size) {
    FieldRequest r;
    r.size = size;
    r.octaves = 8;
    r.features = 2.5F;
    r.seed = base::Seed{5};
    return r;
}

// Hills of some two hundred metres, a third of them under the sea.
mesh::Field hills(int size) {
    mesh::Field field = make_field(*field_method("fbm"), request(size));
    for (float& h : field.samples) h = 220 * h + 60;
    return field;
}

double msamples_a_second(const char* method, int size) {
    const double ms = best_cpu_ms(9, [&] { field_method(method)->make(request(size)); });
    return 1.0e-3 * size * size / ms;
}

void add_water(Results& results) {
    const mesh::Field ground = hills(1025);
    const auto work = [&] { drained_area_m2(drain(ground, 0), 2); };
    {
        const Threads one(1);
        results.push_back({"land.water_ms", best_cpu_ms(9, work), "ms", 1});
    }
    const Threads two(2);
    results.push_back({"land.water_ms", best_ms(9, work), "ms", 2});
}

// What people add to the growing of a land: a hamlet, a town.
void add_settlement(Results& results) {
    scene::LandParameters p;
    p.land_relief_m = 15;  // there is room for a town
    p.land_sea_level = 0;
    const scene::Land wild = synthesis::grow_land(p, base::Seed{11});
    mesh::Image albedo(1024, 1024, 4);
    const auto settle = [&](const char* row, float age) {
        p.settle_age = age;
        std::size_t houses = 0;
        double ms = 1.0e30;
        for (int run = 0; run < 5; ++run) {
            scene::Land land = wild;  // the ground is levelled
            ms = std::min(ms, milliseconds_of([&] {
                              synthesis::HouseBuilders builders(p, base::Seed{11});
                              builders.build(land);
                              mesh::Field to_edge_m;
                              builders.keep_clear(land, to_edge_m);
                              builders.paint(land, albedo);
                          }));
            houses = land.settlement.houses.size();
        }
        results.push_back({row, ms, fmt::format("ms, {} houses", houses), 2});
    };
    const Threads two(2);
    settle("land.hamlet_ms", 0.27F);
    p.settle_density = 1;
    p.settle_house_size = 0.8F;
    settle("land.town_ms", 1.0F);
}

void add_erosion(Results& results) {
    const mesh::Field ground = hills(513);
    for (const int threads : {1, 2}) {
        const Threads some(threads);
        const double ms = best_ms(9, [&] {
            mesh::Field carved = ground;
            carve_valleys(carved, 2, {});
        });
        results.push_back({"land.erosion_ms", ms, "ms", threads});
    }
}

void add_other_ways(Results& results) {
    const Threads one(1);
    const mesh::Field ground = hills(513);
    const mesh::Field mask = make_field(*field_method("gaussian-hills"), request(65));
    const auto tell = [&](const char* name, double ms) { results.push_back({name, ms, "ms", 1}); };
    tell("land.streams_ms", best_cpu_ms(3, [] { make_field(*field_method("streams"), request(513)); }));
    tell("land.search_ms", best_cpu_ms(3, [&] {
             mesh::Field bent = ground;
             for (float& h : bent.samples) h /= 220;
             bend_to_mask(bent, mask, {}, base::Seed{3});
         }));
    tell("land.map_of_cells_ms", best_cpu_ms(5, [] {
             namespace ls = synthesis::lsystem;
             ls::derive_map(ls::library_map("map-cross"), ls::regular_outline(4), {.steps = 12, .chance = 0.5F},
                            base::Seed{3});
         }));
    tell("land.tiles_ms", best_cpu_ms(5, [] {
             const synthesis::noise::Tiles of = synthesis::noise::tiles_from(tile_examples().front().text, "ruin");
             facets_of(synthesis::noise::synthesise(of, {13, 11, 4}, {}, base::Seed{3}), {}, base::Seed{3});
         }));
    tell("land.inhibition_ms", best_cpu_ms(5, [] { synthesis::noise::inhibited({}, base::Seed{3}, 64); }));
    tell("land.mud_ms", best_cpu_ms(5, [] { mud_tile(base::Seed{3}, 256); }));
    tell("land.fin_ms", best_cpu_ms(5, [] { weathered_fin({}, base::Seed{3}).surface(); }));
}

// Heights, valleys and water of ever larger fields of one cell: the slope of log time over log cells.
double cost_exponent() {
    std::vector<double> xs;
    std::vector<double> ys;
    for (int size = 257; size <= 4097; size = 2 * size - 1) {
        const double ms = best_cpu_ms(size < 1000 ? 5 : 2, [&] {
            mesh::Field field = hills(size);
            carve_valleys(field, 2, {});
            make_fresh_water(field, 2, {});
        });
        xs.push_back(2 * std::log(static_cast<double>(size)));
        ys.push_back(std::log(ms));
    }
    const auto n = static_cast<double>(xs.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        sx += xs[i];
        sy += ys[i];
        sxx += xs[i] * xs[i];
        sxy += xs[i] * ys[i];
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

void land(Results& results) {
    {
        const Threads one(1);
        results.push_back({"land.fbm_msamples", msamples_a_second("fbm", 1025), "Msamples/s", 1});
        results.push_back({"land.diamond_square_msamples", msamples_a_second("diamond-square", 2049), "Msamples/s", 1});
    }
    add_water(results);
    add_erosion(results);
    add_other_ways(results);
    add_settlement(results);
    {
        const Threads one(1);
        results.push_back({"land.cost_exponent", cost_exponent(), "of cells", 1});
    }
    over_threads(results, "land.scene_ms", [](const genome::Recipe& r) {
        synthesis::grow_land(scene::realise_land(r.values), r.seeds[genome::Aspect::Land]);
    });
    const double four_ms = best_ms(5, [] {
        for (std::uint64_t i = 1; i <= genome::kCandidates; ++i) {
            const genome::Recipe r = genome::random_recipe(base::Seed{i});
            synthesis::grow_land(scene::realise_land(r.values), r.seeds[genome::Aspect::Land]);
        }
    });
    results.push_back({"land.generation_ms", four_ms, "ms", cores()});
}

}  // namespace quadrat::benches
