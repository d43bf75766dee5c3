// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "scene/tree_parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/land/facets.hpp"
#include "synthesis/land/patterns.hpp"
#include "synthesis/noise/reaction.hpp"
#include "synthesis/trees/bark.hpp"
#include "synthesis/trees/colonisation.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/leaf_picture.hpp"
#include "synthesis/trees/phyllotaxis.hpp"
#include "synthesis/trees/species.hpp"
#include "synthesis/trees/turtle.hpp"
#include "synthesis/trees/undergrowth.hpp"
#include "synthesis/trees/weber_penn.hpp"

namespace quadrat::synthesis::trees {
namespace {

TreeSkeleton grown(const char* name, int steps, float gnarl_deg = 0) {
    const Grammar grammar = library_grammar(name);
    TurtleOptions options = options_of(grammar);
    options.gnarl_deg = gnarl_deg;
    options.leafy_below = 0.3F;
    DeriveOptions how;
    how.steps = steps;
    return interpret(derive(grammar, how).word, options, base::Seed{3});
}

void expect_whole(const TreeSkeleton& skeleton) {
    ASSERT_FALSE(skeleton.limbs.empty());
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
        const Limb& limb = skeleton.limbs[i];
        ASSERT_GE(limb.nodes.size(), 2U);
        ASSERT_LT(limb.parent, static_cast<int>(i));
        for (const Limb::Node& node : limb.nodes) {
            ASSERT_TRUE(std::isfinite(node.at_m.x + node.at_m.y + node.at_m.z));
            ASSERT_GT(node.radius_m, 0);
            ASSERT_TRUE(node.sway >= 0 && node.sway <= 1);
        }
        if (limb.parent < 0) continue;
        const Limb& bearer = skeleton.limbs[limb.parent];
        ASSERT_LT(limb.parent_node, static_cast<int>(bearer.nodes.size()));
        EXPECT_LT(glm::distance(bearer.nodes[limb.parent_node].at_m, limb.nodes.front().at_m), 1e-4F) << i;
    }
    for (const Site& site : skeleton.sites) {
        ASSERT_LT(site.limb, static_cast<int>(skeleton.limbs.size()));
        ASSERT_LT(site.node, static_cast<int>(skeleton.limbs[site.limb].nodes.size()));
        ASSERT_NEAR(glm::length(site.along), 1, 1e-3);
        ASSERT_NEAR(glm::length(site.out), 1, 1e-3);
    }
}

TEST(Turtle, WalksASquareBackToItsStart) {
    for (const char turn : {'&', '+', '-', '^'}) {
        Word word;
        for (int i = 0; i < 4; ++i) {
            word.add('F', {1});
            word.add(turn, {90});
        }
        const TreeSkeleton skeleton = interpret(word, {}, base::Seed{1});
        ASSERT_EQ(skeleton.limbs.size(), 1U);
        EXPECT_NEAR(glm::length(skeleton.limbs[0].nodes.back().at_m), 0, 1e-5);
        EXPECT_NEAR(skeleton.longest_path_m, 4, 1e-5);
    }
}

TEST(Turtle, TurnsAsTheBooksMatricesSay) {
    // From heading up: + turns left, & pitches down and away from up, and \ rolls left toward up.
    const auto after = [](std::initializer_list<std::pair<char, float>> turns) {
        Word word;
        for (const auto& turn : turns) word.add(turn.first, {turn.second});
        word.add('F', {1});
        return interpret(word, {}, base::Seed{1}).limbs.front().nodes.back().at_m;
    };
    const auto near = [](const glm::vec3& a, const glm::vec3& b) { return glm::distance(a, b) < 1e-5F; };
    EXPECT_TRUE(near(after({}), {0, 1, 0}));
    EXPECT_TRUE(near(after({{'+', 90}}), {-1, 0, 0}));
    EXPECT_TRUE(near(after({{'&', 90}}), {0, 0, -1}));
    EXPECT_TRUE(near(after({{'\\', 90}, {'+', 90}}), {0, 0, 1}));
    EXPECT_TRUE(near(after({{'/', 90}, {'+', 90}}), {0, 0, -1}));
    EXPECT_TRUE(near(after({{'|', 0}}), {0, -1, 0}));
}

TEST(Turtle, BeginsEveryLimbOnItsBearerInEveryGrammarOfTheLibrary) {
    for (const NamedGrammar& one : grammar_library()) {
        SCOPED_TRACE(one.name);
        expect_whole(grown(std::string(one.name).c_str(), 5, 5));
    }
}

TEST(Turtle, ReadsWordsThatMakeNoSense) {
    Word word;
    for (const char c : {']', '[', '[', 'F', ']', ']', ']', '!', 'L', '$', '|', '%'}) word.add(c);
    EXPECT_EQ(interpret(word, {}, base::Seed{1}).limbs.size(), 1U);
    EXPECT_TRUE(interpret({}, {}, base::Seed{1}).limbs.empty());
}

TEST(WeberPenn, GrowsEveryPresetWholeAndAsHighAsItIs) {
    for (int i = 0; i <= static_cast<int>(Preset::Cypress); ++i) {
        const WeberPenn& preset = weber_penn(static_cast<Preset>(i));
        SCOPED_TRACE(preset.name);
        for (std::uint64_t seed = 0; seed < tests::of(20U); ++seed) {
            const TreeSkeleton skeleton = grow_weber_penn(preset, base::Seed{seed});
            expect_whole(skeleton);
            EXPECT_GT(skeleton.high_m.y, 0.6F);
            EXPECT_LT(skeleton.high_m.y, 1.8F);
            EXPECT_FALSE(skeleton.sites.empty());
            EXPECT_LE(skeleton.limbs.size(), 1700U);
        }
    }
}

TEST(WeberPenn, KeepsItsBudgetOfLimbsByLeavingOutTheLatest) {
    const TreeSkeleton few = grow_weber_penn(weber_penn(Preset::Fir), base::Seed{1}, 40);
    EXPECT_EQ(few.limbs.size(), 40U);
    for (std::size_t i = 1; i < few.limbs.size(); ++i) EXPECT_EQ(few.limbs[i].order, 1);
}

TEST(Colonisation, FillsItsCrownAndNothingElse) {
    Colonisation c;
    const TreeSkeleton skeleton = colonise(c, base::Seed{5});
    expect_whole(skeleton);
    EXPECT_GT(skeleton.limbs.size(), 60U);
    EXPECT_NEAR(skeleton.high_m.y, 1, 0.1);
    EXPECT_GT(skeleton.high_m.x, 0.6F * c.crown_radius);
    for (const Limb& limb : skeleton.limbs)
        for (const Limb::Node& node : limb.nodes)
            EXPECT_LT(std::hypot(node.at_m.x, node.at_m.z), c.crown_radius + c.kill);
}

TEST(Colonisation, IsKeptOutOfItsNeighboursShadeAndOffTheGround) {
    Colonisation c;
    const std::vector<glm::vec4> neighbours{{0.5F, 0.6F, 0, 0.4F}};
    const TreeSkeleton open = colonise(c, base::Seed{5});
    c.neighbours = neighbours;
    const TreeSkeleton shaded = colonise(c, base::Seed{5});
    EXPECT_LT(shaded.high_m.x, 0.75F * open.high_m.x);
    EXPECT_LT(shaded.low_m.x, 0.7F * open.low_m.x);
    Colonisation hillside;
    hillside.crown_base = 0.02F;
    hillside.slope = {0.9F, 0};
    hillside.clearance = 0.1F;
    for (const Limb& limb : colonise(hillside, base::Seed{5}).limbs)
        for (const Limb::Node& node : limb.nodes)
            EXPECT_GT(node.at_m.y, 0.9F * node.at_m.x - hillside.kill) << "under the hill";
}

TEST(PipeModel, GivesALimbTheSumOfWhatItBears) {
    TreeSkeleton skeleton;
    skeleton.limbs.resize(3);
    skeleton.limbs[0].nodes = {{{0, 0, 0}}, {{0, 1, 0}}};
    for (const std::size_t i : {1U, 2U}) {
        skeleton.limbs[i].nodes = {{{0, 1, 0}}, {{1, 2, 0}}};
        skeleton.limbs[i].parent = 0;
        skeleton.limbs[i].parent_node = 1;
    }
    PipeModel model;
    model.exponent = 2;
    model.trunk_radius_m = 0.5F;
    set_pipe_radii(skeleton, model);
    const auto area = [&](std::size_t limb, std::size_t node) {
        return std::pow(skeleton.limbs[limb].nodes[node].radius_m, 2.0F);
    };
    EXPECT_FLOAT_EQ(skeleton.limbs[0].nodes[0].radius_m, 0.5F);
    // The trunk's upper end bears two limbs and ends itself in a tip, whose area a limb has at its end.
    EXPECT_NEAR(area(0, 1), area(1, 0) + area(2, 0) + area(1, 1), 1e-3);
    EXPECT_LT(skeleton.limbs[1].nodes[1].radius_m, skeleton.limbs[1].nodes[0].radius_m);
}

TEST(Bending, KeepsLengthsAndJointsAndPullsTheWayItSays) {
    TreeSkeleton skeleton = grown("changed-c", 8);
    set_pipe_radii(skeleton, {});
    measure(skeleton);
    const TreeSkeleton before = skeleton;
    Forces forces;
    forces.sag = 1;
    forces.wind = {0.8F, 0, 0};
    bend(skeleton, forces);
    expect_whole(skeleton);
    double shift = 0;
    double drop = 0;
    for (std::size_t l = 0; l < skeleton.limbs.size(); ++l) {
        for (std::size_t i = 1; i < skeleton.limbs[l].nodes.size(); ++i) {
            const auto& now = skeleton.limbs[l].nodes;
            const auto& then = before.limbs[l].nodes;
            ASSERT_NEAR(glm::distance(now[i].at_m, now[i - 1].at_m), glm::distance(then[i].at_m, then[i - 1].at_m),
                        1e-3);
            shift += now[i].at_m.x - then[i].at_m.x;
            drop += then[i].at_m.y - now[i].at_m.y;
        }
    }
    EXPECT_GT(shift, 0);
    EXPECT_GT(drop, 0);
    EXPECT_LT(glm::distance(skeleton.limbs[0].nodes[0].at_m, before.limbs[0].nodes[0].at_m), 1e-6F);
}

TEST(Phyllotaxis, PlacesFloretsEvenlyAtTheGoldenAngle) {
    for (int n = 1; n < 400; ++n) {
        const glm::vec2 at = floret(n, 0.5F);
        EXPECT_NEAR(glm::length(at), 0.5 * std::sqrt(n), 1e-4);
        const double turn = std::remainder(std::atan2(at.y, at.x) - n * 137.50776 * M_PI / 180, 2 * M_PI);
        EXPECT_NEAR(turn, 0, 2e-3);
    }
    // No two of them come nearer than about a unit apart when c is one.
    float nearest = 9;
    for (int i = 0; i < 300; ++i)
        for (int k = 0; k < i; ++k) nearest = std::min(nearest, glm::distance(floret(i, 1), floret(k, 1)));
    EXPECT_GT(nearest, 0.9F);
}

TEST(Phyllotaxis, CoversAConeFromFootToTip) {
    glm::vec3 outward;
    EXPECT_LT(scale_on_cone(0, 50, outward).y, 0.05F);
    EXPECT_GT(scale_on_cone(49, 50, outward).y, 0.95F);
    for (int n = 0; n < 50; ++n) {
        scale_on_cone(n, 50, outward);
        EXPECT_NEAR(glm::length(outward), 1, 1e-5);
    }
}

TEST(Foliage, OfAConiferBearsConesOfScales) {
    TreeSkeleton skeleton;
    skeleton.limbs.push_back({.nodes = {{{0, 0, 0}, 0.2F, 0, 0}, {{0, 8, 0}, 0.1F, 1, 0}}});
    for (int i = 0; i < 200; ++i) {
        Site site;
        site.at_m = {std::cos(0.3F * static_cast<float>(i)), 0.04F * static_cast<float>(i),
                     std::sin(0.3F * static_cast<float>(i))};
        site.along = {0, 1, 0};
        site.out = {1, 0, 0};
        site.organ = i % 2 == 0 ? Organ::Fruit : Organ::Leaf;
        skeleton.sites.push_back(site);
    }
    FoliageOptions options;
    options.kind = LeafKind::Needles;
    options.blades = 600;
    options.colours.leaf = options.colours.second = {0, 1, 0};
    options.colours.fruit = {1, 0, 0};
    const scene::Leaves leaves = make_foliage(skeleton, options, base::Seed{5});
    EXPECT_LE(leaves.blades, options.blades);
    std::size_t scales = 0;
    const std::size_t per_blade = leaves.vertices.size() / leaves.blades;
    for (std::size_t i = 0; i < leaves.vertices.size(); i += per_blade) scales += leaves.vertices[i].colour.r > 0.5F;
    EXPECT_GT(scales, 90U);  // ten cones
    EXPECT_EQ(scales % 9, 0U);
}

struct Lightness {
    double mean, deviation;
};
Lightness lightness_of(const mesh::Image& picture) {
    double mean = 0;
    double square = 0;
    for (const std::uint8_t byte : picture.bytes) {
        mean += byte;
        square += byte * byte;
    }
    const auto count = static_cast<double>(picture.bytes.size());
    mean /= count;
    return {mean, std::sqrt(square / count - mean * mean)};
}

TEST(LeafPicture, HasVeinsAndTheBladesOwnColourOnTheWhole) {
    for (int k = 0; k < kLeafKinds; ++k) {
        const mesh::Image picture = leaf_picture(static_cast<LeafKind>(k), base::Seed{3});
        const Lightness light = lightness_of(picture);
        EXPECT_NEAR(light.mean, 128, 1) << k;
        EXPECT_GT(light.deviation, 8) << k;
        // The midrib is lighter than the blade beside it.
        EXPECT_GT(*picture.pixel(0, 24), *picture.pixel(9, 24)) << k;
        EXPECT_EQ(picture, leaf_picture(static_cast<LeafKind>(k), base::Seed{3}));
        EXPECT_NE(picture, leaf_picture(static_cast<LeafKind>(k), base::Seed{4}));
    }
}

double mean_step(const mesh::Image& picture, int to_column) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        sum +=
            std::abs(*picture.pixel(to_column, y) - *picture.pixel((to_column + picture.width - 1) % picture.width, y));
    return sum / picture.height;
}

