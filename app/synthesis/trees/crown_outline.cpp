// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/crown_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "base/seed.hpp"
#include "mesh/nearness.hpp"
#include "synthesis/trees/crown_reach.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kFewEnough = 0.75F;  // of a level's triangles, for another
constexpr float kRound = 0.92F;      // of the farthest point: flat triangles between such would look too large
constexpr float kWidest = 0.96F;     // likewise, whatever chance adds: on a spire that point is the lowest of its band
constexpr float kArmless = 0.6F;     // of the ring's mean where nothing of the crown lies that way
constexpr float kBand = 0.1F;        // of the crown's height, to each side of a ring
constexpr float kFirstRing = 0.1F;   // how high in the crown
constexpr float kLastRing = 0.82F;
constexpr float kUneven = 0.24F;   // of a corner's distance from the axis, by chance: rings alone make a ball of a bush
constexpr float kDappled = 0.20F;  // of its colour
constexpr float kTurned = 0.55F;   // of its normal
constexpr float kDomed = 0.8F;     // how far normals lean down at a crown's foot and up at its top

class Wrapping {
  public:
    Wrapping(const scene::CrownMass& crown, const Outline& outline)
        : crown_(crown), outline_(outline), most_m_(reach_m(crown.mesh)) {
        const auto [low, high] =
            std::ranges::minmax_element(crown.mesh.positions_m, {}, [](const glm::vec3& at_m) { return at_m.y; });
        low_m_ = low->y;
        tall_m_ = std::max(high->y - low_m_, 1e-3F);
        mass_.share = crown.share;
    }

    scene::CrownMass take() {
        add_point(0);
        for (std::size_t ring = 0; ring < outline_.rings; ++ring) add_ring(height_of(ring));
        add_point(1);
        join();
        return std::move(mass_);
    }

  private:
    struct Corner {
        std::size_t like = 0;  // the crown's vertex there
        float off_m = -1;      // from the axis; less than 0: nothing lies that way
    };

    // Of the crown's height: a round crown has no tips, and a spire is narrow there anyway.
    float height_of(std::size_t ring) const {
        return kFirstRing +
               (kLastRing - kFirstRing) * static_cast<float>(ring) / static_cast<float>(outline_.rings - 1);
    }

    bool is_near(const glm::vec3& at_m, float height) const {
        return std::abs((at_m.y - low_m_) / tall_m_ - height) <= kBand;
    }

    // The middle of what lies at this height; a crown may lean.
    glm::vec2 axis_at(float height) const {
        glm::vec2 sum_m{0};
        float count = 0;
        for (const bool is_all : {false, true}) {
            for (const glm::vec3& at_m : crown_.mesh.positions_m) {
                if (!is_all && !is_near(at_m, height)) continue;
                sum_m += glm::vec2{at_m.x, at_m.z};
                ++count;
            }
            if (count > 0) break;
        }
        return sum_m / count;
    }

    std::vector<Corner> corners_at(float height, const glm::vec2& axis_m) const {
        std::vector<Corner> corners(outline_.corners);
        const float per_rad = static_cast<float>(outline_.corners) / glm::two_pi<float>();
        for (std::size_t i = 0; i < crown_.mesh.positions_m.size(); ++i) {
            const glm::vec3& at_m = crown_.mesh.positions_m[i];
            if (!is_near(at_m, height)) continue;
            const glm::vec2 off_m = glm::vec2{at_m.x, at_m.z} - axis_m;
            const auto turn = static_cast<std::ptrdiff_t>(std::lround(std::atan2(off_m.y, off_m.x) * per_rad));
            const auto all = static_cast<std::ptrdiff_t>(outline_.corners);
            Corner& corner = corners[static_cast<std::size_t>((turn + all) % all)];
            if (glm::length(off_m) > corner.off_m) corner = {i, glm::length(off_m)};
        }
        return corners;
    }

    // By the corner's number: the same outline whatever else is drawn.
    float chance(std::uint64_t what) const {
        return 2 * base::unit_of(base::hash_of(base::Seed{0x726167}, mass_.mesh.positions_m.size(), what)) - 1;
    }

