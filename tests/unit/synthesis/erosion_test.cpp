// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/erosion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <numeric>

#include "scene/land.hpp"
#include "support/effort.hpp"
#include "synthesis/land/drainage.hpp"
#include "synthesis/land/field_methods.hpp"
#include "synthesis/land/rivers.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

mesh::Field hills(std::uint64_t seed, int size = 129, float relief_m = 120) {
    land::FieldRequest r;
    r.size = size;
    r.seed = base::Seed{seed};
    r.features = 3;
    mesh::Field field = land::make_field(*land::field_method("fbm"), r);
    for (float& h : field.samples) h = relief_m * h + 15;
    return field;
}

double volume(const mesh::Field& field) { return std::accumulate(field.samples.begin(), field.samples.end(), 0.0); }

TEST(Drainage, LeadsEveryCellDownToTheSeaOrTheBorder) {
    for (std::uint64_t seed = 0; seed < tests::of(30U); ++seed) {
        const mesh::Field field = hills(seed, 65);
        const land::Drainage d = land::drain(field, 0);
        ASSERT_EQ(d.order.size(), field.samples.size());
        std::vector<int> place(field.samples.size(), -1);
        for (std::size_t i = 0; i < d.order.size(); ++i) place[d.order[i]] = static_cast<int>(i);
        for (std::size_t i = 0; i < field.samples.size(); ++i) {
            const int to = d.receiver[i];
            const int x = static_cast<int>(i) % 65;
            const int y = static_cast<int>(i) / 65;
            ASSERT_GE(place[i], 0);
            if (to == static_cast<int>(i)) {
                EXPECT_TRUE(field.samples[i] <= 0 || x == 0 || y == 0 || x == 64 || y == 64);
                continue;
            }
            EXPECT_LE(std::max(std::abs(to % 65 - x), std::abs(to / 65 - y)), 1);
            EXPECT_LT(place[to], place[i]);
            EXPECT_LE(d.spill_m.samples[to], d.spill_m.samples[i]);
            EXPECT_GE(d.spill_m.samples[i], field.samples[i]);
        }
    }
}

// The definition: the least, over all ways out, of the highest ground on the way (Bellman-Ford until nothing changes).
TEST(Drainage, FloodsToTheSpillLevelAndNoHigher) {
    const mesh::Field field = hills(4, 33);
    mesh::Field level(33, 33, 1.0e9F);
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (int y = 0; y < 33; ++y) {
            for (int x = 0; x < 33; ++x) {
                const bool is_outlet = x == 0 || y == 0 || x == 32 || y == 32 || field.at(x, y) <= 0;
                float best = is_outlet ? field.at(x, y) : 1.0e9F;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        if (!is_outlet && field.is_inside(x + dx, y + dy))
                            best = std::min(best, std::max(field.at(x, y), level.at(x + dx, y + dy)));
                if (best < level.at(x, y)) {
                    level.at(x, y) = best;
                    has_changed = true;
                }
            }
        }
    }
    EXPECT_EQ(land::drain(field, 0).spill_m, level);
}

TEST(Drainage, CountsEveryCellOnceAtTheOutlets) {
    const mesh::Field field = hills(9);
    const land::Drainage d = land::drain(field, 0);
    const std::vector<float> area = land::drained_area_m2(d, 2);
    double sum = 0;
    for (std::size_t i = 0; i < area.size(); ++i)
        if (d.receiver[i] == static_cast<int>(i)) sum += area[i];
    EXPECT_NEAR(sum, 4.0 * static_cast<double>(area.size()), 1);
}

TEST(StreamErosion, LosesNoEarthButWhatItCarriesOff) {
    mesh::Field field = hills(12);
    const double before = volume(field);
    const land::MovedEarth moved = land::erode_by_streams(field, 2, {.steps = 6, .strength = 1, .hillslope = 0});
    const double lost = 4 * (before - volume(field));
    EXPECT_GT(moved.worn_m3, 1000);
    EXPECT_NEAR(moved.worn_m3, moved.laid_m3 + moved.carried_off_m3, 1e-5 * moved.worn_m3);
    EXPECT_NEAR(lost, moved.carried_off_m3, 1e-5 * moved.worn_m3);
}

TEST(StreamErosion, CutsDeeperWhereMoreWaterRuns) {
    mesh::Field field = hills(3);
    const mesh::Field before = field;
    const std::vector<float> area = land::drained_area_m2(land::drain(field, -1000), 2);
    land::erode_by_streams(field, 2, {.steps = 3, .strength = 1, .deposit = 0, .sea_m = -1000, .hillslope = 0});
    double streams = 0, slopes = 0;
    int stream_cells = 0, slope_cells = 0;
    for (std::size_t i = 0; i < area.size(); ++i) {
        const double cut = before.samples[i] - field.samples[i];
        EXPECT_GE(cut, -1e-3);
        (area[i] > 800 ? streams : slopes) += cut;
        ++(area[i] > 800 ? stream_cells : slope_cells);
    }
    EXPECT_GT(streams / stream_cells, 3 * slopes / slope_cells);
}

