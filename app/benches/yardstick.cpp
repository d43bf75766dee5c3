// SPDX-License-Identifier: Apache-2.0
#include "benches/yardstick.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace quadrat::benches {
namespace {

namespace gl = render::gl;

constexpr shaders::Source kVertex = {"plain_ground.vert",
                                     R"(#version 310 es
layout(location = 0) in vec4 place;
layout(location = 1) in vec2 at;
layout(location = 2) in vec3 up;
layout(location = 3) in float fog;
out vec2 over_land;
out vec3 normal;
out float far;
void main() {
    gl_Position = place;
    over_land = at;
    normal = up;
    far = fog;
}
)",
                                     {}};

constexpr shaders::Source kFragment = {"plain_ground.frag",
                                       R"(#version 310 es
precision highp float;
layout(binding = 0) uniform sampler2D ground;
in vec2 over_land;
in vec3 normal;
in float far;
layout(location = 0) out vec4 pixel;
void main() {
    float lit = 0.2 + 0.8 * max(dot(normalize(normal), vec3(0.36, 0.8, 0.48)), 0.0);
    pixel = vec4(mix(texture(ground, over_land).rgb * lit, vec3(0.6, 0.7, 0.8), far), 1.0);
}
)",
                                       {}};

constexpr shaders::Source kSkyVertex = {"plain_sky.vert",
                                        R"(#version 310 es
out vec3 towards;
void main() {
    vec2 at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(at, 0.0, 1.0);
    towards = vec3(at.x, 0.62 + 0.6 * at.y, 1.0);
}
)",
                                        {}};

// At a turbidity of three, the sun at 45 degrees.
constexpr shaders::Source kSkyFragment = {"plain_sky.frag",
                                          R"(#version 310 es
precision highp float;
in vec3 towards;
layout(location = 0) out vec4 pixel;
const vec3 a = vec3(-0.9269, -0.3171, -0.3109);
const vec3 b = vec3(-0.6387, -0.1987, -0.2758);
const vec3 c = vec3(5.2570, 0.2113, 0.1865);
const vec3 d = vec3(-2.2153, -1.0912, -1.7860);
const vec3 e = vec3(0.1693, 0.0353, 0.0202);
uniform vec3 zenith;
void main() {
    vec3 to = normalize(towards);
    float cosine = clamp(dot(to, vec3(0.0, 0.7071, 0.7071)), -1.0, 1.0);
    float angle = acos(cosine);
    vec3 perez = (1.0 + a * exp(b / max(to.y, 0.01))) * (1.0 + c * exp(d * angle) + e * cosine * cosine);
    vec3 shown = zenith * perez;
    vec3 whole = vec3(shown.y, shown.z, 1.0 - shown.y - shown.z) * (shown.x / max(shown.z, 0.01));
    whole = vec3(whole.x, shown.x, whole.z);
    vec3 light = mat3(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570) * whole;
    pixel = vec4(sqrt(light / (1.0 + light)), 1.0);
}
)",
                                          {}};

struct Corner {
    glm::vec4 place;  // in clip space
    glm::vec2 at;
    glm::vec3 up;
    float fog;
};

// Seen from above, the far end three times as far away as the near one.
std::vector<Corner> corners(int squares) {
    std::vector<Corner> all;
    for (int row = 0; row <= squares; ++row) {
        for (int column = 0; column <= squares; ++column) {
            const glm::vec2 seen = 2.0F * glm::vec2{column, row} / static_cast<float>(squares) - 1.0F;
            const float distance_m = 60 / (2 - seen.y);
            const float slope = 0.1F * std::sin(11.0F * seen.x + 14.0F * seen.y);
            all.push_back({{seen * distance_m, 0.5F * distance_m, distance_m},
                           glm::vec2{seen.x, 2} * distance_m / 64.0F,
                           {slope, 1, slope},
                           1 - std::exp(-0.01F * distance_m)});
        }
    }
    return all;
}

std::vector<std::uint32_t> triangles(std::uint32_t squares) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t row = 0; row < squares; ++row) {
        for (std::uint32_t column = 0; column < squares; ++column) {
            const std::uint32_t at = row * (squares + 1) + column;
            const std::uint32_t above = at + squares + 1;
            all.insert(all.end(), {at, at + 1, above, at + 1, above + 1, above});
        }
    }
    return all;
}

gl::Texture2D noise() {
    constexpr int kSide = 512;
    gl::Texture2D texture({kSide, kSide, 4, gl::Wrap::Repeat, gl::Wrap::Repeat, gl::Sampling::Smooth});
    std::vector<std::uint8_t> bytes(std::size_t{4} * kSide * kSide);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>((i * 2654435761U) >> 13U);
    texture.write_rows(0, 0, kSide, bytes);
    texture.fill_levels();
    return texture;
}

void begin(const display::Canvas& canvas) {
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glViewport(0, 0, canvas.size.width, canvas.size.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

template <typename Element>
gl::Buffer buffer_of(GLenum target, const std::vector<Element>& elements) {
    gl::Buffer buffer(target, elements.size() * sizeof(Element));
    buffer.write<Element>(0, elements);
    return buffer;
}

}  // namespace

PlainGround::PlainGround(int squares_a_side)
    : program_(kVertex, kFragment),
      vertices_{{0,
                 sizeof(Corner),
                 gl::Advance::PerVertex,
                 {{0, 4, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(Corner, place)},
                  {1, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(Corner, at)},
                  {2, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(Corner, up)},
                  {3, 1, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(Corner, fog)}}}},
      places_(buffer_of(GL_ARRAY_BUFFER, corners(squares_a_side))),
      order_(buffer_of(GL_ARRAY_BUFFER, triangles(static_cast<std::uint32_t>(squares_a_side)))),
      texture_(noise()) {}

void PlainGround::draw(const display::Canvas& canvas) const {
    begin(canvas);
    program_.use();
    texture_.bind(0);
    vertices_.bind();
    vertices_.feed(0, places_.name());
    vertices_.feed_indices(order_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(order_.bytes() / sizeof(std::uint32_t)), GL_UNSIGNED_INT,
                   nullptr);
    glBindVertexArray(0);
}

PlainSky::PlainSky() : program_(kSkyVertex, kSkyFragment), vertices_{} {
    program_.use();
    glUniform3f(glGetUniformLocation(program_.name(), "zenith"), 0.3F, 0.25F, 0.25F);
}

void PlainSky::draw(const display::Canvas& canvas) const {
    begin(canvas);
    program_.use();
    vertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace quadrat::benches