    void add_ring(float height) {
        const glm::vec2 axis_m = axis_at(height);
        const std::vector<Corner> corners = corners_at(height, axis_m);
        float sum_m = 0;
        float count = 0;
        std::size_t like = 0;
        for (const Corner& corner : corners) {
            if (corner.off_m < 0) continue;
            sum_m += corner.off_m;
            like = corner.like;
            ++count;
        }
        const float usual_m = count > 0 ? sum_m / count : 0.2F * tall_m_;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const bool is_bare = corners[i].off_m < 0;
            const float turn_rad = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners.size());
            const glm::vec2 way{std::cos(turn_rad), std::sin(turn_rad)};
            const float uneven = 1 + kUneven * (chance(0) - 0.25F);
            const float off_m =
                is_bare ? kArmless * usual_m * uneven : std::min(kRound * uneven, kWidest) * corners[i].off_m;
            const glm::vec2 at_m = axis_m + way * off_m;
            const float up = height + 0.3F * kUneven * chance(1);
            const glm::vec3 turned = kTurned * glm::vec3{chance(2), chance(3), chance(4)};
            add({at_m.x, low_m_ + up * tall_m_, at_m.y},
                glm::normalize(glm::vec3{way.x, kDomed * (2 * height - 1), way.y} + turned),
                is_bare ? like : corners[i].like);
            mass_.colours.back() *= 1 + kDappled * chance(5);
        }
    }

    void add_point(float height) {
        const glm::vec2 axis_m = axis_at(height);
        const auto like = std::ranges::max_element(
            crown_.mesh.positions_m, {}, [&](const glm::vec3& at_m) { return height > 0.5F ? at_m.y : -at_m.y; });
        add({axis_m.x, low_m_ + height * tall_m_, axis_m.y}, {0, height > 0.5F ? 1 : -1, 0},
            static_cast<std::size_t>(like - crown_.mesh.positions_m.begin()));
    }

    void add(const glm::vec3& at_m, const glm::vec3& normal, std::size_t like) {
        mass_.mesh.positions_m.push_back(within(at_m, most_m_));
        mass_.mesh.normals.push_back(normal);
        mass_.colours.push_back(crown_.colours[like]);
        mass_.shades.push_back(crown_.shades[like]);
        mass_.ages.push_back(crown_.ages[like]);
        mass_.sways.push_back(crown_.sways[like]);
    }

    void join() {
        const auto corners = static_cast<std::uint32_t>(outline_.corners);
        const auto top = static_cast<std::uint32_t>(mass_.mesh.positions_m.size() - 1);
        auto& indices = mass_.mesh.indices;
        for (std::uint32_t i = 0; i < corners; ++i) {
            const std::uint32_t next = (i + 1) % corners;
            indices.insert(indices.end(), {0, 1 + i, 1 + next});
            for (std::uint32_t low = 1; low + corners < top; low += corners) {
                const std::uint32_t high = low + corners;
                indices.insert(indices.end(), {low + i, high + i, low + next, low + next, high + i, high + next});
            }
            indices.insert(indices.end(), {top, top - corners + next, top - corners + i});
        }
    }

    const scene::CrownMass& crown_;
    Outline outline_;
    float most_m_;
    float low_m_ = 0;
    float tall_m_ = 1;
    scene::CrownMass mass_;
};

}  // namespace

void add_outline(std::vector<scene::CrownMass>& masses, const Outline& outline) {
    if (masses.empty()) return;
    scene::CrownMass& last = masses.back();
    const auto most = static_cast<std::size_t>(kFewEnough * static_cast<float>(last.mesh.triangle_count()));
    if (outline.triangles() > most) return;
    scene::CrownMass next = Wrapping(masses.front(), outline).take();
    const mesh::Nearness surface(next.mesh);
    last.coarser_m.clear();
    for (const glm::vec3& at_m : last.mesh.positions_m) last.coarser_m.push_back(surface.nearest(at_m).at_m);
    masses.push_back(std::move(next));
}

}  // namespace quadrat::synthesis::trees
