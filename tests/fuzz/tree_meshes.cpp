// SPDX-License-Identifier: Apache-2.0
// Any word read by the turtle becomes closed wood by each of the meshers, and leaves, with every number finite and
// every index inside.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "support/manifold.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/turtle.hpp"

namespace trees = quadrat::synthesis::trees;

namespace {

void require(bool is_right) {
    if (!is_right) std::abort();
}

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require_sound(const quadrat::scene::Wood& wood) {
    require(quadrat::tests::manifold_fault(wood.mesh.indices, wood.mesh.positions_m.size()).empty());
    for (std::size_t i = 0; i < wood.mesh.positions_m.size(); ++i)
        require(is_finite(wood.mesh.positions_m[i]) && is_finite(wood.mesh.normals[i]) && std::isfinite(wood.ages[i]));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view kLetters = "F!+-&^/\\$[]ABfL|";
    if (size > 1200) return 0;
    trees::Word word;
    for (std::size_t i = 0; i + 1 < size; i += 2) {
        const char letter = kLetters[data[i] % kLetters.size()];
        const auto value = static_cast<float>(static_cast<std::int8_t>(data[i + 1]));
        word.add(letter, {letter == 'F' || letter == '!' || letter == 'f' ? 0.02F * value : 1.5F * value});
    }
    trees::TurtleOptions options;
    options.elasticity = 0.2F;
    options.gnarl_deg = 4;
    options.leafy_below = 0.9F;
    options.radius_per_width = 0.1F;
    trees::TreeSkeleton skeleton = trees::interpret(word, options, quadrat::base::Seed{size});
    for (const float flattest : {0.0F, 0.5F}) require_sound(trees::sweep_tubes(skeleton, {.flattest = flattest}));
    require_sound(trees::mesh_cylinders(skeleton, 4));
    const glm::vec3 size_m = skeleton.high_m - skeleton.low_m;
    trees::MetaTubeDetail detail;
    detail.cell_m = std::max({size_m.x, size_m.y, size_m.z, 0.5F}) / 40;
    for (const bool sweeps : {false, true}) {
        detail.sweeps_twigs = sweeps;
        require_sound(trees::mesh_meta_tubes(skeleton, detail));
    }
    if (!skeleton.limbs.empty()) {
        trees::set_pipe_radii(skeleton, {});
        trees::bend(skeleton, {.sag = 0.5F, .wind = {0.3F, 0, 0.1F}, .light = {0, 0.4F, 0}});
    }
    trees::FoliageOptions foliage;
    foliage.blades = 50;
    const auto leaves = trees::make_foliage(skeleton, foliage, quadrat::base::Seed{1});
    for (const auto index : leaves.indices) require(index < leaves.vertices.size());
    for (const auto& v : leaves.vertices)
        require(is_finite(v.site_m) && is_finite(v.corner_m) && is_finite(v.normal) && std::isfinite(v.shade));
    return 0;
}
