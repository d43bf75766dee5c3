// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/settle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/network.hpp"
#include "synthesis/houses/place.hpp"
#include "synthesis/houses/stains.hpp"
#include "synthesis/houses/styles.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kMostFall_m = 3.2F;  // of the ground under one house
constexpr float kSounded_m = 3.5F;   // from place to place where the ground is looked at
constexpr int kRounds = 3;           // along all lanes
constexpr float kFlight_m = 42;      // around where the viewer's flight may pass no one builds
constexpr int kChapelAt = 4;         // the chapel is the fifth building
constexpr int kLandmarkAt = 7;       // mill or lighthouse

// Whether two outlines, convex, come nearer than touching: by the axes of both.
bool overlap(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
    const auto parted_by = [](const std::vector<glm::vec2>& of, const std::vector<glm::vec2>& p,
                              const std::vector<glm::vec2>& q) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            const glm::vec2 side = of[(i + 1) % of.size()] - of[i];
            const glm::vec2 axis{-side.y, side.x};
            glm::vec2 from{1.0e9F, 1.0e9F};
            glm::vec2 to{-1.0e9F, -1.0e9F};
            for (std::size_t k = 0; k < p.size(); ++k) {
                from = glm::min(from, {glm::dot(axis, p[k]), glm::dot(axis, q[k])});
                to = glm::max(to, {glm::dot(axis, p[k]), glm::dot(axis, q[k])});
            }
            if (to.x < from.y || to.y < from.x) return true;
        }
        return false;
    };
    return !parted_by(a, a, b) && !parted_by(b, a, b);
}

// One side of a lane that is still to be built along.
struct Frontage {
    int branch = 0;
    float side = 1;
    float at_m = 0;
    float end_m = 0;
    float price = 0;  // of building there next
};

class Growth {
  public:
    Growth(const scene::Land& land, const scene::LandParameters& p, base::Seed seed, glm::vec2 middle)
        : land_(land), p_(p), seed_(seed), middle_(middle), stock_(p, seed.child("stock")) {
        branches_ = grow_network(land, middle, p, seed.child("lanes"));
        for (const scene::Road& road : land.roads) {
            Lane lane{{}, road.width_m, true, {}};
            for (const glm::vec3& at : road.line_m) lane.line_m.emplace_back(at.x, at.z);
            roads_.push_back(std::move(lane));
        }
        for (std::size_t b = 0; b < branches_.size(); ++b) {
            const Branch& branch = branches_[b];
            const float end_m = kLaneStep_m * static_cast<float>(branch.lane.line_m.size() - 1);
            const float from_m = branch.from < 0 ? 2.0F : 4.0F;
            for (const float side : {1.0F, -1.0F}) {
                frontages_.push_back({static_cast<int>(b), side, from_m, end_m});
                frontages_.back().price = price(frontages_.back());
            }
            used_m_.push_back(0);
        }
    }

    void grow(int count) {
        while (static_cast<int>(houses_.size()) < count) {
            const auto number = static_cast<int>(houses_.size());
            if (number == kChapelAt && p_.settle_chapel > 0 && !tried_chapel_) {
                tried_chapel_ = true;
                if (place_chapel()) continue;
            }
            if (number == kLandmarkAt && !tried_landmark_) {
                tried_landmark_ = true;
                if (place_landmark()) continue;
            }
            if (build_along_lanes()) continue;
            if (++rounds_ == kRounds) return;
            look_for_gaps();
        }
    }

