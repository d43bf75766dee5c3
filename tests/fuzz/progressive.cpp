// SPDX-License-Identifier: Apache-2.0
// Any triangles at all become levels with half the vertices each: every number finite, every index and parent inside,
// no corner twice; and it ends.
#include "mesh/progressive.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>

namespace mesh = quadrat::mesh;

namespace {

void require(bool is_right) {
    if (!is_right) std::abort();
}

void require_sound(const mesh::Progressive& progressive) {
    for (std::size_t i = 0; i < progressive.levels.size(); ++i) {
        const auto& level = progressive.levels[i];
        const std::size_t count = level.mesh.positions_m.size();
        require(std::isfinite(level.error_m) && level.error_m >= 0);
        for (const glm::vec3& p : level.mesh.positions_m)
            require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        for (std::size_t t = 0; t + 2 < level.mesh.indices.size(); t += 3) {
            const std::uint32_t* abc = &level.mesh.indices[t];
            require(abc[0] < count && abc[1] < count && abc[2] < count);
            require(abc[0] != abc[1] && abc[1] != abc[2] && abc[2] != abc[0]);
        }
        require(level.materials.empty() || level.materials.size() == level.mesh.triangle_count());
        require(level.attributes.size() == count);
        if (i + 1 == progressive.levels.size()) continue;
        const std::size_t next = progressive.levels[i + 1].mesh.positions_m.size();
        require(next < count && level.parents.size() == count);
        for (const std::uint32_t parent : level.parents) require(parent < next);
    }
}

}  // namespace

// Its first byte says how many vertices, on a coarse lattice so that they meet and lie in one plane, and what else;
// four bytes a vertex, then four a triangle.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1 || size > 4000) return 0;
    const std::span<const std::uint8_t> bytes(data + 1, size - 1);
    const std::size_t vertices = std::min<std::size_t>(3 + data[0] % 64, bytes.size() / 4);
    if (vertices < 3) return 0;
    mesh::Mesh any;
    std::vector<float> ages;
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::uint8_t* b = &bytes[4 * v];
        any.positions_m.emplace_back(b[0] % 16, b[1] % 16, b[2] % 4);
        any.texcoords.emplace_back(b[3] % 2, b[3] / 2 % 2);
        ages.push_back(b[3]);
    }
    std::vector<std::uint8_t> materials;
    for (std::size_t i = 4 * vertices; i + 3 < bytes.size(); i += 4) {
        for (std::size_t k = 0; k < 3; ++k) any.indices.push_back(bytes[i + k] % static_cast<std::uint32_t>(vertices));
        materials.push_back(bytes[i + 3] % 2);
    }
    mesh::ProgressiveOptions options;
    options.fewest = 4;
    options.attributes = ages;
    options.attributes_a_vertex = 1;
    options.placement = data[0] >= 128 ? mesh::Placement::Line : mesh::Placement::Fitted;
    require_sound(mesh::make_progressive(any, options));
    options.materials = materials;
    require_sound(mesh::make_progressive(any, options));
    return 0;
}
