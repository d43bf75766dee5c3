// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

#include "mesh/image.hpp"

namespace quadrat::scene {

// A picture of sRGB colours and of wetness, as photographs are kept: every pixel has its own brightness, four share hue
// and wetness, which change more slowly. 1.75 bytes a pixel instead of 4: a visit holds ten of them.
class GroundColours {
  public:
    GroundColours() = default;                        // none
    explicit GroundColours(const mesh::Image& rgba);  // alpha: wetness

    int width() const { return width_; }
    int height() const { return height_; }
    bool is_empty() const { return brightness_.empty(); }
    glm::u8vec3 colour(int x, int y) const;
    std::uint8_t wetness(int x, int y) const { return shared(x, y)[2]; }
    // A row of the picture halved so often, each pixel the mean of what it covers. to: 4 bytes a pixel, the last 0.
    void mean_row(int halvings, int row, std::span<std::uint8_t> to) const;

    friend bool operator==(const GroundColours&, const GroundColours&) = default;

  private:
    using Shared = std::array<std::uint8_t, 3>;  // orange over blue and green over purple, 128 is neither; wetness
    const Shared& shared(int x, int y) const {
        return shared_[static_cast<std::size_t>((y >> 1) * ((width_ + 1) >> 1) + (x >> 1))];
    }
    int brightness(int x, int y) const { return brightness_[static_cast<std::size_t>(y * width_ + x)]; }

    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint8_t> brightness_;
    std::vector<Shared> shared_;
};

}  // namespace quadrat::scene
