// SPDX-License-Identifier: Apache-2.0
// Gierer & Meinhardt, "A theory of biological pattern formation", Kybernetik 12, 1972: an activator a that makes more
// of itself and of an inhibitor h, which spreads faster and keeps it down:
//     da/dt = Da lap a + rho a^2 / h - mu a + sigma,    dh/dt = Dh lap h + rho a^2 - nu h.
// One step a unit of time, one sample a unit of length.
#include "synthesis/noise/lateral_inhibition.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

namespace quadrat::synthesis::noise {
namespace {

constexpr float kDa = 0.02F;
constexpr float kDh = 0.24F;
constexpr float kRho = 0.05F;
constexpr float kMu = 0.05F;
constexpr float kNu = 0.07F;
constexpr float kSigma = 0.001F;

struct Morphogens {
    mesh::Field a, h;
};

void react(const Morphogens& m, int y, Morphogens& next) {
    const int side = m.a.columns;
    const int up = (y + side - 1) % side;
    const int down = (y + 1) % side;
    for (int x = 0; x < side; ++x) {
        const int left = x == 0 ? side - 1 : x - 1;
        const int right = x + 1 == side ? 0 : x + 1;
        const auto spread = [&](const mesh::Field& f) {
            return f.at(left, y) + f.at(right, y) + f.at(x, up) + f.at(x, down) - 4 * f.at(x, y);
        };
        const float a = m.a.at(x, y);
        const float h = m.h.at(x, y);
        const float made = kRho * a * a;
        next.a.at(x, y) = a + kDa * spread(m.a) + made / std::max(h, 1.0e-3F) - kMu * a + kSigma;
        next.h.at(x, y) = h + kDh * spread(m.h) + made - kNu * h;
    }
}

}  // namespace

mesh::Field inhibited(const LateralInhibition& inhibition, base::Seed seed, int side) {
    assert(side >= 16);
    Morphogens m{mesh::Field(side, side), mesh::Field(side, side)};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            m.a.at(x, y) = 0.9F + 0.2F * base::unit_of(base::hash_of(seed, x, y));
            m.h.at(x, y) = 1;
        }
    Morphogens next = m;
    for (int step = 0; step < inhibition.steps; ++step) {
        for (int y = 0; y < side; ++y) react(m, y, next);
        std::swap(m, next);
    }
    return std::move(m.a);
}

std::vector<glm::ivec2> peaks_of(const mesh::Field& field) {
    const float mean =
        std::accumulate(field.samples.begin(), field.samples.end(), 0.0F) / static_cast<float>(field.samples.size());
    const auto is_peak = [&](int x, int y) {
        const float here = field.at(x, y);
        if (here < 1.5F * mean) return false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (dx == 0 && dy == 0) continue;
                const int nx = (x + dx + field.columns) % field.columns;
                const int ny = (y + dy + field.rows) % field.rows;
                if (field.at(nx, ny) >= here) return false;
            }
        return true;
    };
    std::vector<glm::ivec2> peaks;
    for (int y = 0; y < field.rows; ++y)
        for (int x = 0; x < field.columns; ++x)
            if (is_peak(x, y)) peaks.emplace_back(x, y);
    return peaks;
}

mesh::Field ranks_of(const mesh::Field& field) {
    std::vector<std::size_t> order(field.samples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return field.samples[i]; });
    mesh::Field ranks(field.columns, field.rows);
    for (std::size_t i = 0; i < order.size(); ++i)
        ranks.samples[order[i]] = (static_cast<float>(i) + 0.5F) / static_cast<float>(order.size());
    return ranks;
}

}  // namespace quadrat::synthesis::noise
