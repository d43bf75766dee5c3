// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/reaction.hpp"

#include <algorithm>
#include <vector>

namespace quadrat::synthesis::noise {
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

}  // namespace quadrat::synthesis::noise
