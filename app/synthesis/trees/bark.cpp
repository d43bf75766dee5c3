// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/bark.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::trees {
namespace {

// Rows with one sample more on each side, so that the inner loop needs no wrap.
struct Torus {
    int side;
    int stride;
    std::vector<float> samples;
    explicit Torus(int n, float fill)
        : side(n), stride(n + 2), samples(static_cast<std::size_t>(stride) * static_cast<std::size_t>(stride), fill) {}
    float* row(int y) { return samples.data() + static_cast<std::ptrdiff_t>(y + 1) * stride + 1; }
    void wrap() {
        for (int y = 0; y < side; ++y) {
            row(y)[-1] = row(y)[side - 1];
            row(y)[side] = row(y)[0];
        }
        std::copy_n(row(side - 1) - 1, stride, row(-1) - 1);
        std::copy_n(row(0) - 1, stride, row(side) - 1);
    }
};

void react_row(const float* u, const float* v, int stride, int side, const Reaction& r, float* next_u, float* next_v) {
    const float along = 2.0F * r.stretch / (1.0F + r.stretch);
    const float across = 2.0F - along;
    const float feed = r.feed;
    const float loss = r.feed + r.kill;
    for (int x = 0; x < side; ++x) {
        const float lu = across * (u[x - 1] + u[x + 1] - 2 * u[x]) + along * (u[x - stride] + u[x + stride] - 2 * u[x]);
        const float lv = across * (v[x - 1] + v[x + 1] - 2 * v[x]) + along * (v[x - stride] + v[x + stride] - 2 * v[x]);
        const float reacted = u[x] * v[x] * v[x];
        next_u[x] = u[x] + 0.16F * lu - reacted + feed * (1.0F - u[x]);
        next_v[x] = v[x] + 0.08F * lv + reacted - loss * v[x];
    }
}

float tile_noise(noise::Key key, float u, float v, int period, int octaves) {
    const auto p = static_cast<float>(period);
    return noise::fbm_tiled(key, std::min(u * p, p * 0.999999F), std::min(v * p, p * 0.999999F), period,
                            {.count = octaves});
}

// The two nearest of the points of a torus with so many cells a side: Worley's noise of 1996.
glm::vec2 cells(base::Seed seed, float u, float v, int across, int along) {
    const float x = u * static_cast<float>(across);
    const float y = v * static_cast<float>(along);
    const int cx = static_cast<int>(std::floor(x));
    const int cy = static_cast<int>(std::floor(y));
    float first = 9;
    float second = 9;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int wx = (cx + dx + across) % across;
            const int wy = (cy + dy + along) % along;
            const std::uint64_t hash = base::hash_of(seed, wx, wy);
            const float px = static_cast<float>(cx + dx) + 0.1F + 0.8F * base::unit_of(hash);
            const float py = static_cast<float>(cy + dy) + 0.1F + 0.8F * base::unit_of(hash << 24U);
            const float d = std::hypot(x - px, y - py);
            second = std::min(second, std::max(first, d));
            first = std::min(first, d);
        }
    }
    return {first, second};
}

void normalise(mesh::Field& field) {
    const auto [low, high] = std::minmax_element(field.samples.begin(), field.samples.end());
    const float least = *low;
    const float range = std::max(*high - least, 1.0e-4F);
    for (float& value : field.samples) value = (value - least) / range;
}

}  // namespace

