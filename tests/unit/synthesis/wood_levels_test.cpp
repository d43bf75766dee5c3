// SPDX-License-Identifier: Apache-2.0
// Levels of detail from what the generator knows (which limbs bear most), against those of the same mesh without it:
// edges collapsed by quadric error to as many triangles. "Genetic selection of parametric scenes" (2003) wished for
// the first and had the second. What differs is measured as a viewer sees it: by the outline.
#include "synthesis/trees/wood_levels.hpp"

#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "mesh/progressive.hpp"
#include "synthesis/trees/species.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kPixels = 240;  // height of the picture an outline is drawn in

double own_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

// What a mesh hides of a picture, seen from the south or from the west, kPixels high for height_m.
mesh::Grid<std::uint8_t> outline(const mesh::Mesh& mesh, float height_m, bool from_west) {
    mesh::Grid<std::uint8_t> hidden(2 * kPixels, kPixels + 16, 0);
    const float per_m = kPixels / height_m;
    const auto at = [&](std::uint32_t i) {
        const glm::vec3& p = mesh.positions_m[i];
        return glm::vec2{kPixels + per_m * (from_west ? p.z : p.x), 8 + per_m * p.y};
    };
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::vec2 a = at(mesh.indices[t]);
        const glm::vec2 b = at(mesh.indices[t + 1]);
        const glm::vec2 c = at(mesh.indices[t + 2]);
        const glm::vec2 low = glm::floor(glm::min(a, glm::min(b, c)));
        const glm::vec2 high = glm::ceil(glm::max(a, glm::max(b, c)));
        const auto cross = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
        const float turn = cross(b - a, c - a) < 0 ? -1.0F : 1.0F;
        for (int y = std::max(static_cast<int>(low.y), 0); y < std::min(static_cast<int>(high.y), hidden.rows); ++y)
            for (int x = std::max(static_cast<int>(low.x), 0); x < std::min(static_cast<int>(high.x), hidden.columns);
                 ++x) {
                const glm::vec2 p{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F};
                if (turn * cross(b - a, p - a) >= 0 && turn * cross(c - b, p - b) >= 0 &&
                    turn * cross(a - c, p - c) >= 0)
                    hidden.at(x, y) = 1;
            }
    }
    return hidden;
}

// Pixels that one outline has and the other has not, to those of the finer one; the mean of both sides.
double outline_error(const mesh::Mesh& fine, const mesh::Mesh& coarse, float height_m) {
    double sum = 0;
    for (const bool from_west : {false, true}) {
        const auto a = outline(fine, height_m, from_west);
        const auto b = outline(coarse, height_m, from_west);
        double differ = 0;
        double own = 0;
        for (std::size_t i = 0; i < a.samples.size(); ++i) {
            differ += a.samples[i] != b.samples[i] ? 1 : 0;
            own += a.samples[i];
        }
        sum += 0.5 * differ / std::max(own, 1.0);
    }
    return sum;
}

// Of a chain at so many triangles, between the two levels that it lies between; less than 0 where none is as coarse.
double outline_error(const mesh::Progressive& chain, std::size_t triangles, float height_m) {
    const mesh::Mesh& fine = chain.levels.front().mesh;
    for (std::size_t i = 0; i + 1 < chain.levels.size(); ++i) {
        const mesh::Mesh& finer = chain.levels[i].mesh;
        const mesh::Mesh& coarser = chain.levels[i + 1].mesh;
        if (triangles < coarser.triangle_count()) continue;
        const auto log = [](std::size_t n) { return std::log(static_cast<double>(n)); };
        const double t = (log(finer.triangle_count()) - log(std::min(triangles, finer.triangle_count()))) /
                         (log(finer.triangle_count()) - log(coarser.triangle_count()));
        return (1 - t) * outline_error(fine, finer, height_m) + t * outline_error(fine, coarser, height_m);
    }
    return -1;
}

struct Compared {
    double known = 0, blind = 0;                     // outline's error, mean over levels
    double known_ms = 0, blind_ms = 0;               // to make all levels
    std::size_t fewest_known = 0, fewest_blind = 0;  // triangles of the coarsest
};

