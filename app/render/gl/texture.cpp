// SPDX-License-Identifier: Apache-2.0
#include "render/gl/texture.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "render/gl/limits.hpp"

namespace quadrat::render::gl {
namespace {

GLenum internal_format(const TextureShape& shape) {
    return shape.channels == 1 ? GL_R8 : shape.channels == 2 ? GL_RG8 : GL_RGBA8;
}

GLenum pixel_format(int channels) { return channels == 1 ? GL_RED : channels == 2 ? GL_RG : GL_RGBA; }

GLint minifying(Sampling sampling) {
    if (sampling == Sampling::Flat) return GL_LINEAR;
    return sampling == Sampling::Sharp ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR;
}

GLint wrapped(Wrap wrap) { return wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; }

}  // namespace

int TextureShape::levels() const {
    if (sampling == Sampling::Flat) return 1;
    int count = 1;
    for (int side = std::max(width, height); side > coarsest; side /= 2) ++count;
    return count;
}

Texture2D::Texture2D(const TextureShape& shape) : shape_(shape) {
    limits::check_texture(shape.width, shape.height, internal_format(shape), limits::Filter::Linear);
    GLuint name = 0;
    glGenTextures(1, &name);
    name_.reset(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, shape.levels(), internal_format(shape), shape.width, shape.height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minifying(shape.sampling));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapped(shape.wrap_s));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapped(shape.wrap_t));
}

void Texture2D::write_rows(int level, int first_row, int rows, std::span<const std::uint8_t> bytes) const {
    assert(bytes.size() >= static_cast<std::size_t>(width(level) * rows * shape_.channels));
    glBindTexture(GL_TEXTURE_2D, name_.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, level, 0, first_row, width(level), rows, pixel_format(shape_.channels),
                    GL_UNSIGNED_BYTE, bytes.data());
}

void Texture2D::fill_levels() const {
    glBindTexture(GL_TEXTURE_2D, name_.get());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void Texture2D::bind(GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name_.get());
}

const std::array<std::uint8_t, 256>& roots_of_srgb() {
    static const std::array<std::uint8_t, 256> table = [] {
        std::array<std::uint8_t, 256> roots{};
        for (std::size_t i = 0; i < roots.size(); ++i) {
            const float e = static_cast<float>(i) / 255;
            const float linear = e <= 0.04045F ? e / 12.92F : std::pow((e + 0.055F) / 1.055F, 2.4F);
            roots[i] = static_cast<std::uint8_t>(std::lround(255 * std::sqrt(linear)));
        }
        return roots;
    }();
    return table;
}

mesh::Image halved(const mesh::Image& image) {
    mesh::Image half(std::max(image.width / 2, 1), std::max(image.height / 2, 1), image.channels);
    for (int y = 0; y < half.height; ++y) {
        const std::uint8_t* upper = image.pixel(0, std::min(2 * y, image.height - 1));
        const std::uint8_t* lower = image.pixel(0, std::min(2 * y + 1, image.height - 1));
        std::uint8_t* out = half.pixel(0, y);
        for (int x = 0; x < half.width; ++x) {
            const int left = std::min(2 * x, image.width - 1) * image.channels;
            const int right = std::min(2 * x + 1, image.width - 1) * image.channels;
            for (int c = 0; c < image.channels; ++c)
                *out++ = static_cast<std::uint8_t>(
                    (upper[left + c] + upper[right + c] + lower[left + c] + lower[right + c] + 2) / 4);
        }
    }
    return half;
}

}  // namespace quadrat::render::gl
