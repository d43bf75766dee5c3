// SPDX-License-Identifier: Apache-2.0
#include "render/gl/limits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <regex>

#include "base/log.hpp"

namespace quadrat::render::gl::limits {
namespace {

struct Record {
    std::mutex mutex;
    std::vector<std::string> lines;
};
Record& record() {
    static Record one;
    return one;
}

void breach(std::string line) {
    Record& kept = record();
    const std::lock_guard lock(kept.mutex);
    if (std::ranges::find(kept.lines, line) != kept.lines.end()) return;
    base::log::warn("a Raspberry Pi could not do this: {}", line);
    kept.lines.push_back(std::move(line));
}

// Of those that a shader or a renderer like ours might want; V3D 7.1 lacks no more than V3D 4.2 does.
constexpr std::array kLacking{
    "GL_EXT_float_blend",
    "GL_OES_texture_float_linear",
    "GL_EXT_texture_norm16",
    "GL_EXT_texture_compression_bptc",
    "GL_EXT_tessellation_shader",
    "GL_OES_tessellation_shader",
    "GL_OES_sample_variables",
    "GL_OES_sample_shading",
    "GL_OES_shader_multisample_interpolation",
    "GL_EXT_texture_buffer",
    "GL_OES_texture_buffer",
    "GL_EXT_clip_cull_distance",
    "GL_KHR_blend_equation_advanced",
    "GL_KHR_robustness",
    "GL_EXT_robustness",
    "GL_EXT_shader_framebuffer_fetch",
    "GL_ARM_shader_framebuffer_fetch",
    "GL_EXT_gpu_shader5",
    "GL_EXT_shader_implicit_conversions",
    "GL_NV_gpu_shader5",
    "GL_EXT_mesh_shader",
};
// They exist there, and stall it: the binner then waits for the last frame to be drawn.
constexpr std::array kStalling{"GL_EXT_multi_draw_indirect", "GL_EXT_disjoint_timer_query"};

template <typename Names, typename Name>
bool is_one_of(const Names& names, Name name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_norm16(GLenum format) {
    return is_one_of(std::array<GLenum, 8>{0x822A, 0x822C, 0x8054, 0x805B, 0x8F98, 0x8F99, 0x8F9A, 0x8F9B}, format);
}
bool is_float32(GLenum format) {
    return is_one_of(std::array<GLenum, 4>{GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F}, format);
}

bool is_sampler(GLint type) {
    return is_one_of(
        std::array<GLint, 13>{GL_SAMPLER_2D, GL_SAMPLER_3D, GL_SAMPLER_CUBE, GL_SAMPLER_2D_SHADOW, GL_SAMPLER_2D_ARRAY,
                              GL_SAMPLER_2D_ARRAY_SHADOW, GL_SAMPLER_CUBE_SHADOW, GL_INT_SAMPLER_2D, GL_INT_SAMPLER_3D,
                              GL_INT_SAMPLER_2D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_3D,
                              GL_UNSIGNED_INT_SAMPLER_2D_ARRAY},
        type);
}
bool is_image(GLint type) {
    return is_one_of(std::array<GLint, 4>{GL_IMAGE_2D, GL_IMAGE_3D, GL_IMAGE_CUBE, GL_IMAGE_2D_ARRAY}, type);
}

GLint count_of(GLuint program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return count;
}

template <std::size_t N>
std::array<GLint, N> properties_of(GLuint program, GLenum interface, GLint index, const std::array<GLenum, N>& wanted) {
    std::array<GLint, N> values{};
    glGetProgramResourceiv(program, interface, static_cast<GLuint>(index), N, wanted.data(), N, nullptr, values.data());
    return values;
}

std::string name_of(GLuint program, GLenum interface, GLint index) {
    std::array<char, 128> text{};
    glGetProgramResourceName(program, interface, static_cast<GLuint>(index), text.size(), nullptr, text.data());
    return text.data();
}

// One pattern and what to say of a line that matches.
struct Ban {
    std::regex pattern;
    std::string why;
};

std::vector<std::string> banned_lines(std::string_view path, std::string_view text, const std::vector<Ban>& bans) {
    std::vector<std::string> found;
    std::size_t number = 0;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        std::string line{text.substr(start, end - start)};
        line = line.substr(0, line.find("//"));
        ++number;
        for (const Ban& ban : bans)
            if (std::regex_search(line, ban.pattern)) found.push_back(fmt::format("{}:{}: {}", path, number, ban.why));
        start = end + 1;
    }
    return found;
}

}  // namespace

void check_texture(int width, int height, GLenum internal_format, Filter filter) {
    if (std::max(width, height) > kLargestTexture)
        breach(fmt::format("a texture of {}x{}; {} a side is the largest", width, height, kLargestTexture));
    if (is_norm16(internal_format)) breach(fmt::format("a 16 bit normalised texture (0x{:x})", internal_format));
    if (is_float32(internal_format) && filter == Filter::Linear)
        breach(fmt::format("a filtered 32 bit float texture (0x{:x})", internal_format));
}

void check_uniform_range(std::size_t offset_bytes, std::size_t size_bytes) {
    if (offset_bytes % kUniformAlignment != 0)
        breach(fmt::format("a uniform block at byte {}; offsets are multiples of {}", offset_bytes, kUniformAlignment));
    if (size_bytes > kLargestUniformBlock)
        breach(fmt::format("a uniform block of {} bytes; {} is the largest", size_bytes, kLargestUniformBlock));
}

void check_attribute(GLuint location) {
    if (location >= kVertexAttributes)
        breach(fmt::format("vertex attribute {}; there are {}", location, kVertexAttributes));
}

void check_draw(std::string_view entry_point) {
    if (entry_point.find("Indirect") != std::string_view::npos)
        breach(fmt::format("{}: an indirect draw stalls the binner", entry_point));
}

void check_program(GLuint program, std::string_view name) {
    for (GLint i = 0; i < count_of(program, GL_SHADER_STORAGE_BLOCK); ++i) {
        const auto [in_vertex] =
            properties_of<1>(program, GL_SHADER_STORAGE_BLOCK, i, {GL_REFERENCED_BY_VERTEX_SHADER});
        if (in_vertex)
            breach(fmt::format("{}: storage block {} in the vertex stage", name,
                               name_of(program, GL_SHADER_STORAGE_BLOCK, i)));
    }
    int samplers = 0;
    for (GLint i = 0; i < count_of(program, GL_UNIFORM); ++i) {
        const auto [type, in_vertex, size] =
            properties_of<3>(program, GL_UNIFORM, i, {GL_TYPE, GL_REFERENCED_BY_VERTEX_SHADER, GL_ARRAY_SIZE});
        const bool fetches = is_sampler(type) || is_image(type);
        samplers += is_sampler(type) ? size : 0;
        if (fetches && in_vertex)
            breach(fmt::format("{}: {} is fetched in the vertex stage, which stalls the binner", name,
                               name_of(program, GL_UNIFORM, i)));
    }
    if (samplers > kFragmentTextures) breach(fmt::format("{}: {} textures", name, samplers));
    if (count_of(program, GL_PROGRAM_INPUT) > kVertexAttributes + 2)
        breach(fmt::format("{}: more than {} vertex attributes", name, kVertexAttributes));
}

bool has_extension(std::string_view name) {
    if (is_one_of(kLacking, name)) breach(fmt::format("{} is asked for; V3D lacks it", name));
    if (is_one_of(kStalling, name)) breach(fmt::format("{} is asked for; it stalls V3D", name));
    return epoxy_has_gl_extension(std::string{name}.c_str());
}

std::vector<std::string> breaches() {
    const std::lock_guard lock(record().mutex);
    return record().lines;
}

void forget_breaches() {
    const std::lock_guard lock(record().mutex);
    record().lines.clear();
}

std::vector<std::string> breaches_in_shader(std::string_view path, std::string_view text) {
    std::vector<Ban> bans;
    for (const char* name : kLacking)
        bans.push_back({std::regex(fmt::format(R"(#\s*extension\s+{}\b)", name)), fmt::format("V3D lacks {}", name)});
    bans.push_back({std::regex(R"(\bdiscard\b)"), "discard switches early depth off"});
    bans.push_back({std::regex(R"(\bgl_FragDepth\b)"), "a depth of its own switches early depth off"});
    if (path.ends_with(".vert")) {
        bans.push_back({std::regex(R"(\b(textureLod|texelFetch|texture|textureGrad|imageLoad)\w*\s*\()"),
                        "a fetch in the vertex stage stalls the binner"});
        bans.push_back({std::regex(R"(\bbuffer\b)"), "V3D has no storage blocks in the vertex stage"});
    }
    return banned_lines(path, text, bans);
}

std::vector<std::string> breaches_in_code(std::string_view path, std::string_view text) {
    static const std::vector<Ban> bans{
        {std::regex(R"(\bgl(Multi)?Draw\w*Indirect\w*\s*\()"), "an indirect draw stalls the binner"},
        {std::regex(R"(\bgl(Begin|End)Query\w*\s*\()"), "a query flushes the tiles"},
        {std::regex(R"(\bglReadPixels\s*\()"), "reading back flushes the tiles"},
        {std::regex(R"(\bglMemoryBarrier\w*\s*\()"), "a barrier flushes every job"},
        {std::regex(R"(\bepoxy_has_gl_extension\s*\()"), "asks for an extension past the limits"},
    };
    return banned_lines(path, text, bans);
}

}  // namespace quadrat::render::gl::limits
