// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "render/gl/texture.hpp"

namespace quadrat::render::gl {

// Textures that are taken again when nobody holds them any more. A software rasteriser clears a new one at once, some
// thousand pages that the system has to find for it first: longer than all else that a frame does.
class TexturePool {
  public:
    // No more than so many that nobody holds are kept, beside the one that is asked for.
    explicit TexturePool(std::size_t most_free) : most_free_(most_free) {}

    // Of this shape, nobody else's as long as it is held; what is in it is left from before.
    std::shared_ptr<const Texture2D> take(const TextureShape& shape);
    void trim(std::size_t most_free);

  private:
    std::size_t most_free_;
    std::vector<std::shared_ptr<const Texture2D>> textures_;
};

}  // namespace quadrat::render::gl
