// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>

#include "mesh/image.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/texture_pool.hpp"

// Colours are sRGB-encoded in an image. In our textures their bytes hold the square root of linear light, which a
// shader squares: decoding by the GPU is free on a Raspberry Pi, but keeps a software rasteriser from its fast path.
namespace quadrat::render::gl {

// Adds the slices that fill texture, all levels, with image, which lives until the last of them is done. The texture is
// made by the first piece; its address must stay.
void add_picture(Slices& slices, Texture2D& texture, const std::shared_ptr<const mesh::Image>& image,
                 const TextureShape& wanted);

// The same for an image that is worked out while everything is prepared, row by row: paint(image, row); into a texture
// of the pool. Returns the image; it is whole for what is prepared after it.
using Painter = std::function<void(mesh::Image&, int row)>;
std::shared_ptr<const mesh::Image> add_painting(Slices& slices, std::shared_ptr<const Texture2D>& texture,
                                                const std::shared_ptr<TexturePool>& pool, const TextureShape& shape,
                                                const Painter& paint);

}  // namespace quadrat::render::gl
