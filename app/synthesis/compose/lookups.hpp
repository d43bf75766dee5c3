// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "mesh/field.hpp"
#include "scene/flora.hpp"
#include "synthesis/compose/competition.hpp"
#include "synthesis/compose/kinds_of_plants.hpp"
#include "synthesis/noise/automaton.hpp"
#include "synthesis/noise/fairy_rings.hpp"
#include "synthesis/noise/gradient.hpp"
#include "synthesis/noise/lateral_inhibition.hpp"

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

// Ground on which what stands keeps others off (lateral inhibition): the share of it that is nearer to none of its
// middles, 0 to 1, which lie about so far apart.
class EvenMap {
  public:
    EvenMap(float share, float apart_m, base::Seed seed) : sample_m_(apart_m / noise::kPeakSpacing) {
        if (share > 0) ranks_ = noise::ranks_of(noise::inhibited({}, seed, kSide));
    }
    bool is_empty() const { return ranks_.samples.empty(); }
    float at(glm::vec2 at_m) const {
        const glm::vec2 at = at_m / sample_m_;
        const glm::vec2 low = glm::floor(at);
        const glm::vec2 t = at - low;
        const auto sample = [&](int dx, int dy) {
            const auto wrapped = [](float v, int d) { return ((static_cast<int>(v) + d) % kSide + kSide) % kSide; };
            return ranks_.at(wrapped(low.x, dx), wrapped(low.y, dy));
        };
        return glm::mix(glm::mix(sample(0, 0), sample(1, 0), t.x), glm::mix(sample(0, 1), sample(1, 1), t.x), t.y);
    }

  private:
    static constexpr int kSide = 64;
    float sample_m_;
    mesh::Field ranks_;
};

// Where a fungus in the ground bears mushrooms: rings, over and over.
class RingMap {
  public:
    explicit RingMap(base::Seed seed) : fungus_(noise::fairy_rings({}, seed, kSide)) {}
    bool has_any(glm::vec2 at_m) const {
        const auto wrapped = [](float v) { return ((static_cast<int>(std::floor(v)) % kSide) + kSide) % kSide; };
        return fungus_.at(wrapped(at_m.x / kSample_m), wrapped(at_m.y / kSample_m)) > kBears;
    }

  private:
    static constexpr int kSide = 96;
    static constexpr float kSample_m = 0.3F;
    static constexpr float kBears = 0.12F;
    mesh::Field fungus_;
};

// How far ground is from being a clearing, spread as noise is: by chance, or as far from others as they keep it.
class Glades {
  public:
    Glades(const scene::Stand& stand, float half_m, base::Seed seed)
        : by_chance_(seed.child("clearings"), glm::vec2{-half_m}, glm::vec2{half_m}, stand.grove_m / 1.3F, 2),
          even_(stand.even_clearings, stand.grove_m, seed.child("glades")),
          share_(stand.even_clearings),
          ragged_m_(0.5F * stand.grove_m) {}
    float at(glm::vec2 at_m, const NoiseMap& groves) const {
        const float by_chance = by_chance_.at(at_m);
        if (even_.is_empty()) return by_chance;
        const glm::vec2 off_m = ragged_m_ * glm::vec2{groves.at(at_m), by_chance};
        return glm::mix(by_chance, quantile(1 - even_.at(at_m + off_m)), share_);
    }

  private:
    NoiseMap by_chance_;
    EvenMap even_;
    float share_;
    float ragged_m_;
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
