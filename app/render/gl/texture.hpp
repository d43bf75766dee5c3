// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "mesh/image.hpp"
#include "render/gl/handles.hpp"

namespace quadrat::render::gl {

enum class Wrap { Repeat, Clamp };
// Sharp: bilinear in the nearest mipmap, half the price of Smooth, trilinear. Flat: no mipmaps, for what is never seen
// smaller than it is.
enum class Sampling { Smooth, Sharp, Flat };

struct TextureShape {
    int width = 1;
    int height = 1;
    int channels = 4;  // 1, 2 or 4
    Wrap wrap_s = Wrap::Clamp;
    Wrap wrap_t = Wrap::Clamp;
    Sampling sampling = Sampling::Sharp;
    int coarsest = 1;  // of a side: no mipmaps below that

    int levels() const;
    friend bool operator==(const TextureShape&, const TextureShape&) = default;
};

// Immutable storage, written level by level and band by band.
class Texture2D {
  public:
    Texture2D() = default;  // none
    explicit Texture2D(const TextureShape& shape);

    // rows of one level, from the top, tightly packed.
    void write_rows(int level, int first_row, int rows, std::span<const std::uint8_t> bytes) const;
    // All coarser levels from the finest, by the GPU.
    void fill_levels() const;
    void bind(GLuint unit) const;
    GLuint name() const { return name_.get(); }
    const TextureShape& shape() const { return shape_; }
    int width(int level) const { return std::max(shape_.width >> level, 1); }
    int height(int level) const { return std::max(shape_.height >> level, 1); }

  private:
    TextureName name_;
    TextureShape shape_;
};

// sRGB bytes as the bytes of the square roots of the same linear light.
const std::array<std::uint8_t, 256>& roots_of_srgb();
inline std::uint8_t root_of_srgb(std::uint8_t encoded) { return roots_of_srgb()[encoded]; }

// The next coarser level: each pixel the mean of four (of fewer at odd borders).
mesh::Image halved(const mesh::Image& image);

}  // namespace quadrat::render::gl
