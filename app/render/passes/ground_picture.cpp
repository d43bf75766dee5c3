// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <initializer_list>

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

constexpr int kBandRows = 64;
constexpr int kPixelsOfLight = 4;  // a side, to one of the light's, at most
// What a GPU does while it paints a pixel, in bytes it could have been brought instead.
constexpr std::size_t kPaintedBytes = 8;

}  // namespace

void add_material(gl::Slices& slices, MaterialOnGpu& material, const std::shared_ptr<const scene::Land>& land) {
    gl::TextureShape shape;
    shape.width = land->albedo.width;
    shape.height = land->albedo.height;
    shape.sampling = gl::Sampling::Flat;
    gl::add_painting(slices, material.roots, shape, [land](mesh::Image& roots, int row) {
        const std::uint8_t* from = land->albedo.pixel(0, row);
        std::uint8_t* to = roots.pixel(0, row);
        for (int i = 0; i < 4 * roots.width; ++i) to[i] = gl::root_of_srgb(from[i]);
    });
    std::shared_ptr<const mesh::Image> kinds{land, &land->kinds};
    if (kinds->bytes.empty()) {
        auto soft = std::make_shared<mesh::Image>(1, 1, 2);
        soft->bytes = {255, 0};
        kinds = soft;
    }
    gl::TextureShape flat;
    flat.sampling = gl::Sampling::Flat;
    gl::add_picture(slices, material.kinds, kinds, flat);
}

GroundPainter::GroundPainter() : program_("paint_ground.vert", "paint_ground.frag") {}

void GroundPainter::paint(const Sheet& sheet, const GroundPictureOnGpu& picture, int first_row, int rows) const {
    const gl::TextureShape& shape = picture.lit.shape();
    const auto drawing = target_.onto(picture.lit);
    glScissor(0, first_row, shape.width, rows);
    glEnable(GL_SCISSOR_TEST);
    program_.use();
    glUniform1f(0, sheet.relief_tiles);
    const float rim = 1 - 2 / static_cast<float>(std::min(shape.width, shape.height));
    glUniform2f(1, 0.5F * kGrain, rim);
    const gl::TextureShape& kinds = sheet.material.kinds.shape();
    glUniform2f(2, static_cast<float>(kinds.width), static_cast<float>(kinds.height));
    sheet.material.roots.bind(0);
    sheet.material.kinds.bind(1);
    sheet.light.bind(2);
    picture.grain.bind(3);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
}

void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture,
                        const std::shared_ptr<const GroundPainter>& painter,
                        const std::shared_ptr<const MaterialOnGpu>& material,
                        const std::shared_ptr<const scene::Scene>& scene) {
    const scene::Land& land = *scene->land;
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = land.detail.width;
    tiled.height = land.detail.height;
    tiled.channels = 2;
    gl::add_painting(slices, picture.grain, tiled, [scene](mesh::Image& grain, int row) {
        light_grain_row(*scene->land, scene->sky->sun_direction, grain, row);
    });
    const auto light = std::make_shared<gl::Texture2D>();
    gl::TextureShape flat;
    flat.sampling = gl::Sampling::Flat;
    gl::add_picture(slices, *light, {scene, &scene->light.ground}, flat);
    gl::TextureShape shape;
    // As coarse as its light: no more of it would be seen.
    shape.width = std::min(land.albedo.width, kPixelsOfLight * scene->light.ground.width);
    shape.height = std::min(land.albedo.height, kPixelsOfLight * scene->light.ground.height);
    slices.add(0, [&picture, shape] { picture.lit = gl::Texture2D{shape}; });
    const float tiles = kReliefTiles * land.side_m() / land.detail_tile_m;
    slices.add_pieces(
        static_cast<std::size_t>(shape.height), kBandRows, kPaintedBytes * static_cast<std::size_t>(shape.width),
        [&picture, painter, light, material, tiles](std::size_t first, std::size_t rows) {
            painter->paint({*light, *material, tiles}, picture, static_cast<int>(first), static_cast<int>(rows));
        });
    slices.add(kPaintedBytes / 4 * static_cast<std::size_t>(shape.width * shape.height),
               [&picture] { picture.lit.fill_levels(); });
}

}  // namespace quadrat::render::passes
