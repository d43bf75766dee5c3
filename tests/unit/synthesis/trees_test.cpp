// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>

#include "genome/recipe.hpp"
#include "mesh/nearness.hpp"
#include "scene/tree_parameters.hpp"
#include "support/effort.hpp"
#include "support/manifold.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/species.hpp"

namespace quadrat::synthesis::trees {
namespace {

// Empty, or what is wrong with it.
std::string wood_fault(const scene::Wood& wood) {
    const std::size_t n = wood.mesh.positions_m.size();
    if (wood.mesh.normals.size() != n || wood.grains.size() != n || wood.mesh.texcoords.size() != n ||
        wood.ages.size() != n || wood.sways.size() != n)
        return "an attribute is missing";
    for (std::size_t i = 0; i < n; ++i) {
        if (!std::isfinite(glm::dot(wood.mesh.positions_m[i], wood.mesh.positions_m[i])))
            return "a place that is no number";
        if (std::abs(glm::length(wood.mesh.normals[i]) - 1) > 1e-3F) return "a normal that is not one long";
        if (!(wood.ages[i] >= 0 && wood.ages[i] <= 1 && wood.sways[i] >= 0 && wood.sways[i] <= 1))
            return "an age or a sway beyond 0 to 1";
        if (!std::isfinite(wood.mesh.texcoords[i].x + wood.mesh.texcoords[i].y))
            return "a bark coordinate that is no number";
    }
    if (std::string fault = tests::manifold_fault(wood.mesh.indices, n); !fault.empty()) return fault;
    return n > 0 && tests::volume_of(wood.mesh) <= 0 ? "inside out" : "";
}

// How far from what is nearest of the next level what stands on the ground goes, in the mean.
float foot_strays_m(const scene::Wood& wood, const mesh::Nearness& next, float foot_m) {
    float strays = 0;
    float count = 0;
    for (std::size_t i = 0; i < wood.coarser_m.size(); ++i) {
        const glm::vec3 at_m = wood.mesh.positions_m[i];
        if (at_m.y > foot_m) continue;
        strays += glm::distance(wood.coarser_m[i], next.nearest(at_m).at_m);
        ++count;
    }
    return strays / std::max(count, 1.0F);
}

// Of all levels: that each knows the way to the next one's surface, and none takes a trunk from the ground.
std::string levels_fault(const std::vector<scene::Wood>& levels, float trunk_radius_m) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const scene::Wood& wood = levels[level];
        const std::size_t ways = level + 1 < levels.size() ? wood.mesh.positions_m.size() : 0;
        if (wood.coarser_m.size() != ways || wood.coarser_sways.size() != ways) return "a vertex without a way";
        if (ways == 0) continue;
        const mesh::Nearness next(levels[level + 1].mesh);
        const float strays = foot_strays_m(wood, next, trunk_radius_m) / trunk_radius_m;
        if (strays > 0.5F) return "a trunk that leaves the ground by " + std::to_string(strays);
        for (std::size_t i = 0; i < ways; ++i) {
            if (next.distance_m(wood.coarser_m[i]) > 1e-3F) return "a way that ends beside the next level";
            if (!(wood.coarser_sways[i] >= 0 && wood.coarser_sways[i] <= 1)) return "a sway beyond 0 to 1";
        }
    }
    return {};
}

std::string masses_fault(const scene::Species& species) {
    float reach_m = 0;
    for (const scene::Leaves::Vertex& v : species.leaves.vertices)
        reach_m = std::max(reach_m, glm::length(v.site_m + v.corner_m));
    std::size_t triangles = 1350;
    for (const scene::CrownMass& mass : species.masses) {
        const std::size_t n = mass.mesh.positions_m.size();
        if (mass.colours.size() != n || mass.shades.size() != n || mass.ages.size() != n || mass.sways.size() != n)
            return "an attribute of the crown's mass is missing";
        if (!mass.coarser_m.empty() && mass.coarser_m.size() != n) return "a vertex of a mass without a way";
        mesh::Mesh closed = mass.mesh;
        closed.indices.resize(closed.indices.size() - 3 * mass.sprays);
        closed.positions_m.resize(n - 3 * mass.sprays);
        if (const std::string fault = tests::manifold_fault(closed.indices, closed.positions_m.size()); !fault.empty())
            return fault;
        const bool is_strokes = closed.indices.empty();  // of a tree without leaves
        if (!is_strokes && tests::volume_of(closed) <= 0) return "a crown's mass inside out";
        for (const glm::vec3& at_m : mass.mesh.positions_m)
            if (!(glm::length(at_m) < 1.1F * reach_m)) return "a crown's mass beyond its leaves";
        for (const glm::vec3& colour : mass.colours)
            if (!(glm::length(colour) < 3)) return "a mass of no colour";
        if (mass.mesh.triangle_count() >= triangles) return "a coarser mass of more triangles";
        triangles = mass.mesh.triangle_count();
        if (!(mass.share > 0 && mass.share <= 1)) return "a mass of no share";
    }
    return {};
}

