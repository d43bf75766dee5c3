// SPDX-License-Identifier: Apache-2.0
// Width and depth of a river by its discharge: L. Leopold & T. Maddock, "The hydraulic geometry of stream channels",
// 1953 (width as Q^0.5, depth as Q^0.4), discharge in proportion to the drained area.
#include "synthesis/land/rivers.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/land.hpp"
#include "synthesis/land/drainage.hpp"

namespace quadrat::synthesis::land {
namespace {

using scene::kNoWater;

// Hollows joined by the flood: lakes where they are deep and wide, filled with earth otherwise.
void settle_hollows(mesh::Field& h, const Drainage& d, const std::vector<float>& area_m2, float cell_m,
                    const FreshWaterOptions& options, mesh::Field& surface) {
    const auto count = h.samples.size();
    std::vector<std::uint8_t> is_seen(count, 0);
    std::vector<std::int32_t> hollow;
    const auto is_wet = [&](std::size_t i) { return d.spill_m.samples[i] > h.samples[i] + 1.0e-4F; };
    for (std::size_t seed = 0; seed < count; ++seed) {
        if (is_seen[seed] != 0 || !is_wet(seed)) continue;
        hollow.assign(1, static_cast<std::int32_t>(seed));
        is_seen[seed] = 1;
        const float level = d.spill_m.samples[seed];
        float deepest = 0;
        float most_area_m2 = 0;
        for (std::size_t k = 0; k < hollow.size(); ++k) {
            const std::int32_t cell = hollow[k];
            deepest = std::max(deepest, level - h.samples[cell]);
            most_area_m2 = std::max(most_area_m2, area_m2[cell]);
            const int x = cell % h.columns;
            const int y = cell / h.columns;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!h.is_inside(x + dx, y + dy)) continue;
                    const auto next = h.index(x + dx, y + dy);
                    if (is_seen[next] != 0 || !is_wet(next) || d.spill_m.samples[next] != level) continue;
                    is_seen[next] = 1;
                    hollow.push_back(static_cast<std::int32_t>(next));
                }
            }
        }
        if (options.hollows == Hollows::Seep && most_area_m2 < options.river_area_m2) continue;
        const float water_m2 = static_cast<float>(hollow.size()) * cell_m * cell_m;
        const bool is_lake = deepest >= options.lake_depth_m && water_m2 >= options.lake_area_m2;
        for (const std::int32_t cell : hollow) {
            if (is_lake)
                surface.samples[cell] = level;
            else
                h.samples[cell] = level;
        }
    }
}

struct Channel {
    float width_m = 0;
    float depth_m = 0;
};

Channel channel_of(float area_m2, const FreshWaterOptions& options) {
    const float hectares = area_m2 * 1.0e-4F;
    return {options.width * (1.0F + 1.25F * std::sqrt(hectares)),
            options.depth * (0.25F + 0.22F * std::pow(hectares, 0.4F))};
}

constexpr float kSteepReach = 0.24F;  // fall over run from which on a river leaps

// Of the way down from here over some cells.
float steepness(const mesh::Field& ground_m, const Drainage& d, std::int32_t cell, float cell_m) {
    std::int32_t at = cell;
    float run_m = 0;
    for (int i = 0; i < 5; ++i) {
        const std::int32_t to = d.receiver[at];
        const bool is_straight = to % ground_m.columns == at % ground_m.columns || std::abs(to - at) == 1;
        run_m += to == at ? 0.0F : cell_m * (is_straight ? 1.0F : 1.41421356F);
        at = to;
    }
    return run_m > 0 ? (ground_m.samples[cell] - ground_m.samples[at]) / run_m : 0.0F;
}