// A slope with springs of chance above a plain: gullies are cut into the slope, and below it what came down lies spread
// out, wider than the gullies are.
TEST(StreamErosion, LeavesGulliesAboveAndFansBelow) {
    constexpr int kSide = 129;
    mesh::Field field(kSide, kSide);
    const mesh::Field rough = hills(21, kSide, 6);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            field.at(x, y) =
                (y < 64 ? 2 + 0.9F * static_cast<float>(64 - y) : 2 + 0.006F * static_cast<float>(128 - y)) +
                (y < 64 ? 1.0F : 0.05F) * (rough.at(x, y) - 15);
    const mesh::Field before = field;
    land::erode_by_streams(field, 2,
                           {.steps = 8, .strength = 1, .deposit = 0.6F, .fans = 0.2F, .sea_m = -1000, .hillslope = 0});
    int cut = 0;
    int raised = 0;
    float deepest_m = 0;
    float thickest_m = 0;
    for (int y = 4; y < kSide - 4; ++y) {
        for (int x = 4; x < kSide - 4; ++x) {
            const float change_m = field.at(x, y) - before.at(x, y);
            if (y < 60) {
                cut += change_m < -1.0F;
                deepest_m = std::max(deepest_m, -change_m);
            } else if (y > 66) {
                raised += change_m > 0.02F;
                thickest_m = std::max(thickest_m, change_m);
            }
        }
    }
    EXPECT_GT(deepest_m, 3);
    EXPECT_GT(cut, 300);
    EXPECT_LT(cut, 56 * 121 * 3 / 4) << "gullies, not a slope worn back as a whole";
    EXPECT_GT(thickest_m, 0.1F);
    EXPECT_GT(raised, 25);
}

TEST(StreamErosion, WithoutStrengthLeavesTheGroundAlone) {
    mesh::Field field = hills(3);
    const mesh::Field before = field;
    land::erode_by_streams(field, 2, {.steps = 3, .strength = 0, .hillslope = 0});
    EXPECT_EQ(field, before);
}

TEST(Slides, EndUnderTheAngleOfReposeAndKeepTheEarth) {
    mesh::Field cone(65, 65);
    for (int y = 0; y < 65; ++y)
        for (int x = 0; x < 65; ++x)
            cone.at(x, y) =
                std::max(0.0F, 40.0F - 3.5F * std::hypot(static_cast<float>(x - 32), static_cast<float>(y - 32)));
    const double before = volume(cone);
    const float repose = std::tan(35.0F * 3.14159265F / 180.0F);
    const float steepest = land::slide_to_repose(cone, 2, repose, 1500);
    EXPECT_LE(steepest, repose);
    EXPECT_NEAR(volume(cone), before, 1e-5 * before);
    EXPECT_GT(cone.at(32, 32), 20);
}

TEST(Slides, LeaveGentleGroundAlone) {
    mesh::Field field = hills(5, 65, 8);
    const mesh::Field before = field;
    land::slide_to_repose(field, 2, 1.2F, 5);
    EXPECT_EQ(field, before);
}

TEST(Burrs, AreTakenOffAndTheRestIsLeft) {
    mesh::Field field(33, 33, 5.0F);
    field.at(10, 12) = 30;
    field.at(20, 7) = -9;                                                 // a pit
    for (const int x : {24, 25}) field.at(x, 24) = 12;                    // two samples long
    for (int y = 0; y < 33; ++y) field.at(28, y) += 0.3F * (y % 2 == 0);  // too low to be one
    land::remove_burrs(field, 2, 3);
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 33; ++x) EXPECT_NEAR(field.at(x, y), 5, 1) << x << ' ' << y;
    mesh::Field gentle = hills(5, 65, 2);
    const mesh::Field before = gentle;
    land::remove_burrs(gentle, 3, 2);
    EXPECT_EQ(gentle, before);
}

TEST(Burrs, GoWhileSteepSlopesRidgesAndSummitsStay) {
    mesh::Field cone(65, 65);
    for (int y = 0; y < 65; ++y)
        for (int x = 0; x < 65; ++x)
            cone.at(x, y) = 200 - 4 * std::hypot(static_cast<float>(x - 30), static_cast<float>(y - 33)) -
                            3 * static_cast<float>(std::abs(x - 30));  // steep, and with a crest
    mesh::Field evened = cone;
    land::remove_burrs(evened, 2, 3);
    EXPECT_EQ(evened, cone);
}

TEST(Burrs, TakenOffHillsLeaveTheirMeanAndTheirSummitsWhereTheyWere) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const mesh::Field clean = hills(seed, 129, 60);
        mesh::Field field = clean;
        base::RandomStream chance{base::Seed{seed}};
        for (int i = 0; i < 160; ++i)
            field.at(1 + static_cast<int>(chance.below(127)), 1 + static_cast<int>(chance.below(127))) +=
                chance.unit() < 0.5 ? 12.0F : -12.0F;
        land::remove_burrs(field, 4, 3);
        double moved = 0;
        double most = 0;
        for (std::size_t i = 0; i < field.samples.size(); ++i) {
            moved += field.samples[i] - clean.samples[i];
            most = std::max(most, static_cast<double>(std::abs(field.samples[i] - clean.samples[i])));
        }
        EXPECT_LT(std::abs(moved) / static_cast<double>(field.samples.size()), 0.02) << "metres, of the mean";
        EXPECT_LT(most, 12) << "no burr is left whole";
        EXPECT_NEAR(*std::ranges::max_element(field.samples), *std::ranges::max_element(clean.samples), 4.0);
        EXPECT_NEAR(*std::ranges::min_element(field.samples), *std::ranges::min_element(clean.samples), 4.0);
    }
}

