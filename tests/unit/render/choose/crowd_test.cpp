// SPDX-License-Identifier: Apache-2.0
#include "render/choose/crowd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>

#include "base/seed.hpp"
#include "scene/camera.hpp"
#include "unit/render/choose/plant_kinds.hpp"

namespace quadrat::render::choose {
namespace {

const scene::Camera kCamera{{0, 6, 0}, {0, 4, -100}, 42};

glm::mat4 clip_from_world() { return scene::clip_from_view(kCamera, 16.0F / 9) * scene::view_from_world(kCamera); }

Frustum frustum() { return Frustum(clip_from_world()); }

std::vector<scene::Plant> forest(std::size_t trees, std::size_t tufts) {
    std::vector<scene::Plant> plants;
    base::RandomStream stream{base::Seed{3}};
    for (std::size_t i = 0; i < trees + tufts; ++i) {
        scene::Plant plant;
        plant.species = i < trees ? 0 : 1;
        plant.root_m = {stream.between(-500, 500), stream.between(-5, 20), stream.between(-500, 500)};
        plant.scale = stream.between(0.7F, 1.3F);
        plants.push_back(plant);
    }
    return plants;
}

Gathering looking_from_the_camera() {
    Gathering g;
    g.view.eye_seconds = {kCamera.eye_m, 0};
    g.view.clip_from_world = clip_from_world();
    g.pixels_per_radian = 469;
    return g;
}

// One view by itself.
int step_within(std::size_t budget, std::span<const PlantKind> kinds, const Gathering& g, const Sight& sight,
                std::optional<int> guess = {}) {
    const Crowding alone{kinds, &g, &sight};
    return affordable_step({&alone, 1}, budget, guess);
}

Crowd gathered(std::span<const scene::Plant> plants, std::span<const PlantKind> kinds, const Gathering& g,
               std::vector<Instance>& instances, std::size_t budget = 1'000'000) {
    Sight sight = look(plants, kinds, frustum(), g);
    const int step = step_within(budget, kinds, g, sight);
    return gather(plants, kinds, std::move(sight), step, g, instances);
}

TEST(Crowd, HoldsEveryTreeThatReachesIntoTheViewAndNoneThatIsFarOutside) {
    const auto plants = forest(3000, 0);
    const std::vector<PlantKind> kinds{tree()};
    std::vector<Instance> instances;
    gathered(plants, kinds, looking_from_the_camera(), instances);
    const auto is_in = [&](const scene::Plant& plant) {
        return std::ranges::any_of(instances,
                                   [&](const Instance& i) { return glm::vec3{i.root_scale} == plant.root_m; });
    };
    std::size_t seen = 0;
    for (const scene::Plant& plant : plants) {
        const bool roots_on_screen = frustum().may_see_sphere(plant.root_m, 0);
        EXPECT_TRUE(is_in(plant) || !roots_on_screen);
        EXPECT_TRUE(!is_in(plant) || frustum().may_see_sphere(plant.root_m, 40));
        seen += roots_on_screen;
    }
    EXPECT_GT(seen, 100U);
    EXPECT_LT(instances.size(), plants.size() / 2);
}

TEST(Crowd, BatchesCoverEveryInstanceOnceAndCountTheirTriangles) {
    const auto plants = forest(1500, 4000);
    const std::vector<PlantKind> kinds{tree(), grass()};
    std::vector<Instance> instances;
    const Crowd crowd = gathered(plants, kinds, looking_from_the_camera(), instances);
    std::vector<int> leaves(instances.size());
    std::size_t triangles = 0;
    for (const Batch& batch : crowd.batches) {
        ASSERT_LE(batch.first + batch.count, instances.size());
        const PlantKind& kind = kinds[batch.species];
        const bool is_wood = batch.part == Batch::Part::Wood;
        triangles +=
            batch.count * (is_wood ? kind.wood_triangles[batch.level] : batch.blades * kind.triangles_per_blade);
        for (std::size_t i = batch.first; !is_wood && i < batch.first + batch.count; ++i) ++leaves[i];
    }
    EXPECT_TRUE(std::ranges::all_of(leaves, [](int n) { return n == 1; }));
    EXPECT_EQ(triangles, crowd.triangles);
}

TEST(Crowd, DrawsTheBladesItsInstancesAskFor) {
    const auto plants = forest(1500, 0);
    const std::vector<PlantKind> kinds{tree()};
    std::vector<Instance> instances;
    const Crowd crowd = gathered(plants, kinds, looking_from_the_camera(), instances);
    for (const Batch& batch : crowd.batches) {
        if (batch.part != Batch::Part::Leaves) continue;
        for (std::size_t i = batch.first; i < batch.first + batch.count; ++i)
            EXPECT_GE(static_cast<float>(batch.blades) + 0.5F, instances[i].turn_grown_share.w * 2100.0F);
    }
}

// Ten rows of trees, one behind the other.
std::vector<scene::Plant> rows() {
    std::vector<scene::Plant> plants;
    for (int row = 0; row < 10; ++row) {
        for (int k = -12; k <= 12; ++k) {
            scene::Plant plant;
            plant.root_m = {2.5F * static_cast<float>(k) + 0.7F * static_cast<float>(row % 3), 0,
                            -40.0F - 6.0F * static_cast<float>(row)};
            plants.push_back(plant);
        }
    }
    return plants;
}

TEST(Crowd, DrawsLessOfWhatStandsBehindOtherCrowns) {
    const auto plants = rows();
    PlantKind kind = leafy();
    kind.crown_m = 3;
    std::vector<Instance> all;
    const std::vector<PlantKind> clear{kind};
    const Crowd before = gathered(plants, clear, looking_from_the_camera(), all);
    kind.opacity = 0.85F;
    std::vector<Instance> some;
    const std::vector<PlantKind> opaque{kind};
    const Crowd now = gathered(plants, opaque, looking_from_the_camera(), some);
    EXPECT_LT(some.size(), all.size());
    EXPECT_LT(now.triangles, before.triangles / 2);
    // Of the first row none in the picture is missing, and none has fewer blades.
    const auto share_of = [](const std::vector<Instance>& instances, const scene::Plant& plant) {
        const auto at =
            std::ranges::find_if(instances, [&](const Instance& i) { return glm::vec3{i.root_scale} == plant.root_m; });
        return at == instances.end() ? 0.0F : at->turn_grown_share.w;
    };
    for (const scene::Plant& plant : plants) {
        EXPECT_LE(share_of(some, plant), share_of(all, plant));
        if (plant.root_m.z > -41 && std::abs(plant.root_m.x) < 22) {
            EXPECT_GT(share_of(some, plant), 0.5F * share_of(all, plant));
        }
    }
}

// However plants stand before each other, a batch's instances are those that ask for it.
TEST(Crowd, BatchesOfHalfHiddenPlantsHoldTheirOwn) {
    const auto plants = rows();
    PlantKind kind = leafy();
    kind.crown_m = 3;
    kind.opacity = 0.6F;
    const std::vector<PlantKind> kinds{kind};
    std::vector<Instance> instances;
    const Crowd crowd = gathered(plants, kinds, looking_from_the_camera(), instances, 60'000);
    std::vector<int> parts(instances.size());
    for (const Batch& batch : crowd.batches) {
        ASSERT_LE(batch.first + batch.count, instances.size());
        for (std::size_t i = batch.first; i < batch.first + batch.count; ++i) {
            ++parts[i];
            const bool are_leaves = batch.part == Batch::Part::Leaves;
            EXPECT_TRUE(!are_leaves ||
                        static_cast<float>(batch.blades) + 0.5F >= instances[i].turn_grown_share.w * 2100.0F);
        }
    }
    EXPECT_TRUE(std::ranges::all_of(parts, [](int n) { return n >= 1 && n <= 3; }));
}

// Those that stand in the picture with all of their crown.
TEST(Crowd, WithinASpeciesNearPlantsComeBeforeFarOnes) {
    auto plants = forest(1500, 0);
    for (scene::Plant& plant : plants) plant.scale = 1;
    std::erase_if(plants, [](const scene::Plant& plant) {
        return std::abs(plant.root_m.x) > -0.5F * plant.root_m.z || plant.root_m.z > -60;
    });
    ASSERT_GT(plants.size(), 100U);
    const std::vector<PlantKind> kinds{tree()};
    std::vector<Instance> instances;
    gathered(plants, kinds, looking_from_the_camera(), instances);
    for (std::size_t i = 1; i < instances.size(); ++i) {
        const auto distance = [&](std::size_t k) {
            return glm::length(glm::vec3{instances[k].root_scale} + glm::vec3{0, 6, 0} - kCamera.eye_m);
        };
        EXPECT_LE(distance(i - 1), distance(i) + 1e-3F);
    }
}

// Near by a blade may be drawn several times, each smaller: a tree's leaves are then no boards.
TEST(Crowd, NearByLeavesAreMoreAndSmallerThanThereAreBlades) {
    scene::Plant plant;
    plant.root_m = {0, 0, -20};
    PlantKind kind = leafy();
    kind.blades = 300;
    const auto copies_with = [&](std::size_t most, std::vector<Instance>& instances, Crowd& crowd) {
        kind.copies = most;
        const std::vector<PlantKind> kinds{kind};
        crowd = gathered({&plant, 1}, kinds, looking_from_the_camera(), instances);
    };
    std::vector<Instance> once;
    std::vector<Instance> often;
    Crowd of_once;
    Crowd of_often;
    copies_with(1, once, of_once);
    copies_with(4, often, of_often);
    ASSERT_EQ(once.size(), 1U);
    ASSERT_EQ(often.size(), 4U) << "an instance a copy";
    EXPECT_EQ(of_once.triangles + 3 * 300 * kind.triangles_per_blade, of_often.triangles);
    std::size_t blades = 0;
    for (const Batch& batch : of_often.batches)
        if (batch.part == Batch::Part::Leaves) blades += batch.count * batch.blades;
    EXPECT_EQ(blades, 4U * 300U);
    for (std::size_t copy = 0; copy < often.size(); ++copy) {
        EXPECT_FLOAT_EQ(often[copy].turn_grown_share.w, 1);
        EXPECT_NEAR(kLeastBlade * 255 / static_cast<float>(often[copy].half_tint_enlarged.a), 0.66F, 0.01F)
            << "four cover 1.7 times as much: they hide one another";
    }
    EXPECT_NEAR(kLeastBlade * 255 / static_cast<float>(once.front().half_tint_enlarged.a), 1, 0.01F);
}

// What hangs into the picture from beside it needs no triangles where nobody sees it.
TEST(Crowd, WhatStandsBesideThePictureHasLess) {
    scene::Plant plant;
    plant.root_m = {0, 0, -30};
    const std::vector<PlantKind> kinds{leafy()};
    std::vector<Instance> instances;
    const auto triangles_at = [&](float x_m) {
        plant.root_m.x = x_m;
        return gathered({&plant, 1}, kinds, looking_from_the_camera(), instances).triangles;
    };
    EXPECT_LE(triangles_at(21), triangles_at(0));
    EXPECT_LT(triangles_at(22), triangles_at(0));
    EXPECT_GT(triangles_at(22), 0U);
}

scene::Plant standing(float beside_m, float away_m) {
    scene::Plant plant;
    plant.root_m = {beside_m, 0, -away_m};
    return plant;
}

std::vector<float> looked_at(std::span<const scene::Plant> plants) {
    const std::vector<PlantKind> kinds{leafy(), grass()};
    std::vector<float> all(plants.size(), 0);
    for (const Sight::Seen& seen : look(plants, kinds, frustum(), looking_from_the_camera()).seen)
        all[seen.plant] = seen.looked_at;
    return all;
}

TEST(Crowd, AFewThatStandOutAreSubjects) {
    std::vector<scene::Plant> plants{standing(-9, 30), standing(12, 38)};
    for (int i = 0; i < 9; ++i) plants.push_back(standing(14.0F * static_cast<float>(i - 4), 90));
    const std::vector<float> all = looked_at(plants);
    EXPECT_EQ(all[0], 1);
    EXPECT_EQ(all[1], 1);
    for (std::size_t i = 2; i < all.size(); ++i) EXPECT_EQ(all[i], 0) << i;
}

TEST(Crowd, OfARowOfEqualsNoneIsTheSubject) {
    std::vector<scene::Plant> plants;
    for (int i = 0; i < 9; ++i) plants.push_back(standing(9.0F * static_cast<float>(i - 4), 60));
    for (const float each : looked_at(plants)) EXPECT_LT(each, 0.2F);
}

TEST(Crowd, NoSubjectComesOrGoesAtOnce) {
    std::vector<scene::Plant> plants{standing(-9, 70), standing(12, 60), standing(22, 70), standing(-24, 80)};
    std::vector<float> before = looked_at(plants);
    float most = 0;
    for (float away_m = 70; away_m > 25; away_m -= 0.05F) {
        plants[0] = standing(-9, away_m);
        const std::vector<float> now = looked_at(plants);
        for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], before[i], 0.02F) << away_m;
        most = std::max(most, now[0]);
        before = now;
    }
    EXPECT_EQ(most, 1);
}

TEST(Crowd, KeepsItsBudgetByGivingUpFineness) {
    const auto plants = forest(4000, 4000);
    const std::vector<PlantKind> kinds{tree(), grass()};
    const Gathering g = looking_from_the_camera();
    std::vector<Instance> instances;
    const Crowd free = gathered(plants, kinds, g, instances);
    const std::size_t budget = free.triangles / 2;
    instances.clear();
    const Crowd held = gathered(plants, kinds, g, instances, budget);
    EXPECT_LE(held.triangles, budget);
    EXPECT_GT(held.triangles, budget * 8 / 10);
    EXPECT_LT(held.fineness, free.fineness);
}

TEST(Crowd, IsTheSameWhateverIsGuessed) {
    const auto plants = forest(4000, 4000);
    const std::vector<PlantKind> kinds{tree(), grass()};
    for (const float fineness : {0.2F, 1.0F}) {
        for (const std::size_t budget : {0U, 300U, 4'000U, 20'000U, 100'000'000U}) {
            Gathering g = looking_from_the_camera();
            g.fineness = fineness;
            const Sight sight = look(plants, kinds, frustum(), g);
            const int alone = step_within(budget, kinds, g, sight);
            for (const int guess : {-5, 0, 1, 2, 100, 255, 256, 510, 511, 512, 9999, alone - 1, alone + 1})
                EXPECT_EQ(step_within(budget, kinds, g, sight, guess), alone) << budget << ' ' << guess;
        }
    }
}

TEST(Crowd, OfSeveralViewsShareABudgetByOneFineness) {
    const std::vector<PlantKind> kinds{tree(), grass()};
    const Gathering g = looking_from_the_camera();
    const auto wood = forest(6000, 3000);
    const auto heath = forest(40, 900);
    const Sight in_wood = look(wood, kinds, frustum(), g);
    const Sight on_heath = look(heath, kinds, frustum(), g);
    const std::vector<Crowding> both{{kinds, &g, &in_wood}, {kinds, &g, &on_heath}};
    std::vector<Instance> instances;
    const auto triangles = [&](int step) {
        return gather(wood, kinds, in_wood, step, g, instances).triangles +
               gather(heath, kinds, on_heath, step, g, instances).triangles;
    };
    const std::size_t budget = triangles(kSteps) / 3;
    const int step = affordable_step(both, budget);
    ASSERT_GT(step, 0);
    ASSERT_LT(step, kSteps);
    EXPECT_LE(triangles(step), budget);
    EXPECT_GT(triangles(step + 1), budget) << "the finest that is within it";
    EXPECT_GT(step, step_within(budget / 2, kinds, g, in_wood)) << "the forest has what the heath does not need";
}

TEST(Crowd, WhatIsDrawnSmallerNeedsLessAndIsThere) {
    const auto plants = forest(1500, 4000);
    const std::vector<PlantKind> kinds{leafy(), grass()};
    Gathering g = looking_from_the_camera();
    std::vector<Instance> whole;
    const Crowd all = gathered(plants, kinds, g, whole);
    g.scale = 0.5F;
    std::vector<Instance> halved;
    EXPECT_EQ(gathered(plants, kinds, g, halved).triangles, all.triangles);
    // And where there is little to spend:
    g.fineness = 0.01F;
    g.scale = 1;
    whole.clear();
    const Crowd little = gathered(plants, kinds, g, whole);
    g.scale = 0.5F;
    halved.clear();
    const Crowd fewer = gathered(plants, kinds, g, halved);
    EXPECT_LT(fewer.triangles, little.triangles * 8 / 10);
    g.scale = 0.75F;  // the least that is ever shown
    halved.clear();
    gathered(plants, kinds, g, halved);
    EXPECT_GT(halved.size(), whole.size() * 8 / 10);  // some of the smallest stand for others
}

TEST(Crowd, FewOfTheFarthestStandForAllAndCoverAsMuch) {
    std::vector<scene::Plant> plants;
    for (int i = 0; i < 4000; ++i) {
        scene::Plant plant;
        plant.root_m = {static_cast<float>(i % 80) - 40, 0, -700 - static_cast<float>(i / 80)};
        plants.push_back(plant);
    }
    const std::vector<PlantKind> kinds{tree()};
    const Gathering g = looking_from_the_camera();
    const auto covered = [&](std::size_t budget, std::size_t& count) {
        std::vector<Instance> instances;
        gathered(plants, kinds, g, instances, budget);
        count = instances.size();
        double sum = 0;
        for (const Instance& i : instances) sum += static_cast<double>(i.root_scale.w) * i.root_scale.w;
        return sum;
    };
    std::size_t all = 0;
    std::size_t few = 0;
    const double whole = covered(1'000'000, all);
    const double thinned = covered(14'000, few);
    EXPECT_EQ(all, plants.size());
    EXPECT_LT(few, plants.size() / 2);
    EXPECT_GT(few, plants.size() / 5);
    EXPECT_NEAR(thinned, whole, 0.12 * whole);
}

TEST(Grown, StartsAsASeedlingAndEndsGrownWhateverTheDelay) {
    for (float delay = 0; delay <= 1; delay += 0.1F) {
        EXPECT_NEAR(grown(0, delay), grown(0, 0), 1e-6F);
        EXPECT_GT(grown(0, delay), 0);
        EXPECT_FLOAT_EQ(grown(1, delay), 1);
        float before = 0;
        for (float growth = 0; growth <= 1; growth += 0.02F) {
            EXPECT_GE(grown(growth, delay), before);
            before = grown(growth, delay);
        }
    }
}

}  // namespace
}  // namespace quadrat::render::choose
