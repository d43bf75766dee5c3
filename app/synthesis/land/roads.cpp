// SPDX-License-Identifier: Apache-2.0
// The cheapest way over a grid with many directions: E. Galin, A. Peytavie, N. Marechal & E. Guerin, "Procedural
// generation of roads", 2010. Changed: the grade is not only paid for but kept: the profile is made Lipschitz, as the
// mean of its least majorant and its greatest minorant of that slope.
#include "synthesis/land/roads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <numeric>
#include <queue>

namespace quadrat::synthesis::land {
namespace {

constexpr glm::vec2 kViewer_m{0, 300};  // where the camera's way lies, about
constexpr float kNode_m = 8.0F;
constexpr float kDryOverSea_m = 0.8F;
// A road ends this far inside the land's border, which must stay where the country around meets it.
float border_m(float width_m, float cell_m) { return std::max(16.0F, 0.5F * width_m + 3.0F * cell_m); }

float half_side_m(const mesh::Field& field, float cell_m) {
    return 0.5F * cell_m * static_cast<float>(field.columns - 1);
}

// Where a road may run: nodes some metres apart, with the ground's height.
struct Nodes {
    int side = 0;
    float step_m = kNode_m;  // from node to node: more on coarse lands
    mesh::Field height_m;
    mesh::Grid<std::uint8_t> wet;  // 0 dry, 1 a river, 2 a lake or the sea

    glm::vec2 place_m(std::int32_t node) const {
        const float half = 0.5F * static_cast<float>(side - 1);
        return step_m * glm::vec2{static_cast<float>(node % side) - half, static_cast<float>(node / side) - half};
    }
    std::int32_t nearest(glm::vec2 at_m) const {
        const float half = 0.5F * static_cast<float>(side - 1);
        const auto index = [&](float m) {
            return std::clamp(static_cast<int>(std::lround(m / step_m + half)), 0, side - 1);
        };
        return index(at_m.y) * side + index(at_m.x);
    }
};

Nodes nodes_of(const mesh::Field& h, const mesh::Field& surface, float cell_m) {
    Nodes nodes;
    const int stride = std::max(1, static_cast<int>(std::lround(kNode_m / cell_m)));
    nodes.side = (h.columns - 1) / stride + 1;
    nodes.step_m = cell_m * static_cast<float>(stride);
    nodes.height_m = mesh::Field(nodes.side, nodes.side);
    nodes.wet = mesh::Grid<std::uint8_t>(nodes.side, nodes.side, 0);
    for (int y = 0; y < nodes.side; ++y) {
        for (int x = 0; x < nodes.side; ++x) {
            nodes.height_m.at(x, y) = h.at(x * stride, y * stride);
            std::uint8_t& wet = nodes.wet.at(x, y);
            int still = 0;
            for (int dy = -stride / 2; dy <= stride / 2; ++dy) {
                for (int dx = -stride / 2; dx <= stride / 2; ++dx) {
                    const int c = x * stride + dx;
                    const int r = y * stride + dy;
                    if (!h.is_inside(c, r)) continue;
                    if (h.at(c, r) < kDryOverSea_m) wet = 2;
                    if (surface.at(c, r) <= scene::kNoWater) continue;
                    wet = std::max(wet, std::uint8_t{1});
                    still += surface.at(c, r) - h.at(c, r) > 0.9F;  // too deep to ford
                }
            }
            if (still > 0) wet = 2;
        }
    }
    return nodes;
}

struct Move {
    int dx, dy;
    float length_m;
    float bearing;
};

// All directions with coprime steps of three and less: 32.
std::vector<Move> moves(float step_m) {
    std::vector<Move> all;
    for (int dy = -3; dy <= 3; ++dy)
        for (int dx = -3; dx <= 3; ++dx)
            if ((dx != 0 || dy != 0) && std::gcd(std::abs(dx), std::abs(dy)) == 1)
                all.push_back({dx, dy, step_m * std::hypot(static_cast<float>(dx), static_cast<float>(dy)),
                               std::atan2(static_cast<float>(dy), static_cast<float>(dx))});
    return all;
}

constexpr float kNever = std::numeric_limits<float>::infinity();

// What it costs to build a stretch and to walk it, in metres of level road.
float cost_of(const Nodes& nodes, std::int32_t from, const Move& move, float grade) {
    const int x = from % nodes.side;
    const int y = from / nodes.side;
    const std::int32_t to = from + move.dy * nodes.side + move.dx;
    if (nodes.wet.samples[to] == 2) return kNever;
    const float steep = std::abs(nodes.height_m.samples[to] - nodes.height_m.samples[from]) / move.length_m / grade;
    float cost = move.length_m * (1.0F + 0.7F * steep * steep + (steep > 1 ? 14.0F * (steep - 1) : 0.0F));
    bool fords = nodes.wet.samples[to] == 1;
    const int stride = std::max(std::abs(move.dx), std::abs(move.dy));
    for (int k = 1; k < stride; ++k) {
        const float share = static_cast<float>(k) / static_cast<float>(stride);
        const float column = static_cast<float>(x) + share * static_cast<float>(move.dx);
        const float row = static_cast<float>(y) + share * static_cast<float>(move.dy);
        // The two nodes that the way runs between there.
        for (const auto crossed :
             {nodes.wet.at(static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))),
              nodes.wet.at(static_cast<int>(std::ceil(column)), static_cast<int>(std::ceil(row)))}) {
            if (crossed == 2) return kNever;
            fords = fords || crossed == 1;
        }
    }
    return fords ? cost + 90.0F : cost;
}

