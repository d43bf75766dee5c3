// SPDX-License-Identifier: Apache-2.0
#include "render/passes/falling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "base/seed.hpp"
#include "render/passes/encode.hpp"

namespace quadrat::render::passes {
namespace {

struct DropCorner {
    glm::vec3 home;
    glm::vec2 corner;
};

std::vector<DropCorner> drop_corners() {
    std::vector<DropCorner> corners;
    base::RandomStream random{base::Seed{0x64'72'6f'70'73}};
    for (std::size_t i = 0; i < choose::kDrops; ++i) {
        const float x = random.unit_f();
        const float y = random.unit_f();
        const glm::vec3 home{x, y, random.unit_f()};
        for (const glm::vec2 corner : {glm::vec2{-1, -1}, glm::vec2{1, -1}, glm::vec2{-1, 1}, glm::vec2{1, 1}})
            corners.push_back({home, corner});
    }
    return corners;
}

std::vector<std::uint16_t> drop_indices() {
    std::vector<std::uint16_t> indices;
    for (std::size_t i = 0; i < choose::kDrops; ++i)
        for (const std::size_t k : {0, 1, 2, 2, 1, 3}) indices.push_back(static_cast<std::uint16_t>(4 * i + k));
    return indices;
}

}  // namespace

FallingPass::FallingPass()
    : program_("falling.vert", "falling.frag"),
      vertices_{{0,
                 sizeof(DropCorner),
                 gl::Advance::PerVertex,
                 {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0},
                  {1, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(DropCorner, corner)}}}} {
    const auto corners = drop_corners();
    drops_ = gl::Buffer{GL_ARRAY_BUFFER, corners.size() * sizeof(DropCorner)};
    drops_.write<DropCorner>(0, corners);
    const auto indices = drop_indices();
    indices_ = gl::Buffer{GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof(std::uint16_t)};
    indices_.write<std::uint16_t>(0, indices);
}

gl::Work FallingPass::draw(const scene::Precipitation& what, const choose::ViewBlock& view, float pixels_per_radian,
                           float share) const {
    using Kind = scene::Precipitation::Kind;
    if (what.kind == Kind::None) return {};
    program_.use();
    const bool is_snow = what.kind == Kind::Snow;
    // A streak keeps its length, a flake is as high as wide, and so is the least of it that is drawn.
    const float fewer = 1 / share;
    // Of thin strokes a byte's rounding loses some light, of wide ones less.
    const float wider = std::pow(fewer, is_snow ? 0.5F : 0.95F);
    const float least_rad = 0.7F / pixels_per_radian * (is_snow ? wider : 1);
    glUniform4f(0, what.speed_m_s.x, what.speed_m_s.y, what.speed_m_s.z, wider * what.width_m);
    glUniform4f(1, what.streak_s, is_snow ? 0.22F : 0, least_rad, 0);
    const glm::vec3 shown = encode(what.colour) * view.to_sun.w;
    glUniform4f(2, shown.r, shown.g, shown.b, what.opacity);
    vertices_.bind();
    vertices_.feed(0, drops_.name());
    vertices_.feed_indices(indices_.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);
    const std::size_t drops = choose::drops_of(what, share);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * drops), GL_UNSIGNED_SHORT, nullptr);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    return {1, 2 * drops, 4 * drops};
}

}  // namespace quadrat::render::passes
