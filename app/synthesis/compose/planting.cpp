// SPDX-License-Identifier: Apache-2.0
// Hard-core point process: candidates on a jittered grid carry a mark each, and one stands where no candidate of a
// better mark stands too near (Matérn's second process, 1960). Every number hangs on the candidate's cell.
#include "synthesis/compose/planting.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <span>

#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kShore_m = 0.45F;  // nothing roots lower over the water
constexpr float kEdge_m = 10.0F;   // nor nearer to the land's edge

struct Candidate {
    glm::vec2 at_m{0};
    float mark = 2;  // 0 best to 1; 2: no plant here
    std::uint32_t species = 0;
    float scale = 1;
};

struct View {
    float along_m;   // in front of the nearest station
    float aside;     // tangent of the angle off its view
    float to_way_m;  // distance from the camera's way
};

View view_of(const FlightPlan& flight, glm::vec2 at) {
    View view{0, 0, 1.0e6F};
    for (const FlightPlan::Station& station : flight.stations) {
        const glm::vec2 d = at - station.at_m;
        const float distance = glm::length(d);
        if (distance >= view.to_way_m) continue;
        view.to_way_m = distance;
        view.along_m = glm::dot(d, station.ahead);
        view.aside = std::abs(d.x * station.ahead.y - d.y * station.ahead.x) / std::max(view.along_m, 0.1F);
    }
    return view;
}

bool is_in_the_way(const FlightPlan& flight, glm::vec2 at, float radius_m) {
    for (const FlightPlan::Station& station : flight.stations) {
        const glm::vec2 d = at - station.at_m;
        if (glm::length(d) < radius_m + 5.0F) return true;
        const float along = glm::dot(d, station.ahead);
        const float aside = std::abs(d.x * station.ahead.y - d.y * station.ahead.x);
        // Before the camera the middle of the picture stays open.
        if (along > 0 && along < 55.0F && aside < radius_m + 0.36F * along) return true;
    }
    return false;
}

float slope_at(const scene::Land& land, glm::vec2 at) {
    const glm::vec3 n = scene::ground_normal(land, at);
    return std::sqrt(std::max(0.0F, 1.0F - n.y * n.y)) / std::max(n.y, 0.05F);
}

// How well a species does here, 0 to 1.
float welfare(const scene::Species& species, float height_m, float slope) {
    const float above = std::clamp((height_m - std::max(species.lowest_m, kShore_m)) / 1.5F, 0.0F, 1.0F);
    const float below = std::clamp((species.treeline_m - height_m) / (0.12F * species.treeline_m + 1.0F), 0.0F, 1.0F);
    const float flat = std::clamp((species.steepest_slope - slope) / 0.25F, 0.0F, 1.0F);
    return height_m < kShore_m ? 0 : above * below * flat;
}

bool is_on_land(const scene::Land& land, glm::vec2 at) {
    return std::max(std::abs(at.x), std::abs(at.y)) < 0.5F * land.side_m() - kEdge_m;
}

// The species that does best here by its share, drawn by an own number of the place.
std::uint32_t choose_species(const scene::Flora& flora, std::span<const std::uint32_t> kinds, float height_m,
                             float slope, float draw, float& best_welfare) {
    float total = 0;
    best_welfare = 0;
    for (const std::uint32_t kind : kinds) {
        const float w = welfare(flora.species[kind], height_m, slope);
        best_welfare = std::max(best_welfare, w);
        total += w * flora.species[kind].share;
    }
    float left = draw * total;
    for (const std::uint32_t kind : kinds) {
        left -= welfare(flora.species[kind], height_m, slope) * flora.species[kind].share;
        if (left <= 0) return kind;
    }
    return kinds.back();
}

struct Storeyed {
    std::vector<std::uint32_t> trees, shrubs, herbs;
};