std::string leaves_fault(const scene::Leaves& leaves) {
    if (leaves.indices_per_blade() * leaves.blades != leaves.indices.size() || leaves.indices_per_blade() % 3 != 0)
        return "blades of different triangles";
    if (leaves.indices_per_plain_blade() * leaves.blades != leaves.plain_indices.size())
        return "plain blades of different triangles";
    for (const auto index : leaves.indices)
        if (index >= leaves.vertices.size()) return "an index beyond the vertices";
    for (const auto index : leaves.plain_indices)
        if (index >= leaves.vertices.size()) return "a plain index beyond the vertices";
    for (const auto& v : leaves.vertices) {
        if (std::abs(glm::length(v.normal) - 1) > 1e-3F) return "a normal that is not one long";
        if (!std::isfinite(v.site_m.x + v.site_m.y + v.site_m.z + v.corner_m.x + v.corner_m.y + v.corner_m.z))
            return "a place that is no number";
        if (!(v.shade > 0 && v.shade <= 1 && v.age >= 0 && v.age <= 1 && v.sway >= 0 && v.sway <= 1))
            return "a share beyond 0 to 1";
        for (int c = 0; c < 3; ++c)
            if (!(v.colour[c] >= 0 && v.colour[c] < 2)) return "a colour that is none";
    }
    return {};
}

class EveryHabit : public testing::TestWithParam<int> {};

TEST_P(EveryHabit, GrowsSoundClosedWoodAndLeavesWithinItsBudget) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(GetParam());
    const scene::Flora flora = grow_trees(p, base::Seed{77});
    ASSERT_GE(flora.species.size(), 6U);
    for (const scene::Species& species : flora.species) {
        SCOPED_TRACE(species.name);
        ASSERT_FALSE(species.wood.empty());
        for (const scene::Wood& wood : species.wood) EXPECT_EQ(wood_fault(wood), "");
        EXPECT_EQ(levels_fault(species.wood, species.trunk_radius_m), "");
        EXPECT_EQ(leaves_fault(species.leaves), "");
        EXPECT_EQ(masses_fault(species), "");
    }
    const scene::Species& tree = flora.species.front();
    EXPECT_LE(tree.wood[0].mesh.triangle_count(), kMostWoodTriangles);
    EXPECT_LE(tree.wood[1].mesh.triangle_count(), 4500U);
    const Kind& own = kind(GetParam());
    const bool has_crown = tree.leaves.blades > 0 && own.own_leaf != LeafKind::Spines;
    EXPECT_LE(tree.wood.back().mesh.triangle_count(), !has_crown ? 200U : own.is_rosette ? 8U : 4U);
    EXPECT_EQ(tree.wood.front().left_out_m, 0);
    for (std::size_t level = 1; level < tree.wood.size(); ++level) {
        EXPECT_LE(4 * tree.wood[level].mesh.triangle_count(), 3 * tree.wood[level - 1].mesh.triangle_count());
        EXPECT_GT(tree.wood[level].left_out_m, tree.wood[level - 1].left_out_m);
    }
    EXPECT_LE(tree.leaves.indices.size() / 3, kMostLeafTriangles);
    EXPECT_NEAR(tree.height_m, 13 * kind(GetParam()).height, 5);
    EXPECT_EQ(tree.bark.width, 128);
}

TEST_P(EveryHabit, CoversItsWholeCrownWithAPrefixOfItsLeaves) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(GetParam());
    const scene::Leaves leaves = grow_trees(p, base::Seed{5}).species.front().leaves;
    const std::size_t per_blade = leaves.vertices.size() / leaves.blades;
    const auto bounds = [&](std::size_t blades) {
        glm::vec3 low{1e6F};
        glm::vec3 high{-1e6F};
        for (std::size_t i = 0; i < per_blade * blades; ++i) {
            low = glm::min(low, leaves.vertices[i].site_m);
            high = glm::max(high, leaves.vertices[i].site_m);
        }
        return high - low;
    };
    const glm::vec3 part = bounds(leaves.blades / 8);
    const glm::vec3 whole = bounds(leaves.blades);
    if (leaves.blades < 100) return;  // a palm's fronds have one site
    for (int i = 0; i < 3; ++i) EXPECT_GT(part[i], 0.6F * whole[i]);
}

INSTANTIATE_TEST_SUITE_P(All, EveryHabit, testing::Range(0, kind_count()));

