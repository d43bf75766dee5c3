// SPDX-License-Identifier: Apache-2.0
#include "render/passes/sky.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

#include "render/gl/picture_upload.hpp"
#include "render/passes/encode.hpp"

namespace quadrat::render::passes {
namespace {

constexpr int kSectors = 64;
constexpr float kLowest_rad = -10.0F / 180.0F * std::numbers::pi_v<float>;

// Encoded as the display wants it, in sixteen bits: eight would show as bands.
struct DomeColour {
    std::uint16_t red, green, blue, unused;
};

glm::vec2 dome_place(float azimuth_rad, float elevation_rad) {
    const float quarter = std::numbers::pi_v<float> / 2;
    return {azimuth_rad / (4 * quarter), (quarter - elevation_rad) / (quarter - kLowest_rad)};
}

// Rings stand closer together toward the horizon, where the picture is looked at; the last hangs far below it.
std::vector<float> ring_elevations_deg() {
    return {90, 74, 59, 46, 36, 28, 21, 15.5F, 11, 7.5F, 4.5F, 2, 0, -3, -10, -40};
}

constexpr std::array<glm::vec2, 4> kSunCorners{glm::vec2{-1, -1}, glm::vec2{1, -1}, glm::vec2{-1, 1}, glm::vec2{1, 1}};

struct DomePlace {
    float azimuth_rad;
    float elevation_rad;
};

std::vector<DomePlace> dome_places() {
    std::vector<DomePlace> places;
    for (const float degrees : ring_elevations_deg())
        for (int sector = 0; sector <= kSectors; ++sector)
            places.push_back({2 * std::numbers::pi_v<float> * static_cast<float>(sector) / kSectors,
                              degrees / 180 * std::numbers::pi_v<float>});
    return places;
}

glm::vec3 direction_of(const DomePlace& p) {
    return {std::sin(p.azimuth_rad) * std::cos(p.elevation_rad), std::sin(p.elevation_rad),
            -std::cos(p.azimuth_rad) * std::cos(p.elevation_rad)};
}

float shown_at(const mesh::Image& dome, int x, int y, int channel) {
    const int column = ((x % dome.width) + dome.width) % dome.width;
    const float root =
        static_cast<float>(gl::root_of_srgb(dome.pixel(column, std::clamp(y, 0, dome.height - 1))[channel]));
    return encode_root(root / 255);
}

// Bilinear; around the compass it has no seam.
glm::vec3 dome_shown(const mesh::Image& dome, const DomePlace& place) {
    const glm::vec2 at = dome_place(place.azimuth_rad, std::max(place.elevation_rad, kLowest_rad)) *
                             glm::vec2{static_cast<float>(dome.width), static_cast<float>(dome.height)} -
                         0.5F;
    const glm::vec2 corner = glm::floor(at);
    const glm::vec2 t = at - corner;
    const int x = static_cast<int>(corner.x);
    const int y = static_cast<int>(corner.y);
    glm::vec3 shown{0};
    for (int c = 0; c < 3; ++c)
        shown[c] = glm::mix(glm::mix(shown_at(dome, x, y, c), shown_at(dome, x + 1, y, c), t.x),
                            glm::mix(shown_at(dome, x, y + 1, c), shown_at(dome, x + 1, y + 1, c), t.x), t.y);
    return shown;
}

std::vector<DomeColour> dome_colours(const mesh::Image& dome) {
    std::vector<DomeColour> colours;
    for (const DomePlace& place : dome_places()) {
        const glm::vec3 shown = glm::clamp(dome_shown(dome, place), 0.0F, 1.0F) * 65535.0F;
        colours.push_back({static_cast<std::uint16_t>(shown.r), static_cast<std::uint16_t>(shown.g),
                           static_cast<std::uint16_t>(shown.b), 0});
    }
    return colours;
}

std::vector<std::uint16_t> dome_indices() {
    std::vector<std::uint16_t> indices;
    const int rings = static_cast<int>(ring_elevations_deg().size());
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int sector = 0; sector < kSectors; ++sector) {
            const auto upper = static_cast<std::uint16_t>(ring * (kSectors + 1) + sector);
            const auto lower = static_cast<std::uint16_t>(upper + kSectors + 1);
            // Counter-clockwise from within.
            for (const int i : {upper + 0, lower + 0, upper + 1, upper + 1, lower + 0, lower + 1})
                indices.push_back(static_cast<std::uint16_t>(i));
        }
    }
    return indices;
}

std::shared_ptr<const mesh::Image> interleaved(const scene::CloudLayer& layer) {
    auto both = std::make_shared<mesh::Image>(std::max(layer.density.width, 1), std::max(layer.density.height, 1), 2);
    for (std::size_t i = 0; i < layer.density.bytes.size(); ++i) {
        both->bytes[2 * i] = layer.density.bytes[i];
        both->bytes[2 * i + 1] = i < layer.lit.bytes.size() ? layer.lit.bytes[i] : std::uint8_t{255};
    }
    return both;
}

}  // namespace

void add_sky(gl::Slices& slices, SkyOnGpu& sky, const std::shared_ptr<const scene::Sky>& source) {
    slices.add(std::size_t{64} << 10U, [&sky, source] {
        const auto colours = dome_colours(source->dome);
        sky.dome = gl::Buffer{GL_ARRAY_BUFFER, colours.size() * sizeof(DomeColour)};
        sky.dome.write<DomeColour>(0, colours);
    });
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    for (std::size_t i = 0; i < source->clouds.size(); ++i)
        gl::add_picture(slices, sky.clouds[i], interleaved(source->clouds[i]), tiled);
}

SkyPass::SkyPass()
    : program_("sky.vert", "sky.frag"),
      sun_("sun.vert", "sun.frag"),
      vertices_{
          {0, sizeof(glm::vec3), gl::Advance::PerVertex, {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
          {1, sizeof(DomeColour), gl::Advance::PerVertex, {{1, 4, GL_UNSIGNED_SHORT, gl::Numbers::Normalised, 0}}}},
      sun_vertices_{{0, sizeof(glm::vec2), gl::Advance::PerVertex, {{0, 2, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}}} {
    sun_corners_ = gl::Buffer{GL_ARRAY_BUFFER, sizeof(kSunCorners)};
    sun_corners_.write<glm::vec2>(0, kSunCorners);
    std::vector<glm::vec3> directions;
    for (const DomePlace& place : dome_places()) directions.push_back(direction_of(place));
    directions_ = gl::Buffer{GL_ARRAY_BUFFER, directions.size() * sizeof(glm::vec3)};
    directions_.write<glm::vec3>(0, directions);
    const auto indices = dome_indices();
    indices_ = gl::Buffer{GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof(std::uint16_t)};
    indices_.write<std::uint16_t>(0, indices);
    index_count_ = indices.size();
}

void SkyPass::draw(const SkyOnGpu& sky) const {
    program_.use();
    sky.clouds[0].bind(0);
    sky.clouds[1].bind(1);
    vertices_.bind();
    vertices_.feed(0, directions_.name());
    vertices_.feed(1, sky.dome.name());
    vertices_.feed_indices(indices_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(index_count_), GL_UNSIGNED_SHORT, nullptr);
    sun_.use();
    sun_vertices_.bind();
    sun_vertices_.feed(0, sun_corners_.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

}  // namespace quadrat::render::passes
