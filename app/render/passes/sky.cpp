// SPDX-License-Identifier: Apache-2.0
#include "render/passes/sky.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <vector>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/passes/cloud_shadow.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/packing.hpp"
#include "render/passes/ranges.hpp"

namespace quadrat::render::passes {
namespace {

constexpr int kSectors = 64;
constexpr int kBowRings = 10;
constexpr int kBowSectors = 56;  // a chord leaves its arc by less than a tenth of a degree
// Encoded as the display wants it, in sixteen bits: eight would show as bands.
struct DomeColour {
    std::uint16_t red, green, blue, unused;
};

// Rings stand closer together toward the horizon, where the picture is looked at; the last hangs far below it.
std::vector<float> ring_elevations_deg() {
    return {90, 74, 59, 46, 36, 28, 21, 15.5F, 11, 7.5F, 4.5F, 2, 0, -3, -10, -40};
}

constexpr std::array<glm::vec2, 4> kDiscCorners{glm::vec2{-1, -1}, glm::vec2{1, -1}, glm::vec2{-1, 1}, glm::vec2{1, 1}};

struct DomePlace {
    float azimuth_rad;  // -pi to pi, once around from the south
    float elevation_rad;
};

std::vector<DomePlace> dome_places() {
    std::vector<DomePlace> places;
    for (const float degrees : ring_elevations_deg())
        for (int sector = 0; sector <= kSectors; ++sector)
            places.push_back({std::numbers::pi_v<float> * (2 * static_cast<float>(sector) / kSectors - 1),
                              degrees / 180 * std::numbers::pi_v<float>});
    return places;
}

glm::vec3 direction_of(const DomePlace& p) {
    return {std::sin(p.azimuth_rad) * std::cos(p.elevation_rad), std::sin(p.elevation_rad),
            -std::cos(p.azimuth_rad) * std::cos(p.elevation_rad)};
}

std::vector<DomeColour> dome_colours(const scene::Dome& dome) {
    std::vector<DomeColour> colours;
    for (const DomePlace& place : dome_places()) {
        const glm::vec3 shown = glm::clamp(encode(held(dome.radiance(direction_of(place)))), 0.0F, 1.0F) * 65535.0F;
        colours.push_back({static_cast<std::uint16_t>(shown.r), static_cast<std::uint16_t>(shown.g),
                           static_cast<std::uint16_t>(shown.b), 0});
    }
    return colours;
}

std::vector<std::uint16_t> dome_indices() {
    std::vector<std::uint16_t> indices;
    const int rings = static_cast<int>(ring_elevations_deg().size());
    for (int sector = 0; sector < kSectors; ++sector) {
        for (int ring = 0; ring + 1 < rings; ++ring) {
            const auto upper = static_cast<std::uint16_t>(ring * (kSectors + 1) + sector);
            const auto lower = static_cast<std::uint16_t>(upper + kSectors + 1);
            // Counter-clockwise from within.
            for (const int i : {upper + 0, lower + 0, upper + 1, upper + 1, lower + 0, lower + 1})
                indices.push_back(static_cast<std::uint16_t>(i));
        }
    }
    return indices;
}

constexpr glm::ivec2 kCloudscape{512, 128};  // of layers that have none

// Density, as opaque as the layer is, and light.
void interleave_row(const scene::CloudLayer& layer, mesh::Image& both, int row) {
    const auto width = static_cast<std::size_t>(layer.density.width);
    const std::size_t first = static_cast<std::size_t>(row) * width;
    for (std::size_t i = first; i < first + width; ++i) {
        both.bytes[2 * i] = unsigned_byte(layer.opacity * static_cast<float>(layer.density.bytes[i]) / 255);
        both.bytes[2 * i + 1] = i < layer.lit.bytes.size() ? layer.lit.bytes[i] : std::uint8_t{255};
    }
}

struct BowCorner {
    glm::vec4 around;
    glm::vec3 colour;
};

// Colours of a rainbow over its radius, 0 inside to 1 outside: what drops of water make of white light, softened.
glm::vec3 bow_colour(float t) {
    const auto bell = [t](float at, float wide) { return std::exp(-(t - at) * (t - at) / (wide * wide)); };
    return {bell(0.80F, 0.17F) + 0.35F * bell(0.12F, 0.12F), bell(0.55F, 0.17F), bell(0.28F, 0.19F)};
}

// One bow, and a second of a third of its light outside with its colours the other way round (Descartes 1637: 42 and 51
// degrees).
std::vector<BowCorner> bow_corners() {
    std::vector<BowCorner> corners;
    struct Bow {
        float inner_deg, outer_deg, light;
        bool is_turned;
    };
    for (const Bow& bow : {Bow{38.6F, 43.0F, 1.0F, false}, Bow{49.6F, 54.6F, 0.3F, true}}) {
        for (int ring = 0; ring <= kBowRings; ++ring) {
            const float t = static_cast<float>(ring) / kBowRings;
            const float radius = glm::radians(glm::mix(bow.inner_deg, bow.outer_deg, t));
            const bool is_rim = ring == 0 || ring == kBowRings;
            const glm::vec3 colour = is_rim ? glm::vec3{0} : bow_colour(bow.is_turned ? 1 - t : t) * bow.light;
            for (int sector = 0; sector <= kBowSectors; ++sector) {
                const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(sector) / kBowSectors;
                corners.push_back({{std::cos(turn), std::sin(turn), std::cos(radius), std::sin(radius)}, colour});
            }
        }
    }
    return corners;
}

std::vector<std::uint16_t> bow_indices() {
    std::vector<std::uint16_t> indices;
    for (int ring = 0; ring <= 2 * kBowRings; ++ring) {
        if (ring == kBowRings) continue;  // between the bows
        for (int sector = 0; sector < kBowSectors; ++sector) {
            const auto inner = static_cast<std::uint16_t>(ring * (kBowSectors + 1) + sector);
            const auto outer = static_cast<std::uint16_t>(inner + kBowSectors + 1);
            for (const int i : {inner + 0, outer + 0, inner + 1, inner + 1, outer + 0, outer + 1})
                indices.push_back(static_cast<std::uint16_t>(i));
        }
    }
    return indices;
}

template <typename T>
gl::Buffer filled(GLenum kind, const std::vector<T>& from) {
    gl::Buffer buffer{kind, from.size() * sizeof(T)};
    buffer.write<T>(0, from);
    return buffer;
}

void add_cloudscape(gl::Slices& slices, std::shared_ptr<const gl::Texture2D>& texture,
                    const std::shared_ptr<gl::TexturePool>& pool, const std::shared_ptr<const scene::Sky>& source) {
    const bool is_made = !source->cloudscape.bytes.empty();
    gl::TextureShape around;
    around.wrap_s = gl::Wrap::Repeat;
    around.channels = 2;
    around.width = is_made ? source->cloudscape.width : kCloudscape.x;
    around.height = is_made ? source->cloudscape.height : kCloudscape.y;
    const auto flat = std::make_shared<scene::Cloudscape>();
    if (!is_made)
        slices.prepare(
            [flat, source] { *flat = scene::cloudscape_of(source->clouds[0], kCloudscape.x, kCloudscape.y); });
    gl::add_painting(slices, texture, pool, around, [source, flat, is_made](mesh::Image& to, int row) {
        const scene::Cloudscape& from = is_made ? source->cloudscape : *flat;
        if (from.bytes.empty()) return;
        const std::size_t bytes = 2 * static_cast<std::size_t>(from.width);
        std::copy_n(from.pixel(0, row), bytes, to.pixel(0, row));
    });
}

}  // namespace

void add_sky(gl::Slices& slices, SkyOnGpu& sky, const std::shared_ptr<gl::TexturePool>& pool,
             const std::shared_ptr<const scene::Sky>& source) {
    sky.bow = source->bow;
    const auto colours = std::make_shared<std::vector<DomeColour>>();
    slices.prepare([colours, source] { *colours = dome_colours(source->dome); });
    gl::add_elements<DomeColour>(slices, sky.dome, GL_ARRAY_BUFFER, dome_places().size(),
                                 [colours] { return std::span<const DomeColour>(*colours); });
    static_assert(sizeof(scene::Star) == sizeof(glm::vec4));
    sky.star_count = source->stars.size();
    gl::add_elements<scene::Star>(slices, sky.stars, GL_ARRAY_BUFFER, {source, &source->stars});
    const auto table = std::make_shared<ShadowTable>();
    slices.prepare([&sky, source, table] {
        sky.shadow_map = shadow_map_of(source->clouds[0].density);
        *table = shadow_table(sky.shadow_map);
    });
    gl::add_elements<std::uint32_t>(slices, sky.shadow, GL_UNIFORM_BUFFER, table->size(),
                                    [table] { return std::span<const std::uint32_t>(*table); });
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.channels = 2;
    const scene::CloudLayer& upper = source->clouds[1];
    tiled.width = std::max(upper.density.width, 1);
    tiled.height = std::max(upper.density.height, 1);
    gl::add_painting(slices, sky.clouds[1], pool, tiled, [source, &upper](mesh::Image& both, int row) {
        if (!upper.density.bytes.empty()) interleave_row(upper, both, row);
    });
    add_cloudscape(slices, sky.clouds[0], pool, source);
    gl::TextureShape disc;
    disc.sampling = gl::Sampling::Smooth;
    sky.has_disc = !source->disc.picture.bytes.empty();
    if (sky.has_disc) gl::add_picture(slices, sky.disc, {source, &source->disc.picture}, disc);
}

SkyPass::SkyPass()
    : program_("sky.vert", "sky.frag"),
      held_("held_sky.vert", "held_sky.frag"),
      disc_("disc.vert", "disc.frag"),
      stars_("stars.vert", "stars.frag"),
      bow_("bow.vert", "lit.frag"),
      vertices_{
          {0, sizeof(glm::vec4), gl::Advance::PerVertex, {{0, 4, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
          {1, sizeof(DomeColour), gl::Advance::PerVertex, {{1, 4, GL_UNSIGNED_SHORT, gl::Numbers::Normalised, 0}}}},
      disc_vertices_{{0, sizeof(glm::vec2), gl::Advance::PerVertex, {{0, 2, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}}},
      star_vertices_{{0, sizeof(glm::vec4), gl::Advance::PerVertex, {{0, 4, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}}},
      bow_vertices_{{0,
                     sizeof(BowCorner),
                     gl::Advance::PerVertex,
                     {{0, 4, GL_FLOAT, gl::Numbers::AsTheyAre, 0},
                      {1, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(BowCorner, colour)}}}} {
    disc_corners_ = filled(GL_ARRAY_BUFFER, std::vector<glm::vec2>(kDiscCorners.begin(), kDiscCorners.end()));
    std::vector<glm::vec4> directions;
    for (const DomePlace& place : dome_places()) directions.emplace_back(direction_of(place), place.azimuth_rad);
    directions_ = filled(GL_ARRAY_BUFFER, directions);
    const auto indices = dome_indices();
    indices_ = filled(GL_ELEMENT_ARRAY_BUFFER, indices);
    std::vector<std::vector<glm::vec3>> ways(kSectors);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const std::size_t edge = i % (kSectors + 1);
        if (edge < kSectors) ways[edge].emplace_back(directions[i]);
        if (edge > 0) ways[edge - 1].emplace_back(directions[i]);
    }
    sectors_ = choose::Sectors(std::move(ways), indices.size() / kSectors);
    bow_corners_ = filled(GL_ARRAY_BUFFER, bow_corners());
    const auto bow = bow_indices();
    bow_indices_ = filled(GL_ELEMENT_ARRAY_BUFFER, bow);
    bow_index_count_ = bow.size();
}

gl::Work SkyPass::draw_dome(const SkyOnGpu& sky, const choose::Frustum& frustum, glm::vec3 eye_m) const {
    glDepthMask(GL_FALSE);  // it lies where depth was cleared to
    program_.use();
    sky.clouds[0]->bind(0);
    sky.clouds[1]->bind(1);
    vertices_.bind();
    vertices_.feed(0, directions_.name());
    vertices_.feed(1, sky.dome.name());
    vertices_.feed_indices(indices_.name());
    const gl::Work work = draw_ranges(sectors_.seen(frustum, eye_m), GL_UNSIGNED_SHORT);
    glDepthMask(GL_TRUE);
    return work;
}

gl::Work SkyPass::draw_held(const gl::Texture2D& held, const glm::mat3& held_from_view, float kept) const {
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);  // whichever way the panel hangs
    held_.use();
    glUniformMatrix3fv(0, 1, GL_FALSE, glm::value_ptr(held_from_view));
    glUniform1f(1, kept);
    // A twentieth of a pixel off in the middle of a square where the view has turned by a degree.
    constexpr int kSide = 6;
    glUniform1i(2, kSide);
    held.bind(3);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 6 * kSide * kSide);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    return {1, 2 * kSide * kSide, 6 * kSide * kSide};
}

gl::Work SkyPass::draw_lights(const SkyOnGpu& sky, int height_px, float share_of_stars) const {
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);  // what they are added to stays as clear as it is
    glDisable(GL_CULL_FACE);
    sky.clouds[0]->bind(0);
    sky.clouds[1]->bind(1);
    gl::Work work;
    // The brightest come first.
    const auto stars = static_cast<std::size_t>(std::ceil(share_of_stars * static_cast<float>(sky.star_count)));
    if (stars > 0) {
        stars_.use();
        glUniform1f(0, static_cast<float>(height_px) / 1080);
        star_vertices_.bind();
        star_vertices_.feed(0, sky.stars.name());
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(stars));
        work += {1, 2 * stars, stars};
    }
    if (sky.has_disc) {
        disc_.use();
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // what hides the sky hides one that is added later, too
        sky.disc.bind(2);
        disc_vertices_.bind();
        disc_vertices_.feed(0, disc_corners_.name());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
        work += {1, 2, 4};
    }
    if (sky.bow > 0) {
        bow_.use();
        bow_vertices_.bind();
        bow_vertices_.feed(0, bow_corners_.name());
        bow_vertices_.feed_indices(bow_indices_.name());
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(bow_index_count_), GL_UNSIGNED_SHORT, nullptr);
        work += gl::work_of_mesh(bow_index_count_);
    }
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    return work;
}

}  // namespace quadrat::render::passes