mesh::Field react(const Reaction& reaction, base::Seed seed, int side) {
    Torus u(side, 1.0F);
    Torus v(side, 0.0F);
    Torus next_u(side, 1.0F);
    Torus next_v(side, 0.0F);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool is_seed = base::unit_of(base::hash_of(seed, x / 2, y / 5)) < 0.5F;
            u.row(y)[x] = is_seed ? 0.5F : 1.0F;
            v.row(y)[x] = is_seed ? 0.25F + 0.1F * base::unit_of(base::hash_of(seed, x, y, 1)) : 0.0F;
        }
    for (int step = 0; step < reaction.steps; ++step) {
        u.wrap();
        v.wrap();
        for (int y = 0; y < side; ++y)
            react_row(u.row(y), v.row(y), u.stride, side, reaction, next_u.row(y), next_v.row(y));
        std::swap(u.samples, next_u.samples);
        std::swap(v.samples, next_v.samples);
    }
    mesh::Field field(side, side);
    for (int y = 0; y < side; ++y)
        std::copy_n(v.row(y), side, field.samples.begin() + static_cast<std::ptrdiff_t>(y) * side);
    return field;
}

mesh::Field bark_relief(Bark kind, base::Seed seed, int side) {
    mesh::Field relief(side, side);
    const noise::Key rough(seed.child("rough"));
    const noise::Key bend(seed.child("bend"));
    mesh::Field ridges;
    const int half = side / 2;
    if (kind == Bark::Furrowed) ridges = react({}, seed.child("reaction"), half);
    const auto ridge_at = [&](float u, float v) {
        const float x = u * static_cast<float>(half);
        const float y = v * static_cast<float>(half);
        const int x0 = static_cast<int>(x) % half;
        const int y0 = static_cast<int>(y) % half;
        const float tx = x - std::floor(x);
        const float ty = y - std::floor(y);
        const auto at = [&](int dx, int dy) { return ridges.at((x0 + dx) % half, (y0 + dy) % half); };
        return (1 - ty) * ((1 - tx) * at(0, 0) + tx * at(1, 0)) + ty * ((1 - tx) * at(0, 1) + tx * at(1, 1));
    };
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const float u = (static_cast<float>(column) + 0.5F) / static_cast<float>(side);
            const float v = (static_cast<float>(row) + 0.5F) / static_cast<float>(side);
            const float grain = tile_noise(rough, u, v, 8, 3);
            float h = 0;
            switch (kind) {
                case Bark::Furrowed:
                    h = 2.4F * ridge_at(u, v) + 0.12F * grain;
                    break;
                case Bark::Plates: {
                    const float warp = 0.03F * tile_noise(bend, u, v, 4, 2);
                    const glm::vec2 f = cells(seed, std::fmod(u + warp + 1, 1.0F), std::fmod(v + warp + 1, 1.0F), 5, 3);
                    h = std::min(2.6F * (f.y - f.x), 1.0F) + 0.15F * grain;
                    break;
                }
                case Bark::Smooth:
                    h = 0.5F + 0.22F * tile_noise(bend, u, v, 3, 2) + 0.05F * grain;
                    break;
                case Bark::Banded: {
                    // Short dark bands around the limb.
                    const glm::vec2 f = cells(seed, u, v, 3, 14);
                    h = f.x > 0.28F ? 0.85F + 0.08F * grain : 0.85F * f.x / 0.28F;
                    break;
                }
            }
            relief.at(column, row) = h;
        }
    }
    if (kind != Bark::Smooth) normalise(relief);
    return relief;
}

mesh::Image bark_picture(const mesh::Field& relief, float depth) {
    const int n = relief.columns;
    mesh::Image picture(n, n, 4);
    const auto byte = [](float unit) {
        return static_cast<std::uint8_t>(std::clamp(128.0F + 127.0F * unit, 0.0F, 255.0F));
    };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const float across = relief.at((x + n - 1) % n, y) - relief.at((x + 1) % n, y);
            const float along = relief.at(x, (y + n - 1) % n) - relief.at(x, (y + 1) % n);
            std::uint8_t* p = picture.pixel(x, y);
            p[0] = byte(2.2F * depth * across);
            p[1] = byte(2.2F * depth * along);
            p[2] = byte(depth * 0.85F * (relief.at(x, y) - 0.58F));
            p[3] = 255;
        }
    }
    return picture;
}

}  // namespace quadrat::synthesis::trees
