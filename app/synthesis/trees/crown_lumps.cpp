// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/crown_lumps.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "base/seed.hpp"
#include "mesh/value_noise.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kCell = 0.62F;   // of a lump, to the crown's radius
constexpr float kSwing = 0.24F;  // of it, that the surface is moved at most
constexpr float kLight = 0.20F;  // that a bulge has more of, and a hollow less
constexpr base::Seed kLattice{0x6C'75'6D'70};

}  // namespace

CrownLumps::CrownLumps(const glm::vec3& low_m, const glm::vec3& high_m)
    : middle_m_(0.5F * (low_m + high_m)),
      radius_m_(std::max(0.25F * (high_m.x - low_m.x + high_m.z - low_m.z), 0.01F)),
      cell_m_(kCell * radius_m_) {}

// Turned, so that the lattice's directions are not the crown's.
float CrownLumps::at(const glm::vec3& at_m) const {
    const glm::vec3 off = (at_m - middle_m_) / cell_m_;
    return mesh::value_noise({0.36F * off.x + 0.48F * off.y - 0.8F * off.z, -0.8F * off.x + 0.6F * off.y,
                              0.48F * off.x + 0.64F * off.y + 0.6F * off.z},
                             kLattice);
}

// About the axis a spire is thin: it keeps its tip.
float CrownLumps::swing_m(const glm::vec3& at_m) const {
    const float aside_m = glm::length(glm::vec2{at_m.x - middle_m_.x, at_m.z - middle_m_.z});
    return kSwing * radius_m_ * std::clamp(1.3F * aside_m / radius_m_, 0.25F, 1.0F);
}

float CrownLumps::outward_m(const glm::vec3& at_m) const { return swing_m(at_m) * at(at_m); }

glm::vec3 CrownLumps::normal(const glm::vec3& at_m, const glm::vec3& smooth) const {
    const float step_m = 0.25F * cell_m_;
    glm::vec3 rise{0};
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 aside{0};
        aside[axis] = step_m;
        rise[axis] = (at(at_m + aside) - at(at_m - aside)) / (2 * step_m);
    }
    const glm::vec3 bent = smooth - swing_m(at_m) * (rise - glm::dot(rise, smooth) * smooth);
    return bent / glm::length(bent);
}

float CrownLumps::light(const glm::vec3& at_m) const { return 1 + kLight * at(at_m); }

}  // namespace quadrat::synthesis::trees