Storeyed by_storey(const scene::Flora& flora) {
    Storeyed kinds;
    for (std::uint32_t i = 0; i < flora.species.size(); ++i) {
        switch (flora.species[i].storey) {
            case scene::Storey::Tree:
                kinds.trees.push_back(i);
                break;
            case scene::Storey::Shrub:
                kinds.shrubs.push_back(i);
                break;
            case scene::Storey::Herb:
                kinds.herbs.push_back(i);
                break;
        }
    }
    return kinds;
}

// A square of cells, each with its candidate; cell (0, 0) has its corner at origin_m.
struct CandidateGrid {
    glm::vec2 origin_m;
    float cell_m;
    mesh::Grid<Candidate> cells;
};

template <typename Draw>
CandidateGrid draw_candidates(glm::vec2 low_m, glm::vec2 high_m, float cell_m, base::Seed seed, const Draw& draw) {
    // Cells are numbered from the world's middle, so that a place keeps its candidate whatever window is drawn.
    const auto first = [cell_m](float m) { return static_cast<int>(std::floor(m / cell_m)); };
    const int x0 = first(low_m.x);
    const int y0 = first(low_m.y);
    const int columns = first(high_m.x) - x0 + 1;
    const int rows = first(high_m.y) - y0 + 1;
    CandidateGrid grid{{static_cast<float>(x0) * cell_m, static_cast<float>(y0) * cell_m}, cell_m, {columns, rows}};
    oneapi::tbb::parallel_for(0, rows, [&](int row) {
        for (int column = 0; column < columns; ++column) {
            base::RandomStream random{base::Seed{base::hash_of(seed, x0 + column, y0 + row)}};
            Candidate& c = grid.cells.at(column, row);
            c.at_m = grid.origin_m + cell_m * glm::vec2{static_cast<float>(column) + random.between(0.08F, 0.92F),
                                                        static_cast<float>(row) + random.between(0.08F, 0.92F)};
            draw(c, random);
        }
    });
    return grid;
}

// Those whose mark no nearer neighbour beats.
template <typename Apart>
std::vector<Candidate> hard_core(const CandidateGrid& grid, float reach_m, const Apart& apart_m) {
    const int reach = static_cast<int>(std::ceil(reach_m / grid.cell_m));
    std::vector<Candidate> standing;
    for (int row = 0; row < grid.cells.rows; ++row) {
        for (int column = 0; column < grid.cells.columns; ++column) {
            const Candidate& c = grid.cells.at(column, row);
            if (c.mark > 1) continue;
            bool stands = true;
            for (int dy = -reach; dy <= reach && stands; ++dy) {
                for (int dx = -reach; dx <= reach && stands; ++dx) {
                    if ((dx == 0 && dy == 0) || !grid.cells.is_inside(column + dx, row + dy)) continue;
                    const Candidate& other = grid.cells.at(column + dx, row + dy);
                    stands = other.mark >= c.mark || glm::length(other.at_m - c.at_m) >= apart_m(c, other);
                }
            }
            if (stands) standing.push_back(c);
        }
    }
    return standing;
}

