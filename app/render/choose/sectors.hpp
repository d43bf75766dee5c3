// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "render/choose/frustum.hpp"
#include "render/choose/ranges.hpp"

namespace quadrat::render::choose {

// A mesh all around the eye, ordered by equal sectors about the vertical: what lies beside and behind the view is left
// out.
class Sectors {
  public:
    Sectors() = default;
    // ways: of the vertices of each sector, from the apex.
    Sectors(std::vector<std::vector<glm::vec3>> ways, std::size_t indices_a_sector)
        : ways_(std::move(ways)), indices_a_sector_(indices_a_sector) {}

    // Neighbours in one range. of_each: of a sector's indices, those that are asked for.
    std::vector<Range> seen(const Frustum& frustum, glm::vec3 apex_m) const {
        return seen(frustum, apex_m, {0, indices_a_sector_});
    }
    std::vector<Range> seen(const Frustum& frustum, glm::vec3 apex_m, const Range& of_each) const {
        std::vector<Range> ranges;
        for (std::size_t sector = 0; sector < ways_.size(); ++sector) {
            if (!frustum.may_see_cone(apex_m, ways_[sector])) continue;
            const std::size_t first = sector * indices_a_sector_ + of_each.first;
            if (!ranges.empty() && ranges.back().first + ranges.back().count == first)
                ranges.back().count += of_each.count;
            else
                ranges.push_back({first, of_each.count});
        }
        return ranges;
    }

  private:
    std::vector<std::vector<glm::vec3>> ways_;
    std::size_t indices_a_sector_ = 0;
};

}  // namespace quadrat::render::choose