// Beds from the mouth upward: each no lower than the one it runs to.
void carve_rivers(mesh::Field& h, const Drainage& d, const std::vector<float>& area_m2, float cell_m,
                  const FreshWaterOptions& options, mesh::Field& surface) {
    const mesh::Field before = h;
    std::vector<float> bed_m(h.samples.size(), kNoWater);
    for (const std::int32_t cell : d.order) {
        const std::int32_t to = d.receiver[cell];
        if (to == cell || area_m2[cell] < options.river_area_m2 || before.samples[cell] <= options.sea_m) continue;
        if (surface.samples[cell] > kNoWater) continue;  // it runs through a lake
        const Channel channel = channel_of(area_m2[cell], options);
        const float below =
            bed_m[to] > kNoWater ? bed_m[to] : std::min(before.samples[to], before.samples[cell] - channel.depth_m);
        const float natural_m = before.samples[cell] - channel.depth_m;
        // Steep reaches run from pool to pool and fall between them: the bed stays level until it lies as deep in the
        // ground as a fall is high.
        const bool is_pool =
            natural_m > below && natural_m - below < options.fall_m && steepness(before, d, cell, cell_m) > kSteepReach;
        bed_m[cell] = is_pool ? below : std::max(below, natural_m);
        float& water_m = surface.samples[cell];
        water_m = std::max(bed_m[cell] + 0.65F * channel.depth_m, options.sea_m);
        water_m = std::max(water_m, surface.samples[to]);  // it never rises downstream
    }
    // Across the bed and up its banks.
    for (std::size_t i = 0; i < bed_m.size(); ++i) {
        if (bed_m[i] <= kNoWater) continue;
        const Channel channel = channel_of(area_m2[i], options);
        const int x = static_cast<int>(i) % h.columns;
        const int y = static_cast<int>(i) / h.columns;
        const float half_m = 0.5F * channel.width_m;
        const float bank_m = half_m + 2.5F * channel.depth_m + cell_m;
        const int reach = static_cast<int>(std::ceil(bank_m / cell_m));
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                // The border stays, where the land meets the country around it.
                const bool is_inner = x + dx > 0 && y + dy > 0 && x + dx < h.columns - 1 && y + dy < h.rows - 1;
                if (!is_inner) continue;
                const float away_m = cell_m * std::sqrt(static_cast<float>(dx * dx + dy * dy));
                const float up = std::clamp((away_m - half_m) / (bank_m - half_m), 0.0F, 1.0F);
                float& ground = h.at(x + dx, y + dy);
                const float old = before.at(x + dx, y + dy);
                if (old > bed_m[i]) ground = std::min(ground, bed_m[i] + up * up * (old - bed_m[i]));
            }
        }
    }
}

// How fast the water runs: by its fall; below a fall it is still white.
mesh::Field speeds_m_s(const Drainage& d, const mesh::Field& level, float cell_m) {
    constexpr float kFastest_m_s = 8;
    mesh::Field speed(level.columns, level.rows, 0.05F);
    for (std::size_t i = d.order.size(); i-- > 0;) {
        const std::int32_t cell = d.order[i];
        const std::int32_t to = d.receiver[cell];
        if (level.samples[cell] <= kNoWater || level.samples[to] <= kNoWater) continue;
        const float fall = (level.samples[cell] - level.samples[to]) / cell_m;
        if (fall > 1.0e-4F)
            speed.samples[cell] = std::max(speed.samples[cell], std::min(0.4F + 6.0F * fall, kFastest_m_s));
        if (fall > 0.5F) speed.samples[to] = std::max(speed.samples[to], 0.8F * speed.samples[cell]);
    }
    return speed;
}

