// SPDX-License-Identifier: Apache-2.0
// What weather leaves on walls, and what grows on roofs: a reaction that diffuses faster downward (noise/reaction)
// makes runs and crusts, cloudy noise says where there are any.
#include "synthesis/houses/stains.hpp"

#include <glm/common.hpp>

#include "synthesis/noise/gradient.hpp"
#include "synthesis/noise/reaction.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr int kSide = 128;
constexpr int kClouds = 5;  // across a tile

mesh::Image made() {
    const base::Seed seed{0x57A1};
    const mesh::Field grown =
        noise::react({.feed = 0.050F, .kill = 0.0620F, .stretch = 6.5F, .steps = 420}, seed.child("runs"), kSide);
    const noise::Key clouds(seed.child("clouds"));
    mesh::Image picture(kSide, kSide, 1);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            constexpr float kPerPixel = static_cast<float>(kClouds) / kSide;
            const float cloud = noise::fbm_tiled(clouds, static_cast<float>(x) * kPerPixel,
                                                 static_cast<float>(y) * kPerPixel, kClouds, {.count = 4});
            const float here = glm::smoothstep(-0.35F, 0.5F, cloud);
            const float run = glm::smoothstep(0.02F, 0.34F, grown.at(x, y));
            *picture.pixel(x, y) = static_cast<std::uint8_t>(255 * here * (0.4F + 0.6F * run));
        }
    return picture;
}

}  // namespace

const std::shared_ptr<const mesh::Image>& weather_stains() {
    static const auto kStains = std::make_shared<const mesh::Image>(made());
    return kStains;
}

}  // namespace quadrat::synthesis::houses
