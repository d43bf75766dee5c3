// SPDX-License-Identifier: Apache-2.0
#include "render/gl/texture_pool.hpp"

#include <algorithm>

namespace quadrat::render::gl {
namespace {

bool is_free(const std::shared_ptr<const Texture2D>& texture) { return texture.use_count() == 1; }

}  // namespace

std::shared_ptr<const Texture2D> TexturePool::take(const TextureShape& shape) {
    const auto found = std::ranges::find_if(
        textures_, [&](const auto& texture) { return is_free(texture) && texture->shape() == shape; });
    if (found != textures_.end()) return *found;
    trim(most_free_);  // of shapes that nobody asks for any more, too
    return textures_.emplace_back(std::make_shared<Texture2D>(shape));
}

void TexturePool::trim(std::size_t most_free) {
    auto free = static_cast<std::size_t>(std::ranges::count_if(textures_, is_free));
    std::erase_if(textures_, [&](const auto& texture) { return is_free(texture) && free-- > most_free; });
}

}  // namespace quadrat::render::gl