// Where it lies no higher than the sea it is the sea that is seen.
mesh::Mesh surface_mesh(const mesh::Field& h, const Drainage& d, float cell_m, const mesh::Field& surface,
                        float sea_m) {
    constexpr float kOfTheSea_m = 0.02F;
    mesh::Mesh mesh;
    // Beyond its edge the water goes on at the level of the nearest wet sample, into the bank.
    mesh::Field level = surface;
    for (int y = 0; y < h.rows; ++y) {
        for (int x = 0; x < h.columns; ++x) {
            if (surface.at(x, y) > kNoWater) continue;
            float lowest = 1.0e6F;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (h.is_inside(x + dx, y + dy) && surface.at(x + dx, y + dy) > kNoWater)
                        lowest = std::min(lowest, surface.at(x + dx, y + dy));
            if (lowest < 1.0e5F) level.at(x, y) = lowest;
        }
    }
    const mesh::Field speed_m_s = speeds_m_s(d, level, cell_m);
    std::vector<std::uint32_t> vertex(h.samples.size(), 0);
    const float half = 0.5F * static_cast<float>(h.columns - 1);
    const auto vertex_at = [&](int x, int y) {
        std::uint32_t& number = vertex[h.index(x, y)];
        if (number != 0) return number - 1;
        mesh.positions_m.push_back(
            {(static_cast<float>(x) - half) * cell_m, level.at(x, y), (static_cast<float>(y) - half) * cell_m});
        const auto cell = static_cast<std::int32_t>(h.index(x, y));
        const std::int32_t to = d.receiver[cell];
        glm::vec2 way{static_cast<float>(to % h.columns - x), static_cast<float>(to / h.columns - y)};
        const float far = glm::length(way);
        mesh.texcoords.push_back(far > 0 ? way / far * speed_m_s.samples[cell] : glm::vec2{0});
        number = static_cast<std::uint32_t>(mesh.positions_m.size());
        return number - 1;
    };
    for (int y = 0; y + 1 < h.rows; ++y) {
        for (int x = 0; x + 1 < h.columns; ++x) {
            const bool touches = surface.at(x, y) > kNoWater || surface.at(x + 1, y) > kNoWater ||
                                 surface.at(x, y + 1) > kNoWater || surface.at(x + 1, y + 1) > kNoWater;
            const float highest_m =
                std::max({level.at(x, y), level.at(x + 1, y), level.at(x, y + 1), level.at(x + 1, y + 1)});
            if (!touches || highest_m < sea_m + kOfTheSea_m) continue;
            const std::uint32_t a = vertex_at(x, y);
            const std::uint32_t b = vertex_at(x + 1, y);
            const std::uint32_t c = vertex_at(x, y + 1);
            const std::uint32_t e = vertex_at(x + 1, y + 1);
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, e});
        }
    }
    // Kept for as long as the land is shown.
    mesh.positions_m.shrink_to_fit();
    mesh.texcoords.shrink_to_fit();
    mesh.indices.shrink_to_fit();
    return mesh;
}

}  // namespace

FreshWater make_fresh_water(mesh::Field& height_m, float cell_m, const FreshWaterOptions& options) {
    FreshWater water{mesh::Field(height_m.columns, height_m.rows, kNoWater),
                     mesh::Grid<Wet>(height_m.columns, height_m.rows, Wet::No),
                     {},
                     {}};
    const Drainage d = drain(height_m, options.sea_m);
    water.drained_area_m2 = drained_area_m2(d, cell_m);
    settle_hollows(height_m, d, water.drained_area_m2, cell_m, options, water.surface_m);
    for (std::size_t i = 0; i < water.kind.samples.size(); ++i)
        if (water.surface_m.samples[i] > kNoWater) water.kind.samples[i] = Wet::Lake;
    carve_rivers(height_m, d, water.drained_area_m2, cell_m, options, water.surface_m);
    for (std::size_t i = 0; i < water.kind.samples.size(); ++i)
        if (water.surface_m.samples[i] > kNoWater && water.kind.samples[i] == Wet::No)
            water.kind.samples[i] = Wet::River;
    water.mesh = surface_mesh(height_m, d, cell_m, water.surface_m, options.sea_m);
    return water;
}

mesh::Field height_over_water_m(const mesh::Field& height_m, const FreshWater& water) {
    mesh::Field over = height_m;
    for (int y = 0; y < over.rows; ++y) {
        for (int x = 0; x < over.columns; ++x) {
            const Wet kind = water.kind.at(x, y);
            if (kind == Wet::No) continue;
            const int reach = kind == Wet::Lake ? 4 : 2;
            const float level_m = water.surface_m.at(x, y);
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    if (over.is_inside(x + dx, y + dy))
                        over.at(x + dx, y + dy) =
                            std::min(over.at(x + dx, y + dy), height_m.at(x + dx, y + dy) - level_m);
        }
    }
    return over;
}

}  // namespace quadrat::synthesis::land