TEST(Trees, OfEveryTypeOfTheClassicGenomeAreDifferentPlants) {
    std::vector<glm::vec3> sizes;
    for (int type = 0; type < 8; ++type) {
        scene::TreeParameters p;
        p.tree_type = static_cast<float>(type);
        const TreeSkeleton skeleton = grow_skeleton(form_of(p, Rank::First), base::Seed{3});
        for (const glm::vec3& other : sizes) EXPECT_GT(glm::distance(other, skeleton.high_m), 0.05F) << type;
        sizes.push_back(skeleton.high_m);
    }
}

// What the table promises: every combination of its parameters is a plant within its budget.
constexpr std::size_t kMostBytes = 4'000'000;

TEST(Trees, OfRandomGenomesHoldTheirBudgets) {
    const int kTrees = tests::sample_of(10'000);
    std::mutex mutex;
    std::string faults;
    const auto blame = [&](int i, const std::string& what) {
        const std::scoped_lock lock(mutex);
        if (faults.size() < 600) faults += std::to_string(i) + ": " + what + "\n";
    };
    oneapi::tbb::parallel_for(0, kTrees, [&](int i) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{static_cast<std::uint64_t>(i)});
        const Rank rank = i % 3 == 0 ? Rank::First : i % 3 == 1 ? Rank::Second : Rank::Third;
        const Form form = form_of(scene::realise_trees(recipe.values), rank);
        const base::Seed seed = recipe.seeds[genome::Aspect::Trees];
        const TreeSkeleton skeleton = grow_skeleton(form, seed);
        if (skeleton.limbs.empty()) return blame(i, "no limb");
        if (skeleton.limbs.size() > kMostLimbs) blame(i, "too many limbs");
        const float foot_m = skeleton.limbs.front().nodes.front().radius_m;
        for (const Limb& limb : skeleton.limbs) {
            for (const Limb::Node& node : limb.nodes) {
                if (!std::isfinite(node.at_m.x + node.at_m.y + node.at_m.z + node.radius_m))
                    return blame(i, "not a number");
                if (node.at_m.y < -1.0F * foot_m)
                    return blame(i, std::string(kind(form.habit).name) + ": a limb under the ground");
                if (std::abs(node.at_m.x) > 60 || std::abs(node.at_m.z) > 60 || node.at_m.y > 40)
                    return blame(i, "too large");
                if (node.radius_m <= 0 || node.radius_m > 3) return blame(i, "too thick");
            }
        }
        if (i % 40 != 0) return;
        const scene::Species species = make_species(form, seed);
        if (species.wood.front().mesh.indices.empty()) blame(i, "no wood");
        for (const scene::Wood& wood : species.wood) {
            if (const std::string fault = wood_fault(wood); !fault.empty()) blame(i, fault);
            if (wood.mesh.triangle_count() > kMostWoodTriangles)
                blame(i, "too many triangles of wood: " + std::to_string(wood.mesh.triangle_count()));
        }
        if (const std::string fault = levels_fault(species.wood, species.trunk_radius_m); !fault.empty())
            blame(i, fault);
        if (const std::string fault = leaves_fault(species.leaves); !fault.empty()) blame(i, fault);
        if (const std::string fault = masses_fault(species); !fault.empty()) blame(i, fault);
        if (species.leaves.indices.size() / 3 > kMostLeafTriangles) blame(i, "too many leaves");
        if (scene::bytes_of(species) > kMostBytes) blame(i, "too much memory");
        if (species.leaves.blades == 0 && form.bareness < 0.9F) blame(i, "no leaves");
    });
    EXPECT_EQ(faults, "");
}

TEST(MetaTubes, OfAWholeTreeAreClosedAndJoinedIntoOnePiece) {
    scene::TreeParameters p;
    p.tree_habit = 1;
    TreeSkeleton skeleton = grow_skeleton(form_of(p, Rank::First), base::Seed{4});
    MetaTubeDetail detail;
    detail.cell_m = 0.06F;
    detail.sweeps_twigs = false;
    const scene::Wood wood = mesh_meta_tubes(skeleton, detail);
    ASSERT_EQ(wood_fault(wood), "");
    EXPECT_EQ(tests::degenerate_triangles(wood.mesh), 0U);
    // Every vertex is reached from the first over edges.
    std::vector<std::uint32_t> root(wood.mesh.positions_m.size());
    for (std::uint32_t i = 0; i < root.size(); ++i) root[i] = i;
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (std::size_t i = 0; i < wood.mesh.indices.size(); i += 3) {
        root[find(wood.mesh.indices[i])] = find(wood.mesh.indices[i + 1]);
        root[find(wood.mesh.indices[i])] = find(wood.mesh.indices[i + 2]);
    }
    std::size_t in_first = 0;
    const std::uint32_t first = find(0);
    for (std::uint32_t i = 0; i < root.size(); ++i) in_first += find(i) == first;
    EXPECT_EQ(in_first, root.size());
}