std::vector<Candidate> tree_candidates(const scene::Land& land, const scene::Flora& flora, const Storeyed& kinds,
                                       const FlightPlan& flight, base::Seed seed) {
    const noise::Key groves(seed.child("groves"));
    const float half_m = 0.5F * land.side_m();
    const float cell_m = std::max(0.72F * flora.spacing_m, 2.6F);
    // Wide spacing is open country: groves thin out with it.
    const float openness = std::clamp((flora.spacing_m - 4.0F) / 18.0F, 0.0F, 1.0F);
    const auto draw = [&](Candidate& c, base::RandomStream& random) {
        const float mark = random.unit_f();
        const float kind = random.unit_f();
        const float stay = random.unit_f();
        c.scale = random.between(0.72F, 1.18F);
        if (!is_on_land(land, c.at_m)) return;
        const float height_m = scene::ground_height_m(land, c.at_m);
        if (height_m < kShore_m || scene::water_depth_m(land, c.at_m) > 0) return;
        const float grove = noise::fbm(groves, c.at_m.x / 95.0F, c.at_m.y / 95.0F, {.count = 3, .gain = 0.5F});
        const float density = std::clamp(0.62F - 0.25F * openness + 2.6F * grove, 0.03F, 1.0F);
        float well = 0;
        c.species = choose_species(flora, kinds.trees, height_m, slope_at(land, c.at_m), kind, well);
        if (stay > density * well) return;
        const float radius_m = flora.species[c.species].crown_radius_m * c.scale;
        if (is_in_the_way(flight, c.at_m, radius_m)) return;
        c.mark = mark;
    };
    const CandidateGrid grid = draw_candidates({-half_m, -half_m}, {half_m, half_m}, cell_m, seed.child("trees"), draw);
    const float apart_m = 0.55F * flora.spacing_m;
    return hard_core(grid, apart_m + 4.0F, [&](const Candidate& a, const Candidate& b) {
        const float trunks =
            flora.species[a.species].trunk_radius_m * a.scale + flora.species[b.species].trunk_radius_m * b.scale;
        const float crowns =
            flora.species[a.species].crown_radius_m * a.scale + flora.species[b.species].crown_radius_m * b.scale;
        return std::min(std::max({apart_m, 0.42F * crowns, 3.0F * trunks}), apart_m + 4.0F);
    });
}

// Keeps the trees that matter most to the picture: near ones, in view, then the rest by chance.
void keep_most_seen(std::vector<Candidate>& trees, const FlightPlan& flight, std::size_t most) {
    if (trees.size() <= most) return;
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const View view = view_of(flight, trees[i].at_m);
        const bool is_seen = view.along_m > 0 && view.aside < 1.0F;
        const float far = view.to_way_m / 260.0F;
        order.emplace_back(trees[i].mark * (1.0F + far * far) + (is_seen ? 0.0F : 0.8F + 0.01F * view.to_way_m), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < most; ++i) kept.push_back(order[i].second);
    std::sort(kept.begin(), kept.end());
    std::vector<Candidate> fewer;
    for (const std::size_t i : kept) fewer.push_back(trees[i]);
    trees = std::move(fewer);
}

// A tree at each side of the picture, where the land allows it.
void frame_view(std::vector<Candidate>& trees, const scene::Land& land, const scene::Flora& flora,
                const Storeyed& kinds, const FlightPlan& flight, base::Seed seed) {
    const FlightPlan::Station& middle = flight.stations[flight.stations.size() / 2];
    const glm::vec2 aside{-middle.ahead.y, middle.ahead.x};
    for (const float side : {-1.0F, 1.0F}) {
        base::RandomStream random{seed.child("frame").child(side > 0 ? 1U : 0U)};
        for (int attempt = 0; attempt < 24; ++attempt) {
            Candidate c;
            const float along_m = random.between(20.0F, 52.0F);
            c.at_m = middle.at_m + along_m * middle.ahead +
                     side * (along_m * random.between(0.48F, 0.72F) + random.between(6.0F, 16.0F)) * aside;
            c.scale = random.between(0.95F, 1.22F);
            c.species = kinds.trees.front();
            c.mark = 0;
            const scene::Species& species = flora.species[c.species];
            if (!is_on_land(land, c.at_m) || is_in_the_way(flight, c.at_m, 0.8F * species.crown_radius_m * c.scale))
                continue;
            if (scene::water_depth_m(land, c.at_m) > 0) continue;
            if (welfare(species, scene::ground_height_m(land, c.at_m), slope_at(land, c.at_m)) <= 0.2F) continue;
            const float apart_m = std::max(0.6F * species.crown_radius_m * c.scale, 2.5F);
            trees.erase(std::remove_if(trees.begin(), trees.end(),
                                       [&](const Candidate& t) {
                                           return t.mark > 0 && glm::length(t.at_m - c.at_m) < apart_m + 2.0F;
                                       }),
                        trees.end());
            trees.push_back(c);
            break;
        }
    }
}

