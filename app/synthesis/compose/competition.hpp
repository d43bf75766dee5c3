// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::synthesis {

// Who would stand where. Of two that are too near to each other the one of the lower mark stands.
struct Candidate {
    glm::vec2 at_m{0};
    float mark = 9;  // 0 best; 9: no plant here
    std::uint32_t species = 0;
    float scale = 1;
    bool is_young = false;
    std::optional<float> yaw_rad{};  // where it must stand so; else by chance
};

// Every cell's candidate within a window, cells numbered from the world's middle, so that a place keeps its candidate
// whatever window is drawn. Those that came to nothing are left out; cells whose middle may(middle) denies are not
// drawn.
template <typename May, typename Draw>
std::vector<Candidate> draw_candidates(glm::vec2 low_m, glm::vec2 high_m, float cell_m, base::Seed seed, const May& may,
                                       const Draw& draw) {
    const auto first = [cell_m](float m) { return static_cast<int>(std::floor(m / cell_m)); };
    const int x0 = first(low_m.x);
    const int y0 = first(low_m.y);
    const int columns = first(high_m.x) - x0 + 1;
    const int rows = first(high_m.y) - y0 + 1;
    std::vector<std::vector<Candidate>> drawn(static_cast<std::size_t>(std::max(rows, 0)));
    oneapi::tbb::parallel_for(0, rows, [&](int row) {
        for (int column = 0; column < columns; ++column) {
            if (!may(cell_m * (glm::vec2{x0 + column, y0 + row} + 0.5F))) continue;
            base::RandomStream random{base::Seed{base::hash_of(seed, x0 + column, y0 + row)}};
            Candidate c;
            c.at_m = cell_m * glm::vec2{static_cast<float>(x0 + column) + random.unit_f(),
                                        static_cast<float>(y0 + row) + random.unit_f()};
            draw(c, random);
            if (c.mark < 9) drawn[static_cast<std::size_t>(row)].push_back(c);
        }
    });
    std::vector<Candidate> all;
    for (const auto& row : drawn) all.insert(all.end(), row.begin(), row.end());
    return all;
}

// In the order of their marks, each stands that has room.
template <typename Apart>
std::vector<Candidate> compete(std::vector<Candidate> candidates, float reach_m, const Apart& apart_m) {
    if (candidates.empty()) return candidates;
    oneapi::tbb::parallel_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        if (a.mark != b.mark) return a.mark < b.mark;
        return a.at_m.x != b.at_m.x ? a.at_m.x < b.at_m.x : a.at_m.y < b.at_m.y;
    });
    glm::vec2 low = candidates.front().at_m;
    glm::vec2 high = low;
    for (const Candidate& c : candidates) {
        low = glm::min(low, c.at_m);
        high = glm::max(high, c.at_m);
    }
    // No cell is narrower than the reach, and there are no more of them than candidates by far.
    const glm::vec2 size = high - low;
    const float cell_m = std::max(reach_m, std::sqrt(size.x * size.y / (2.0F * static_cast<float>(candidates.size()))));
    const int columns = static_cast<int>(size.x / cell_m) + 1;
    const int rows = static_cast<int>(size.y / cell_m) + 1;
    // Lists of those that stand, a chain a cell.
    std::vector<std::int32_t> head(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), -1);
    const auto cell_of = [&](glm::vec2 at) {
        const glm::vec2 unit = (at - low) / cell_m;
        return glm::ivec2{std::min(static_cast<int>(unit.x), columns - 1),
                          std::min(static_cast<int>(unit.y), rows - 1)};
    };
    std::vector<std::int32_t> next;
    std::vector<Candidate> standing;
    const auto has_room = [&](const Candidate& c) {
        const glm::ivec2 own = cell_of(c.at_m);
        for (int y = std::max(own.y - 1, 0); y <= std::min(own.y + 1, rows - 1); ++y) {
            for (int x = std::max(own.x - 1, 0); x <= std::min(own.x + 1, columns - 1); ++x) {
                for (std::int32_t i = head[static_cast<std::size_t>(y * columns + x)]; i >= 0;
                     i = next[static_cast<std::size_t>(i)]) {
                    const Candidate& other = standing[static_cast<std::size_t>(i)];
                    const glm::vec2 d = other.at_m - c.at_m;
                    const float apart = std::min(apart_m(c, other), reach_m);
                    if (glm::dot(d, d) < apart * apart) return false;
                }
            }
        }
        return true;
    };
    for (const Candidate& c : candidates) {
        if (!has_room(c)) continue;
        const glm::ivec2 own = cell_of(c.at_m);
        std::int32_t& first = head[static_cast<std::size_t>(own.y * columns + own.x)];
        next.push_back(first);
        first = static_cast<std::int32_t>(standing.size());
        standing.push_back(c);
    }
    return standing;
}

}  // namespace quadrat::synthesis
