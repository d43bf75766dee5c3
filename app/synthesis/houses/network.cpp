// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/network.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/street_grammar.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kRoadReach_m = 210;  // of the land's roads, as far as people build along them
constexpr float kBesideRoad_m = 48;
constexpr float kStreetSteps = 34;

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

float heading_deg(glm::vec2 way) { return glm::degrees(std::atan2(way.y, way.x)); }

// The word that the streets' grammar begins with.
class Beginning {
  public:
    Beginning(const scene::Land& land, glm::vec2 middle, const scene::LandParameters& p)
        : land_(land), middle_(middle), p_(p) {
        rules_.pattern = streets_of(p);
        rules_.width_m = p.settle_lane_m;
        rules_.winding = p.settle_winding;
        rules_.middle_m = middle;
        begin_at_roads();
        if (word_.symbols.empty()) begin_with_street();
    }

    const lsystem::Word& word() const { return word_; }
    const StreetRules& rules() const { return rules_; }

  private:
    void begin(glm::vec2 at, float heading, float width_m, bool is_road) {
        if (word_.symbols.empty()) rules_.raster_deg = heading;
        word_.add('[');
        word_.add('M', {at.x, at.y, heading, width_m, is_road ? 1.0F : 0.0F});
    }

    void add_line(const std::vector<glm::vec2>& line, float width_m, bool is_road) {
        if (line.size() < 3) return;
        float heading = heading_deg(line[1] - line[0]);
        begin(line[0], heading, width_m, is_road);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const float next = heading_deg(line[i + 1] - line[i]);
            word_.add('+', {next - heading});
            word_.add('G', {glm::distance(line[i], line[i + 1])});
            word_.add('V', {static_cast<float>(i + 1)});
            heading = next;
        }
        word_.add(']');
    }

    void add_road_half(const std::vector<glm::vec2>& line, float width_m) {
        std::vector<glm::vec2> near;
        for (const glm::vec2 p : line) {
            if (glm::distance(p, middle_) > kRoadReach_m) break;
            near.push_back(p);
        }
        if (near.size() >= 3) add_line(resampled(near), width_m, true);
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
            if (land_.site && glm::distance(*nearest, middle_) > 6)
                add_line(resampled({middle_, *nearest}), road.width_m, false);
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
        const float along = heading_deg({-down.y, down.x});
        constexpr float kGoals[] = {0, 2, 3};
        const float goal = kGoals[static_cast<std::size_t>(rules_.pattern)];
        for (const float heading : {along, along + 180}) {
            begin(middle_, heading, p_.settle_lane_m + 0.8F, false);
            word_.add('R', {kStreetSteps, 3});
            word_.add('?', {0, 0, 0, goal});
            word_.add(']');
        }
    }

    const scene::Land& land_;
    glm::vec2 middle_;
    const scene::LandParameters& p_;
    StreetRules rules_;
    lsystem::Word word_;
};

}  // namespace

Streets streets_of(const scene::LandParameters& parameters) {
    return static_cast<Streets>(std::clamp(static_cast<int>(std::lround(parameters.settle_streets)), 0, 2));
}

std::vector<Branch> grow_network(const scene::Land& land, glm::vec2 middle_m, const scene::LandParameters& parameters,
                                 base::Seed seed) {
    const Beginning beginning(land, middle_m, parameters);
    return grow_streets(land, beginning.rules(), beginning.word(), seed);
}

}  // namespace quadrat::synthesis::houses
