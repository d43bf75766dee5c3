// SPDX-License-Identifier: Apache-2.0
// Nothing is left out that could be seen: lines of sight to all of it are followed over the ground itself.
#include "render/choose/horizon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "base/seed.hpp"
#include "mesh/roam.hpp"
#include "render/choose/blocks.hpp"
#include "render/choose/crowd.hpp"
#include "render/choose/hold.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::choose {
namespace {

constexpr std::uint64_t kLands = 300;  // what is hidden is rare: fewer show nothing
constexpr int kSide = 129;
constexpr float kCell_m = 2;
constexpr int kBlock = 16;
constexpr float kMoved_m = Horizon::kMoved_m + Hold::kMoved_m;

// Ridges and valleys of every height and breadth.
mesh::Field land(base::RandomStream& random) {
    mesh::Field field(kSide, kSide);
    struct Wave {
        glm::vec2 a_cell;
        float phase, high_m;
    };
    std::array<Wave, 5> waves{};
    for (Wave& wave : waves) {
        const float cells = random.between(8, 90);
        const float turn = random.between(0, 2 * std::numbers::pi_v<float>);
        wave = {glm::vec2{std::cos(turn), std::sin(turn)} * (2 * std::numbers::pi_v<float> / cells),
                6 * random.unit_f(), 0.16F * cells * random.unit_f()};
    }
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
            for (const Wave& wave : waves)
                field.at(column, row) +=
                    wave.high_m * std::sin(glm::dot(wave.a_cell, glm::vec2{column, row}) + wave.phase);
    return field;
}

glm::vec3 sample_m(const mesh::Field& field, int column, int row) {
    return {(static_cast<float>(column) - 64) * kCell_m, field.at(column, row),
            (static_cast<float>(row) - 64) * kCell_m};
}

float ground_m(const mesh::Field& field, glm::vec3 at_m) {
    return mesh::sample(field, at_m.x / kCell_m + 64, at_m.z / kCell_m + 64);
}

bool is_free(const mesh::Field& field, glm::vec3 eye_m, glm::vec3 at_m) {
    const float away_m = glm::distance(eye_m, at_m);
    constexpr float kStep_m = 0.5F;
    constexpr float kEnd_m = 1;  // it stands on the ground
    for (float gone_m = kStep_m; gone_m < away_m - kEnd_m; gone_m += kStep_m) {
        const glm::vec3 on_the_way = glm::mix(eye_m, at_m, gone_m / away_m);
        if (on_the_way.y < ground_m(field, on_the_way)) return false;
    }
    return true;
}

// An eye over the land, what it looks at, and how much of the ground that is there is hidden.
struct Outlook {
    explicit Outlook(base::Seed seed) : random(seed), field(land(random)), blocks(field, kCell_m, kBlock) {
        camera.eye_m = {random.between(-120, 120), 0, random.between(-120, 120)};
        camera.eye_m.y = ground_m(field, camera.eye_m) + 1.5F + 20 * random.unit_f() * random.unit_f();
        camera.target_m = {random.between(-60, 60), random.between(-10, 10), random.between(-60, 60)};
        horizon.begin(camera.eye_m, kMoved_m);
        hidden = blocks.hidden(frustum(), camera.eye_m, horizon);
        Blocks::Wish wish{camera.eye_m, 469, 0.01F, 1'000'000};
        blocks.select(frustum(), wish, all);
        wish.hidden = hidden;
        blocks.select(frustum(), wish, drawn);
    }
    Frustum frustum() const { return Frustum(scene::clip_from_view(camera, 1.6F) * scene::view_from_world(camera)); }
    // Wherever the eye goes while the choice is held.
    glm::vec3 moved_eye_m() {
        const glm::vec3 way{random.normal(), random.normal(), random.normal()};
        return camera.eye_m + 0.98F * kMoved_m * glm::normalize(way);
    }

