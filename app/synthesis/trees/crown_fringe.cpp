// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/crown_fringe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/seed.hpp"
#include "mesh/pieces.hpp"
#include "synthesis/trees/crown_outline.hpp"
#include "synthesis/trees/crown_reach.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr std::size_t kFewestTriangles = 15;  // of a mass that has a fringe
constexpr std::size_t kPerTriangle = 7;       // of the mass
constexpr std::size_t kFewest = 24;           // sprays, of a bush some ten pixels high: without any it is a ball
constexpr float kCovers = 1.7F;               // of the mass, by area,
constexpr float kLargest = 0.009F;            // of it, one spray: larger ones are spikes
constexpr float kLargestOfFew = 0.026F;       // and where they are few
constexpr float kLength = 1.5F;               // of a spray, to the square root of its area, and so its width:
constexpr float kWidth = 1.6F;                // longer ones are thorns
constexpr float kHangs = 0.35F;               // how far outward those of a crown's underside point, to the others
constexpr double kGoldenShare = 0.6180339887498949;

// Where a spray stands on the finest mass, and what the leaves about it are.
struct Spray {
    glm::vec3 at_m, along, side, normal, colour;
    float shade, age, sway;
};

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
    const float length2 = glm::dot(v, v);
    return length2 > 1e-9F ? v / std::sqrt(length2) : otherwise;
}

template <typename Value>
Value weighted(const std::vector<Value>& values, const mesh::Mesh& mesh, std::size_t first,
               const std::array<float, 3>& weights) {
    Value sum = values[mesh.indices[first]] * weights[0];
    for (std::size_t k = 1; k < 3; ++k) sum += values[mesh.indices[first + k]] * weights[k];
    return sum;
}

// As much of each sum as the areas before it are of all.
std::vector<float> areas_up_to(const mesh::Mesh& mesh) {
    std::vector<float> sums;
    float sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions_m[mesh.indices[i]];
        sum += 0.5F * glm::length(glm::cross(mesh.positions_m[mesh.indices[i + 1]] - a,
                                             mesh.positions_m[mesh.indices[i + 2]] - a));
        sums.push_back(sum);
    }
    return sums;
}

Spray spray_on(const scene::CrownMass& mass, std::size_t first, base::RandomStream random) {
    const float root = std::sqrt(random.unit_f());
    const float across = random.unit_f();
    const std::array<float, 3> weights{1 - root, root * (1 - across), root * across};
    Spray spray;
    spray.at_m = weighted(mass.mesh.positions_m, mass.mesh, first, weights);
    spray.normal = unit_or(weighted(mass.mesh.normals, mass.mesh, first, weights), {0, 1, 0});
    spray.shade = weighted(mass.shades, mass.mesh, first, weights);
    spray.age = weighted(mass.ages, mass.mesh, first, weights);
    spray.sway = weighted(mass.sways, mass.mesh, first, weights);
    spray.colour = weighted(mass.colours, mass.mesh, first, weights) * random.between(0.86F, 1.14F);
    // Outward, down a little, and any way along the surface.
    const glm::vec3 chance{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const glm::vec3 flat = unit_or(chance - glm::dot(chance, spray.normal) * spray.normal, {1, 0, 0});
    const float under = glm::smoothstep(0.0F, -0.7F, spray.normal.y);
    spray.along =
        unit_or(1.1F * glm::mix(1.0F, kHangs, under) * spray.normal + flat - glm::vec3{0, 0.2F, 0}, spray.normal);
    spray.side = unit_or(glm::cross(spray.along, spray.normal), flat);
    return spray;
}

// An even cover by any prefix: steps of the golden share of the area never gather.
std::vector<Spray> sprays_of(const scene::CrownMass& mass, std::size_t count) {
    const std::vector<float> areas = areas_up_to(mass.mesh);
    std::vector<Spray> sprays;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = (static_cast<double>(i) + 0.5) * kGoldenShare;
        const float area = static_cast<float>(turn - std::floor(turn)) * areas.back();
        const auto triangle = static_cast<std::size_t>(std::ranges::lower_bound(areas, area) - areas.begin());
        const std::size_t first = 3 * std::min(triangle, areas.size() - 1);
        sprays.push_back(spray_on(mass, first, base::RandomStream{base::Seed{0x66'72'69}.child(i)}));
    }
    return sprays;
}

