// SPDX-License-Identifier: Apache-2.0
#include "mesh/value_noise.hpp"

#include <glm/common.hpp>

namespace quadrat::mesh {

float value_noise(const glm::vec3& at, base::Seed seed) {
    const glm::vec3 low = glm::floor(at);
    const glm::vec3 f = at - low;
    const glm::vec3 t = f * f * f * (f * (f * 6.0F - 15.0F) + 10.0F);
    float sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 c{corner & 1, (corner >> 1) & 1, corner >> 2};
        const glm::vec3 w = glm::mix(1.0F - t, t, glm::vec3(c));
        const glm::ivec3 p = glm::ivec3(low) + c;
        sum += w.x * w.y * w.z * (2 * base::unit_of(base::hash_of(seed, p.x, p.y, p.z)) - 1);
    }
    return sum;
}

}  // namespace quadrat::mesh