    Settled taken() {
        Settled settled;
        settled.middle_m = middle_;
        for (const scene::House& house : houses_)
            settled.reach_m = std::max(settled.reach_m, glm::distance(middle_, {house.foot_m.x, house.foot_m.z}));
        settled.settlement.buildings = stock_.raised();
        settled.settlement.houses = std::move(houses_);
        settled.settlement.lit_share = p_.settle_lit_share;
        settled.settlement.stains = weather_stains();
        for (std::size_t b = branches_.size(); b-- > 0;) {
            const Branch& branch = branches_[b];
            if (used_m_[b] > 0 && branch.from >= 0) {
                float& from = used_m_[static_cast<std::size_t>(branch.from)];
                from = std::max(from, branch.from_at_m);
            }
        }
        for (std::size_t b = 0; b < branches_.size(); ++b) {
            Lane lane = branches_[b].lane;
            if (lane.is_road || used_m_[b] <= 0) continue;
            cut(lane, static_cast<std::size_t>(std::ceil((used_m_[b] + 6) / kLaneStep_m)));
            if (lane.line_m.size() > 1) settled.lanes.push_back(std::move(lane));
        }
        for (Lane& path : paths_) settled.lanes.push_back(std::move(path));
        return settled;
    }

  private:
    // Where all lanes are built along, people build closer: in what gaps there are left, smaller steps apart.
    void look_for_gaps() {
        for (Frontage& f : frontages_) {
            f.at_m = branches_[static_cast<std::size_t>(f.branch)].from < 0 ? 2.0F : 4.0F;
            f.price = price(f);
        }
    }

    // After a point; before water that it would end in.
    static void cut(Lane& lane, std::size_t last) {
        for (const Lane::Crossing& crossing : lane.crossings)
            if (last >= crossing.from && last <= crossing.to) last = crossing.from;
        std::erase_if(lane.crossings, [last](const Lane::Crossing& crossing) { return crossing.from >= last; });
        lane.line_m.resize(std::min(lane.line_m.size(), last + 1));
    }

    glm::vec2 point(const Frontage& f, float at_m) const {
        const auto& line = branches_[static_cast<std::size_t>(f.branch)].lane.line_m;
        const float t = std::clamp(at_m / kLaneStep_m, 0.0F, static_cast<float>(line.size() - 1) - 1.0e-3F);
        const auto i = static_cast<std::size_t>(t);
        return line[i] + (t - static_cast<float>(i)) * (line[i + 1] - line[i]);
    }

    float price(const Frontage& f) const {
        const glm::vec2 at = point(f, f.at_m + 4);
        const Branch& branch = branches_[static_cast<std::size_t>(f.branch)];
        return glm::distance(at, middle_) + 45 * steepness(land_, at) - (branch.lane.is_road ? 6.0F : 0.0F);
    }

    // Core, craft and farms, by how far out it is (Groenewegen et al. 2009), and by how large the place has become.
    Use use_at(glm::vec2 at, base::RandomStream& random) const {
        const float out_m = glm::distance(at, middle_);
        const float chance = random.unit_f();
        const auto number = static_cast<float>(houses_.size());
        if (number < 1) return Use::Dwelling;
        if (out_m > 26 && chance < p_.settle_barns * (number < 12 ? 1.0F : 0.55F)) return Use::Barn;
        const float core_m = 10 + 3.2F * std::sqrt(number);
        if (number > 8 && out_m < core_m && chance < 0.3F + 0.6F * p_.settle_density) return Use::Townhouse;
        return Use::Dwelling;
    }

    bool build_along_lanes() {
        for (int tries = 0; tries < 4000; ++tries) {
            Frontage* best = nullptr;
            for (Frontage& f : frontages_)
                if (f.at_m + 4 < f.end_m && (!best || f.price < best->price)) best = &f;
            if (!best) return false;
            const bool is_built = build_at(*best);
            best->price = price(*best);
            if (is_built) return true;
        }
        return false;
    }