float turn_of(const Move& a, const Move& b) {
    const float turn = std::abs(a.bearing - b.bearing);
    return std::min(turn, 6.2831853F - turn);
}

// Dijkstra over the nodes; a bend is paid for by its angle. Empty: no goal can be reached.
template <typename IsGoal>
std::vector<std::int32_t> cheapest_way(const Nodes& nodes, const std::vector<std::int32_t>& starts,
                                       const IsGoal& is_goal, float grade, int border) {
    const std::vector<Move> all = moves(nodes.step_m);
    constexpr std::int8_t kStart = -1;
    std::vector<float> cost(nodes.height_m.samples.size(), kNever);
    std::vector<std::int8_t> came_by(cost.size(), kStart);
    using Entry = std::pair<float, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const std::int32_t start : starts) {
        cost[start] = 0;
        open.emplace(0.0F, start);
    }
    while (!open.empty()) {
        const auto [paid, node] = open.top();
        open.pop();
        if (paid > cost[node]) continue;
        if (is_goal(node)) {
            std::vector<std::int32_t> way{node};
            for (std::int32_t at = node; came_by[at] != kStart;) {
                const Move& move = all[static_cast<std::size_t>(came_by[at])];
                at -= move.dy * nodes.side + move.dx;
                way.push_back(at);
            }
            std::reverse(way.begin(), way.end());
            return way;
        }
        const int x = node % nodes.side;
        const int y = node / nodes.side;
        for (std::size_t m = 0; m < all.size(); ++m) {
            if (!nodes.wet.is_inside(x + all[m].dx - border, y + all[m].dy - border) ||
                !nodes.wet.is_inside(x + all[m].dx + border, y + all[m].dy + border))
                continue;
            float to_pay = cost_of(nodes, node, all[m], grade);
            if (came_by[node] != kStart) {
                const float turn = turn_of(all[static_cast<std::size_t>(came_by[node])], all[m]);
                if (turn > 1.7F) continue;
                to_pay += 9.0F * turn * turn;
            }
            const std::int32_t to = node + all[m].dy * nodes.side + all[m].dx;
            if (paid + to_pay >= cost[to]) continue;
            cost[to] = paid + to_pay;
            came_by[to] = static_cast<std::int8_t>(m);
            open.emplace(cost[to], to);
        }
    }
    return {};
}

// Corners rounded (Chaikin 1974), then points at even steps.
std::vector<glm::vec2> rounded(std::vector<glm::vec2> line) {
    constexpr float kStep_m = 3.0F;
    for (int round = 0; round < 3; ++round) {
        std::vector<glm::vec2> finer{line.front()};
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            finer.push_back(0.75F * line[i] + 0.25F * line[i + 1]);
            finer.push_back(0.25F * line[i] + 0.75F * line[i + 1]);
        }
        finer.push_back(line.back());
        line = std::move(finer);
    }
    std::vector<glm::vec2> even{line.front()};
    float left_m = kStep_m;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const float length_m = glm::length(line[i + 1] - line[i]);
        float at_m = left_m;
        for (; at_m < length_m; at_m += kStep_m) even.push_back(line[i] + (line[i + 1] - line[i]) * (at_m / length_m));
        left_m = at_m - length_m;
    }
    if (glm::length(even.back() - line.back()) > 0.5F * kStep_m) even.push_back(line.back());
    return even;
}

