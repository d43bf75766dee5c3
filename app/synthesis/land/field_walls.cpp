// SPDX-License-Identifier: Apache-2.0
// Fields with dry walls between them, divided as cells of a map L-system are (lsystem/map_lsystem): a wall lies where
// heirs divided a field, so that each ends at an older one.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <set>

#include "scene/colour.hpp"
#include "synthesis/land/facets.hpp"
#include "synthesis/lsystem/map_lsystem.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kPiece_m = 4.6F;  // of a wall, between joints
constexpr float kSteepest = 0.75F;
constexpr std::size_t kStones = 5;   // along a piece of wall, that stand out of it,
constexpr std::size_t kCourses = 2;  // in so many courses
constexpr float kRoughTo_m = 60;     // from where the camera's way lies: farther off a side is one plane

struct Estate {
    glm::vec2 middle_m{0};
    glm::vec2 along{1, 0};
    float half_m = 80;

    glm::vec2 at(glm::vec2 p) const { return middle_m + p.x * along + p.y * glm::vec2{-along.y, along.x}; }
};

// How good it is for walls to be seen on: dry ground that is not steep, turned to the viewer, who can see it.
float merit_of(const scene::Land& land, const Estate& estate) {
    constexpr int kLooks = 9;
    float good = 0;
    for (int k = 0; k < kLooks * kLooks; ++k) {
        const glm::vec2 share =
            glm::vec2{static_cast<float>(k % kLooks), static_cast<float>(k / kLooks)} / (0.5F * (kLooks - 1)) - 1.0F;
        const glm::vec2 at = estate.at(estate.half_m * share);
        if (std::max(std::abs(at.x), std::abs(at.y)) > 470.0F) continue;
        const float ground_m = scene::ground_height_m(land, at);
        if (scene::water_depth_m(land, at) > 0 || ground_m < 1 || scene::to_road_m(land, at) < 2) continue;
        const float slope = slope_at(land, at);
        if (slope > kSteepest) continue;
        const glm::vec3 n = scene::ground_normal(land, at);
        const float turned = glm::dot(glm::vec2{n.x, n.z}, glm::normalize(kViewer_m - at));
        good += 0.6F + std::clamp(4.0F * turned, -0.4F, 1.0F) - 0.3F * slope;
        if (k % 4 == 0 && is_in_sight(land, {at.x, ground_m + 1.2F, at.y})) good += 2.4F;
    }
    return good / (kLooks * kLooks);
}

// The best of many places before the viewer; none is good enough on land that is steep, wet or built over.
std::optional<Estate> find_estate(const scene::Land& land, float field_m, base::Seed seed) {
    std::optional<Estate> best;
    float most = 0.45F;
    for (std::uint64_t i = 0; i < 90; ++i) {
        base::RandomStream random{seed.child(i)};
        Estate estate;
        estate.half_m = std::min(2.8F * field_m, 110.0F) * random.between(0.85F, 1.0F);
        const float far_m = estate.half_m + random.between(30.0F, 150.0F);
        const float aside = random.between(-0.4F, 0.4F);
        estate.middle_m = kViewer_m + far_m * glm::vec2{std::sin(aside), -std::cos(aside)};
        const float turn = aside + random.between(-0.5F, 0.5F);
        estate.along = {std::cos(turn), std::sin(turn)};
        const float merit = merit_of(land, estate);
        if (merit <= most) continue;
        most = merit;
        best = estate;
    }
    return best;
}

// From the edge of the nearest road or lane: kept_clear's samples are too far apart to build by.
float past_roads_m(const scene::Land& land, glm::vec2 at) {
    float least_m = scene::kFarFromRoads_m;
    for (const scene::Road& road : land.roads)
        for (std::size_t i = 1; i < road.line_m.size(); ++i) {
            const glm::vec2 a{road.line_m[i - 1].x, road.line_m[i - 1].z};
            const glm::vec2 run = glm::vec2{road.line_m[i].x, road.line_m[i].z} - a;
            const float t = std::clamp(glm::dot(at - a, run) / std::max(glm::dot(run, run), 1.0e-4F), 0.0F, 1.0F);
            least_m = std::min(least_m, glm::length(at - a - t * run) - 0.5F * road.width_m);
        }
    return least_m;
}

bool is_by_a_house(const scene::Land& land, glm::vec2 at) {
    return std::ranges::any_of(land.settlement.houses, [&](const scene::House& house) {
        const glm::vec2 d{house.foot_m.x - at.x, house.foot_m.z - at.y};
        return glm::dot(d, d) < 900 && scene::to_house_m(land.settlement.buildings[house.building], house, at) < 2;
    });
}

