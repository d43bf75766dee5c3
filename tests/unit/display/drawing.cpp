// SPDX-License-Identifier: Apache-2.0
#include "unit/display/drawing.hpp"

#include <stdexcept>
#include <string>

namespace quadrat::display::testing {
namespace {

// A quarter of the canvas as two triangles without any buffer: the vertex number is the corner.
constexpr const char* kVertex = R"(#version 310 es
uniform vec2 corner;
void main() {
    vec2 at = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    gl_Position = vec4(corner + at * 0.5, 0.0, 1.0);
})";
constexpr const char* kFragment = R"(#version 310 es
precision highp float;
uniform vec4 colour;
out vec4 pixel;
void main() { pixel = colour; })";

GLuint compiled(GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
    if (!is_good) {
        std::array<char, 1024> log{};
        glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
        throw std::runtime_error(log.data());
    }
    return shader;
}

GLuint linked_program() {
    const GLuint program = glCreateProgram();
    const GLuint vertex = compiled(GL_VERTEX_SHADER, kVertex);
    const GLuint fragment = compiled(GL_FRAGMENT_SHADER, kFragment);
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return program;
}

}  // namespace

void draw_four_quarters(const Canvas& canvas) {
    const GLuint program = linked_program();
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glViewport(0, 0, canvas.size.width, canvas.size.height);
    glClearColor(0.2F, 0.4F, 0.6F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glUseProgram(program);
    constexpr std::array<std::array<float, 5>, 4> kQuarters{{{-0.75F, -0.75F, 1.0F, 0.0F, 0.0F},
                                                             {0.25F, -0.75F, 0.0F, 1.0F, 0.0F},
                                                             {-0.75F, 0.25F, 0.0F, 0.0F, 1.0F},
                                                             {0.25F, 0.25F, 1.0F, 1.0F, 1.0F}}};
    for (const auto& [x, y, red, green, blue] : kQuarters) {
        glUniform2f(glGetUniformLocation(program, "corner"), x, y);
        glUniform4f(glGetUniformLocation(program, "colour"), red, green, blue, 1.0F);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glUseProgram(0);
    glDeleteProgram(program);
}

std::vector<Pixel> read_back(const Canvas& canvas) {
    std::vector<Pixel> pixels(static_cast<std::size_t>(canvas.size.width) *
                              static_cast<std::size_t>(canvas.size.height));
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, canvas.size.width, canvas.size.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

}  // namespace quadrat::display::testing
