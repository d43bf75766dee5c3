// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "render/gl/picture_upload.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/ground_brush.hpp"
#include "scene/night_eye.hpp"

namespace quadrat::render::passes {
namespace {

// The ground's grain in the light of the sun, which stands still: what faces it is brighter than level ground, what
// turns away darker.
void light_grain_row(const scene::Land& land, glm::vec3 to_sun, mesh::Image& lit, int row) {
    const glm::vec2 tilt = glm::vec2{to_sun.x, to_sun.z} / std::max(to_sun.y, 0.35F);
    const int channels = land.detail.channels;
    for (int x = 0; x < lit.width; ++x) {
        for (int kind = 0; kind < 2; ++kind) {
            float light = static_cast<float>(land.detail.pixel(x, row)[std::min(kind, channels - 1)]);
            if (!land.detail_slopes.bytes.empty()) {
                const std::uint8_t* slopes = land.detail_slopes.pixel(x, row) + 2 * kind;
                const glm::vec2 rise{static_cast<float>(slopes[0]) - 128, static_cast<float>(slopes[1]) - 128};
                light -= glm::dot(rise, tilt);
            }
            lit.pixel(x, row)[kind] = static_cast<std::uint8_t>(std::clamp(light + 0.5F, 0.0F, 255.0F));
        }
    }
}

// The grain once more, larger and turned, is a relief of metres that the ground's picture holds itself: tiles of it to
// one of the grain.
constexpr float kReliefTiles = 0.107F;

constexpr int kPixelsOfLight = 4;  // a side, to one of the light's, at most

// As coarse as its light: no more of it would be seen.
int halvings(const scene::Land& land, const mesh::Image& light) {
    int count = 0;
    while (land.albedo.width() >> count > kPixelsOfLight * light.width) ++count;
    return count;
}

// None, where there are no kinds: soft ground.
std::shared_ptr<const mesh::Image> kinds_of(const std::shared_ptr<const scene::Land>& land) {
    if (!land->kinds.bytes.empty()) return {land, &land->kinds};
    auto soft = std::make_shared<mesh::Image>(1, 1, 2);
    soft->bytes = {255, 0};
    return soft;
}

// It scatters back what light falls on it from above.
glm::vec3 shallow_shown(const scene::Scene& scene) {
    const scene::Sky& sky = *scene.sky;
    const glm::vec3 on_water = sky.ambient.on({0, 1, 0}) + sky.sunlight * std::max(sky.sun_direction.y, 0.0F);
    return encode(scene::seen_by_night(scene.land->shallow_colour, scene::colour_seen(sky.darkness)) * on_water);
}

}  // namespace

void add_grain(gl::Slices& slices, GrainOnGpu& grain, const std::shared_ptr<gl::TexturePool>& pool,
               const std::shared_ptr<const scene::Land>& land, glm::vec3 to_sun) {
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = land->detail.width;
    tiled.height = land->detail.height;
    tiled.channels = 2;
    const auto lit = gl::add_painting(slices, grain.lit, pool, tiled, [land, to_sun](mesh::Image& to, int row) {
        light_grain_row(*land, to_sun, to, row);
    });
    slices.prepare([&grain, lit] { grain.coarser = std::make_shared<mesh::Image>(gl::halved(*lit)); });
}

void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture, const std::shared_ptr<gl::TexturePool>& pool,
                        const std::shared_ptr<const scene::Scene>& scene) {
    const scene::Land& land = *scene->land;
    gl::TextureShape shape;
    const int halved = halvings(land, scene->light.ground);
    shape.width = land.albedo.width() >> halved;
    shape.height = land.albedo.height() >> halved;
    shape.coarsest = 16;  // no view is so high above a land that all of it has fewer pixels
    const auto brush = std::make_shared<std::optional<GroundBrush>>();
    const auto kinds = kinds_of(scene->land);
    slices.prepare([brush, &picture, scene, kinds, shape] {
        const float tiles = kReliefTiles * scene->land->side_m() / scene->land->detail_tile_m;
        const GroundBrush::Sheet sheet{scene->land->albedo,
                                       scene->light.ground,
                                       *kinds,
                                       *picture.grain->coarser,
                                       tiles,
                                       shallow_shown(*scene),
                                       0.85F,
                                       &scene->land->height_m,
                                       scene->land->cell_m,
                                       scene->flora->cover.withered,
                                       scene::colour_seen(scene->sky->darkness)};
        brush->emplace(sheet, glm::ivec2{shape.width, shape.height});
    });
    gl::add_painting(slices, picture.lit, pool, shape,
                     [brush](mesh::Image& image, int row) { (*brush)->paint(image, row); });
}

}  // namespace quadrat::render::passes