    bool build_at(Frontage& f) {
        base::RandomStream random{
            seed_.child("house").child(houses_.size()).child(static_cast<std::uint64_t>(f.at_m * 8))};
        const Lane& lane = branches_[static_cast<std::size_t>(f.branch)].lane;
        const glm::vec2 here = point(f, f.at_m);
        const Use use = use_at(here, random);
        const Stock::Offer& offer = wished(use);
        const scene::Building& shell = wished_shell_;
        const glm::vec2 half = shell.half_m;
        const glm::vec2 at = point(f, f.at_m + half.x);
        const glm::vec2 along = glm::normalize(point(f, f.at_m + 2 * half.x + 0.1F) - point(f, std::max(f.at_m, 0.0F)));
        const glm::vec2 out = f.side * glm::vec2{-along.y, along.x};
        const float close = p_.settle_density * (use == Use::Townhouse ? 1.0F : 0.7F);
        const float front_m = 1.1F + (1 - close) * random.between(1.5F, 6.0F);
        const float gap_m = 0.5F + (1 - close) * (1 - close) * random.between(4.0F, 26.0F);
        const glm::vec2 foot = at + out * (0.5F * lane.width_m + front_m + half.y);
        const float turn = 0.06F * p_.settle_winding * random.normal();
        scene::House house = house_of(foot, -out, turn, random);
        if (f.at_m + 2 * half.x > f.end_m + 3 || !fits(shell, house, 0.45F)) {
            f.at_m += rounds_ == 0 ? 3.5F : 1.8F;
            return false;
        }
        f.at_m += 2 * half.x + gap_m;
        float& used = used_m_[static_cast<std::size_t>(f.branch)];
        used = std::max(used, f.at_m - gap_m);
        move_in(house, offer);
        return true;
    }

    // What the next to come would build, wherever they may.
    const Stock::Offer& wished(Use use) {
        if (wished_by_ != houses_.size() || wished_.use != use) {
            wished_ = stock_.draw(use, seed_.child("own").child(houses_.size()));
            wished_by_ = houses_.size();
            wished_shell_.half_m = half_of(wished_.design);
        }
        return wished_;
    }

    void move_in(scene::House house, const Stock::Offer& offer) {
        house.building = stock_.take(offer);
        if (!stock_.has_chimney(house.building)) house.plume.strength = 0;
        houses_.push_back(house);
    }

    scene::House house_of(glm::vec2 foot, glm::vec2 facing, float turn, base::RandomStream& random) const {
        scene::House house;
        house.foot_m = {foot.x, scene::ground_height_m(land_, foot), foot.y};
        house.yaw_rad = std::atan2(facing.x, facing.y) + turn;
        const float light = 1 + 0.09F * random.normal() * (0.4F + p_.settle_colourful);
        const float warm = 0.04F * random.normal() * p_.settle_colourful;
        house.wall_tint = light * glm::vec3{1 + warm, 1, 1 - warm};
        const float rust = 0.05F * std::clamp(random.normal(), -2.0F, 2.0F);
        house.roof_tint = (1 + 0.10F * std::clamp(random.normal(), -2.0F, 2.0F)) * glm::vec3{1 + rust, 1, 1 - rust};
        house.evening = random.unit_f();
        if (random.unit_f() < p_.settle_smoke) house.plume = plume_of(random);
        return house;
    }

    // Most fires smoulder; some have just been lit, or burn wet wood.
    static scene::Plume plume_of(base::RandomStream& random) {
        const float fire = random.unit_f();
        scene::Plume plume;
        plume.strength = 0.3F + 0.7F * fire * fire;
        plume.width = random.between(0.6F, 1.5F);
        plume.rise = 0.45F + 0.8F * fire * random.between(0.6F, 1.0F);
        plume.phase = random.unit_f();
        plume.chimney = random.unit_f();
        return plume;
    }

    bool fits(const scene::Building& building, const scene::House& house, float apart_m) const {
        float low = house.foot_m.y;
        float high = low;
        for (const glm::vec2 p : along_outline_m(building, house, 0.7F, kSounded_m)) {
            if (!is_buildable(land_, p)) return false;
            low = std::min(low, scene::ground_height_m(land_, p));
            high = std::max(high, scene::ground_height_m(land_, p));
        }
        if (high - low > kMostFall_m) return false;
        // Its ground is made level: water must not come onto it.
        for (const glm::vec2 p : along_outline_m(building, house, 3, kSounded_m))
            if (!is_buildable(land_, p)) return false;
        const glm::vec2 at{house.foot_m.x, house.foot_m.z};
        const float radius = glm::length(building.half_m) + 1;
        if (is_in_flight(at, radius)) return false;
        for (const scene::House& other : houses_) {
            const scene::Building& its = stock_.buildings()[other.building];
            const glm::vec2 there{other.foot_m.x, other.foot_m.z};
            if (glm::distance(at, there) > radius + glm::length(its.half_m) + apart_m) continue;
            if (overlap(outline_m(building, house, 0.5F * apart_m), outline_m(its, other, 0.5F * apart_m)))
                return false;
        }
        return is_off_lanes(building, house);
    }