enum class Ends { Free, FirstStays };

// The ground's profile along the line, evened out, and nowhere steeper than the grade.
std::vector<float> profile_of(const std::vector<glm::vec2>& line, const mesh::Field& h, float cell_m, float grade,
                              Ends ends) {
    const float half = 0.5F * static_cast<float>(h.columns - 1);
    const auto n = static_cast<int>(line.size());
    std::vector<float> ground(line.size());
    for (int i = 0; i < n; ++i) ground[i] = mesh::sample(h, line[i].x / cell_m + half, line[i].y / cell_m + half);
    std::vector<float> even(ground);
    constexpr int kReach = 5;
    for (int i = 0; i < n; ++i) {
        const int reach = std::min({kReach, i, n - 1 - i});
        float sum = 0;
        for (int k = i - reach; k <= i + reach; ++k) sum += ground[k];
        even[i] = sum / static_cast<float>(2 * reach + 1);
    }
    // A little under the bound: the ground's samples do not lie on the line.
    const float kept = 0.92F * grade;
    std::vector<float> over(even);
    std::vector<float> under(even);
    const auto limit = [&](int i, int before) {
        const float fall = kept * glm::length(line[i] - line[before]);
        over[i] = std::max(over[i], over[before] - fall);
        under[i] = std::min(under[i], under[before] + fall);
    };
    for (int i = 1; i < n; ++i) limit(i, i - 1);
    for (int i = n - 1; i-- > 0;) limit(i, i + 1);
    for (int i = 0; i < n; ++i) even[i] = 0.5F * (over[i] + under[i]);
    if (ends == Ends::FirstStays) {
        float rise = 0;
        for (int i = 0; i < n; ++i) {
            rise += i > 0 ? kept * glm::length(line[i] - line[i - 1]) : 0.0F;
            even[i] = std::clamp(even[i], ground[0] - rise, ground[0] + rise);
        }
    }
    return even;
}

// For every sample near the line: how far from it, and how high the road is there.
struct Nearby {
    mesh::Field away_m;
    mesh::Field road_m;
};

Nearby nearby(const std::vector<glm::vec3>& line, int samples, float cell_m, float reach_m) {
    Nearby near{mesh::Field(samples, samples, 1.0e6F), mesh::Field(samples, samples)};
    const float half = 0.5F * static_cast<float>(samples - 1);
    const auto sample = [&](float m) { return m / cell_m + half; };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::vec2 a{line[i].x, line[i].z};
        const glm::vec2 way = glm::vec2{line[i + 1].x, line[i + 1].z} - a;
        const float squared = std::max(glm::dot(way, way), 1.0e-6F);
        const glm::vec2 low = glm::min(a, a + way) - reach_m;
        const glm::vec2 high = glm::max(a, a + way) + reach_m;
        for (int y = std::max(0, static_cast<int>(sample(low.y)));
             y <= std::min(samples - 1, static_cast<int>(sample(high.y)) + 1); ++y) {
            for (int x = std::max(0, static_cast<int>(sample(low.x)));
                 x <= std::min(samples - 1, static_cast<int>(sample(high.x)) + 1); ++x) {
                const glm::vec2 p = cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half) - a;
                const float t = std::clamp(glm::dot(p, way) / squared, 0.0F, 1.0F);
                const float away_m = glm::length(p - t * way);
                if (away_m >= near.away_m.at(x, y)) continue;
                near.away_m.at(x, y) = away_m;
                near.road_m.at(x, y) = line[i].y + t * (line[i + 1].y - line[i].y);
            }
        }
    }
    return near;
}

