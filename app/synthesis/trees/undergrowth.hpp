// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "synthesis/trees/year.hpp"

namespace quadrat::synthesis::trees {

// Small plants of a few blades, 14 to 100 triangles each, fewer from afar: cheap enough for thousands. Colours linear.
struct GrassOptions {
    glm::vec3 colour{0.2F, 0.3F, 0.1F};
    float height_m = 0.4F;
    float spread = 0.4F;  // 0 upright to 1 lying apart
};
scene::Species grass_tuft(const GrassOptions& options, base::Seed seed);
scene::Species reeds(const GrassOptions& options, base::Seed seed);
scene::Species fern(const glm::vec3& colour, float height_m, base::Seed seed);

struct FlowerOptions {
    glm::vec3 leaf{0.1F, 0.2F, 0.05F};
    glm::vec3 blossom{0.8F};
    float height_m = 0.45F;
    int petals = 6;  // ten and more: a head of florets instead
};
scene::Species flower(const FlowerOptions& options, base::Seed seed);

struct MushroomOptions {
    glm::vec3 cap{0.5F, 0.3F, 0.1F};
    float height_m = 0.24F;
};
scene::Species mushrooms(const MushroomOptions& options, base::Seed seed);  // a few, of one kind; they stand in rings

struct ShrubOptions {
    glm::vec3 leaf{0.1F, 0.2F, 0.05F};
    glm::vec3 second{0.15F, 0.2F, 0.05F};
    glm::vec3 bark{0.1F};
    glm::vec3 blossom{0.8F};
    float height_m = 1.4F;
    float width = 1;
    float leaf_m = 0.2F;
    float blossoms = 0;                   // of its twigs
    glm::vec3 turned{0.5F, 0.2F, 0.03F};  // its leaves in autumn
    Year year;
};
scene::Species shrub(const ShrubOptions& options, base::Seed seed);

}  // namespace quadrat::synthesis::trees
