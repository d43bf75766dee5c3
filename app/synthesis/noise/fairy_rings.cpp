// SPDX-License-Identifier: Apache-2.0
// After Davidson, Sleeman, Rayner, Crawford & Ritz, "Travelling waves and pattern formation in a model for fungal
// development", J. Math. Biol. 35, 1997, without their slow recovery: a mycelium m spreads and lives on a substrate n,
//     dm/dt = D lap m + m n - k m,    dn/dt = -c m n.
// Its front travels at 2 sqrt(D (1 - k)) samples a unit of time (Fisher 1937; Kolmogorov et al. 1937); in steps as long
// as these a fourth slower.
#include "synthesis/noise/fairy_rings.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

namespace quadrat::synthesis::noise {
namespace {

constexpr float kSpreads = 0.22F;
constexpr float kDies = 0.3F;
constexpr float kEats = 1.4F;
constexpr float kStep = 0.7F;  // of time

struct Beginning {
    int x, y, step;
};

void live(const mesh::Field& m, mesh::Field& substrate, mesh::Field& next) {
    const int side = m.columns;
    for (int y = 0; y < side; ++y) {
        const int up = (y + side - 1) % side;
        const int down = (y + 1) % side;
        for (int x = 0; x < side; ++x) {
            const int left = (x + side - 1) % side;
            const int right = (x + 1) % side;
            const float here = m.at(x, y);
            // Of nine points, so that rings are round.
            const float beside = m.at(left, y) + m.at(right, y) + m.at(x, up) + m.at(x, down);
            const float across = m.at(left, up) + m.at(right, up) + m.at(left, down) + m.at(right, down);
            const float spread = (4 * beside + across - 20 * here) / 6;
            float& n = substrate.at(x, y);
            next.at(x, y) = std::max(here + kStep * (kSpreads * spread + here * n - kDies * here), 0.0F);
            n = std::max(n - kStep * kEats * here * n, 0.0F);
        }
    }
}

}  // namespace

mesh::Field fairy_rings(const FairyRings& rings, base::Seed seed, int side) {
    assert(side >= 8);
    base::RandomStream random{seed};
    std::vector<Beginning> beginnings;
    for (int i = 0; i < rings.beginnings; ++i) {
        const auto within = [&](int below) {
            return static_cast<int>(random.below(static_cast<std::uint32_t>(below)));
        };
        const int x = within(side), y = within(side);
        beginnings.push_back({x, y, i == 0 ? 0 : within(std::max(rings.steps * 2 / 3, 1))});
    }
    mesh::Field m(side, side), next(side, side), substrate(side, side);
    std::ranges::fill(substrate.samples, 1.0F);
    for (int step = 0; step < rings.steps; ++step) {
        for (const Beginning& b : beginnings)
            if (b.step == step) m.at(b.x, b.y) = std::max(m.at(b.x, b.y), substrate.at(b.x, b.y));
        live(m, substrate, next);
        std::swap(m, next);
    }
    return m;
}

}  // namespace quadrat::synthesis::noise
