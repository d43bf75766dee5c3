// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

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

// Square roots of linear colours, the picture's size. Alpha: the rim is as under deep water, for all beyond it repeats
// the rim.
mesh::Image roots_of_rows(const scene::GroundColours& colours, const gl::TextureShape& picture, int first, int count) {
    mesh::Image roots(picture.width, count, 4);
    int halvings = 0;
    while (colours.width() >> halvings > picture.width) ++halvings;
    for (int i = 0; i < count; ++i) {
        const std::size_t row_bytes = 4 * static_cast<std::size_t>(picture.width);
        const std::span<std::uint8_t> row(roots.pixel(0, i), row_bytes);
        colours.mean_row(halvings, first + i, row);
        for (std::uint8_t& byte : row) byte = gl::root_of_srgb(byte);
        const bool is_rim = first + i == 0 || first + i == picture.height - 1;
        for (std::size_t alpha = 3; alpha < row_bytes; alpha += is_rim ? 4 : row_bytes - 4) row[alpha] = 255;
    }
    return roots;
}

// What a GPU does while it paints a pixel, in bytes it could have been brought instead.
constexpr std::size_t kPaintedBytes = 8;

}  // namespace

void add_material(gl::Slices& slices, MaterialOnGpu& material, const std::shared_ptr<const scene::Land>& land) {
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

GroundPainter::GroundPainter()
    : program_("paint_ground.vert", "paint_ground.frag"), halving_("spread.vert", "halve.frag") {}

const gl::Texture2D& GroundPainter::band(int width) {
    if (band_.name() == 0 || band_.shape().width < width)
        band_ = gl::Texture2D{{.width = width, .height = kMostRows, .sampling = gl::Sampling::Flat}};
    return band_;
}

void GroundPainter::paint(const Sheet& sheet, const GroundPictureOnGpu& picture, int first_row, int rows) {
    const gl::TextureShape& shape = picture.lit.shape();
    const auto drawing = target_.onto(band(shape.width));
    glViewport(0, -first_row, shape.width, shape.height);  // its first row is the band's
    program_.use();
    glUniform1f(0, sheet.relief_tiles);
    glUniform1f(1, 0.5F * kGrain);
    const gl::TextureShape& kinds = sheet.material.kinds.shape();
    glUniform2f(2, static_cast<float>(kinds.width), static_cast<float>(kinds.height));
    // Of its own: what was brought for the band before may still be read.
    gl::Texture2D roots{{.width = shape.width, .height = rows, .sampling = gl::Sampling::Flat}};
    roots.write_rows(0, 0, rows, roots_of_rows(sheet.colours, shape, first_row, rows).bytes);
    roots.bind(0);
    sheet.material.kinds.bind(1);
    sheet.light.bind(2);
    picture.grain.bind(3);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    drawing.copy_to(picture.lit, 0, first_row, rows);
}

void GroundPainter::halve(const GroundPictureOnGpu& picture, int level, int first_row, int rows) {
    const auto drawing = target_.onto(band(picture.lit.width(level)));
    glViewport(0, -first_row, picture.lit.width(level), picture.lit.height(level));
    halving_.use();
    glUniform4f(0, 0, 0, 1, 1);
    glUniform1f(1, static_cast<float>(level - 1));
    picture.lit.bind(0);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    drawing.copy_to(picture.lit, level, first_row, rows);
}

void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture, const std::shared_ptr<GroundPainter>& painter,
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
    const int count = halvings(land, scene->light.ground);
    shape.width = land.albedo.width() >> count;
    shape.height = land.albedo.height() >> count;
    slices.add(0, [&picture, shape] { picture.lit = gl::Texture2D{shape}; });
    const float tiles = kReliefTiles * land.side_m() / land.detail_tile_m;
    const auto add_rows = [&slices](int height, std::size_t bytes, auto draw) {
        slices.add_pieces(
            static_cast<std::size_t>(height), GroundPainter::kMostRows, bytes,
            [draw](std::size_t first, std::size_t rows) { draw(static_cast<int>(first), static_cast<int>(rows)); });
    };
    const std::size_t painted = kPaintedBytes * static_cast<std::size_t>(shape.width);
    add_rows(shape.height, painted, [&picture, painter, light, material, scene, tiles](int first, int rows) {
        painter->paint({*light, *material, scene->land->albedo, tiles}, picture, first, rows);
    });
    int level = 1;
    for (; level < shape.levels() && shape.height >> level >= GroundPainter::kMostRows; ++level)
        add_rows(shape.height >> level, (painted / 2) >> level,
                 [&picture, painter, level](int first, int rows) { painter->halve(picture, level, first, rows); });
    slices.add(painted, [&picture, painter, level] {
        for (int coarse = level; coarse < picture.lit.shape().levels(); ++coarse)
            painter->halve(picture, coarse, 0, picture.lit.height(coarse));
    });
}

}  // namespace quadrat::render::passes
