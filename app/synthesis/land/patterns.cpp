// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/patterns.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

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

// What one lichen covers: a disc with a ragged rim, thin in the middle where it is old. In samples, on the torus.
struct Thallus {
    glm::vec2 middle;
    float radius;
    std::size_t channel;
};

void grow_on(mesh::Image& picture, const Thallus& thallus, const mesh::Field& ragged, const mesh::Field& crust) {
    const int reach = static_cast<int>(1.5F * thallus.radius) + 1;
    const glm::ivec2 at(thallus.middle);
    const auto wrapped = [](int i) { return (i + kSide) % kSide; };
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            const int x = wrapped(at.x + dx);
            const int y = wrapped(at.y + dy);
            const glm::vec2 off = glm::vec2(at.x + dx, at.y + dy) + 0.5F - thallus.middle;
            const float r = glm::length(off) / thallus.radius + 0.6F * ragged.at(x, y);
            const float old = smooth(3.0F, 8.0F, thallus.radius) * (1 - smooth(0.2F, 0.8F, r));
            const float covers = (1 - smooth(1.0F - 0.8F / thallus.radius, 1.0F + 0.8F / thallus.radius, r)) *
                                 (1 - 0.6F * old) * (0.65F + 0.35F * crust.at(x, y));
            // Two that meet share what is there.
            auto* const channels = picture.pixel(x, y);
            const std::size_t other = 1 - thallus.channel;
            channels[thallus.channel] = std::max(channels[thallus.channel], static_cast<std::uint8_t>(255 * covers));
            channels[other] = std::min(channels[other], static_cast<std::uint8_t>(255 - channels[thallus.channel]));
        }
    }
}

}  // namespace

mesh::Image lichen_picture(base::Seed seed, float share) {
    mesh::Image picture(kSide, kSide, 2);
    if (share <= 0) return picture;
    mesh::Field crust =
        noise::react({.feed = 0.050F, .kill = 0.0620F, .stretch = 1.3F, .steps = 260}, seed.child("crusts"), kSide);
    for (float& c : crust.samples) c = smooth(0.08F, 0.25F, c);
    mesh::Field ragged(kSide, kSide);
    const noise::Key rim(seed.child("rim"));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) ragged.at(x, y) = tiled(rim, x, y, 20, 3);
    // Much as share may be, most of the rock stays bare: stone that is covered all over looks painted.
    // Where there is little of it, all of it is small: one large crust would show that tiles repeat.
    constexpr float kSmallest = 1.1F;
    constexpr float kOrange = 0.2F;  // of them
    const float largest = 2.0F + 5.0F * share;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(40 + 200 * share); ++i) {
        base::RandomStream random{seed.child("thallus").child(i)};
        const glm::vec2 middle{random.between(0.0F, 1.0F * kSide), random.between(0.0F, 1.0F * kSide)};
        const std::size_t channel = random.unit_f() < kOrange ? 1 : 0;
        const float radius =
            std::min(kSmallest * std::pow(random.unit_f() + 1.0e-3F, -0.6F), channel == 0 ? largest : 0.6F * largest);
        grow_on(picture, {middle, radius, channel}, ragged, crust);
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
