// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/view_merit.hpp"

#include <algorithm>

#include "synthesis/compose/view_rays.hpp"

namespace quadrat::synthesis {

Outlook outlook(const scene::Land& land, const scene::Camera& camera) {
    Outlook seen;
    const std::vector<glm::vec3> rays = view_rays(camera);
    const float share = 1.0F / static_cast<float>(rays.size());
    for (const glm::vec3& ray : rays) {
        const Hit hit = first_hit(land, camera.eye_m, ray);
        if (hit.distance_m >= kFarthest_m)
            seen.sky += share;
        else if (hit.is_water)
            seen.water += share;
        else if (hit.distance_m < 45)
            seen.near += share;
        else if (hit.distance_m > 500)
            seen.far += share;
        // Ground at one's feet is no wall.
        if (!hit.is_water && hit.distance_m < 12 && ray.y > -0.12F) seen.walled += share;
    }
    return seen;
}

float view_merit(const Outlook& seen) {
    const auto up_to = [](float share, float enough) { return std::min(share / enough, 1.0F); };
    const float off_sky = (seen.sky - 0.42F) / 0.25F;
    const float too_much = std::max(seen.near - 0.42F, 0.0F) + std::max(seen.water - 0.30F, 0.0F);
    return up_to(seen.near, 0.16F) + 0.9F * up_to(seen.far, 0.10F) + 0.8F * up_to(seen.water, 0.10F) -
           0.8F * off_sky * off_sky - 3 * too_much - 4 * std::max(seen.walled - 0.10F, 0.0F);
}

}  // namespace quadrat::synthesis
