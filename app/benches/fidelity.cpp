// SPDX-License-Identifier: Apache-2.0
// What detail leaves out, and whether it is missed: the same four views with the detail that is drawn and with all
// there is.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/srgb.hpp"
#include "benches/benches.hpp"
#include "benches/four_views.hpp"

namespace quadrat::benches {
namespace {

constexpr float kFinest = 100;  // alpha

float linear_of(std::uint8_t encoded) { return base::linear_from_srgb(static_cast<float>(encoded) / 255); }

// CIE 1976 L*a*b* of a display's pixel, for the white of sRGB (D65).
glm::vec3 lab_of(const std::uint8_t* pixel) {
    const glm::vec3 light{linear_of(pixel[0]), linear_of(pixel[1]), linear_of(pixel[2])};
    const glm::mat3 xyz_from_rgb{0.4124F, 0.2126F, 0.0193F, 0.3576F, 0.7152F, 0.1192F, 0.1805F, 0.0722F, 0.9505F};
    glm::vec3 xyz = xyz_from_rgb * light / glm::vec3{0.9505F, 1.0F, 1.089F};
    for (int i = 0; i < 3; ++i) xyz[i] = xyz[i] > 0.008856F ? std::cbrt(xyz[i]) : 7.787F * xyz[i] + 16.0F / 116;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

// The picture as an eye sees it that cannot tell a pixel from its neighbour: squares of so many pixels, each its mean.
mesh::Image blurred(const mesh::Image& pixels, int square) {
    mesh::Image mean(pixels.width / square, pixels.height / square, 4);
    for (int y = 0; y < mean.height; ++y) {
        for (int x = 0; x < mean.width; ++x) {
            std::array<int, 4> sum{};
            for (int k = 0; k < square * square; ++k)
                for (std::size_t c = 0; c < 4; ++c)
                    sum[c] += pixels.pixel(x * square + k % square, y * square + k / square)[c];
            for (std::size_t c = 0; c < 4; ++c)
                mean.pixel(x, y)[c] = static_cast<std::uint8_t>(sum[c] / (square * square));
        }
    }
    return mean;
}

double difference(const mesh::Image& a, const mesh::Image& b) {
    double sum = 0;
    const std::size_t count = a.bytes.size() / 4;
    for (std::size_t i = 0; i < count; ++i) sum += glm::distance(lab_of(&a.bytes[4 * i]), lab_of(&b.bytes[4 * i]));
    return sum / static_cast<double>(count);
}

}  // namespace

void fidelity(Results& results, const Options& options) {
    FourViews views(options);
    results.gpu = views.easel.display().description();
    const render::Detail coarse_detail = views.picture.detail;
    double apart = 0;
    double apart_blurred = 0;
    double triangles = 0;
    double most = 0;
    int pictures = 0;
    for (const std::uint64_t seed : {11, 12, 13}) {
        if (seed != 11) views.grow(seed);
        for (const float seconds : {0.0F, 12.0F}) {
            views.look(seconds);
            const auto drawn = [&](const render::Detail& detail) {
                views.picture.detail = detail;
                const display::Canvas canvas = views.easel.display().begin_frame();
                views.picture.framebuffer = canvas.framebuffer;
                const auto count = static_cast<double>(views.easel.renderer().draw(views.picture).triangles);
                mesh::Image pixels = views.easel.renderer().read_pixels(views.picture);
                views.easel.display().present();
                return std::pair{std::move(pixels), count};
            };
            const auto [coarse, few] = drawn(coarse_detail);
            const auto [fine, many] = drawn({kFinest, 1});
            triangles += few;
            most += many;
            apart += difference(coarse, fine);
            apart_blurred += difference(blurred(coarse, 4), blurred(fine, 4));
            ++pictures;
        }
    }
    results.push_back({"detail.triangles", triangles / pictures, "triangles a picture", 1});
    results.push_back({"detail.triangle_ratio", most / triangles, "times fewer than all", 1});
    results.push_back({"detail.delta_e", apart / pictures, "CIE 1976, mean of all pixels", 1});
    results.push_back({"detail.delta_e_4px", apart_blurred / pictures, "the same of means of 4x4 pixels", 1});
}

}  // namespace quadrat::benches