    static bool is_in_flight(glm::vec2 at, float radius_m) {
        const glm::vec2 d = glm::max(glm::abs(at - glm::vec2{0, 300}) - glm::vec2{95, 70}, glm::vec2{0});
        return glm::length(d) < kFlight_m - 20 + radius_m;
    }

    bool is_off_lanes(const scene::Building& building, const scene::House& house) const {
        const glm::vec2 at{house.foot_m.x, house.foot_m.z};
        const float near_m = glm::length(building.half_m) + 12;
        const scene::HouseFrame frame(building, house);
        const auto is_off = [&](const std::vector<glm::vec2>& line, float half_m) {
            for (std::size_t i = 0; i < line.size(); ++i) {
                if (glm::distance(line[i], at) > near_m) continue;
                const glm::vec2 next = line[std::min(i + 1, line.size() - 1)];
                for (int k = 0; k < 4; ++k) {
                    const glm::vec2 p = line[i] + 0.25F * static_cast<float>(k) * (next - line[i]);
                    if (frame.away_m(p) < half_m + 0.45F) return false;
                }
            }
            return true;
        };
        for (const Lane& road : roads_)
            if (!is_off(road.line_m, 0.5F * road.width_m)) return false;
        for (const Branch& branch : branches_)
            if (!is_off(branch.lane.line_m, 0.5F * branch.lane.width_m)) return false;
        return std::ranges::all_of(paths_, [&](const Lane& path) { return is_off(path.line_m, 0.5F * path.width_m); });
    }

    // Tries places about the middle from the most wished one down; a path leads from its door to the nearest lane.
    template <typename Wish>
    bool place_alone(Use use, float reach_m, const Wish& wish) {
        struct Spot {
            float wished;
            glm::vec2 at;
        };
        std::vector<Spot> spots;
        for (float z = -reach_m; z <= reach_m; z += 9)
            for (float x = -reach_m; x <= reach_m; x += 9) {
                const glm::vec2 at = middle_ + glm::vec2{x, z};
                if (!is_buildable(land_, at)) continue;
                const std::optional<float> wished = wish(at);
                if (wished) spots.push_back({*wished, at});
            }
        std::ranges::stable_sort(spots, [](const Spot& a, const Spot& b) { return a.wished > b.wished; });
        base::RandomStream random{seed_.child("alone").child(static_cast<std::uint64_t>(use))};
        const Stock::Offer& offer = wished(use);
        const scene::Building& shell = wished_shell_;
        for (std::size_t i = 0; i < std::min(spots.size(), std::size_t{60}); ++i) {
            const glm::vec2 to_lane = nearest_on_lanes(spots[i].at) - spots[i].at;
            if (glm::length(to_lane) < 1 || glm::length(to_lane) > 0.8F * reach_m) continue;
            scene::House house = house_of(spots[i].at, glm::normalize(to_lane), 0, random);
            house.wall_tint = glm::vec3{1};
            if (!fits(shell, house, 3)) continue;
            const glm::vec3 door = placed(house, {0, 0, shell.half_m.y + 1});
            const glm::vec2 from{door.x, door.z};
            const glm::vec2 way = spots[i].at + to_lane - from;
            Lane path{{}, 1.3F, false, {}};
            const int steps = std::max(1, static_cast<int>(glm::length(way) / kLaneStep_m));
            for (int k = 0; k <= steps; ++k)
                path.line_m.push_back(from + way * (static_cast<float>(k) / static_cast<float>(steps)));
            if (!std::ranges::all_of(path.line_m, [&](glm::vec2 p) { return is_buildable(land_, p) && is_open(p); }))
                continue;
            paths_.push_back(std::move(path));
            move_in(house, offer);
            return true;
        }
        return false;
    }

