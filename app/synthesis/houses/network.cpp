// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/network.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace quadrat::synthesis::houses {
namespace {

constexpr float kRoadReach_m = 210;  // of the land's roads, as far as people build along them
constexpr float kBesideRoad_m = 48;
constexpr std::size_t kMostLanes = 72;
constexpr float kBetween_m = 30;  // branches of one side

// Points a step apart along a line.
std::vector<glm::vec2> resampled(const std::vector<glm::vec2>& line) {
    std::vector<glm::vec2> out{line.front()};
    float left = kLaneStep_m;
    for (std::size_t i = 1; i < line.size(); ++i) {
        glm::vec2 from = line[i - 1];
        float length = glm::distance(from, line[i]);
        while (length >= left && length > 0) {
            from += (line[i] - from) * (left / length);
            out.push_back(from);
            length = glm::distance(from, line[i]);
            left = kLaneStep_m;
        }
        left -= length;
    }
    return out;
}

class Network {
  public:
    Network(const scene::Land& land, glm::vec2 middle, const scene::LandParameters& p, base::Seed seed)
        : land_(land), middle_(middle), p_(p), seed_(seed) {}

    std::vector<Branch> grown() {
        begin_at_roads();
        if (branches_.empty()) begin_with_street();
        while (branches_.size() < kMostLanes && add_branch()) {
        }
        return std::move(branches_);
    }

  private:
    std::vector<Lane> lanes() const {
        std::vector<Lane> all;
        for (const Branch& b : branches_) all.push_back(b.lane);
        return all;
    }

    void add_road_half(const std::vector<glm::vec2>& line, float width_m) {
        std::vector<glm::vec2> near;
        for (const glm::vec2 p : line) {
            if (glm::distance(p, middle_) > kRoadReach_m) break;
            near.push_back(p);
        }
        if (near.size() < 3) return;
        branches_.push_back({{resampled(near), width_m, true}, -1, 0});
    }

    void begin_at_roads() {
        for (const scene::Road& road : land_.roads) {
            std::vector<glm::vec2> line;
            for (const glm::vec3& p : road.line_m) line.emplace_back(p.x, p.z);
            const auto nearest = std::min_element(line.begin(), line.end(), [this](glm::vec2 a, glm::vec2 b) {
                return glm::distance(a, middle_) < glm::distance(b, middle_);
            });
            const float reach_m = land_.site ? land_.site->radius_m + 12 : kBesideRoad_m;
            if (nearest == line.end() || glm::distance(*nearest, middle_) > reach_m) continue;
            if (land_.site && glm::distance(*nearest, middle_) > 6) {
                Branch link{{resampled({middle_, *nearest}), road.width_m, false}, -1, 0};
                if (link.lane.line_m.size() > 2) branches_.push_back(std::move(link));
            }
            add_road_half({nearest, line.end()}, road.width_m);
            add_road_half({std::make_reverse_iterator(nearest), line.rend()}, road.width_m);
        }
    }

    // Along the contour, both ways.
    void begin_with_street() {
        const float r = 14;
        glm::vec2 down{scene::ground_height_m(land_, middle_ + glm::vec2{r, 0}) -
                           scene::ground_height_m(land_, middle_ - glm::vec2{r, 0}),
                       scene::ground_height_m(land_, middle_ + glm::vec2{0, r}) -
                           scene::ground_height_m(land_, middle_ - glm::vec2{0, r})};
        if (glm::length(down) < 0.4F) down = {0.35F, 1};
        const glm::vec2 along = glm::normalize(glm::vec2{-down.y, down.x});
        const LaneRules rules{p_.settle_lane_m + 0.8F, p_.settle_winding, 170};
        for (const float way : {1.0F, -1.0F}) {
            const auto lane = grow_lane(land_, {}, middle_, way * along, rules, seed_.child(way > 0 ? 1U : 2U));
            if (lane) branches_.push_back({*lane, -1, 0});
        }
    }

    bool add_branch() {
        struct Start {
            float price = std::numeric_limits<float>::max();
            int from = -1;
            std::size_t at = 0;
            float side = 1;
        } best;
        for (std::size_t b = 0; b < branches_.size(); ++b) {
            const std::vector<glm::vec2>& line = branches_[b].lane.line_m;
            for (std::size_t i = 1; i + 1 < line.size(); ++i) {
                for (const float side : {1.0F, -1.0F}) {
                    const auto key = base::hash_of(seed_, static_cast<std::int64_t>(b), static_cast<std::int64_t>(i),
                                                   side > 0 ? 1 : 2);
                    const float price = glm::distance(line[i], middle_) + 22 * base::unit_of(key);
                    if (price >= best.price || is_taken(static_cast<int>(b), i, side)) continue;
                    best = {price, static_cast<int>(b), i, side};
                }
            }
        }
        if (best.from < 0 || best.price > 320) return false;
        tried_.push_back({best.from, best.at, best.side});
        const std::vector<glm::vec2>& line = branches_[static_cast<std::size_t>(best.from)].lane.line_m;
        const glm::vec2 along = glm::normalize(line[best.at + 1] - line[best.at - 1]);
        const base::Seed seed = seed_.child("lane").child(tried_.size());
        base::RandomStream random{seed};
        const float skew = 0.5F * p_.settle_winding * random.between(-1, 1);
        const glm::vec2 toward = best.side * glm::vec2{-along.y, along.x} + skew * along;
        const LaneRules rules{p_.settle_lane_m, p_.settle_winding, random.between(45, 110)};
        std::vector<Lane> others = lanes();
        const auto lane = grow_lane(land_, others, line[best.at], toward, rules, seed);
        if (lane) branches_.push_back({*lane, best.from, kLaneStep_m * static_cast<float>(best.at)});
        return true;
    }

    bool is_taken(int from, std::size_t at, float side) const {
        for (const Tried& t : tried_) {
            if (t.from != from || t.side != side) continue;
            const auto apart = static_cast<float>(t.at > at ? t.at - at : at - t.at);
            if (apart * kLaneStep_m < kBetween_m) return true;
        }
        return false;
    }

    struct Tried {
        int from;
        std::size_t at;
        float side;
    };
    const scene::Land& land_;
    glm::vec2 middle_;
    const scene::LandParameters& p_;
    base::Seed seed_;
    std::vector<Branch> branches_;
    std::vector<Tried> tried_;
};

}  // namespace

std::vector<Branch> grow_network(const scene::Land& land, glm::vec2 middle_m, const scene::LandParameters& parameters,
                                 base::Seed seed) {
    return Network(land, middle_m, parameters, seed).grown();
}

}  // namespace quadrat::synthesis::houses
