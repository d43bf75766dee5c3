// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "render/gl/fence.hpp"

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

constexpr std::size_t kBandPixels = 1U << 16U;
constexpr int kPixelsOfLight = 4;  // a side, to one of the light's, at most

// As coarse as its light: no more of it would be seen.
int halvings(const scene::Land& land, const mesh::Image& light) {
    int count = 0;
    while (land.albedo.width() >> count > kPixelsOfLight * light.width) ++count;
    return count;
}

// What a GPU does while it paints a pixel, in bytes it could have been brought instead.
constexpr std::size_t kPaintedBytes = 8;

constexpr std::chrono::seconds kLongest{2};

struct Painting {
    std::shared_ptr<const gl::Texture2D> canvas;  // or the picture itself
    gl::Fence done;                               // what was asked of the GPU last
    mesh::Image roots;                            // all of them where a visitor waits for it; or none
};

// What comes next would make the drawing thread wait for what was asked for before: not in this frame then.
void add_pause(gl::Slices& slices, const std::shared_ptr<Painting>& painting) {
    slices.add(0, [painting] { painting->done.set(); });
    const auto is_done = [painting](bool may_wait) {
        return painting->done.is_done_within(may_wait ? kLongest : std::chrono::nanoseconds{0});
    };
    slices.add_when(is_done, 0, [] {});
}

std::span<const std::uint8_t> rows_of(const mesh::Image& image, int first, int count) {
    return {image.pixel(0, first), image.pixel(0, first + count)};
}

}  // namespace

mesh::Image roots_of_rows(const scene::GroundColours& colours, const gl::TextureShape& picture, int first, int count) {
    mesh::Image roots(picture.width, count, 4);
    const auto& root_of = gl::roots_of_srgb();
    int halvings = 0;
    while (colours.width() >> halvings > picture.width) ++halvings;
    for (int i = 0; i < count; ++i) {
        const std::size_t row_bytes = 4 * static_cast<std::size_t>(picture.width);
        const std::span<std::uint8_t> row(roots.pixel(0, i), row_bytes);
        colours.mean_row(halvings, first + i, row);
        for (std::uint8_t& byte : row) byte = root_of[byte];
        const bool is_rim = first + i == 0 || first + i == picture.height - 1;
        for (std::size_t alpha = 3; alpha < row_bytes; alpha += is_rim ? 4 : row_bytes - 4) row[alpha] = 255;
    }
    return roots;
}

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

void add_grain(gl::Slices& slices, GrainOnGpu& grain, const std::shared_ptr<const scene::Land>& land,
               glm::vec3 to_sun) {
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = land->detail.width;
    tiled.height = land->detail.height;
    tiled.channels = 2;
    gl::add_painting(slices, grain.lit, tiled,
                     [land, to_sun](mesh::Image& lit, int row) { light_grain_row(*land, to_sun, lit, row); });
}

GroundPainter::GroundPainter() : program_("paint_ground.vert", "paint_ground.frag") {}

void GroundPainter::paint(const Sheet& sheet, const gl::Texture2D& grain, const gl::Texture2D& canvas, int first_row,
                          int rows) const {
    const gl::TextureShape& shape = canvas.shape();
    const auto drawing = target_.onto(canvas);
    glScissor(0, first_row, shape.width, rows);
    glEnable(GL_SCISSOR_TEST);
    program_.use();
    glUniform1f(0, sheet.relief_tiles);
    glUniform1f(1, 0.5F * kGrain);
    const gl::TextureShape& kinds = sheet.material.kinds.shape();
    glUniform2f(2, static_cast<float>(kinds.width), static_cast<float>(kinds.height));
    glUniform1i(3, first_row);
    // Of its own: what was brought for the band before may still be read.
    gl::Texture2D roots{{.width = shape.width, .height = rows, .sampling = gl::Sampling::Flat}};
    roots.write_rows(0, 0, rows, sheet.roots);
    roots.bind(0);
    sheet.material.kinds.bind(1);
    sheet.light.bind(2);
    grain.bind(3);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
}

void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture, const std::shared_ptr<GroundPainter>& painter,
                        const std::shared_ptr<const MaterialOnGpu>& material,
                        const std::shared_ptr<const scene::Scene>& scene) {
    const scene::Land& land = *scene->land;
    const auto light = std::make_shared<gl::Texture2D>();
    gl::TextureShape flat;
    flat.sampling = gl::Sampling::Flat;
    gl::add_picture(slices, *light, {scene, &scene->light.ground}, flat);
    gl::TextureShape shape;
    const int halved = halvings(land, scene->light.ground);
    shape.width = land.albedo.width() >> halved;
    shape.height = land.albedo.height() >> halved;
    shape.coarsest = 16;  // no view is so high above a land that all of it has fewer pixels
    // What is as fine as it gets is seen for minutes. A first light is soon replaced: it need not wait for a copy.
    const bool stays = halved == 0;
    const auto painting = std::make_shared<Painting>();
    if (!stays)
        slices.prepare(
            [painting, scene, shape] { painting->roots = roots_of_rows(scene->land->albedo, shape, 0, shape.height); });
    slices.add(0, [&picture, shape, painter, painting, stays] {
        painting->canvas = painter->canvases.take(shape);
        picture.lit = stays ? painter->copies.take(shape) : painting->canvas;
    });
    const float tiles = kReliefTiles * land.side_m() / land.detail_tile_m;
    const std::size_t row_bytes = kPaintedBytes * static_cast<std::size_t>(shape.width);
    slices.add_pieces(
        static_cast<std::size_t>(shape.height), kBandPixels / static_cast<std::size_t>(shape.width), row_bytes,
        [&picture, painter, painting, light, material, scene, tiles](std::size_t first, std::size_t rows) {
            const auto row = static_cast<int>(first);
            const auto count = static_cast<int>(rows);
            const gl::Texture2D& onto = *painting->canvas;
            const bool is_here = !painting->roots.bytes.empty();
            const mesh::Image now =
                is_here ? mesh::Image{} : roots_of_rows(scene->land->albedo, onto.shape(), row, count);
            const auto roots =
                is_here ? rows_of(painting->roots, row, count) : std::span<const std::uint8_t>(now.bytes);
            painter->paint({roots, *light, *material, tiles}, picture.grain->lit, onto, row, count);
        });
    add_pause(slices, painting);
    const std::size_t level_bytes = row_bytes / kPaintedBytes * 2 * static_cast<std::size_t>(shape.height);
    // A software rasteriser waits for one before it draws the next.
    for (int level = 1; level < shape.levels(); ++level)
        slices.add(level_bytes >> (2 * (level - 1)), [painting, level] { painting->canvas->fill_level(level); });
    if (!stays) return;
    add_pause(slices, painting);
    slices.add_pieces(static_cast<std::size_t>(shape.height), kBandPixels / static_cast<std::size_t>(shape.width),
                      row_bytes / 2, [&picture, painter, painting](std::size_t first, std::size_t rows) {
                          painter->copy_rows(*painting->canvas, *picture.lit, static_cast<int>(first),
                                             static_cast<int>(rows));
                      });
    slices.add(level_bytes, [&picture, painter, painting] {
        painter->copy_coarser(*painting->canvas, *picture.lit);
        painting->canvas.reset();
    });
}

}  // namespace quadrat::render::passes