    bool is_open(glm::vec2 at) const {
        return std::ranges::all_of(houses_, [&](const scene::House& house) {
            return to_house_m(stock_.buildings()[house.building], house, at) > 1.4F;
        });
    }

    glm::vec2 nearest_on_lanes(glm::vec2 at) const {
        glm::vec2 best = middle_;
        for (std::size_t b = 0; b < branches_.size(); ++b) {
            if (used_m_[b] <= 0 && branches_[b].from >= 0) continue;
            for (const glm::vec2 p : branches_[b].lane.line_m)
                if (glm::distance(p, at) < glm::distance(best, at) && glm::distance(p, middle_) < 70) best = p;
        }
        return best;
    }

    // On a rise that everybody sees, nearer to the middle the more they care.
    bool place_chapel() {
        const float reach_m = 115 - 70 * p_.settle_chapel;
        const float here_m = scene::ground_height_m(land_, middle_);
        return place_alone(Use::Chapel, reach_m, [&](glm::vec2 at) -> std::optional<float> {
            const float out_m = glm::distance(at, middle_);
            if (out_m > reach_m || out_m < 10) return std::nullopt;
            const float over_m = std::clamp(scene::ground_height_m(land_, at) - here_m, -6.0F, 22.0F);
            return over_m - 0.08F * out_m - 20 * steepness(land_, at);
        });
    }

    // A lighthouse where the sea is near, a mill where a stream or a lake is.
    bool place_landmark() {
        const float water_m = to_water_m(land_, middle_, 150);
        if (water_m >= 150 || p_.settle_by_water < 0.3F) return false;
        const auto is_sea_near = [&](glm::vec2 at, float r) {
            for (int i = 0; i < 10; ++i) {
                const float turn = 0.628319F * static_cast<float>(i);
                const glm::vec2 way{std::sin(turn), std::cos(turn)};
                const auto is_sea = [&](float m) { return scene::ground_height_m(land_, at + m * way) < -1.0F; };
                if (is_sea(r) && is_sea(3 * r) && is_sea(5 * r) && is_sea(9 * r)) return true;
            }
            return false;
        };
        const bool by_sea = place_alone(Use::Lighthouse, 150, [&](glm::vec2 at) -> std::optional<float> {
            if (glm::distance(at, middle_) < 45 || !is_sea_near(at, 26)) return std::nullopt;
            return scene::ground_height_m(land_, at) - 15 * steepness(land_, at);
        });
        if (by_sea) return true;
        return place_alone(Use::Mill, 90, [&](glm::vec2 at) -> std::optional<float> {
            const float away_m = to_water_m(land_, at, 30);
            if (away_m >= 30) return std::nullopt;
            return -away_m - 0.1F * glm::distance(at, middle_);
        });
    }

    const scene::Land& land_;
    scene::LandParameters p_;
    base::Seed seed_;
    glm::vec2 middle_;
    Stock stock_;
    Stock::Offer wished_;
    std::size_t wished_by_ = static_cast<std::size_t>(-1);
    scene::Building wished_shell_;
    std::vector<Lane> roads_;  // of the land
    std::vector<Branch> branches_;
    std::vector<Frontage> frontages_;
    std::vector<float> used_m_;  // of each branch
    std::vector<Lane> paths_;
    std::vector<scene::House> houses_;
    int rounds_ = 0;
    bool tried_chapel_ = false, tried_landmark_ = false;
};

}  // namespace

int houses_at(float age) {
    if (age < 0) return 0;
    return std::min(kMostHouses, 1 + static_cast<int>(std::lround(299 * std::pow(std::min(age, 1.0F), 2.2F))));
}

Settled settle(const scene::Land& land, const scene::LandParameters& parameters, base::Seed seed) {
    const int count = houses_at(parameters.settle_age);
    if (count == 0) return {};
    const std::optional<glm::vec2> middle = settling_place(land, parameters);
    if (!middle) return {};
    Growth growth(land, parameters, seed, *middle);
    growth.grow(count);
    return growth.taken();
}

}  // namespace quadrat::synthesis::houses
