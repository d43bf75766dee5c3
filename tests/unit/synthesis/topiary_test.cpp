// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/topiary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/tree_parameters.hpp"
#include "synthesis/trees/flora.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr std::array kShapes{TopiaryShape::Cone, TopiaryShape::BallOnStem, TopiaryShape::Tiers, TopiaryShape::Obelisk};

TreeSkeleton clipped(TopiaryShape shape, std::uint64_t seed) {
    TopiaryOptions options;
    options.shape = shape;
    options.height_m = 1;
    return clipped_skeleton(options, base::Seed{seed});
}

TEST(Topiary, GrowsNowhereOutOfItsShape) {
    for (const TopiaryShape shape : kShapes)
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            for (const Limb& limb : clipped(shape, seed).limbs)
                for (std::size_t n = 2; n < limb.nodes.size(); ++n)
                    EXPECT_TRUE(is_within(shape, limb.nodes[n].at_m)) << static_cast<int>(shape);
}

// Of cells a tenth of the height wide that lie within the shape by their middles, most hold a leaf's place or have one
// beside them.
TEST(Topiary, FillsItsShape) {
    for (const TopiaryShape shape : kShapes) {
        const TreeSkeleton skeleton = clipped(shape, 3);
        int within = 0, filled = 0;
        for (float y = 0.1F; y < 1; y += 0.1F)
            for (float x = -0.3F; x < 0.31F; x += 0.1F)
                for (float z = -0.3F; z < 0.31F; z += 0.1F) {
                    const glm::vec3 at{x, y, z};
                    if (!is_within(shape, at) || std::hypot(x, z) < 0.07F) continue;
                    ++within;
                    filled += std::ranges::any_of(
                        skeleton.sites, [&](const Site& site) { return glm::distance(site.at_m, at) < 0.11F; });
                }
        ASSERT_GT(within, 15) << static_cast<int>(shape);
        EXPECT_GT(filled, within * 7 / 10) << static_cast<int>(shape);
    }
}

TEST(Topiary, HasABareStemUnderItsBall) {
    for (const Site& site : clipped(TopiaryShape::BallOnStem, 2).sites) EXPECT_GT(site.at_m.y, 0.38F);
}

TEST(Topiary, IsOfTheFloraWhereTheGeneAsksForIt) {
    const auto has = [](float shape) {
        scene::TreeParameters p;
        p.topiary_shape = shape;
        const scene::Flora flora = make_flora(p, base::Seed{2});
        return std::ranges::any_of(flora.species, [](const scene::Species& s) {
            return s.name == "topiary" && s.density == 0 && s.leaves.blades > 200;
        });
    };
    EXPECT_FALSE(has(0));
    for (const float shape : {1.0F, 2.0F, 3.0F, 4.0F}) EXPECT_TRUE(has(shape)) << shape;
}

}  // namespace
}  // namespace quadrat::synthesis::trees
