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
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

constexpr int kSectors = 48;
constexpr int kMirrorSide = 128;
constexpr float kMirrorReach = 0.46F;  // of the mirror's side, where the horizon lies; as in shaders/water.frag
constexpr float kLowest_rad = -10.0F / 180.0F * std::numbers::pi_v<float>;

struct DomeVertex {
    glm::vec3 direction;
    glm::vec2 on_dome;
};

glm::vec2 dome_place(float azimuth_rad, float elevation_rad) {
    const float quarter = std::numbers::pi_v<float> / 2;
    return {azimuth_rad / (4 * quarter), (quarter - elevation_rad) / (quarter - kLowest_rad)};
}

// Rings stand closer together toward the horizon, where the picture is looked at; the last hangs far below it.
std::vector<float> ring_elevations_deg() { return {90, 72, 56, 43, 32, 23, 16, 10, 5, 1, -3, -10, -40}; }

std::vector<DomeVertex> dome_vertices() {
    std::vector<DomeVertex> vertices;
    for (const float degrees : ring_elevations_deg()) {
        const float elevation = degrees / 180 * std::numbers::pi_v<float>;
        for (int sector = 0; sector <= kSectors; ++sector) {
            const float azimuth = 2 * std::numbers::pi_v<float> * static_cast<float>(sector) / kSectors;
            vertices.push_back({{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                 -std::cos(azimuth) * std::cos(elevation)},
                                dome_place(azimuth, std::max(elevation, kLowest_rad))});
        }
    }
    return vertices;
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

float mean_of(const mesh::Image& image) {
    double sum = 0;
    for (const std::uint8_t b : image.bytes) sum += b;
    return image.bytes.empty() ? 0 : static_cast<float>(sum / (255.0 * static_cast<double>(image.bytes.size())));
}

float to_encoded(float linear) { return std::pow(std::clamp(linear, 0.0F, 1.0F), 1 / 2.2F); }

// What still water shows: nearest pixels of the dome will do, ripples blur them; clouds join as their mean.
void paint_mirror(const scene::Sky& sky, glm::vec3 cloud_colour, float cover, mesh::Image& mirror, int row) {
    for (int column = 0; column < mirror.width; ++column) {
        const glm::vec2 p = (glm::vec2{static_cast<float>(column), static_cast<float>(row)} + 0.5F) /
                                (static_cast<float>(kMirrorSide) * kMirrorReach) -
                            0.5F / kMirrorReach;
        const float r2 = glm::dot(p, p);
        const float elevation = std::max(std::asin(std::clamp((1 - r2) / (1 + r2), -1.0F, 1.0F)), kLowest_rad);
        float azimuth = std::atan2(p.x, -p.y);
        if (azimuth < 0) azimuth += 2 * std::numbers::pi_v<float>;
        const glm::vec2 at = dome_place(azimuth, elevation);
        const int x = std::clamp(static_cast<int>(at.x * static_cast<float>(sky.dome.width)), 0, sky.dome.width - 1);
        const int y = std::clamp(static_cast<int>(at.y * static_cast<float>(sky.dome.height)), 0, sky.dome.height - 1);
        const std::uint8_t* from = sky.dome.pixel(x, y);
        std::uint8_t* to = mirror.pixel(column, row);
        for (int c = 0; c < 3; ++c)
            to[c] = unsigned_byte(glm::mix(static_cast<float>(from[c]) / 255, to_encoded(cloud_colour[c]), cover));
        to[3] = 255;
    }
}

}  // namespace

void add_sky(gl::Slices& slices, SkyOnGpu& sky, const std::shared_ptr<const scene::Sky>& source) {
    using gl::Meaning;
    using gl::Wrap;
    gl::add_picture(slices, sky.dome, {source, &source->dome}, Meaning::Colour, Wrap::Repeat, Wrap::Clamp);
    for (std::size_t i = 0; i < source->clouds.size(); ++i)
        gl::add_picture(slices, sky.clouds[i], interleaved(source->clouds[i]), Meaning::Plain, Wrap::Repeat,
                        Wrap::Repeat);
    const scene::CloudLayer& low = source->clouds[0];
    const glm::vec3 cloud_colour = glm::mix(low.shaded, low.sunlit, 0.5F);
    const float cover = 0.8F * mean_of(low.density) * low.opacity;
    gl::add_painting(slices, sky.mirror, kMirrorSide, kMirrorSide, 4, Meaning::Colour, Wrap::Clamp, Wrap::Clamp,
                     [source, cloud_colour, cover](mesh::Image& mirror, int row) {
                         paint_mirror(*source, cloud_colour, cover, mirror, row);
                     });
}

SkyPass::SkyPass()
    : program_("sky.vert", "sky.frag"),
      vertices_{{0,
                 sizeof(DomeVertex),
                 gl::Advance::PerVertex,
                 {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(DomeVertex, direction)},
                  {1, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(DomeVertex, on_dome)}}}} {
    const auto vertices = dome_vertices();
    const auto indices = dome_indices();
    dome_ = gl::Buffer{GL_ARRAY_BUFFER, vertices.size() * sizeof(DomeVertex)};
    dome_.write<DomeVertex>(0, vertices);
    indices_ = gl::Buffer{GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof(std::uint16_t)};
    indices_.write<std::uint16_t>(0, indices);
    index_count_ = indices.size();
}

void SkyPass::draw(const SkyOnGpu& sky) const {
    program_.use();
    sky.dome.bind(0);
    sky.clouds[0].bind(1);
    sky.clouds[1].bind(2);
    vertices_.bind();
    vertices_.feed(0, dome_.name());
    vertices_.feed_indices(indices_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(index_count_), GL_UNSIGNED_SHORT, nullptr);
}

}  // namespace quadrat::render::passes