TEST(MetaTubes, HaveTheLimbsOwnRadiusAwayFromForks) {
    TreeSkeleton skeleton;
    skeleton.limbs.resize(1);
    skeleton.limbs[0].nodes = {{{0, 0, 0}, 0.3F}, {{0, 2, 0}, 0.3F}, {{0.2F, 4, 0}, 0.3F}};
    measure(skeleton);
    MetaTubeDetail detail;
    detail.cell_m = 0.08F;
    detail.has_foot = false;
    const scene::Wood wood = mesh_meta_tubes(skeleton, detail);
    int seen = 0;
    for (const glm::vec3& v : wood.mesh.positions_m) {
        if (v.y < 0.4F || v.y > 1.6F) continue;
        EXPECT_NEAR(std::hypot(v.x, v.z), 0.3F, 0.012F);
        ++seen;
    }
    EXPECT_GT(seen, 100);
}

// Bark must not tear: along an edge its coordinates change by hardly more than the edge is long.
TEST(MetaTubes, CarryBarkCoordinatesWithoutASeam) {
    TreeSkeleton skeleton;
    skeleton.limbs.resize(2);
    skeleton.limbs[0].nodes = {{{0, 0, 0}, 0.3F}, {{0, 2, 0}, 0.28F}, {{0, 4, 0}, 0.25F}};
    skeleton.limbs[1].nodes = {{{0, 2, 0}, 0.2F}, {{1.2F, 3, 0.3F}, 0.17F}, {{2, 4, 0.4F}, 0.15F}};
    skeleton.limbs[1].parent = 0;
    skeleton.limbs[1].parent_node = 1;
    measure(skeleton);
    MetaTubeDetail detail;
    detail.cell_m = 0.05F;
    const scene::Wood wood = mesh_meta_tubes(skeleton, detail);
    double worst = 0;
    for (std::size_t i = 0; i < wood.mesh.indices.size(); ++i) {
        const std::uint32_t a = wood.mesh.indices[i];
        const std::uint32_t b = wood.mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        const float apart = glm::distance(wood.mesh.positions_m[a], wood.mesh.positions_m[b]);
        worst = std::max(
            worst, static_cast<double>(glm::distance(wood.mesh.texcoords[a], wood.mesh.texcoords[b]) - 4 * apart));
    }
    EXPECT_LT(worst, 0.1);
}

TEST(SweptTubes, KnowWhichLimbEachRingBelongsTo) {
    const TreeSkeleton skeleton = grow_skeleton(form_of({}, Rank::First), base::Seed{3});
    std::vector<TubeRing> rings;
    const scene::Wood wood = sweep_tubes(skeleton, {}, &rings);
    ASSERT_EQ(wood_fault(wood), "");
    ASSERT_FALSE(rings.empty());
    for (const TubeRing& ring : rings) {
        ASSERT_LT(ring.limb, skeleton.limbs.size());
        ASSERT_LE(ring.first_vertex + ring.sides, wood.mesh.positions_m.size());
    }
    EXPECT_EQ(wood.ages.front(), 0);
    EXPECT_GT(*std::max_element(wood.ages.begin(), wood.ages.end()), 0.8F);
}

TEST(Cylinders, AreOneForEveryInternode) {
    const TreeSkeleton skeleton = grow_skeleton(form_of({}, Rank::First), base::Seed{3});
    std::size_t internodes = 0;
    for (const Limb& limb : skeleton.limbs) internodes += limb.nodes.size() - 1;
    const scene::Wood wood = mesh_cylinders(skeleton, 6);
    EXPECT_EQ(wood_fault(wood), "");
    EXPECT_EQ(wood.mesh.triangle_count(), internodes * 4 * 6);
}

TEST(Kinds, OfColumnsAndSpiresGrowOnOneStemWhateverTheGene) {
    scene::TreeParameters p;
    p.tree_stems = 3;
    for (int habit = 0; habit < kind_count(); ++habit) {
        p.tree_habit = static_cast<float>(habit);
        const Form form = form_of(p, Rank::First);
        EXPECT_EQ(form.stems, std::min(3, kind(form.habit).most_stems)) << kind(form.habit).name;
        const std::string_view name = kind(form.habit).name;
        if (name == "cypress" || name == "poplar" || name == "fir") {
            EXPECT_EQ(form.stems, 1) << name;
        }
    }
}

}  // namespace
}  // namespace quadrat::synthesis::trees