// Walls of a map one behind the other in a line are one: what has divided there stands against it.
struct Straight {
    glm::vec2 from{0}, to{0};
};
std::vector<Straight> straights_of(const lsystem::Map& map) {
    std::vector<std::vector<std::uint32_t>> at_corner(map.corners.size());
    std::set<std::uint32_t> left;
    for (const auto& cell : map.cells)
        for (const lsystem::Map::Side& side : cell) {
            if (!left.insert(side.wall).second) continue;
            at_corner[map.walls[side.wall].from].push_back(side.wall);
            at_corner[map.walls[side.wall].to].push_back(side.wall);
        }
    // Onward from a corner as far as it goes straight.
    const auto follow = [&](std::uint32_t corner, glm::vec2 way) {
        for (bool goes_on = true; goes_on;) {
            goes_on = false;
            for (const std::uint32_t wall : at_corner[corner]) {
                const lsystem::Map::Wall& w = map.walls[wall];
                const std::uint32_t next = w.from == corner ? w.to : w.from;
                const glm::vec2 run = map.corners[next] - map.corners[corner];
                if (!left.contains(wall) || glm::dot(run, way) < 0.9995F * glm::length(run)) continue;
                left.erase(wall);
                corner = next;
                goes_on = true;
                break;
            }
        }
        return map.corners[corner];
    };
    std::vector<Straight> lines;
    while (!left.empty()) {
        const lsystem::Map::Wall& first = map.walls[*left.begin()];
        left.erase(left.begin());
        const glm::vec2 way = glm::normalize(map.corners[first.to] - map.corners[first.from]);
        lines.push_back({follow(first.from, -way), follow(first.to, way)});
    }
    return lines;
}

class Waller {
  public:
    Waller(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, base::Seed seed)
        : stones_(stones), land_(ground.land), p_(p), seed_(seed) {
        stone_ = scene::mix_colours(scene::mix_colours(ground.palette.rock_light, ground.palette.rock_dark, 0.45F),
                                    ground.palette.scree, 0.3F);
        moss_ = scene::mix_colours(stone_, ground.palette.lush, 0.5F);
    }

    // From corner to corner; a gate is left in most that are long enough.
    void wall(glm::vec2 from, glm::vec2 to, int name) {
        const int pieces = std::max(1, static_cast<int>(std::lround(glm::length(to - from) / kPiece_m)));
        const bool has_gate = pieces > 4 && chance(name, 0) < 0.6F;
        const int gate = has_gate ? 1 + static_cast<int>(chance(name, 1) * static_cast<float>(pieces - 2)) : -1;
        bool was_built = false;
        Joint a = joint(from, to, pieces, 0, name);
        for (int i = 0; i < pieces; ++i) {
            const Joint b = joint(from, to, pieces, i + 1, name);
            const bool is_built = i != gate && may_stand(a) && may_stand(b) && may_stand(0.5F * (a.at_m + b.at_m)) &&
                                  chance(name, 64 + i) > 0.45F * p_.wall_decay * p_.wall_decay;
            if (is_built) piece(a, b, !was_built, chance(name, 128 + i), 1'000'000 + 2 * (1000 * name + i));
            if (!is_built && was_built) end(a);
            was_built = is_built;
            a = b;
        }
        if (was_built) end(a);
    }

