// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/sky.hpp"

namespace quadrat::scene {
namespace {

TEST(CloudscapePlaces, AreEachOthersInverse) {
    for (float x = 0.01F; x < 1; x += 0.07F) {
        for (float y = 0.01F; y < 1; y += 0.09F) {
            const glm::vec2 back = cloudscape_at(cloudscape_direction({x, y}));
            EXPECT_NEAR(back.x, x, 1e-4F) << x << " " << y;
            EXPECT_NEAR(back.y, y, 1e-4F) << x << " " << y;
        }
    }
}

TEST(CloudscapePlaces, LieNorthInTheMiddleAndFinestThere) {
    EXPECT_NEAR(cloudscape_at({0, 0, -1}).x, 0.5F, 1e-6F);
    EXPECT_NEAR(cloudscape_at({0, 0, -1}).y, 0, 1e-6F);
    EXPECT_NEAR(cloudscape_at({0, 1, 0}).y, 1, 1e-6F);
    const auto across = [](float from, float to) {
        return cloudscape_at({std::sin(to), 0, -std::cos(to)}).x -
               cloudscape_at({std::sin(from), 0, -std::cos(from)}).x;
    };
    EXPECT_GT(across(0, 0.1F), 3 * across(2.9F, 3.0F));
}

TEST(CloudscapeDrift, GoesWithTheWindAndNeverFar) {
    CloudLayer layer;
    layer.wind_m_s = {8, 0};
    EXPECT_NEAR(cloudscape_drift_rad(layer, 10), 8 * 10 / 4000.0F, 1e-3F);  // of what hangs 4 km away
    CloudLayer back;
    back.wind_m_s = {-8, 0};
    EXPECT_LT(cloudscape_drift_rad(back, 10), 0);
    for (float seconds = 0; seconds < 5000; seconds += 37)
        EXPECT_LT(std::abs(cloudscape_drift_rad(layer, seconds)), 0.17F);
    layer.wind_m_s = {0, 0};
    EXPECT_EQ(cloudscape_drift_rad(layer, 100), 0);
}

// A flat layer, half of it closed: as the layer has it where a ray meets it.
TEST(CloudscapeOf, AFlatLayerShowsItWhereRaysMeetIt) {
    CloudLayer layer;
    layer.density = mesh::Image(64, 64, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) *layer.density.pixel(x, y) = x < 32 ? 255 : 0;
    layer.tile_m = 8000;
    const Cloudscape picture = cloudscape_of(layer, 512, 128);
    int alike = 0;
    int all = 0;
    for (int y = 20; y < 128; y += 5) {
        for (int x = 0; x < 512; x += 3) {
            const glm::vec3 d =
                cloudscape_direction({(static_cast<float>(x) + 0.5F) / 512, (static_cast<float>(y) + 0.5F) / 128});
            const glm::vec2 tile = tile_at(layer, glm::vec2{d.x, d.z} * (layer.height_m / (d.y + kBendsDown)));
            const bool is_closed = tile.x - std::floor(tile.x) < 0.5F;
            alike += is_closed == (picture.pixel(x, y)[0] > 128) ? 1 : 0;
            ++all;
        }
    }
    EXPECT_GT(alike, 0.99 * all);
    EXPECT_TRUE(cloudscape_of({}, 8, 8).bytes.empty());
}

}  // namespace
}  // namespace quadrat::scene