// Cut and filled to the road, with shoulders that run out into the land. Beds of rivers stay: the road fords them.
void level(mesh::Field& h, const mesh::Field& surface, float cell_m, const scene::Road& road) {
    const float flat_m = 0.5F * road.width_m + cell_m;
    const float shoulder_m = border_m(road.width_m, cell_m) - flat_m;
    const Nearby near = nearby(road.line_m, h.columns, cell_m, flat_m + shoulder_m);
    for (std::size_t i = 0; i < h.samples.size(); ++i) {
        const float t = (near.away_m.samples[i] - flat_m) / shoulder_m;
        if (t >= 1 || surface.samples[i] > scene::kNoWater) continue;
        const float share = t <= 0 ? 1.0F : (1 - t) * (1 - t) * (1 + 2 * t);
        h.samples[i] += share * (near.road_m.samples[i] - h.samples[i]);
    }
}

// A dry, gently sloping place some way before the viewer with nothing higher between.
std::optional<std::int32_t> before_the_viewer(const Nodes& nodes, float side) {
    constexpr float kEye_m = 5;
    const float eye_m = std::max(nodes.height_m.samples[nodes.nearest(kViewer_m)], 0.0F) + kEye_m;
    const auto is_in_sight = [&](glm::vec2 to_m, float height_m) {
        for (float t = 0.1F; t < 0.95F; t += 0.1F)
            if (nodes.height_m.samples[nodes.nearest(kViewer_m + t * (to_m - kViewer_m))] >
                eye_m + t * (height_m - eye_m))
                return false;
        return true;
    };
    std::optional<std::int32_t> best;
    float least = 1.0e6F;
    for (std::int32_t node = 0; node < nodes.side * nodes.side; ++node) {
        const glm::vec2 at = nodes.place_m(node);
        const float ahead_m = kViewer_m.y - at.y;
        if (ahead_m < 60 || ahead_m > 220 || std::abs(at.x) > 0.35F * ahead_m || nodes.wet.samples[node] != 0) continue;
        const int x = node % nodes.side;
        const int y = node / nodes.side;
        const float slope = std::hypot(nodes.height_m.at(x + 1, y) - nodes.height_m.at(x - 1, y),
                                       nodes.height_m.at(x, y + 1) - nodes.height_m.at(x, y - 1)) /
                            (2 * nodes.step_m);
        const float price = 4 * slope + std::abs(ahead_m - 110) / 110 + std::abs(at.x - 0.12F * side * ahead_m) / 60;
        if (price >= least || !is_in_sight(at, nodes.height_m.samples[node] + 0.5F)) continue;
        least = price;
        best = node;
    }
    return best;
}

// One way out of two that begin at the same place. Empty where either is.
std::vector<std::int32_t> joined(std::vector<std::int32_t> back, const std::vector<std::int32_t>& on) {
    if (back.empty() || on.empty()) return {};
    std::ranges::reverse(back);
    back.pop_back();
    std::ranges::copy(on, std::back_inserter(back));
    return back;
}

scene::Road road_along(std::vector<glm::vec2> line, Ends ends, mesh::Field& h, const mesh::Field& surface, float cell_m,
                       const RoadOptions& options) {
    const std::vector<float> profile = profile_of(line, h, cell_m, options.grade, ends);
    scene::Road road{{}, options.width_m, options.grade};
    for (std::size_t i = 0; i < line.size(); ++i) road.line_m.emplace_back(line[i].x, profile[i], line[i].y);
    level(h, surface, cell_m, road);
    return road;
}

std::vector<glm::vec2> places_of(const Nodes& nodes, const std::vector<std::int32_t>& way) {
    std::vector<glm::vec2> places;
    for (const std::int32_t node : way) places.push_back(nodes.place_m(node));
    return places;
}

void begin_at_rim(std::vector<glm::vec2>& line, const scene::Site& site) {
    const glm::vec2 home{site.middle_m.x, site.middle_m.z};
    line.erase(line.begin(), std::find_if(line.begin(), line.end(),
                                          [&](glm::vec2 p) { return glm::length(p - home) > 0.9F * site.radius_m; }));
}

}  // namespace

