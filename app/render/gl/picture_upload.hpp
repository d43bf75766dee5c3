// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>

#include "mesh/image.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"

namespace quadrat::render::gl {

// Adds the slices that fill texture, all levels, with image, which lives until the last of them is done. The texture is
// made by the first slice; its address must stay.
void add_picture(Slices& slices, Texture2D& texture, std::shared_ptr<const mesh::Image> image, Meaning meaning,
                 Wrap wrap_s, Wrap wrap_t);

// The same for an image that is worked out by the slices themselves, row by row: paint(image, row).
void add_painting(Slices& slices, Texture2D& texture, int width, int height, int channels, Meaning meaning, Wrap wrap_s,
                  Wrap wrap_t, const std::function<void(mesh::Image&, int row)>& paint);

}  // namespace quadrat::render::gl
