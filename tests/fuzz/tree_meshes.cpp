// SPDX-License-Identifier: Apache-2.0
// Any word read by the turtle becomes wood and leaves with every number finite and every index inside.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/turtle.hpp"

namespace trees = quadrat::synthesis::trees;

namespace {

void require(bool is_right) {
    if (!is_right) std::abort();
}

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view kLetters = "F!+-&^/\\$[]AB";
    if (size > 4000) return 0;
    trees::Word word{trees::module('!', 1)};
    for (std::size_t i = 0; i + 1 < size; i += 2) {
        const char letter = kLetters[data[i] % kLetters.size()];
        const auto value = static_cast<float>(static_cast<std::int8_t>(data[i + 1]));
        word.push_back(trees::module(letter, letter == 'F' || letter == '!' ? 0.05F * value : 1.5F * value));
    }
    const trees::TreeSkeleton skeleton =
        trees::interpret(word, {.tropism_strength = 0.2F, .gnarl_deg = 4, .leafy_from = 1}, quadrat::base::Seed{size});
    for (const int stride : {1, 3}) {
        const auto wood = trees::mesh_limbs(skeleton, {.node_stride = stride});
        for (const auto index : wood.mesh.indices) require(index < wood.mesh.positions_m.size());
        for (std::size_t i = 0; i < wood.mesh.positions_m.size(); ++i)
            require(is_finite(wood.mesh.positions_m[i]) && is_finite(wood.mesh.normals[i]) &&
                    std::isfinite(wood.ages[i]));
    }
    const auto leaves = trees::make_foliage(skeleton, {.blades = 50}, quadrat::base::Seed{1});
    for (const auto index : leaves.indices) require(index < leaves.vertices.size());
    for (const auto& v : leaves.vertices)
        require(is_finite(v.site_m) && is_finite(v.corner_m) && is_finite(v.normal) && std::isfinite(v.shade));
    return 0;
}
