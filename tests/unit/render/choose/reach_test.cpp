// SPDX-License-Identifier: Apache-2.0
#include "render/choose/reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <set>

#include "base/seed.hpp"
#include "render/choose/blocks.hpp"
#include "render/choose/crowd.hpp"
#include "unit/render/choose/plant_kinds.hpp"

namespace quadrat::render::choose {
namespace {

constexpr glm::vec3 kEye_m{10, 4, 30};
constexpr glm::vec2 kAbout_m{10, 30};
constexpr float kSplit_m = 60;
constexpr Reach kNear{Reach::Part::Near, kAbout_m, kSplit_m};
constexpr Reach kFar{Reach::Part::Far, kAbout_m, kSplit_m};

Frustum frustum() {
    return Frustum(glm::perspective(0.73F, 16.0F / 9, 0.5F, 12000.0F) *
                   glm::lookAt(kEye_m, kEye_m + glm::vec3{0, -0.05F, -1}, {0, 1, 0}));
}

std::vector<scene::Plant> forest(std::size_t count) {
    std::vector<scene::Plant> plants(count);
    base::RandomStream random{base::Seed{3}};
    for (scene::Plant& plant : plants) plant.root_m = {random.between(-300, 300), 0, random.between(-300, 300)};
    return plants;
}

TEST(Reach, LeavesEachPlantWholeOnOneSideAndNoneThatIsFarOverNearGround) {
    base::RandomStream random{base::Seed{1}};
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 foot_m = kAbout_m + glm::vec2{random.between(-90, 90), random.between(-90, 90)};
        const float radius_m = random.between(0, 9);
        EXPECT_NE(kNear.holds_standing(foot_m, radius_m), kFar.holds_standing(foot_m, radius_m));
        EXPECT_TRUE(Reach{}.holds_standing(foot_m, radius_m));
        if (kFar.holds_standing(foot_m, radius_m)) {
            EXPECT_GE(glm::distance(foot_m, kAbout_m) - radius_m, kSplit_m - 1e-3F);
        }
    }
}

TEST(Reach, HasWhatIsCutOnEitherSideWhereItMayCross) {
    const auto box = [](float from_m, float to_m) {
        return std::array{glm::vec3{kAbout_m.x - 1, 0, kAbout_m.y - to_m},
                          glm::vec3{kAbout_m.x + 1, 5, kAbout_m.y - from_m}};
    };
    const auto holds = [&](const Reach& reach, float from_m, float to_m) {
        const auto [low_m, high_m] = box(from_m, to_m);
        return reach.may_hold_box(low_m, high_m);
    };
    EXPECT_TRUE(holds(kNear, 50, 70) && holds(kFar, 50, 70));
    EXPECT_TRUE(holds(kNear, 10, 20) && !holds(kFar, 10, 20));
    EXPECT_TRUE(!holds(kNear, 80, 90) && holds(kFar, 80, 90));
    EXPECT_TRUE(holds(kNear, 61, 90)) << "as far as an eye moves";
    const auto [low_m, high_m] = box(68, 90);
    EXPECT_TRUE(kNear.may_hold_ground(low_m, high_m)) << "what leans over stands on it";
    EXPECT_TRUE(kNear.may_hold_sphere({kAbout_m.x, 0, kAbout_m.y - 65}, 8));
    EXPECT_FALSE(kNear.may_hold_sphere({kAbout_m.x, 0, kAbout_m.y - 75}, 8));
}

TEST(Reach, DividesPlantsIntoTwoSightsOfTheSame) {
    const auto plants = forest(4000);
    const std::vector<PlantKind> kinds{tree()};
    const auto seen = [&](const Reach& reach) {
        Gathering g;
        g.view.eye_seconds = {kEye_m, 0};
        g.reach = reach;
        std::set<std::uint32_t> found;
        for (const Sight::Seen& s : look(plants, kinds, frustum(), g).seen) found.insert(s.plant);
        return found;
    };
    const auto all = seen({});
    const auto near = seen(kNear);
    const auto far = seen(kFar);
    EXPECT_FALSE(near.empty());
    EXPECT_FALSE(far.empty());
    EXPECT_EQ(near.size() + far.size(), all.size());
    std::set<std::uint32_t> both = near;
    both.insert(far.begin(), far.end());
    EXPECT_EQ(both, all);
}

TEST(Reach, ChoosesTheGroundOfEachSideAsItIsChosenForAll) {
    mesh::Field field(257, 257);
    base::RandomStream random{base::Seed{2}};
    for (float& sample : field.samples) sample = random.between(0, 3);
    const Blocks blocks(field, 2, 8);
    using Triangle = std::array<std::uint32_t, 3>;
    const auto chosen = [&](const Reach& reach) {
        std::vector<std::uint32_t> indices;
        Blocks::Wish wish{kEye_m, 500};
        wish.triangle_budget = 3000;
        wish.reach = reach;
        blocks.select(frustum(), wish, indices);
        std::set<Triangle> triangles;
        for (std::size_t i = 0; i < indices.size(); i += 3)
            triangles.insert({indices[i], indices[i + 1], indices[i + 2]});
        return triangles;
    };
    const auto all = chosen({});
    const auto near = chosen(kNear);
    const auto far = chosen(kFar);
    EXPECT_LT(near.size(), all.size());
    EXPECT_LT(far.size(), all.size());
    std::set<Triangle> both = near;
    both.insert(far.begin(), far.end());
    EXPECT_EQ(both, all) << "no crack between them";
}

TEST(Reach, LeavesMoreForWhatCountsInPartOnly) {
    const auto plants = forest(4000);
    const std::vector<PlantKind> kinds{tree()};
    Gathering g;
    g.view.eye_seconds = {kEye_m, 0};
    const Sight sight = look(plants, kinds, frustum(), g);
    const auto step_of = [&](float share, std::size_t budget) {
        const Crowding view{kinds, &g, &sight, share};
        return affordable_step({&view, 1}, budget);
    };
    const int whole = step_of(1, 40'000);
    ASSERT_GT(whole, 0);
    ASSERT_LT(whole, kSteps);
    EXPECT_GT(step_of(0.25F, 40'000), whole);
    EXPECT_EQ(step_of(0.25F, 10'000), whole);
}

}  // namespace
}  // namespace quadrat::render::choose