Compared compared(int habit) {
    Form form;
    form.habit = habit;
    const TreeSkeleton skeleton = skeleton_of_species(form, base::Seed{7});
    Compared c;
    double before = own_ms();
    const std::vector<scene::Wood> levels = wood_levels(skeleton);
    c.known_ms = own_ms() - before;
    mesh::ProgressiveOptions options;
    options.fewest = 12;
    before = own_ms();
    const mesh::Progressive chain = mesh::make_progressive(levels.front().mesh, options);
    c.blind_ms = own_ms() - before;
    const float height_m = skeleton.high_m.y;
    int shared = 0;
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const mesh::Mesh& known = levels[i].mesh;
        const double blind = outline_error(chain, known.triangle_count(), height_m);
        if (blind < 0) continue;
        ++shared;
        c.known += outline_error(levels.front().mesh, known, height_m);
        c.blind += blind;
    }
    c.known /= std::max(shared, 1);
    c.blind /= std::max(shared, 1);
    c.fewest_known = levels.back().mesh.triangle_count();
    c.fewest_blind = chain.levels.back().mesh.triangle_count();
    return c;
}

TEST(WoodLevels, OfTheGeneratorCostLessAndGoFartherThanCollapsesOfTheSameMesh) {
    Compared sum;
    std::size_t fewest_known = 0;
    std::size_t fewest_blind = 0;
    std::printf("kind            outline's error: known  blind   ms: known  blind   fewest triangles: known  blind\n");
    for (int habit = 0; habit < kind_count(); ++habit) {
        const Compared c = compared(habit);
        std::printf("%-20s %17.3f %6.3f %11.1f %6.1f %22zu %6zu\n", kind(habit).name, c.known, c.blind, c.known_ms,
                    c.blind_ms, c.fewest_known, c.fewest_blind);
        fewest_known += c.fewest_known;
        fewest_blind += c.fewest_blind;
        sum.known += c.known / kind_count();
        sum.blind += c.blind / kind_count();
        sum.known_ms += c.known_ms / kind_count();
        sum.blind_ms += c.blind_ms / kind_count();
    }
    std::printf("%-20s %17.3f %6.3f %11.1f %6.1f\n", "mean", sum.known, sum.blind, sum.known_ms, sum.blind_ms);
    // What collapses win is outline, since they keep a sliver of each twig for which the generator shows leaves.
    EXPECT_LT(sum.known, 1.5 * sum.blind);
    EXPECT_LT(2 * sum.known_ms, sum.blind_ms);
    EXPECT_LT(2 * fewest_known, fewest_blind);
}

// How wide a mesh's widest triangle is across, with its corners at these places.
float widest_m(const mesh::Mesh& mesh, const std::vector<glm::vec3>& places_m) {
    float widest = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 ab = places_m[mesh.indices[i + 1]] - places_m[mesh.indices[i]];
        const glm::vec3 ac = places_m[mesh.indices[i + 2]] - places_m[mesh.indices[i]];
        const float longest_m = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab), 1e-6F});
        widest = std::max(widest, glm::length(glm::cross(ab, ac)) / longest_m);
    }
    return widest;
}

// A limb that is left out goes into the one that bears it: drawn to two of them it would be a sail.
TEST(WoodLevels, LeaveNoWebBetweenLimbs) {
    for (int habit = 0; habit < kind_count(); ++habit) {
        Form form;
        form.habit = habit;
        form.bareness = 1;
        const TreeSkeleton skeleton = skeleton_of_species(form, base::Seed{7});
        const float trunk_radius_m = skeleton.limbs.front().nodes.front().radius_m;
        std::vector<scene::Wood> levels = wood_levels(skeleton, 1);
        set_coarser(levels, trunk_radius_m);
        for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
            const scene::Wood& wood = levels[level];
            const scene::Wood& next = levels[level + 1];
            ASSERT_EQ(wood.coarser_m.size(), wood.mesh.positions_m.size());
            EXPECT_LT(widest_m(wood.mesh, wood.coarser_m), 1.3F * std::max(widest_m(wood.mesh, wood.mesh.positions_m),
                                                                           widest_m(next.mesh, next.mesh.positions_m)))
                << kind(habit).name << " " << level;
        }
    }
}

}  // namespace
}  // namespace quadrat::synthesis::trees
