// SPDX-License-Identifier: Apache-2.0
#include "render/passes/mirror.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

constexpr glm::ivec2 kSkyAlone{64, 32};
constexpr float kNoShore_m = 4000;

// Wind ruffles water up to its fill; a land may have water that no wind reaches.
float ripple_of(const scene::Scene& scene) {
    const float wind_m_s = glm::length(scene.sky->clouds[0].wind_m_s);
    return std::clamp(scene.land->ripple * (0.25F + 0.09F * wind_m_s), 0.0F, 1.0F);
}

MirrorBlock block_of(const scene::Scene& scene) {
    MirrorBlock block;
    block.place = {scene.mirror.at_m, scene.mirror.middle_rad};
    block.ripple = ripple_block(ripple_of(scene));
    block.shore_m = scene.mirror.shore_m;
    if (scene.mirror.light.bytes.empty()) block.shore_m.fill(kNoShore_m);
    return block;
}

// Light at a pixel of the picture.
glm::vec3 light_at(const scene::Scene& scene, int x, int y) {
    const mesh::Image& held_up = scene.mirror.light;
    if (!held_up.bytes.empty()) {
        const std::uint8_t* root = held_up.pixel(x, y);
        const glm::vec3 half = glm::vec3{root[0], root[1], root[2]} * (2.0F / 255);
        return half * half;
    }
    const float bearing = ((static_cast<float>(x) + 0.5F) / kSkyAlone.x - 0.5F) * scene::Mirror::kWide_rad;
    const float rise = scene::mirror_rise((static_cast<float>(y) + 0.5F) / kSkyAlone.y);
    return scene::mean_radiance(*scene.sky, glm::normalize(glm::vec3{std::sin(bearing), rise, -std::cos(bearing)}));
}

}  // namespace

glm::vec4 ripple_block(float ripple) {
    const float rough = 0.22F + 0.78F * ripple;
    return {0.024F + 0.132F * ripple, 41.0F * rough, 70.0F / rough, 2.8F * rough};
}

void add_mirror(gl::Slices& slices, MirrorOnGpu& mirror, const std::shared_ptr<gl::TexturePool>& pool,
                const std::shared_ptr<const scene::Scene>& scene) {
    const bool is_held_up = !scene->mirror.light.bytes.empty();
    gl::TextureShape shape;
    shape.width = is_held_up ? scene->mirror.light.width : kSkyAlone.x;
    shape.height = is_held_up ? scene->mirror.light.height : kSkyAlone.y;
    gl::add_painting(slices, mirror.picture, pool, shape, [scene](mesh::Image& to, int row) {
        for (int x = 0; x < to.width; ++x) {
            const glm::vec3 shown = encode(held(light_at(*scene, x, row) * scene->exposure));
            for (int c = 0; c < 3; ++c) to.pixel(x, row)[c] = unsigned_byte(shown[c]);
            to.pixel(x, row)[3] = 255;
        }
    });
    slices.add(sizeof(MirrorBlock), [&mirror, scene] {
        const MirrorBlock block = block_of(*scene);
        mirror.block = gl::Buffer{GL_UNIFORM_BUFFER, sizeof(MirrorBlock)};
        mirror.block.write<MirrorBlock>(0, std::span(&block, 1));
    });
}

}  // namespace quadrat::render::passes
