// SPDX-License-Identifier: Apache-2.0
#include "render/gl/program.hpp"

#include <fmt/core.h>

#include <charconv>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "render/gl/limits.hpp"
#include "render/gl/wires.hpp"

namespace quadrat::render::gl {
namespace {

std::string log_of(GLuint name, void (*length_of)(GLuint, GLenum, GLint*),
                   void (*text_of)(GLuint, GLsizei, GLsizei*, GLchar*)) {
    GLint length = 0;
    length_of(name, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> text(static_cast<std::size_t>(length) + 1);
    text_of(name, length + 1, nullptr, text.data());
    return text.data();
}

ShaderName compiled(GLenum stage, const shaders::Source& source) {
    ShaderName shader{glCreateShader(stage)};
    const char* text = source.text.data();
    const GLint length = static_cast<GLint>(source.text.size());
    glShaderSource(shader.get(), 1, &text, &length);
    glCompileShader(shader.get());
    GLint is_compiled = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled) return shader;
    const std::string log = log_of(
        shader.get(), [](GLuint n, GLenum what, GLint* v) { glGetShaderiv(n, what, v); },
        [](GLuint n, GLsizei size, GLsizei* got, GLchar* out) { glGetShaderInfoLog(n, size, got, out); });
    throw base::InputError(
        fmt::format("shader {}: this GPU's driver refuses it: {}", source.name, with_file_names(log, source)));
}

// Mesa writes "1:2(7): error", NVIDIA "1(2) : error": file 1, line 2.
std::string with_file_name(const std::string& line, const shaders::Source& source) {
    const char* const last = line.data() + line.size();
    std::size_t file = 0, number = 0;
    const auto [end, error] = std::from_chars(line.data(), last, file);
    if (error != std::errc{} || end == last || file >= source.files.size()) return line;
    if (*end == ':') return std::string{source.files[file]} + end;
    const auto [close, trouble] = std::from_chars(end + 1, last, number);
    const bool is_nvidias = *end == '(' && trouble == std::errc{} && close != last && *close == ')';
    if (!is_nvidias) return line;
    const std::string_view rest = std::string_view(close + 1, static_cast<std::size_t>(last - close - 1));
    return fmt::format("{}:{}{}", source.files[file], number, rest.starts_with(" :") ? rest.substr(1) : rest);
}

}  // namespace

std::string with_file_names(std::string_view driver_log, const shaders::Source& source) {
    std::string named;
    std::istringstream lines{std::string{driver_log}};
    for (std::string line; std::getline(lines, line);) {
        if (!named.empty()) named += '\n';
        named += with_file_name(line, source);
    }
    return named;
}

Program::Program(const shaders::Source& vertex, const shaders::Source& fragment)
    : name_(glCreateProgram()), vertex_(vertex) {
    const ShaderName first = compiled(GL_VERTEX_SHADER, vertex);
    const ShaderName second = compiled(GL_FRAGMENT_SHADER, fragment);
    glAttachShader(name_.get(), first.get());
    glAttachShader(name_.get(), second.get());
    glLinkProgram(name_.get());
    // What stays attached is not deleted, and a driver keeps what it made of its text.
    glDetachShader(name_.get(), first.get());
    glDetachShader(name_.get(), second.get());
    GLint is_linked = 0;
    glGetProgramiv(name_.get(), GL_LINK_STATUS, &is_linked);
    const std::string both = fmt::format("{} + {}", vertex.name, fragment.name);
    if (!is_linked) {
        const std::string log = log_of(
            name_.get(), [](GLuint n, GLenum what, GLint* v) { glGetProgramiv(n, what, v); },
            [](GLuint n, GLsizei size, GLsizei* got, GLchar* out) { glGetProgramInfoLog(n, size, got, out); });
        throw base::InputError(fmt::format("shaders {}: this GPU's driver cannot link them: {}", both, log));
    }
    limits::check_program(name_.get(), both);
}

void Program::use() const {
    if (!Wires::are_on()) {
        glUseProgram(name_.get());
        return;
    }
    if (!wired_) wired_ = std::make_unique<Program>(vertex_, shaders::source("wire.frag"));
    glUseProgram(wired_->name());
    Wires::set_level(0);
}

}  // namespace quadrat::render::gl