    base::RandomStream random;
    mesh::Field field;
    Blocks blocks;
    scene::Camera camera;
    Horizon horizon;
    std::vector<std::uint8_t> hidden;
    std::vector<std::uint32_t> all, drawn;
};

TEST(Horizon, HidesNoBlockOfWhichAnythingIsSeen) {
    std::size_t left_out = 0;
    std::size_t all = 0;
    for (std::uint64_t i = 0; i < kLands; ++i) {
        Outlook outlook{base::Seed{i}};
        left_out += outlook.all.size() - outlook.drawn.size();
        all += outlook.all.size();
        const std::set<std::uint32_t> drawn(outlook.drawn.begin(), outlook.drawn.end());
        for (const std::uint32_t index : std::set<std::uint32_t>(outlook.all.begin(), outlook.all.end())) {
            if (drawn.contains(index)) continue;
            const glm::vec3 at_m =
                sample_m(outlook.field, static_cast<int>(index) % kSide, static_cast<int>(index) / kSide);
            EXPECT_FALSE(is_free(outlook.field, outlook.moved_eye_m(), at_m + glm::vec3{0, 1e-3F, 0}))
                << "land " << i << ", sample " << index;
        }
    }
    EXPECT_GT(left_out, all / 50) << all << ": one serves for two metres of flight, which leaves that much less out";
}

TEST(Horizon, HidesNothingThatStandsInSight) {
    int hidden = 0;
    for (std::uint64_t i = 0; i < kLands; ++i) {
        Outlook outlook{base::Seed{i}};
        for (int k = 0; k < 200; ++k) {
            glm::vec3 foot_m{outlook.random.between(-125, 125), 0, outlook.random.between(-125, 125)};
            foot_m.y = ground_m(outlook.field, foot_m);
            const float radius_m = outlook.random.between(0.2F, 3);
            const float high_m = outlook.random.between(0.5F, 12);
            if (!outlook.frustum().may_see_sphere(foot_m + glm::vec3{0, high_m, 0}, 0)) continue;
            if (!outlook.horizon.hides_standing({foot_m.x, foot_m.z}, radius_m, foot_m.y + high_m)) continue;
            ++hidden;
            for (const float turn : {0.0F, 1.6F, 3.1F, 4.7F}) {
                const glm::vec3 crown{radius_m * std::cos(turn), high_m, radius_m * std::sin(turn)};
                EXPECT_FALSE(is_free(outlook.field, outlook.moved_eye_m(), foot_m + crown)) << "land " << i;
            }
        }
    }
    EXPECT_GT(hidden, 500);
}

// The ground as these triangles have it, at every sample.
mesh::Field drawn_by(const mesh::Roam& roam, const mesh::Field& field) {
    std::vector<std::uint32_t> indices;
    roam.append_indices({}, indices);
    mesh::Field drawn = field;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const glm::vec3 a = roam.place_m(indices[i]);
        const glm::vec3 b = roam.place_m(indices[i + 1]);
        const glm::vec3 c = roam.place_m(indices[i + 2]);
        const glm::vec3 normal = glm::cross(b - a, c - a);
        const auto is_left_of = [](glm::vec3 from, glm::vec3 to, glm::vec3 at) {
            return (to.z - from.z) * (at.x - from.x) - (to.x - from.x) * (at.z - from.z) >= 0;
        };
        const glm::vec3 low = glm::min(a, glm::min(b, c));
        const glm::vec3 high = glm::max(a, glm::max(b, c));
        for (float z = low.z; z <= high.z; z += kCell_m) {
            for (float x = low.x; x <= high.x; x += kCell_m) {
                const glm::vec3 at{x, 0, z};
                if (!is_left_of(a, b, at) || !is_left_of(b, c, at) || !is_left_of(c, a, at)) continue;
                drawn.at(static_cast<int>(x / kCell_m) + 64, static_cast<int>(z / kCell_m) + 64) =
                    a.y - (normal.x * (x - a.x) + normal.z * (z - a.z)) / normal.y;
            }
        }
    }
    return drawn;
}

// A plain with a wall across it, two blocks thick.
mesh::Field walled_plain(float high_m) {
    mesh::Field field(kSide, kSide);
    for (int row = kBlock; row <= 3 * kBlock; ++row)
        for (int column = 0; column < kSide; ++column) field.at(column, row) = high_m;
    return field;
}

