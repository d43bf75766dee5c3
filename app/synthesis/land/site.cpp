// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/land/roads.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kOverSea_m = 1.5F;
constexpr float kEased = 1.6F;  // to how many radii the land is eased toward the plane

// The plane that lies best among the samples about a place (least squares).
struct Plane {
    float height_m = 0;  // over the middle
    glm::vec2 slope{0};  // rise over run, east and south
    float rough_m = 0;   // mean distance of the ground from it
    bool is_dry = true;  // and so is what is around it
};

template <typename Visit>
void for_samples(const mesh::Field& h, float cell_m, glm::vec2 at_m, float reach_m, int stride, const Visit& visit) {
    const float half = 0.5F * static_cast<float>(h.columns - 1);
    const auto sample = [&](float m) { return static_cast<int>(std::lround(m / cell_m + half)); };
    for (int y = sample(at_m.y - reach_m); y <= sample(at_m.y + reach_m); y += stride) {
        for (int x = sample(at_m.x - reach_m); x <= sample(at_m.x + reach_m); x += stride) {
            if (!h.is_inside(x, y)) continue;
            const glm::vec2 p = cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half) - at_m;
            if (glm::length(p) <= reach_m) visit(x, y, p);
        }
    }
}

Plane plane_at(const mesh::Field& h, const mesh::Field& surface, float cell_m, glm::vec2 at_m, float radius_m,
               int stride) {
    Plane plane;
    float count = 0;
    glm::vec2 moment{0};
    float spread = 0;
    for_samples(h, cell_m, at_m, kEased * radius_m, stride, [&](int x, int y, glm::vec2 p) {
        const float height_m = h.at(x, y);
        if (height_m < kOverSea_m || surface.at(x, y) > scene::kNoWater) plane.is_dry = false;
        if (glm::length(p) > radius_m) return;
        count += 1;
        plane.height_m += height_m;
        moment += height_m * p;
        spread += 0.5F * glm::dot(p, p);
    });
    if (count < 1) return {0, {0, 0}, 1.0e6F, false};
    plane.height_m /= count;
    plane.slope = spread > 0 ? moment / spread : glm::vec2{0};
    for_samples(h, cell_m, at_m, radius_m, stride, [&](int x, int y, glm::vec2 p) {
        plane.rough_m += std::abs(h.at(x, y) - plane.height_m - glm::dot(plane.slope, p)) / count;
    });
    return plane;
}

}  // namespace

std::optional<scene::Site> make_site(mesh::Field& height_m, const mesh::Field& surface_m, float cell_m,
                                     float radius_m) {
    const int stride = std::max(1, static_cast<int>(std::lround(8.0F / cell_m)));
    for (const float radius : {radius_m, 0.6F * radius_m}) {
        glm::vec2 best_m{0};
        float least = 1.0e6F;
        for (float z = -200.0F; z <= 168.0F; z += 16.0F) {
            for (float x = -240.0F; x <= 240.0F; x += 16.0F) {
                const Plane plane = plane_at(height_m, surface_m, cell_m, {x, z}, radius, stride);
                if (!plane.is_dry) continue;
                // Near enough before the viewer that what stands on it is more than a dot.
                const glm::vec2 off = glm::vec2{x, z - 120.0F} / 150.0F;
                const float price = 9.0F * glm::length(plane.slope) + 0.25F * plane.rough_m + 0.5F * glm::dot(off, off);
                if (price >= least) continue;
                least = price;
                best_m = {x, z};
            }
        }
        if (least >= 1.0e6F) continue;
        Plane plane = plane_at(height_m, surface_m, cell_m, best_m, radius, 1);
        const float steep = glm::length(plane.slope);
        if (steep > kSiteSlope) plane.slope *= kSiteSlope / steep;
        for_samples(height_m, cell_m, best_m, kEased * radius, 1, [&](int x, int y, glm::vec2 p) {
            const float t = std::max(0.0F, (glm::length(p) / radius - 1.0F) / (kEased - 1.0F));
            const float share = (1 - t) * (1 - t) * (1 + 2 * t);
            float& h = height_m.at(x, y);
            h += share * (plane.height_m + glm::dot(plane.slope, p) - h);
        });
        return scene::Site{{best_m.x, plane.height_m, best_m.y}, radius};
    }
    return std::nullopt;
}

}  // namespace quadrat::synthesis::land
