// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
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
};

// Every cell's candidate within a window, cells numbered from the world's middle, so that a place keeps its candidate
// whatever window is drawn. Those that came to nothing are left out.
template <typename Draw>
std::vector<Candidate> draw_candidates(glm::vec2 low_m, glm::vec2 high_m, float cell_m, base::Seed seed,
                                       const Draw& draw) {
    const auto first = [cell_m](float m) { return static_cast<int>(std::floor(m / cell_m)); };
    const int x0 = first(low_m.x);
    const int y0 = first(low_m.y);
    const int columns = first(high_m.x) - x0 + 1;
    const int rows = first(high_m.y) - y0 + 1;
    std::vector<std::vector<Candidate>> drawn(static_cast<std::size_t>(std::max(rows, 0)));
    oneapi::tbb::parallel_for(0, rows, [&](int row) {
        for (int column = 0; column < columns; ++column) {
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
std::vector<Candidate> compete(std::vector<Candidate> candidates, float reach_m, float half_m, const Apart& apart_m) {
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        if (a.mark != b.mark) return a.mark < b.mark;
        return a.at_m.x != b.at_m.x ? a.at_m.x < b.at_m.x : a.at_m.y < b.at_m.y;
    });
    const int side = std::max(static_cast<int>(2 * half_m / reach_m) + 1, 1);
    const auto cell = [&](float m) { return std::clamp(static_cast<int>((m + half_m) / reach_m), 0, side - 1); };
    // Lists of those that stand, a chain a cell.
    std::vector<std::int32_t> head(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), -1);
    std::vector<std::int32_t> next;
    std::vector<Candidate> standing;
    const auto has_room = [&](const Candidate& c) {
        const int cx = cell(c.at_m.x);
        const int cy = cell(c.at_m.y);
        for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, side - 1); ++y) {
            for (int x = std::max(cx - 1, 0); x <= std::min(cx + 1, side - 1); ++x) {
                for (std::int32_t i = head[static_cast<std::size_t>(y * side + x)]; i >= 0;
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
        std::int32_t& first = head[static_cast<std::size_t>(cell(c.at_m.y) * side + cell(c.at_m.x))];
        next.push_back(first);
        first = static_cast<std::int32_t>(standing.size());
        standing.push_back(c);
    }
    return standing;
}

}  // namespace quadrat::synthesis