TEST(FoliagePicture, IsOfLeavesOverOneAnotherThatGoOnAtItsSides) {
    for (int k = 0; k < kLeafKinds; ++k) {
        const mesh::Image picture = foliage_picture(static_cast<LeafKind>(k), base::Seed{3});
        const Lightness light = lightness_of(picture);
        EXPECT_NEAR(light.mean, 128, 2) << k;
        EXPECT_GT(light.deviation, 16) << k;
        double usual = 0;
        for (int x = 1; x < picture.width; ++x) usual = std::max(usual, mean_step(picture, x));
        EXPECT_LE(mean_step(picture, 0), 1.2 * usual) << k;
        EXPECT_EQ(picture, foliage_picture(static_cast<LeafKind>(k), base::Seed{3}));
        EXPECT_NE(picture, foliage_picture(static_cast<LeafKind>(k), base::Seed{4}));
    }
}

// A bush is a dome with leaves near the ground, near by and as a mass from afar.
TEST(Shrub, IsADomeThatReachesTheGround) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        ShrubOptions options;
        options.height_m = 1.6F;
        options.width = seed % 2 == 0 ? 1.0F : 0.5F;
        const scene::Species species = shrub(options, base::Seed{seed});
        int low = 0;
        for (const scene::Leaves::Vertex& v : species.leaves.vertices) low += v.site_m.y < 0.3F * options.height_m;
        EXPECT_GT(low, static_cast<int>(species.leaves.vertices.size()) / 8) << seed;
        ASSERT_FALSE(species.masses.empty()) << seed;
        const scene::CrownMass& mass = species.masses.front();
        EXPECT_GT(mass.share, 0.7F) << seed;
        float lowest_m = 9, widest_m = 0;
        for (std::size_t i = 0; i < mass.mesh.positions_m.size() - 3 * mass.sprays; ++i) {
            const glm::vec3& p = mass.mesh.positions_m[i];
            lowest_m = std::min(lowest_m, p.y);
            widest_m = std::max(widest_m, std::hypot(p.x, p.z));
        }
        EXPECT_LT(lowest_m, 0.25F * options.height_m) << seed;
        EXPECT_GT(widest_m, 0.3F * options.height_m) << seed;
    }
}

