// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/hero_place.hpp"

#include <algorithm>
#include <optional>

#include "synthesis/compose/view_rays.hpp"

namespace quadrat::synthesis {
namespace {

bool is_whole_in(const scene::Camera& camera, const glm::vec3& foot_m, float high_m) {
    constexpr float kFoot = -0.94F;
    constexpr float kTop = 0.97F;
    const std::optional<glm::vec2> foot = in_picture(camera, foot_m);
    const std::optional<glm::vec2> top = in_picture(camera, foot_m + glm::vec3{0, high_m, 0});
    return foot && top && foot->y > kFoot && top->y < kTop;
}

}  // namespace

std::optional<glm::vec2> hero_place(const scene::Land& land, const FlightPlan& flight, const scene::Track& track,
                                    float high_m, float side, base::RandomStream& random) {
    constexpr float kPictureOverDistance = 0.7677F;  // a picture's height, 42 degrees
    constexpr int kFarther = 5;
    const std::size_t early = flight.stations.size() / 5;
    const FlightPlan::Station& from = flight.stations[early];
    const glm::vec2 right{-from.ahead.y, from.ahead.x};
    const float share = random.between(0.40F, 0.62F);  // of the picture's height
    const float near_m = std::clamp(high_m / (kPictureOverDistance * share), 14.0F, 72.0F);
    const glm::vec2 way = from.ahead + side * random.between(0.17F, 0.29F) * right;
    if (early >= track.cameras.size()) return from.at_m + near_m * way;
    float along_m = near_m;
    for (int i = 0; i < kFarther; ++i) {
        const glm::vec2 at_m = from.at_m + along_m * way;
        const glm::vec3 foot_m{at_m.x, scene::ground_height_m(land, at_m), at_m.y};
        if (is_whole_in(track.cameras[early], foot_m, high_m)) return at_m;
        along_m *= 1.25F;
    }
    return {};
}

}  // namespace quadrat::synthesis