std::vector<Candidate> undergrowth(const scene::Land& land, const scene::Flora& flora,
                                   std::span<const std::uint32_t> kinds, const FlightPlan& flight,
                                   std::span<const Candidate> trees, float cell_m, float reach_m, base::Seed seed) {
    if (kinds.empty()) return {};
    const noise::Key patches(seed.child("patches"));
    glm::vec2 low{1.0e6F};
    glm::vec2 high{-1.0e6F};
    for (const FlightPlan::Station& station : flight.stations) {
        low = glm::min(low, station.at_m - reach_m);
        high = glm::max(high, station.at_m + reach_m);
    }
    const auto draw = [&](Candidate& c, base::RandomStream& random) {
        const float mark = random.unit_f();
        const float kind = random.unit_f();
        const float stay = random.unit_f();
        c.scale = random.between(0.65F, 1.3F);
        if (!is_on_land(land, c.at_m)) return;
        const View view = view_of(flight, c.at_m);
        if (view.along_m < 1.0F || view.aside > 1.15F || view.to_way_m > reach_m || view.to_way_m < 2.2F) return;
        const float height_m = scene::ground_height_m(land, c.at_m);
        if (height_m < kShore_m || scene::water_depth_m(land, c.at_m) > 0) return;
        const float nearness = 1.0F - view.to_way_m / reach_m;
        const float patch = 0.55F + 2.4F * noise::fbm(patches, c.at_m.x / 11.0F, c.at_m.y / 11.0F, {.count = 2});
        float well = 0;
        c.species = choose_species(flora, kinds, height_m, slope_at(land, c.at_m), kind, well);
        if (stay > std::clamp(patch, 0.05F, 1.0F) * well * nearness * 1.3F) return;
        for (const Candidate& tree : trees)
            if (glm::length(tree.at_m - c.at_m) < flora.species[tree.species].trunk_radius_m * tree.scale * 2.0F +
                                                      0.35F * flora.species[c.species].crown_radius_m)
                return;
        c.mark = mark;
    };
    const CandidateGrid grid = draw_candidates(low, high, cell_m, seed, draw);
    return hard_core(grid, 0.6F * cell_m, [cell_m](const Candidate&, const Candidate&) { return 0.5F * cell_m; });
}

}  // namespace

std::vector<scene::Plant> plant_land(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight,
                                     base::Seed seed) {
    const Storeyed kinds = by_storey(flora);
    std::vector<Candidate> trees;
    if (!kinds.trees.empty()) {
        trees = tree_candidates(land, flora, kinds, flight, seed);
        keep_most_seen(trees, flight, kMostTrees - 2);
        frame_view(trees, land, flora, kinds, flight, seed);
    }
    std::vector<Candidate> shrubs =
        undergrowth(land, flora, kinds.shrubs, flight, trees, 5.5F, 150.0F, seed.child("shrubs"));
    std::vector<Candidate> herbs =
        undergrowth(land, flora, kinds.herbs, flight, trees, 0.62F, 40.0F, seed.child("herbs"));
    keep_most_seen(shrubs, flight, kMostUndergrowth / 6);
    keep_most_seen(herbs, flight, kMostUndergrowth - shrubs.size());

    std::vector<scene::Plant> plants;
    for (const auto* storey : {&trees, &shrubs, &herbs}) {
        for (const Candidate& c : *storey) {
            base::RandomStream random{
                base::Seed{base::hash_of(seed, std::lround(c.at_m.x * 64), std::lround(c.at_m.y * 64))}};
            scene::Plant plant;
            plant.species = c.species;
            plant.root_m = {c.at_m.x, scene::ground_height_m(land, c.at_m), c.at_m.y};
            plant.yaw_rad = random.between(0, glm::radians(360.0F));
            plant.scale = c.scale;
            plant.tint = random.between(-1, 1);
            plant.delay = random.unit_f();
            plants.push_back(plant);
        }
    }
    std::stable_sort(plants.begin(), plants.end(),
                     [](const scene::Plant& a, const scene::Plant& b) { return a.species < b.species; });
    return plants;
}

}  // namespace quadrat::synthesis
