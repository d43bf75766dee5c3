// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/patterns.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/noise/gradient.hpp"
#include "synthesis/noise/reaction.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr int kSide = 128;

float smooth(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

float tiled(noise::Key key, int x, int y, int period, int octaves) {
    const float per_px = static_cast<float>(period) / kSide;
    return noise::fbm_tiled(key, static_cast<float>(x) * per_px, static_cast<float>(y) * per_px, period,
                            {.count = octaves});
}

}  // namespace

mesh::Image lichen_picture(base::Seed seed, float share) {
    mesh::Image picture(kSide, kSide, 2);
    if (share <= 0) return picture;
    // Colonies: branched crusts with bare rock between them.
    const mesh::Field crusts =
        noise::react({.feed = 0.050F, .kill = 0.0620F, .stretch = 1.6F, .steps = 560}, seed.child("crusts"), kSide);
    const noise::Key ground(seed.child("colonies"));
    const noise::Key rim(seed.child("rim"));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float colony = tiled(ground, x, y, 3, 3);
            const float crust = crusts.at(x, y) + 0.11F * tiled(rim, x, y, 24, 2);
            // What is not covered yet has the largest concentration last.
            const float edge = 0.34F - 0.26F * share;
            const float covered = smooth(edge, edge + 0.07F, crust);
            const float pale = covered * smooth(-0.10F, 0.06F, colony + 0.25F * (share - 0.5F));
            const float orange = covered * smooth(0.02F, 0.14F, -colony + 0.15F * (share - 0.5F));
            picture.pixel(x, y)[0] = static_cast<std::uint8_t>(255 * pale);
            picture.pixel(x, y)[1] = static_cast<std::uint8_t>(255 * orange);
        }
    return picture;
}

mesh::Field bare_bands(base::Seed seed) {
    mesh::Field grown =
        noise::react({.feed = 0.055F, .kill = 0.0620F, .stretch = 1.3F, .steps = 520}, seed.child("bands"), kSide);
    for (float& g : grown.samples) g = 1 - smooth(0.10F, 0.30F, g);
    return grown;
}

}  // namespace quadrat::synthesis::land
