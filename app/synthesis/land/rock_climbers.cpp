// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/land/facets.hpp"
#include "synthesis/voxels/climber.hpp"

namespace quadrat::synthesis::land {
namespace {

using voxels::Surroundings;
using voxels::Tendril;

constexpr float kLeaf_m = 0.36F;
constexpr int kLeaves = 3;            // of a tendril
constexpr float kReachable_m = 1.2F;  // over the ground, where a shoot begins
constexpr std::size_t kMostRoots = 6;

// A leaf folded along its midrib, that stands out by its foot.
void add_leaf(scene::Stone& stone, const glm::vec3& foot_m, const glm::vec3& along_m, const glm::vec3& out,
              const glm::vec3& colour) {
    const float size_m = glm::length(along_m);
    const glm::vec3 aside_m = 0.38F * glm::cross(out, along_m);
    const glm::vec3 tip_m = foot_m + along_m - 0.12F * size_m * out;
    const glm::vec3 wide_m = foot_m + 0.45F * along_m + 0.2F * size_m * out;
    add_facet(stone, {foot_m, tip_m, wide_m + aside_m}, {0.7F * colour, 1.1F * colour, colour});
    add_facet(stone, {foot_m, wide_m - aside_m, tip_m}, {0.7F * colour, colour, 1.1F * colour});
}

// Leaves about a tendril, most of which hang.
void add_tuft(scene::Stone& stone, const Tendril& tendril, float size_m, const glm::vec3& colour,
              base::RandomStream& random) {
    for (int i = 0; i < kLeaves; ++i) {
        const glm::vec3 chance{random.between(-1, 1), random.between(-1.6F, 0.6F), random.between(-1, 1)};
        const glm::vec3 on_rock = chance - glm::dot(chance, tendril.out) * tendril.out;
        const glm::vec3 along = glm::normalize(on_rock + 1.0e-3F * tendril.way);
        const glm::vec3 foot_m = tendril.at_m + random.between(0.03F, 0.14F) * tendril.out + 0.25F * size_m * along;
        add_leaf(stone, foot_m, size_m * random.between(0.75F, 1.15F) * along, tendril.out,
                 colour * random.between(0.8F, 1.2F));
    }
}

struct Rock {
    Surroundings around;
    std::vector<glm::vec3> roots_m;
};

Rock rock_about(const scene::Stone& stone, const scene::Land& land, const scene::Landmark& mark,
                base::RandomStream& random) {
    const float reach_m = std::clamp(0.8F * mark.size_m, 4.0F, 24.0F);
    Rock rock{{mark.at_m - reach_m, mark.at_m + reach_m, std::clamp(reach_m / 26, 0.3F, 0.8F)}, {}};
    const auto& at = stone.mesh.positions_m;
    const auto& indices = stone.mesh.indices;
    std::size_t seen = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::array<glm::vec3, 3> c{at[indices[i]], at[indices[i + 1]], at[indices[i + 2]]};
        rock.around.add_face(c[0], c[1], c[2], Surroundings::Kind::Hold);
        const glm::vec3 middle = (c[0] + c[1] + c[2]) / 3.0F;
        if (glm::distance(middle, mark.at_m) > reach_m) continue;
        const float over_m = middle.y - scene::ground_height_m(land, {middle.x, middle.z});
        if (over_m < 0 || over_m > kReachable_m) continue;
        // Each of those seen so far is as likely to be among the roots.
        ++seen;
        if (rock.roots_m.size() < kMostRoots)
            rock.roots_m.push_back(middle);
        else if (const std::uint32_t place = random.below(static_cast<std::uint32_t>(seen)); place < kMostRoots)
            rock.roots_m[place] = middle;
    }
    return rock;
}

}  // namespace

void add_rock_climbers(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, base::Seed seed) {
    for (std::size_t i = 0; i < stones.landmarks.size(); ++i) {
        const scene::Landmark mark = stones.landmarks[i];
        base::RandomStream random{seed.child(i)};
        const bool is_snowy = mark.at_m.y > snow_line_m(p);
        if (random.unit_f() >= p.climber_share || is_snowy) continue;
        const Rock rock = rock_about(stones.stone, ground.land, mark, random);
        voxels::Climber climber;
        climber.high_m = (0.2F + 0.7F * p.climber_height) * mark.size_m;
        climber.most = static_cast<std::size_t>(80 + 180 * p.climber_height);
        climber.upward = 0.45F;
        const glm::vec3 colour = voxels::climber_colour(p.climber_redness, seed.child(i).child("colour"));
        for (const Tendril& tendril : climb(rock.around, rock.roots_m, climber, seed.child(i).child("shoots")))
            add_tuft(stones.stone, tendril, kLeaf_m * random.between(0.7F, 1.3F), colour * random.between(0.8F, 1.25F),
                     random);
    }
}

}  // namespace quadrat::synthesis::land
