// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace quadrat::synthesis::voxels {

// How dark what grows makes the air below it, in cells of one internode (Palubicki et al. 2009, section 4.1): a leafy
// internode in cell (I, J, K) adds Δs = a b^-q to the cells (I ± p, J − q, K ± p), p ≤ q ≤ q_max. Whole numbers, so
// that shadows come and go in any order and leave nothing behind.
class ShadowGrid {
  public:
    struct Shade {
        float a = 0.22F;    // of a whole day's light, in its own cell
        float b = 1.5F;     // 1 or more
        int q_max = 4;      // 0 to 15
        float far = 0.01F;  // of the light, an internode in the 16 square internodes over a place
    };
    // From low, so many cells each way. What lies outside casts into it, and is lit.
    ShadowGrid(const Shade& shade, const glm::vec3& low, const glm::ivec3& cells);

    struct Change {
        glm::vec3 at;
        bool is_new;  // or fallen
    };
    // In parallel where there is much of it.
    void apply(std::span<const Change> changes);

    // The light that a bud gets there: what the far roof lets through of C − s + a, with C = 1 and between 0 and 1; a
    // for its own internode's shade.
    float light_at(const glm::vec3& at) const;
    // Toward more light: the shadows' negative gradient, in light per cell.
    glm::vec3 way_to_light(const glm::vec3& at) const;
    bool holds(const glm::vec3& at) const;

  private:
    static constexpr float kWhole = 8192;  // of these are full light
    glm::ivec3 cell_of(const glm::vec3& at) const;
    std::int32_t shadow_in(const glm::ivec3& cell) const;
    void shade_layer(int y, std::span<const Change> changes);
    void raise_roof();
    float roof_over(const glm::vec3& at) const;
    std::size_t flat(int x, int y, int z) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.z) + static_cast<std::size_t>(z)) *
                   static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(x);
    }

    std::size_t flat_block(int x, int y, int z) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(blocks_.z) + static_cast<std::size_t>(z)) *
                   static_cast<std::size_t>(blocks_.x) +
               static_cast<std::size_t>(x);
    }

    Shade shade_;
    glm::vec3 low_;
    glm::ivec3 cells_;
    std::vector<std::int32_t> added_;   // by q
    std::vector<std::int32_t> shadow_;  // a cell
    glm::ivec3 blocks_;                 // of 4 cells a side
    std::vector<std::int32_t> within_;  // a block: internodes
    std::vector<float> roof_;           // a block: internodes over it, those beside as they are seen from it
};

}  // namespace quadrat::synthesis::voxels
