// SPDX-License-Identifier: Apache-2.0
#include "render/passes/signs.hpp"

#include <array>

namespace quadrat::render::passes {
namespace {

struct Corner {
    glm::vec2 clip;
    glm::vec2 from_middle_px;
};

constexpr std::array<glm::vec2, 4> kStrip{glm::vec2{-1, -1}, glm::vec2{1, -1}, glm::vec2{-1, 1}, glm::vec2{1, 1}};

}  // namespace

SignsPass::SignsPass()
    : plain_("sign.vert", "sign.frag"),
      picture_("sign.vert", "sign_picture.frag"),
      vertices_{{0,
                 sizeof(Corner),
                 gl::Advance::PerVertex,
                 {{0, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(Corner, clip)},
                  {1, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(Corner, from_middle_px)}}}},
      corners_(GL_ARRAY_BUFFER) {}

void SignsPass::draw(std::span<const FlatSign> signs, glm::ivec2 upright_px, const glm::mat2& target_from_upright) {
    if (signs.empty()) return;
    std::vector<Corner> corners;
    for (const FlatSign& sign : signs) {
        // A pixel more on every side of a plain one, for its softened edge.
        const glm::vec2 half = 0.5F * sign.size_px + (sign.picture ? 0.0F : 1.0F);
        const glm::vec2 middle = sign.low_px + 0.5F * sign.size_px;
        for (const glm::vec2 c : kStrip)
            corners.push_back(
                {target_from_upright * (2.0F * (middle + c * half) / glm::vec2{upright_px} - 1.0F), c * half});
    }
    corners_.fill<Corner>(corners);
    vertices_.bind();
    vertices_.feed(0, corners_.name());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const FlatSign& sign = signs[i];
        (sign.picture ? picture_ : plain_).use();
        if (sign.picture) sign.picture->bind(0);
        const float a = sign.colour.a;
        glUniform4f(0, sign.colour.r * a, sign.colour.g * a, sign.colour.b * a, a);
        glUniform4f(1, 0.5F * sign.size_px.x, 0.5F * sign.size_px.y, sign.corner_radius_px, sign.border_px);
        glDrawArrays(GL_TRIANGLE_STRIP, static_cast<GLint>(4 * i), 4);
    }
    glDisable(GL_BLEND);
}

}  // namespace quadrat::render::passes
