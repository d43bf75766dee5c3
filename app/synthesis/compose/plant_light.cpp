// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <vector>

#include "synthesis/compose/light.hpp"

namespace quadrat::synthesis {

void light_plants(std::span<scene::Plant> plants, const scene::Flora& flora, const scene::Sky& sky,
                  const LandShadow& shadow) {
    constexpr float kBin_m = 12.0F;
    const auto bin_of = [](float x, float z) {
        return (static_cast<std::int64_t>(std::floor(x / kBin_m)) << 32) ^
               (static_cast<std::int64_t>(std::floor(z / kBin_m)) & 0xFFFFFFFF);
    };
    std::unordered_map<std::int64_t, std::vector<std::size_t>> bins;
    for (std::size_t i = 0; i < plants.size(); ++i)
        if (flora.species[plants[i].species].storey == scene::Storey::Tree)
            bins[bin_of(plants[i].root_m.x, plants[i].root_m.z)].push_back(i);

    // What a ray toward the sun from this point passes through of the crowns around.
    const auto past_neighbours = [&](std::size_t self, const glm::vec3& from) {
        float through = 1;
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = bins.find(
                    bin_of(from.x + static_cast<float>(dx) * kBin_m, from.z + static_cast<float>(dz) * kBin_m));
                if (found == bins.end()) continue;
                for (const std::size_t i : found->second) {
                    if (i == self) continue;
                    const scene::Species& species = flora.species[plants[i].species];
                    const float high_m = species.height_m * plants[i].scale;
                    const glm::vec3 crown = plants[i].root_m + glm::vec3{0, 0.6F * high_m, 0};
                    const float along = glm::dot(crown - from, sky.sun_direction);
                    if (along <= 0) continue;
                    const glm::vec3 miss = (crown - from - along * sky.sun_direction) /
                                           glm::vec3{species.crown_radius_m * plants[i].scale, 0.42F * high_m,
                                                     species.crown_radius_m * plants[i].scale};
                    const float r = glm::dot(miss, miss);
                    if (r < 1) through *= 1.0F - 0.62F * (1.0F - r);
                }
            }
        }
        return through;
    };
    oneapi::tbb::parallel_for(std::size_t{0}, plants.size(), [&](std::size_t i) {
        scene::Plant& plant = plants[i];
        const scene::Species& species = flora.species[plant.species];
        const float up = species.storey == scene::Storey::Tree ? 0.6F : 0.9F;
        const glm::vec3 from = plant.root_m + glm::vec3{0, up * species.height_m * plant.scale, 0};
        plant.sun = shadow.sun_at(from) * past_neighbours(i, from);
    });
}

}  // namespace quadrat::synthesis