TEST(Streams, AccountForAllThatTheyMove) {
    mesh::Field field = hills(7, 129, 60);
    const auto sum = [&] { return std::accumulate(field.samples.begin(), field.samples.end(), 0.0); };
    const double before = sum();
    const land::MovedEarth moved =
        land::erode_by_streams(field, 4, {.steps = 10, .deposit = 0.5F, .sea_m = -1.0e9F, .hillslope = 0.08F});
    EXPECT_GT(moved.worn_m3, 0);
    EXPECT_NEAR(moved.worn_m3, moved.laid_m3 + moved.carried_off_m3, 1e-3 * moved.worn_m3);
    EXPECT_NEAR(16 * (before - sum()), moved.carried_off_m3 + moved.crept_off_m3, 1e-3 * moved.worn_m3);
}

TEST(Smoothing, KeepsAPlaneInsideAndLessensTheRest) {
    mesh::Field plane(33, 33);
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 33; ++x) plane.at(x, y) = static_cast<float>(3 * x - 2 * y);
    mesh::Field field = plane;
    land::smooth(field, 2);
    for (int y = 2; y < 31; ++y)
        for (int x = 2; x < 31; ++x) EXPECT_NEAR(field.at(x, y), plane.at(x, y), 1e-3);
}

// Over many lands: rivers run down to a lake, the sea or the border; lakes are level and below their banks.
TEST(FreshWater, AlwaysHasAWayDown) {
    int rivers = 0;
    int lakes = 0;
    for (std::uint64_t seed = 0; seed < tests::of(500U); ++seed) {
        mesh::Field field = hills(seed, 65, 60);
        const land::FreshWater water =
            land::make_fresh_water(field, 8, {.river_area_m2 = 12000, .lake_depth_m = 0.8F, .lake_area_m2 = 400});
        const auto wet = [&](int x, int y) { return water.kind.at(x, y) != land::Wet::No; };
        std::deque<std::pair<int, int>> open;
        mesh::Grid<int> is_reached(65, 65, 0);
        for (int y = 0; y < 65; ++y) {
            for (int x = 0; x < 65; ++x) {
                bool ends = water.kind.at(x, y) == land::Wet::Lake || x == 0 || y == 0 || x == 64 || y == 64;
                lakes += water.kind.at(x, y) == land::Wet::Lake;
                for (int dy = -1; dy <= 1 && wet(x, y); ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        if (field.is_inside(x + dx, y + dy))
                            ends = ends || field.at(x + dx, y + dy) <= 0 || x + dx == 0 || y + dy == 0 ||
                                   x + dx == 64 || y + dy == 64;
                if (wet(x, y) && ends) {
                    open.emplace_back(x, y);
                    is_reached.at(x, y) = 1;
                }
            }
        }
        while (!open.empty()) {
            const auto [x, y] = open.front();
            open.pop_front();
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!field.is_inside(x + dx, y + dy) || !wet(x + dx, y + dy) || is_reached.at(x + dx, y + dy) != 0)
                        continue;
                    if (water.surface_m.at(x + dx, y + dy) < water.surface_m.at(x, y)) continue;
                    is_reached.at(x + dx, y + dy) = 1;
                    open.emplace_back(x + dx, y + dy);
                }
            }
        }
        for (int y = 0; y < 65; ++y) {
            for (int x = 0; x < 65; ++x) {
                if (!wet(x, y)) continue;
                rivers += water.kind.at(x, y) == land::Wet::River;
                EXPECT_EQ(is_reached.at(x, y), 1) << seed << ' ' << x << ' ' << y;
                EXPECT_GT(water.surface_m.at(x, y), field.at(x, y)) << seed;
                if (water.kind.at(x, y) != land::Wet::Lake) continue;
                if (x + 1 < 65 && water.kind.at(x + 1, y) == land::Wet::Lake) {
                    EXPECT_EQ(water.surface_m.at(x, y), water.surface_m.at(x + 1, y)) << seed;
                }
            }
        }
        const std::vector<std::uint32_t>& indices = water.mesh.indices;
        for (const auto index : indices) ASSERT_LT(index, water.mesh.positions_m.size());
        // What lies level with the sea is not drawn over it once more.
        for (std::size_t i = 0; i < indices.size(); i += 6) {
            float highest_m = -1;
            for (std::size_t k = 0; k < 6; ++k)
                highest_m = std::max(highest_m, water.mesh.positions_m[indices[i + k]].y);
            EXPECT_GT(highest_m, 0.01F) << seed;
        }
    }
    EXPECT_GT(rivers, tests::of(5000));
    EXPECT_GT(lakes, tests::of(500));
}

}  // namespace
