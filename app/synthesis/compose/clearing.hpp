// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/settlement.hpp"

namespace quadrat::synthesis {

// The share of trees that people leave about their houses: few, and those for shade and fruit.
class Clearing {
  public:
    explicit Clearing(const scene::Settlement& settlement) {
        for (const scene::House& house : settlement.houses) {
            const glm::vec2 at{house.foot_m.x, house.foot_m.z};
            low_m_ = houses_m_.empty() ? at : glm::min(low_m_, at);
            high_m_ = houses_m_.empty() ? at : glm::max(high_m_, at);
            houses_m_.push_back(at);
        }
    }
    float left_at(glm::vec2 at_m) const {
        if (houses_m_.empty()) return 1;
        const glm::vec2 off = glm::max(glm::max(low_m_ - at_m, at_m - high_m_), glm::vec2{0});
        if (std::max(off.x, off.y) > kReach_m) return 1;
        float least2 = kReach_m * kReach_m;
        for (const glm::vec2 house : houses_m_) {
            const glm::vec2 d = at_m - house;
            least2 = std::min(least2, glm::dot(d, d));
        }
        return 0.10F + 0.90F * glm::smoothstep(24.0F, kReach_m, std::sqrt(least2));
    }

  private:
    static constexpr float kReach_m = 54;
    std::vector<glm::vec2> houses_m_;
    glm::vec2 low_m_{0}, high_m_{0};
};

}  // namespace quadrat::synthesis
