// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// What a Raspberry Pi 4 or 5 cannot do (V3D 4.2 and 7.1 under Mesa 25.0), or does only by stalling its tiler. Every
// wrapper of this folder asks here, on any GPU, and what a Pi would refuse is recorded once: the exhibit logs it, a
// test that finds a record fails.
namespace quadrat::render::gl::limits {

inline constexpr int kLargestTexture = 4096;
inline constexpr int kUniformAlignment = 256;
inline constexpr int kLargestUniformBlock = 65536;
inline constexpr int kVertexAttributes = 16;
inline constexpr int kFragmentTextures = 24;

enum class Filter { Nearest, Linear };

void check_texture(int width, int height, GLenum internal_format, Filter filter);
void check_uniform_range(std::size_t offset_bytes, std::size_t size_bytes);
void check_attribute(GLuint location);
void check_draw(std::string_view entry_point);  // "glDrawElementsInstanced"
// Asks the linked program: storage blocks, images or samplers that its vertex stage uses; too many attributes or
// samplers. name is for the record.
void check_program(GLuint program, std::string_view name);
// Whether the context has it; asking for one that V3D lacks is recorded.
bool has_extension(std::string_view name);

std::vector<std::string> breaches();  // one line each, in the order first met
void forget_breaches();

// The same for source text, before a GPU sees it. One line "file:line: what" a breach.
std::vector<std::string> breaches_in_shader(std::string_view path, std::string_view text);
std::vector<std::string> breaches_in_code(std::string_view path, std::string_view text);

}  // namespace quadrat::render::gl::limits
