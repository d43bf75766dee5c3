// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <vector>

#include "mesh/field.hpp"
#include "synthesis/compose/competition.hpp"
#include "synthesis/noise/automaton.hpp"
#include "synthesis/noise/gradient.hpp"

// What is asked at many places over one land, worked out once.
namespace quadrat::synthesis {

// fBm over a window, worked out on a grid and read between its samples: many places ask for it.
class NoiseMap {
  public:
    NoiseMap(base::Seed seed, glm::vec2 low_m, glm::vec2 high_m, float scale_m, int octaves)
        : low_m_(low_m), cell_m_(scale_m / 7) {
        const glm::vec2 size = glm::max(high_m - low_m, glm::vec2{cell_m_}) / cell_m_;
        map_ = mesh::Field(static_cast<int>(size.x) + 2, static_cast<int>(size.y) + 2);
        const noise::Key key(seed);
        oneapi::tbb::parallel_for(0, map_.rows, [&](int row) {
            const auto columns = static_cast<std::size_t>(map_.columns);
            std::vector<float> xs(columns);
            const std::vector<float> ys(columns, (low_m.y + static_cast<float>(row) * cell_m_) / scale_m);
            for (std::size_t i = 0; i < columns; ++i) xs[i] = (low_m.x + static_cast<float>(i) * cell_m_) / scale_m;
            noise::fbm(key, xs, ys, {&map_.at(0, row), columns}, {.count = octaves});
        });
    }
    float at(glm::vec2 at_m) const {
        return mesh::sample(map_, (at_m.x - low_m_.x) / cell_m_, (at_m.y - low_m_.y) / cell_m_);
    }

  private:
    glm::vec2 low_m_;
    float cell_m_;
    mesh::Field map_;
};

// How old the forest is at a place: 0 just burnt to 1 old, which it all is without fires.
class StandAges {
  public:
    StandAges(float fires, float half_m, base::Seed seed) : half_m_(half_m) {
        if (fires > 0) ages_ = noise::forest_ages(kSide, fires, seed);
    }
    float at(glm::vec2 at_m) const {
        if (ages_.samples.empty()) return 1;
        const glm::vec2 cell = (at_m / half_m_ + 1.0F) * (0.5F * kSide) - 0.5F;
        return mesh::sample(ages_, cell.x, cell.y);
    }

  private:
    static constexpr int kSide = 56;
    float half_m_;
    mesh::Field ages_;
};

// The trees about a place, without asking all of them.
class Near {
  public:
    Near(std::span<const Candidate> trees, float half_m)
        : half_m_(half_m), side_(static_cast<int>(2 * half_m / kCell_m) + 1) {
        cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        for (const Candidate& tree : trees)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) cells_[index(tree.at_m + kCell_m * glm::vec2{dx, dy})].push_back(tree);
    }
    std::span<const Candidate> around(glm::vec2 at) const { return cells_[index(at)]; }

  private:
    static constexpr float kCell_m = 8;
    std::size_t index(glm::vec2 at) const {
        const auto cell = [this](float m) {
            return std::clamp(static_cast<int>((m + half_m_) / kCell_m), 0, side_ - 1);
        };
        return static_cast<std::size_t>(cell(at.y) * side_ + cell(at.x));
    }
    float half_m_;
    int side_;
    std::vector<std::vector<Candidate>> cells_;
};

}  // namespace quadrat::synthesis