  private:
    static constexpr float kFoot = 0.36F;  // of its height, how far it reaches to each side below,
    static constexpr float kTop = 0.11F;   // and above
    struct Joint {
        glm::vec2 at_m{0};
        glm::vec2 aside{0};
        float ground_m = 0;
        float up_m = 0;
    };
    float chance(int name, int what) const { return base::unit_of(base::hash_of(seed_, name, what)); }
    Joint joint(glm::vec2 from, glm::vec2 to, int pieces, int i, int name) const {
        const glm::vec2 run = (to - from) / std::max(glm::length(to - from), 0.01F);
        Joint j;
        j.aside = {-run.y, run.x};
        // Never quite straight.
        const float bow = i == 0 || i == pieces ? 0.0F : 0.5F * (chance(name, 256 + i) - 0.5F);
        j.at_m = glm::mix(from, to, static_cast<float>(i) / static_cast<float>(pieces)) + bow * j.aside;
        j.ground_m = scene::ground_height_m(land_, j.at_m);
        const float fallen = p_.wall_decay * std::max(0.0F, 1.6F * chance(name, 512 + i) - 0.6F);
        j.up_m = p_.wall_height_m * (0.86F + 0.24F * chance(name, 768 + i)) * (1 - 0.75F * fallen);
        return j;
    }
    // Each of its corners, and a little beyond: a stream is as narrow as a wall.
    bool may_stand(const Joint& j) const {
        return may_stand(j.at_m) && std::ranges::none_of(std::array{0.5F, kFoot, kTop}, [&](float share) {
                   const glm::vec2 aside = share * p_.wall_height_m * j.aside;
                   return scene::water_depth_m(land_, j.at_m + aside) > 0 ||
                          scene::water_depth_m(land_, j.at_m - aside) > 0;
               });
    }
    bool may_stand(glm::vec2 at) const {
        if (std::max(std::abs(at.x), std::abs(at.y)) > 480.0F || scene::water_depth_m(land_, at) > 0) return false;
        if (scene::ground_height_m(land_, at) < 0.6F || slope_at(land_, at) > kSteepest) return false;
        const float about_m = scene::to_road_m(land_, at);
        if (about_m < -1) return false;
        return about_m > 9 || (past_roads_m(land_, at) > 1.2F && !is_by_a_house(land_, at));
    }
    std::array<glm::vec3, 4> ring(const Joint& j) const {
        const float foot = kFoot * p_.wall_height_m;
        const float top = kTop * p_.wall_height_m;
        const auto at = [&](float aside_m, float up_m) {
            const glm::vec2 p = j.at_m + aside_m * j.aside;
            return glm::vec3{p.x, j.ground_m + up_m, p.y};
        };
        return {at(-foot, -0.5F), at(-top, j.up_m), at(top, j.up_m), at(foot, -0.5F)};
    }
    void facet(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float tint) {
        const auto colour = [&](const glm::vec3& at) {
            const float over_m = at.y - scene::ground_height_m(land_, {at.x, at.z});
            return tint * scene::mix_colours(moss_, stone_, std::clamp(0.2F + over_m / p_.wall_height_m, 0.0F, 1.0F));
        };
        add_facet(stones_.stone, {a, b, c}, {colour(a), colour(b), colour(c)});
    }
    void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, float tint) {
        facet(a, b, c, tint);
        facet(a, c, d, tint);
    }
    // A side of rough stones: a to b upward, a to d along it. Its edges are straight, as what joins it there is.
    void rough(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, float tint,
               std::int64_t name) {
        base::RandomStream random{base::Seed{base::hash_of(seed_, name, 0)}};
        const auto tone = [&] { return tint * random.between(0.62F, 1.25F); };
        const glm::vec3 out = glm::normalize(glm::cross(d - a, b - a));
        std::array<std::array<glm::vec3, kStones>, kCourses> at;
        for (std::size_t i = 0; i < kCourses; ++i)
            for (std::size_t k = 0; k < kStones; ++k) {
                const float along = (static_cast<float>(k) + random.between(0.7F, 1.3F)) / (kStones + 1);
                const float up = (static_cast<float>(i) + random.between(0.75F, 1.25F)) / (kCourses + 1);
                at[i][k] = glm::mix(glm::mix(a, b, up), glm::mix(d, c, up), along) + random.between(-0.08F, 0.3F) * out;
            }
        constexpr std::size_t kUpper = kCourses - 1;
        constexpr std::size_t kLast = kStones - 1;
        for (std::size_t k = 0; k < kLast; ++k) {
            for (std::size_t i = 0; i < kUpper; ++i)
                quad(at[i][k], at[i + 1][k], at[i + 1][k + 1], at[i][k + 1], tone());
            facet(a, at[0][k], at[0][k + 1], tone());
            facet(b, at[kUpper][k + 1], at[kUpper][k], tone());
        }
        facet(a, at[0][kLast], d, tone());
        facet(b, c, at[kUpper][kLast], tone());
        for (std::size_t i = 0; i < kUpper; ++i) {
            facet(a, at[i + 1][0], at[i][0], tone());
            facet(d, at[i][kLast], at[i + 1][kLast], tone());
        }
        facet(a, b, at[kUpper][0], tone());
        facet(d, at[kUpper][kLast], c, tone());
    }
    void piece(const Joint& a, const Joint& b, bool has_end, float tone, std::int64_t name) {
        const auto r = ring(a);
        const auto s = ring(b);
        const float tint = 0.86F + 0.26F * tone;
        const bool is_near = glm::distance(a.at_m, kViewer_m) < kRoughTo_m;
        for (std::size_t i = 0; i < r.size(); ++i) {
            const std::size_t next = (i + 1) % 4;
            if (is_near && i == 0)
                rough(r[i], r[next], s[next], s[i], tint, name);
            else if (is_near && i == 2)  // goes down
                rough(s[next], s[i], r[i], r[next], tint, name + 1);
            else
                quad(r[i], r[next], s[next], s[i], tint);
        }
        if (has_end) quad(r[3], r[2], r[1], r[0], tint);
    }
    void end(const Joint& a) {
        const auto r = ring(a);
        quad(r[0], r[1], r[2], r[3], 0.95F);
    }

    Stones& stones_;
    const scene::Land& land_;
    const scene::LandParameters& p_;
    base::Seed seed_;
    glm::vec3 stone_{0.5F};
    glm::vec3 moss_{0.4F};
};

}  // namespace

void add_field_walls(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, base::Seed seed) {
    const auto estate = find_estate(ground.land, p.wall_field_m, seed.child("estate"));
    if (!estate) return;
    static const lsystem::MapGrammar kFields = lsystem::library_map("map-fields");
    base::RandomStream random{seed};
    // What was one field once: a rectangle whose corners nobody measured.
    std::vector<glm::vec2> outline;
    for (const glm::vec2 corner : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        outline.push_back(estate->half_m * (corner + 0.22F * glm::vec2{random.between(-1, 1), random.between(-1, 1)}));
    const lsystem::Map map = lsystem::derive_map(
        kFields, outline, {.steps = 10, .chance = 0.5F, .most_area = 1.6F * p.wall_field_m * p.wall_field_m},
        seed.child("fields"));
    Waller waller(stones, ground, p, seed.child("walls"));
    int name = 0;
    for (const Straight& line : straights_of(map)) waller.wall(estate->at(line.from), estate->at(line.to), name++);
}

}  // namespace quadrat::synthesis::land