std::vector<scene::Road> make_roads(mesh::Field& height_m, const mesh::Field& surface_m, float cell_m,
                                    const std::optional<scene::Site>& site, const RoadOptions& options,
                                    base::Seed seed) {
    base::RandomStream random{seed.child("roads")};
    const float side = random.unit() < 0.5 ? -1.0F : 1.0F;
    const Nodes nodes = nodes_of(height_m, surface_m, cell_m);
    const auto border = static_cast<int>(std::ceil(border_m(options.width_m, cell_m) / nodes.step_m));
    const float edge_m = half_side_m(height_m, cell_m) - static_cast<float>(border) * nodes.step_m;
    // It comes in beside the viewer and leaves where it is seen to.
    const auto is_near_edge = [&](std::int32_t node) {
        const glm::vec2 p = nodes.place_m(node);
        return nodes.wet.samples[node] == 0 &&
               ((p.y >= edge_m - 0.5F && side * p.x > 120.0F) || (side * p.x >= edge_m - 0.5F && p.y > 60.0F));
    };
    const auto is_far_edge = [&](std::int32_t node) {
        const glm::vec2 p = nodes.place_m(node);
        return nodes.wet.samples[node] == 0 &&
               (p.y <= -edge_m + 0.5F || (-side * p.x >= edge_m - 0.5F && p.y < 150.0F));
    };
    const auto is_shore = [&](std::int32_t node) {
        if (glm::length(nodes.place_m(node) - glm::vec2{site->middle_m.x, site->middle_m.z}) < 1.6F * site->radius_m)
            return false;
        const int x = node % nodes.side;
        const int y = node / nodes.side;
        bool is_wet_beside = false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (nodes.wet.is_inside(x + dx, y + dy)) is_wet_beside |= nodes.wet.at(x + dx, y + dy) == 2;
        return is_wet_beside;
    };
    std::vector<std::int32_t> starts;
    for (std::int32_t node = 0; node < nodes.side * nodes.side; ++node)
        if (is_near_edge(node)) starts.push_back(node);
    std::vector<std::vector<std::int32_t>> ways;
    if (site) {
        const std::vector<std::int32_t> home{nodes.nearest({site->middle_m.x, site->middle_m.z})};
        ways.push_back(cheapest_way(nodes, home, is_near_edge, options.grade, border));
        if (options.goes_on || ways[0].empty())
            ways.push_back(cheapest_way(nodes, home, is_far_edge, options.grade, border));
        if (ways.front().empty() && ways.back().empty())
            ways.push_back(cheapest_way(nodes, home, is_shore, options.grade, border));
    } else if (const auto seen = before_the_viewer(nodes, side)) {
        // It leads into the picture: from the edge beside the viewer past a place in sight, and on into the distance.
        ways.push_back(joined(cheapest_way(nodes, {*seen}, is_near_edge, options.grade, border),
                              cheapest_way(nodes, {*seen}, is_far_edge, options.grade, border)));
    }
    if (ways.empty() || (ways.front().empty() && !site))
        ways = {cheapest_way(nodes, starts, is_far_edge, options.grade, border)};
    std::vector<scene::Road> roads;
    for (const auto& way : ways) {
        if (way.size() < 4) continue;
        std::vector<glm::vec2> line = rounded(places_of(nodes, way));
        if (site) begin_at_rim(line, *site);
        if (line.size() < 4) continue;
        roads.push_back(
            road_along(std::move(line), site ? Ends::FirstStays : Ends::Free, height_m, surface_m, cell_m, options));
    }
    return roads;
}

mesh::Field distance_to_roads_m(int samples, float cell_m, const std::vector<scene::Road>& roads,
                                const std::optional<scene::Site>& site) {
    if (roads.empty() && !site) return {};
    mesh::Field to_edge_m(samples, samples, scene::kFarFromRoads_m);
    for (const scene::Road& road : roads) {
        const Nearby near = nearby(road.line_m, samples, cell_m, scene::kFarFromRoads_m);
        for (std::size_t i = 0; i < to_edge_m.samples.size(); ++i)
            to_edge_m.samples[i] = std::min(to_edge_m.samples[i], near.away_m.samples[i] - 0.5F * road.width_m);
    }
    if (!site) return to_edge_m;
    const float half = 0.5F * static_cast<float>(samples - 1);
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x) {
            const glm::vec2 p = cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half);
            const float away_m = glm::length(p - glm::vec2{site->middle_m.x, site->middle_m.z}) - site->radius_m;
            to_edge_m.at(x, y) = std::min(to_edge_m.at(x, y), away_m);
        }
    }
    return to_edge_m;
}

}  // namespace quadrat::synthesis::land
