// SPDX-License-Identifier: Apache-2.0
#include "scene/settlement.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "scene/camera.hpp"
#include "scene/parameters.hpp"
#include "synthesis/compose/track.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/houses/fields.hpp"
#include "synthesis/houses/settle.hpp"
#include "synthesis/houses/styles.hpp"

namespace quadrat::synthesis {
namespace {

constexpr scene::Fineness kCoarse{.land_samples = 257, .light_px = 64, .albedo_px = 128};

scene::LandParameters country(float age, int region) {
    scene::LandParameters p;
    p.land_relief_m = 70;
    p.land_sea_level = 0.15F;
    p.settle_age = age;
    p.settle_region = static_cast<float>(region);
    p.settle_chapel = 0.5F;
    return p;
}

// Grown once: of one region each, villages and a town.
const std::vector<scene::Land>& lands() {
    static const std::vector<scene::Land> kLands = [] {
        std::vector<scene::Land> grown;
        for (int region = 0; region < houses::kRegions; ++region)
            grown.push_back(grow_land(country(region == 4 ? 0.9F : 0.5F, region),
                                      base::Seed{static_cast<std::uint64_t>(20 + region)}, kCoarse));
        return grown;
    }();
    return kLands;
}

// Whether convex outlines have a point in common, by their sides as axes.
bool meet(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
    for (const auto* of : {&a, &b})
        for (std::size_t i = 0; i < of->size(); ++i) {
            const glm::vec2 side = (*of)[(i + 1) % of->size()] - (*of)[i];
            const auto extent = [&](const std::vector<glm::vec2>& outline) {
                float low = 1.0e9F;
                float high = -1.0e9F;
                for (const glm::vec2 p : outline) {
                    low = std::min(low, side.x * p.y - side.y * p.x);
                    high = std::max(high, side.x * p.y - side.y * p.x);
                }
                return std::pair{low, high};
            };
            const auto [low_a, high_a] = extent(a);
            const auto [low_b, high_b] = extent(b);
            if (high_a < low_b || high_b < low_a) return false;
        }
    return true;
}

TEST(Settlement, NoTwoHousesTouch) {
    for (const scene::Land& land : lands()) {
        const scene::Settlement& s = land.settlement;
        ASSERT_GT(s.houses.size(), 20U);
        for (std::size_t i = 0; i < s.houses.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                if (glm::distance(s.houses[i].foot_m, s.houses[k].foot_m) > 40) continue;
                EXPECT_FALSE(meet(scene::outline_m(s.buildings[s.houses[i].building], s.houses[i]),
                                  scene::outline_m(s.buildings[s.houses[k].building], s.houses[k])))
                    << i << " and " << k;
            }
    }
}

TEST(Settlement, NoHouseStandsInTheWaterOrOnARoad) {
    for (const scene::Land& land : lands()) {
        for (const scene::House& house : land.settlement.houses) {
            const scene::Building& building = land.settlement.buildings[house.building];
            for (const glm::vec2 corner : scene::outline_m(building, house)) {
                EXPECT_EQ(scene::water_depth_m(land, corner), 0.0F);
                EXPECT_GT(scene::ground_height_m(land, corner), 0.5F);
            }
            for (const scene::Road& road : land.roads)
                for (const glm::vec3& p : road.line_m)
                    EXPECT_GE(scene::to_house_m(building, house, {p.x, p.z}), 0.5F * road.width_m);
        }
    }
}

TEST(Settlement, EveryDoorIsNearALaneThatItLooksAt) {
    for (const scene::Land& land : lands()) {
        for (const scene::House& house : land.settlement.houses) {
            const glm::vec3 door = scene::placed(house, {0, 0, land.settlement.buildings[house.building].half_m.y});
            const glm::vec3 ahead = scene::turned(house, {0, 0, 1});
            float nearest_m = 1.0e9F;
            for (const scene::Road& road : land.roads)
                for (const glm::vec3& p : road.line_m) {
                    const glm::vec3 to = p - door;
                    if (to.x * ahead.x + to.z * ahead.z > 0)
                        nearest_m = std::min(nearest_m, glm::length(glm::vec2{to.x, to.z}));
                }
            EXPECT_LT(nearest_m, 14.0F);
        }
    }
}

TEST(Settlement, NoFlightPassesThroughAHouse) {
    for (const scene::Land& land : lands()) {
        const Lookout lookout(land);
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            const base::Seed flight{seed};
            const scene::Track track = fly(fitted_to(lookout, plan_flight(flight)), lookout, flight);
            for (float seconds = 0; seconds < track.period_s; seconds += 0.5F) {
                const glm::vec3 eye = scene::camera_at(track, seconds).eye_m;
                for (const scene::House& house : land.settlement.houses) {
                    const scene::Building& building = land.settlement.buildings[house.building];
                    const bool is_beside = scene::to_house_m(building, house, {eye.x, eye.z}) > 1.5F;
                    EXPECT_TRUE(is_beside || eye.y > house.foot_m.y + building.height_m) << seed << ", " << seconds;
                }
            }
        }
    }
}

TEST(Settlement, TheGroundIsLevelUnderEveryHouse) {
    for (const scene::Land& land : lands())
        for (const scene::House& house : land.settlement.houses)
            for (const glm::vec2 corner : scene::outline_m(land.settlement.buildings[house.building], house, -0.5F))
                EXPECT_NEAR(scene::ground_height_m(land, corner), house.foot_m.y, 1.1F);
}

// From above, every place within the walls lies under a roof that stands no lower than the eaves.
TEST(Settlement, RoofsAreClosedOverTheWalls) {
    for (int region = 0; region < houses::kRegions; ++region) {
        const houses::Stock stock = houses::sample_stock(country(0.5F, region), base::Seed{7}, 12);
        for (std::size_t b = 0; b < stock.buildings().size(); ++b) {
            const scene::Building& building = stock.buildings()[b];
            const scene::Masses& far = building.levels.back();
            int open = 0;
            for (int i = 1; i < 8; ++i)
                for (int k = 1; k < 8; ++k) {
                    const glm::vec2 at = building.half_m * (glm::vec2{i, k} / 4.0F - 1.0F) * 0.97F;
                    // A wing leaves a corner of the rectangle empty: there is no wall below either.
                    float top_m = -1;
                    for (std::size_t t = 0; t + 2 < far.mesh.indices.size(); t += 3) {
                        glm::vec3 p[3];
                        for (std::size_t c = 0; c < 3; ++c) p[c] = far.mesh.positions_m[far.mesh.indices[t + c]];
                        const auto cross = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
                        const glm::vec2 a{p[0].x, p[0].z}, bb{p[1].x, p[1].z}, cc{p[2].x, p[2].z};
                        const float area = cross(bb - a, cc - a);
                        if (std::abs(area) < 1.0e-6F) continue;
                        const float u = cross(at - a, cc - a) / area;
                        const float v = cross(bb - a, at - a) / area;
                        if (u < -1.0e-4F || v < -1.0e-4F || u + v > 1.0001F) continue;
                        top_m = std::max(top_m, p[0].y + u * (p[1].y - p[0].y) + v * (p[2].y - p[0].y));
                    }
                    if (top_m < 2.0F) ++open;
                }
            // Of a house with a wing at most the empty corner, of a lighthouse the corners of its square.
            EXPECT_LE(open, stock.uses()[b] == houses::Use::Dwelling || stock.uses()[b] == houses::Use::Chapel ? 26 : 8)
                << region << ", " << b;
        }
    }
}

TEST(Settlement, BuildingsKeepToTheirTriangles) {
    for (int region = 0; region < houses::kRegions; ++region) {
        const houses::Stock stock = houses::sample_stock(country(0.5F, region), base::Seed{7}, 12);
        for (const scene::Building& building : stock.buildings()) {
            ASSERT_EQ(building.levels.size(), 3U);
            EXPECT_LE(building.levels[0].mesh.triangle_count(), 6000U);
            EXPECT_LE(building.levels[1].mesh.triangle_count(), 790U);
            EXPECT_LE(building.levels[2].mesh.triangle_count(), 200U);
            for (const scene::Masses& level : building.levels) {
                EXPECT_EQ(level.colours.size(), level.mesh.positions_m.size());
                EXPECT_EQ(level.lamps.size(), level.mesh.positions_m.size());
                EXPECT_EQ(level.claddings.size(), level.mesh.positions_m.size());
                EXPECT_TRUE(std::ranges::any_of(level.lamps, [](float lamp) { return lamp > 0; }) ||
                            building.chimneys_m.empty());
            }
        }
    }
}

TEST(Settlement, NoTwoHousesOfAHamletAreBuiltAlike) {
    for (const scene::Land& land : lands()) {
        const scene::Settlement& s = land.settlement;
        const std::size_t hamlet = std::min<std::size_t>(s.houses.size(), 24);
        std::vector<std::uint32_t> numbers;
        std::vector<float> heights_m;
        for (std::size_t i = 0; i < hamlet; ++i) {
            numbers.push_back(s.houses[i].building);
            heights_m.push_back(s.buildings[s.houses[i].building].height_m);
        }
        std::ranges::sort(numbers);
        EXPECT_EQ(std::unique(numbers.begin(), numbers.end()), numbers.end());
        const auto [low, high] = std::ranges::minmax(heights_m);
        EXPECT_GT(high, low + 1);
        for (std::size_t a = 0; a < hamlet; ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_NE(s.buildings[numbers[a]].levels[0].mesh, s.buildings[numbers[b]].levels[0].mesh);
    }
}

// Moss and soot on roofs, where rain runs off last.
TEST(Settlement, RoofsAreTheDarkerTheLessTheyAreKeptUp) {
    const auto light = [](float wear) {
        scene::LandParameters p = country(0.5F, 4);
        p.settle_wear = wear;
        double sum = 0;
        std::size_t count = 0;
        const houses::Stock stock = houses::sample_stock(p, base::Seed{9}, 12);
        for (const scene::Building& building : stock.buildings()) {
            const scene::Masses& far = building.levels.back();
            for (std::size_t i = 0; i < far.colours.size(); ++i) {
                if (far.claddings[i] < scene::Cladding::Tiles) continue;
                sum += static_cast<double>(far.colours[i].r + far.colours[i].g + far.colours[i].b);
                ++count;
            }
        }
        return sum / static_cast<double>(count);
    };
    EXPECT_LT(light(1), 0.93 * light(0));
}

TEST(Settlement, SmokeDiffersFromHouseToHouseAndSomeHaveNone) {
    scene::LandParameters p = country(0.6F, 4);
    p.settle_smoke = 0.6F;
    const scene::Settlement s = grow_land(p, base::Seed{24}, kCoarse).settlement;
    std::vector<scene::Plume> plumes;
    std::size_t without = 0;
    for (const scene::House& house : s.houses) {
        const bool has_chimney = !s.buildings[house.building].chimneys_m.empty();
        if (house.plume.strength > 0)
            plumes.push_back(house.plume);
        else if (has_chimney)
            ++without;
    }
    ASSERT_GT(plumes.size(), 12U);
    EXPECT_GT(without, 5U);
    const auto spread = [&](float scene::Plume::*of) {
        float low = 1.0e9F;
        float high = -1.0e9F;
        for (const scene::Plume& plume : plumes) {
            low = std::min(low, plume.*of);
            high = std::max(high, plume.*of);
        }
        return high - low;
    };
    EXPECT_GT(spread(&scene::Plume::strength), 0.4F);
    EXPECT_GT(spread(&scene::Plume::width), 0.5F);
    EXPECT_GT(spread(&scene::Plume::rise), 0.4F);
    EXPECT_GT(spread(&scene::Plume::phase), 0.6F);
}

TEST(Settlement, IsTheSameOnAnyNumberOfThreads) {
    const auto grown = [](std::size_t threads) {
        const oneapi::tbb::global_control only(oneapi::tbb::global_control::max_allowed_parallelism, threads);
        return grow_land(country(0.45F, 2), base::Seed{31}, kCoarse);
    };
    const scene::Land one = grown(1);
    const scene::Land many = grown(4);
    EXPECT_EQ(one.height_m, many.height_m);
    EXPECT_EQ(one.kept_clear, many.kept_clear);
    ASSERT_EQ(one.settlement.houses.size(), many.settlement.houses.size());
    for (std::size_t i = 0; i < one.settlement.houses.size(); ++i)
        EXPECT_EQ(one.settlement.houses[i].foot_m, many.settlement.houses[i].foot_m);
    for (std::size_t b = 0; b < one.settlement.buildings.size(); ++b)
        for (std::size_t level = 0; level < 3; ++level)
            EXPECT_EQ(one.settlement.buildings[b].levels[level].mesh, many.settlement.buildings[b].levels[level].mesh);
}

TEST(Settlement, AYoungerOneIsTheBeginningOfAnOlderOne) {
    std::vector<scene::Settlement> ages;
    for (const float age : {0.05F, 0.25F, 0.5F, 0.95F})
        ages.push_back(grow_land(country(age, 4), base::Seed{52}, kCoarse).settlement);
    for (std::size_t a = 0; a + 1 < ages.size(); ++a) {
        ASSERT_LT(ages[a].houses.size(), ages[a + 1].houses.size());
        for (std::size_t i = 0; i < ages[a].houses.size(); ++i) {
            EXPECT_EQ(ages[a].houses[i].foot_m.x, ages[a + 1].houses[i].foot_m.x);
            EXPECT_EQ(ages[a].houses[i].foot_m.z, ages[a + 1].houses[i].foot_m.z);
            EXPECT_EQ(ages[a].houses[i].building, ages[a + 1].houses[i].building);
        }
    }
    EXPECT_GT(ages.back().houses.size(), 150U);
}

TEST(Settlement, HousesAreAsManyAsItsAgeSays) {
    EXPECT_EQ(houses::houses_at(-0.1F), 0);
    EXPECT_EQ(houses::houses_at(0), 1);
    EXPECT_EQ(houses::houses_at(1), houses::kMostHouses);
    for (float age = 0; age < 1; age += 0.05F) EXPECT_LE(houses::houses_at(age), houses::houses_at(age + 0.05F));
}

TEST(Settlement, StainsGoOnAcrossATileAndLeaveSomeWallClean) {
    const mesh::Image& stains = *lands().front().settlement.stains;
    EXPECT_EQ(lands()[0].settlement.stains, lands()[1].settlement.stains);
    double sum = 0;
    double within = 0;  // how much a row differs from the next, and the last from the first
    double across = 0;
    for (int x = 0; x < stains.width; ++x) {
        for (int y = 0; y < stains.height; ++y) sum += *stains.pixel(x, y);
        within += std::abs(*stains.pixel(x, 40) - *stains.pixel(x, 41));
        across += std::abs(*stains.pixel(x, 0) - *stains.pixel(x, stains.height - 1));
    }
    const double mean = sum / (255.0 * stains.width * stains.height);
    EXPECT_GT(mean, 0.12);
    EXPECT_LT(mean, 0.6);
    EXPECT_LT(across, 3 * within + stains.width);
}

TEST(Settlement, WhatBoundsAPlotClimbsNoCliff) {
    int sides = 0;
    for (const scene::Land& land : lands())
        for (const scene::Masses& piece : land.settlement.bounds)
            for (std::size_t i = 0; i < piece.mesh.indices.size(); ++i) {
                const std::uint32_t a = piece.mesh.indices[i];
                const std::uint32_t b = piece.mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
                if (piece.claddings[a] != scene::Cladding::Leaves) continue;
                const glm::vec2 p{piece.mesh.positions_m[a].x, piece.mesh.positions_m[a].z};
                const glm::vec2 q{piece.mesh.positions_m[b].x, piece.mesh.positions_m[b].z};
                const float climb_m = std::abs(scene::ground_height_m(land, p) - scene::ground_height_m(land, q));
                EXPECT_LT(climb_m, 0.42F * glm::distance(p, q) + 0.8F);  // and across it
                ++sides;
            }
    EXPECT_GT(sides, 500);
}

TEST(Settlement, NoBrookRunsThroughAField) {
    int fields = 0;
    for (int region = 0; region < houses::kRegions; ++region) {
        const scene::LandParameters p = country(0.5F, region);
        scene::LandParameters wild = p;
        wild.settle_age = -1;
        const base::Seed seed{static_cast<std::uint64_t>(20 + region)};
        const scene::Land land = grow_land(wild, seed, kCoarse);
        const houses::Settled settled = houses::settle(land, p, seed);
        for (const scene::FieldPlot& field : houses::lay_fields(land, settled, p, seed)) {
            ++fields;
            glm::vec2 middle{0};
            for (const glm::vec2 corner : field.outline_m)
                middle += corner / static_cast<float>(field.outline_m.size());
            for (const glm::vec2 corner : field.outline_m)
                for (const float t : {0.2F, 0.4F, 0.6F, 0.8F})
                    EXPECT_LE(scene::water_depth_m(land, corner + t * (middle - corner)), 0.25F);
        }
    }
    EXPECT_GT(fields, 20);
}

TEST(Settlement, WildernessHasNone) {
    const scene::Land wild = grow_land(country(-0.2F, 4), base::Seed{52}, kCoarse);
    EXPECT_TRUE(wild.settlement.is_empty());
    EXPECT_TRUE(wild.roads.empty());
}

}  // namespace
}  // namespace quadrat::synthesis
