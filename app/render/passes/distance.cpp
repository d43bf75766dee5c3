// SPDX-License-Identifier: Apache-2.0
#include "render/passes/distance.hpp"

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

namespace quadrat::render::passes {
namespace {

constexpr GLint kPlant = 1;
constexpr GLint kOther = 0;
constexpr GLuint kAll = 0xFF;

}  // namespace

DistancePass::DistancePass() : program_("held_distance.vert", "held_distance.frag") {}

gl::Work DistancePass::draw(const gl::Texture2D& held, const gl::Texture2D& held_sky, const DistanceWarp& warp) const {
    constexpr int kSide = 8;
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);  // whichever way the panel hangs
    program_.use();
    glUniformMatrix3fv(0, 1, GL_FALSE, glm::value_ptr(warp.way_from_clip));
    glUniformMatrix3fv(1, 1, GL_FALSE, glm::value_ptr(warp.held_from_way));
    glUniformMatrix3fv(2, 1, GL_FALSE, glm::value_ptr(warp.sky_from_view));
    glUniform4fv(3, 1, glm::value_ptr(warp.moved_radius));
    glUniform3fv(4, 1, glm::value_ptr(warp.split));
    glUniform1i(5, kSide);
    glUniform2fv(6, 1, glm::value_ptr(warp.kept));
    held_sky.bind(3);
    held.bind(4);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 6 * kSide * kSide);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    return {1, 2 * kSide * kSide, 6 * kSide * kSide};
}

NearMarks::NearMarks() {
    glEnable(GL_STENCIL_TEST);
    begin_others();
}

NearMarks::~NearMarks() { glDisable(GL_STENCIL_TEST); }

void NearMarks::begin_plants() const {
    glStencilFunc(GL_ALWAYS, kPlant, kAll);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void NearMarks::begin_others() const {
    glStencilFunc(GL_ALWAYS, kOther, kAll);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void NearMarks::begin_distance() const {
    glStencilFunc(GL_EQUAL, kOther, kAll);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

}  // namespace quadrat::render::passes