// From afar a tree is its mass: what the mass leaves out floats about it as single leaves.
TEST(CrownMass, IsNearlyAllOfATreesCrownAndNoneOfACactus) {
    for (int habit = 0; habit < kind_count(); ++habit) {
        const Kind& of = kind(habit);
        scene::TreeParameters p;
        p.tree_habit = static_cast<float>(habit);
        const Form form = form_of(p, Rank::First);
        ASSERT_EQ(form.habit, habit);
        const scene::Species species = make_species(form, base::Seed{3});
        if (of.is_rosette || of.own_leaf == LeafKind::Spines) {
            EXPECT_TRUE(species.masses.empty()) << of.name;
        } else if (!species.masses.empty()) {
            EXPECT_GT(species.masses.front().share, 0.75F) << of.name;
        }
    }
}

TEST(Stone, IsRoundedOffAsFarAsItIsAsked) {
    using land::add_facet;
    const std::array<glm::vec3, 3> colours{};
    scene::Stone sharp;
    add_facet(sharp, {glm::vec3{5, 0, 0}, {6, 0, 0}, {5, 0, 1}}, colours);  // not of it
    const std::size_t from = sharp.mesh.positions_m.size();
    add_facet(sharp, {glm::vec3{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, colours);  // up
    add_facet(sharp, {glm::vec3{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, colours);
    scene::Stone round = sharp;
    land::round_off(sharp, from, 0);
    land::round_off(round, from, 1);
    for (std::size_t i = 0; i < from; ++i) EXPECT_EQ(round.mesh.normals[i], sharp.mesh.normals[i]);
    EXPECT_EQ(sharp.mesh.normals[from], glm::vec3(0, 1, 0));
    EXPECT_NEAR(glm::length(round.mesh.normals[from] - round.mesh.normals[from + 3]), 0, 1e-6) << "where both meet";
    EXPECT_NEAR(glm::dot(round.mesh.normals[from], sharp.mesh.normals[from]), 0.7071, 1e-3);
    EXPECT_NEAR(glm::length(round.mesh.normals[from + 1] - sharp.mesh.normals[from + 1]), 0, 1e-6)
        << "where one is alone";
}

TEST(Lichen, CoversMoreOfAStoneTheMoreItIsAskedFor) {
    const auto covered = [](float share) {
        const mesh::Image picture = land::lichen_picture(base::Seed{3}, share);
        double sum = 0;
        for (const std::uint8_t byte : picture.bytes) sum += byte;
        return sum / (255.0 * picture.width * picture.height);
    };
    EXPECT_EQ(covered(0), 0);
    double last = 0;
    for (const float share : {0.25F, 0.5F, 0.75F, 1.0F}) {
        EXPECT_GT(covered(share), last) << share;
        last = covered(share);
    }
    EXPECT_GT(covered(0.5F), 0.05);
    EXPECT_LT(covered(1), 0.9);
}

TEST(Bands, LeaveBareGroundBetweenThem) {
    const mesh::Field bare = land::bare_bands(base::Seed{3});
    std::size_t bands = 0;
    double bare_share = 0;
    for (int y = 0; y < bare.rows; ++y)
        for (int x = 0; x < bare.columns; ++x) {
            ASSERT_TRUE(bare.at(x, y) >= 0 && bare.at(x, y) <= 1);
            bare_share += bare.at(x, y) / static_cast<float>(bare.columns * bare.rows);
            bands += bare.at(x, y) > 0.5F && bare.at((x + 1) % bare.columns, y) <= 0.5F;
        }
    EXPECT_GT(bare_share, 0.2);
    EXPECT_LT(bare_share, 0.8);
    EXPECT_GT(bands, 4U * bare.rows) << "in the mean along a row";
}

TEST(Bark, ReactsIntoAPatternThatRunsAlongTheLimb) {
    const mesh::Field field = noise::react({}, base::Seed{3}, 64);
    double mean = 0;
    double across = 0;
    double along = 0;
    double square = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double v = field.at(x, y);
            ASSERT_TRUE(v >= 0 && v < 1);
            mean += v / 4096;
            square += v * v / 4096;
            across += std::abs(v - field.at((x + 1) % 64, y));
            along += std::abs(v - field.at(x, (y + 1) % 64));
        }
    }
    EXPECT_GT(std::sqrt(square - mean * mean), 0.08) << "no pattern";
    EXPECT_GT(across, 1.5 * along);
}

TEST(Bark, OfEveryKindTilesAndIsLevelInTheMean) {
    for (const Bark kind : {Bark::Furrowed, Bark::Plates, Bark::Smooth, Bark::Banded, Bark::Ribbed}) {
        const mesh::Field relief = bark_relief(kind, base::Seed{9}, 128);
        double inside = 0;
        double seam = 0;
        for (int i = 0; i < 128; ++i) {
            seam += std::abs(relief.at(127, i) - relief.at(0, i)) + std::abs(relief.at(i, 127) - relief.at(i, 0));
            for (int k = 0; k < 127; ++k)
                inside += (std::abs(relief.at(k, i) - relief.at(k + 1, i)) +
                           std::abs(relief.at(i, k) - relief.at(i, k + 1))) /
                          127;
        }
        EXPECT_LT(seam, 2.2 * inside) << static_cast<int>(kind);
        const mesh::Image picture = bark_picture(relief, 1);
        double slope = 0;
        for (std::size_t i = 0; i < picture.bytes.size(); i += 4) slope += picture.bytes[i] - 128.0;
        EXPECT_NEAR(slope / (128 * 128), 0, 3);
    }
}

}  // namespace
}  // namespace quadrat::synthesis::trees