// Coarse triangles leave a wall out that fills whole blocks, where none of their corners lies on it: what stands behind
// it is then in sight.
TEST(Horizon, HidesNothingThatIsSeenOverGroundWhichIsDrawnLower) {
    const mesh::Field field = walled_plain(6);
    const Blocks blocks(field, kCell_m, kBlock);
    base::RandomStream random{base::Seed{5}};
    int hidden = 0;
    int in_sight = 0;  // of what the wall as it is would hide
    for (int i = 0; i < 400; ++i) {
        const float sunk = i % 2 == 0 ? 0.005F : 0.6F;
        const glm::vec3 eye_m{random.between(-60, 60), random.between(1, 5), random.between(90, 125)};
        const scene::Camera camera{eye_m, {0, 2, -100}, 60};
        const Frustum frustum(scene::clip_from_view(camera, 1.6F) * scene::view_from_world(camera));
        mesh::Roam roam(field, kCell_m);
        roam.update({eye_m, 1, sunk});
        const mesh::Field drawn = drawn_by(roam, field);
        Horizon of_drawn;
        of_drawn.begin(eye_m, kMoved_m, sunk);
        blocks.hidden(frustum, eye_m, of_drawn);
        Horizon of_wall;
        of_wall.begin(eye_m, kMoved_m);
        blocks.hidden(frustum, eye_m, of_wall);
        for (int k = 0; k < 20; ++k) {
            const glm::vec3 top_m{random.between(-60, 60), random.between(0.5F, 6), random.between(-124, -100)};
            const auto hides = [&](const Horizon& by) { return by.hides_standing({top_m.x, top_m.z}, 0.2F, top_m.y); };
            const bool is_seen = is_free(drawn, eye_m, top_m);
            in_sight += hides(of_wall) && is_seen ? 1 : 0;
            if (!hides(of_drawn)) continue;
            ++hidden;
            EXPECT_FALSE(is_seen) << i << ", " << k;
        }
    }
    EXPECT_GT(hidden, 50);
    EXPECT_GT(in_sight, 50);
}

TEST(Horizon, OfNoGroundHidesNothing) {
    Horizon horizon;
    horizon.begin({0, 10, 0}, kMoved_m);
    EXPECT_FALSE(horizon.hides_box({40, -90, 40}, {50, -80, 50}));
    EXPECT_FALSE(horizon.hides_standing({60, 0}, 2, -70));
}

TEST(Horizon, OfAWallHidesWhatIsBehindItAndNotWhatStandsBeforeIt) {
    Horizon horizon;
    horizon.begin({0, 2, 0}, kMoved_m);
    for (float x = -90; x < 90; x += 20) horizon.cover({x, 12, -60}, {x + 20, 30, -40});
    EXPECT_TRUE(horizon.hides_box({-10, 0, -100}, {10, 13, -80}));
    EXPECT_FALSE(horizon.hides_box({-10, 0, -100}, {10, 40, -80}));
    EXPECT_FALSE(horizon.hides_box({-10, 0, 80}, {10, 3, 100}));
    EXPECT_TRUE(horizon.hides_standing({0, -150}, 2, 12));
    EXPECT_FALSE(horizon.hides_standing({0, -150}, 2, 60));
    EXPECT_FALSE(horizon.hides_standing({0, -30}, 2, 5));
}

TEST(Horizon, LeavesOutHiddenPlants) {
    Horizon horizon;
    horizon.begin({0, 2, 0}, kMoved_m);
    for (float x = -90; x < 90; x += 20) horizon.cover({x, 20, -60}, {x + 20, 30, -40});
    std::vector<scene::Plant> plants(2);
    plants[0].root_m = {0, 0, -30};
    plants[1].root_m = {0, 0, -150};
    const std::vector<PlantKind> kinds{{5, 2, {200, 50}, {0, 0.1F}, 0, 0}};
    const scene::Camera camera{{0, 2, 0}, {0, 2, -100}, 42};
    const Frustum frustum(scene::clip_from_view(camera, 1) * scene::view_from_world(camera));
    Gathering gathering;
    gathering.view.eye_seconds = {camera.eye_m, 0};
    const Sight all = look(plants, kinds, frustum, gathering);
    EXPECT_EQ(all.hidden, 0U);
    EXPECT_EQ(all.seen.size(), 2U);
    gathering.horizon = &horizon;
    const Sight over_hills = look(plants, kinds, frustum, gathering);
    EXPECT_EQ(over_hills.hidden, 1U);
    ASSERT_EQ(over_hills.seen.size(), 1U);
    EXPECT_EQ(over_hills.seen[0].plant, 0U);
}

}  // namespace
}  // namespace quadrat::render::choose
