// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"

namespace quadrat::synthesis::noise {

// What makes more of itself, and keeps itself down farther off: on a torus of side by side samples, side at least 16.
// It ends in peaks some kPeakSpacing samples apart, none near another; between them there is next to nothing.
struct LateralInhibition {
    int steps = 800;
};
mesh::Field inhibited(const LateralInhibition& inhibition, base::Seed seed, int side);
inline constexpr float kPeakSpacing = 6.3F;

// The peaks of such a field, in samples.
std::vector<glm::ivec2> peaks_of(const mesh::Field& field);

// The share of a field's samples that are no more, 0 to 1, for each sample: whatever the field, evenly spread.
mesh::Field ranks_of(const mesh::Field& field);

}  // namespace quadrat::synthesis::noise