// Foot, foot, tip, its outside to the front; none further from the root than so much. area_m2: of the triangle.
std::array<glm::vec3, 3> corners(const Spray& spray, float area_m2, float most_m) {
    const float length_m = kLength * std::sqrt(area_m2);
    const float half_m = 0.5F * kWidth * std::sqrt(area_m2);
    const glm::vec3 foot = spray.at_m - 0.2F * length_m * spray.along;
    std::array<glm::vec3, 3> at{foot - half_m * spray.side, foot + half_m * spray.side, foot + length_m * spray.along};
    for (glm::vec3& corner : at) corner = within(corner, most_m);
    return at;
}

void add(scene::CrownMass& mass, const Spray& spray, const std::array<glm::vec3, 3>& at) {
    constexpr std::array<float, 3> kLightness{0.9F, 0.94F, 1.14F};
    ++mass.sprays;
    for (std::size_t k = 0; k < 3; ++k) {
        mass.mesh.indices.push_back(static_cast<std::uint32_t>(mass.mesh.positions_m.size()));
        mass.mesh.positions_m.push_back(at[k]);
        mass.mesh.normals.push_back(spray.normal);
        mass.colours.push_back(spray.colour * kLightness[k]);
        mass.shades.push_back(std::clamp(spray.shade, 0.0F, 1.0F));
        mass.ages.push_back(std::clamp(spray.age, 0.0F, 1.0F));
        mass.sways.push_back(std::clamp(spray.sway, 0.0F, 1.0F));
    }
}

// A level like that one but for its sprays, which are fewer; after it.
void insert_sparser(std::vector<scene::CrownMass>& masses, std::vector<std::size_t>& counts, std::size_t level,
                    std::size_t sprays) {
    const auto after = static_cast<std::ptrdiff_t>(level + 1);
    scene::CrownMass sparser = masses[level];
    masses[level].coarser_m = sparser.mesh.positions_m;
    masses.insert(masses.begin() + after, std::move(sparser));
    counts.insert(counts.begin() + after, sprays);
}

// Of two levels of which the next has far fewer triangles, one of half the sprays stands between: else a crown of a
// size between them would be drawn as the coarser one, a lump without leaves. The last has but a few.
void fill_gaps(std::vector<scene::CrownMass>& masses, std::vector<std::size_t>& counts) {
    constexpr std::size_t kGap = 3;
    if (counts.back() > 2 * kFewest) insert_sparser(masses, counts, masses.size() - 1, kFewest);
    for (std::size_t level = 0; level + 1 < masses.size(); ++level) {
        const auto all = [&](std::size_t of) { return masses[of].mesh.triangle_count() + counts[of]; };
        if (counts[level] >= 2 * kFewest && all(level) >= kGap * all(level + 1))
            insert_sparser(masses, counts, level, counts[level] / 2);
    }
}

}  // namespace

void add_fringe(std::vector<scene::CrownMass>& masses) {
    if (masses.empty()) return;
    const std::size_t clumps = mesh::pieces_of(masses.front().mesh).size();
    std::vector<std::size_t> counts;
    for (const scene::CrownMass& mass : masses) {
        const std::size_t own = mass.mesh.triangle_count();
        const bool has_all = mesh::pieces_of(mass.mesh).size() == clumps;
        counts.push_back(has_all && own >= kFewestTriangles ? kPerTriangle * own : 0);
    }
    fill_gaps(masses, counts);
    if (counts.front() == 0) return;
    const std::vector<Spray> sprays = sprays_of(masses.front(), counts.front());
    const float crown_m2 = areas_up_to(masses.front().mesh).back();
    const float most_m = reach_m(masses.front().mesh);
    const auto at = [&](std::size_t level, std::size_t spray) {
        const float share =
            std::min(kCovers / static_cast<float>(counts[level]), counts[level] > kFewest ? kLargest : kLargestOfFew);
        return corners(sprays[spray], share * crown_m2, most_m);
    };
    for (std::size_t level = 0; level < masses.size() && counts[level] > 0; ++level) {
        const bool has_coarser = !masses[level].coarser_m.empty();
        for (std::size_t i = 0; i < counts[level]; ++i) {
            add(masses[level], sprays[i], at(level, i));
            if (!has_coarser) continue;
            // One that the next level lacks dwindles to nothing.
            const bool stays = level + 1 < masses.size() && i < counts[level + 1];
            const glm::vec3 gone_m = sprays[i].at_m;
            for (const glm::vec3& corner : stays ? at(level + 1, i) : std::array{gone_m, gone_m, gone_m})
                masses[level].coarser_m.push_back(corner);
        }
    }
    for (const Outline& outline : {kRoundOutline, kPlainOutline}) add_outline(masses, outline);
}

}  // namespace quadrat::synthesis::trees
