// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/track.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "synthesis/compose/view_merit.hpp"

namespace quadrat::synthesis {
namespace {

constexpr int kStations = 33;
constexpr float kPeriod_s = 80.0F;
constexpr float kLeastOverGround_m = 1.9F;  // 1.7 m and room for the spline between stations
constexpr float kLeastOverWater_m = 3.0F;

glm::vec2 toward(float bearing_rad) { return {std::sin(bearing_rad), -std::cos(bearing_rad)}; }

struct Path {
    glm::vec2 from, bend, to;
    float bearing_from, bearing_to;
};

Path draw_path(base::Seed seed) {
    base::RandomStream random{seed};
    const float bearing = glm::radians(random.between(-34.0F, 34.0F));
    const glm::vec2 ahead = toward(bearing);
    const glm::vec2 aside{-ahead.y, ahead.x};
    const float side = random.unit() < 0.5 ? -1.0F : 1.0F;
    const glm::vec2 middle =
        glm::vec2{random.between(-90.0F, 90.0F), random.between(240.0F, 350.0F)} - aside * (60.0F * std::sin(bearing));
    const float glide_m = random.between(28.0F, 48.0F) * side;
    const float advance_m = random.between(6.0F, 34.0F);
    Path path{};
    path.from = middle - glide_m * aside - advance_m * ahead;
    path.to = middle + glide_m * aside + advance_m * ahead;
    path.bend = middle + random.between(-14.0F, 14.0F) * ahead;
    const float turn = glm::radians(random.between(2.0F, 11.0F)) * side;
    path.bearing_from = bearing + turn;
    path.bearing_to = bearing - turn;
    return path;
}

// How well a path keeps the land's middle before it and moves past what is near.
float merit(const Path& path) {
    const glm::vec2 middle = 0.5F * (path.from + path.to);
    const glm::vec2 ahead = toward(0.5F * (path.bearing_from + path.bearing_to));
    const glm::vec2 to_heart = glm::vec2{0, -60} - middle;
    const float faces_heart = glm::dot(ahead, glm::normalize(to_heart));
    const glm::vec2 way = glm::normalize(path.to - path.from);
    const float passes = 1.0F - std::abs(glm::dot(way, ahead));
    const float from_edge_m = 512.0F - std::max(std::abs(middle.x), std::abs(middle.y));
    return 3.0F * faces_heart + 0.6F * passes - (from_edge_m < 130.0F ? 1.0F : 0.0F);
}

// The least height over the houses at a place; far below everything where there are none.
float over_houses_m(const scene::Settlement& settlement, glm::vec2 at) {
    constexpr float kRoom_m = 5;
    constexpr float kOverRidge_m = 2.5F;
    float most = -1.0e6F;
    for (const scene::House& house : settlement.houses) {
        const scene::Building& building = settlement.buildings[house.building];
        const glm::vec2 d = at - glm::vec2{house.foot_m.x, house.foot_m.z};
        if (std::max(std::abs(d.x), std::abs(d.y)) > 30) continue;
        if (scene::to_house_m(building, house, at) < kRoom_m)
            most = std::max(most, house.foot_m.y + building.height_m + kOverRidge_m);
    }
    return most;
}

float floor_m(const scene::Land& land, glm::vec2 at) {
    const float ground_m = scene::ground_height_m(land, at);
    const float water_m = ground_m + scene::water_depth_m(land, at);
    return std::max({ground_m + kLeastOverGround_m, kLeastOverWater_m, water_m + kLeastOverGround_m,
                     over_houses_m(land.settlement, at)});
}

// The highest that must be flown over near a station: the camera does not brush what lies beside its way.
float clear_m(const scene::Land& land, glm::vec2 at, float over_m) {
    float most = floor_m(land, at);
    for (int i = 0; i < 8; ++i) {
        const float a = 0.785398F * static_cast<float>(i);
        most = std::max(most, floor_m(land, at + 4.0F * glm::vec2{std::cos(a), std::sin(a)}));
    }
    return most + over_m;
}

// The height from which the ground two hundred metres ahead is seen past what lies between, within reason.
float sight_m(const scene::Land& land, const FlightPlan::Station& station) {
    constexpr float kReach_m = 230.0F;
    const float far_m = std::max(scene::ground_height_m(land, station.at_m + kReach_m * station.ahead), 0.0F) + 3.0F;
    float need_m = -1.0e6F;
    for (float d = 10.0F; d <= 0.7F * kReach_m; d += 7.0F) {
        const float share = d / kReach_m;
        const float ground_m = scene::ground_height_m(land, station.at_m + d * station.ahead) + 1.0F;
        need_m = std::max(need_m, (ground_m - far_m * share) / (1.0F - share));
    }
    return need_m;
}

// Angle up to the skyline ahead.
float skyline_rad(const scene::Land& land, const FlightPlan::Station& station, float eye_m) {
    float most = 0;
    for (float d = 120.0F; d < 6000.0F; d *= 1.18F)
        for (const float aside : {-0.22F, 0.0F, 0.22F}) {
            const glm::vec2 way = station.ahead + aside * glm::vec2{-station.ahead.y, station.ahead.x};
            most = std::max(most, std::atan2(scene::ground_height_m(land, station.at_m + d * way) - eye_m, d));
        }
    return most;
}

// How much lower than this pitch the eye must look so that no landmark ahead falls out of the picture below.
float lower_rad(const scene::Land& land, const FlightPlan::Station& station, float eye_m, float pitch_rad) {
    constexpr float kFarthest_m = 260;
    constexpr float kWidest = 0.55F;              // tangent off the view
    const float below_rad = glm::radians(11.0F);  // of a picture that shows 21 degrees below its middle
    const float least_rad = glm::radians(-11.0F);
    float lowest = pitch_rad;
    for (const scene::Landmark& mark : land.landmarks) {
        const glm::vec2 to = glm::vec2{mark.at_m.x, mark.at_m.z} - station.at_m;
        const float along_m = glm::dot(to, station.ahead);
        const float aside_m = std::abs(to.x * station.ahead.y - to.y * station.ahead.x);
        if (along_m < 15 || along_m > kFarthest_m || aside_m > kWidest * along_m) continue;
        const float foot_m = std::min(mark.at_m.y, scene::ground_height_m(land, station.at_m + to));
        lowest = std::min(lowest, std::atan2(foot_m - eye_m, along_m) + below_rad);
    }
    return std::max(pitch_rad - std::max(lowest, least_rad), 0.0F);
}

// Each value the highest of its neighbourhood, then their mean: never lower than the value itself.
std::vector<float> smoothed_over(const std::vector<float>& values, int reach) {
    const int n = static_cast<int>(values.size());
    const auto pass = [n, reach](const std::vector<float>& in, const auto& gather) {
        std::vector<float> out(in.size());
        for (int i = 0; i < n; ++i) {
            float sum = in[i];
            int count = 1;
            for (int k = std::max(0, i - reach); k <= std::min(n - 1, i + reach); ++k) gather(sum, count, in[k]);
            out[i] = sum / static_cast<float>(count);
        }
        return out;
    };
    const auto highest = pass(values, [](float& sum, int&, float v) { sum = std::max(sum, v); });
    return pass(highest, [](float& sum, int& count, float v) {
        sum += v;
        ++count;
    });
}

}  // namespace

FlightPlan plan_flight(base::Seed flight) {
    constexpr std::uint64_t kPaths = 12;
    Path best = draw_path(flight.child(0U));
    for (std::uint64_t i = 1; i < kPaths; ++i) {
        const Path path = draw_path(flight.child(i));
        if (merit(path) > merit(best)) best = path;
    }
    FlightPlan plan;
    for (int i = 0; i < kStations; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(kStations - 1);
        const glm::vec2 a = best.from + t * (best.bend - best.from);
        const glm::vec2 b = best.bend + t * (best.to - best.bend);
        plan.stations.push_back(
            {a + t * (b - a), toward(best.bearing_from + t * (best.bearing_to - best.bearing_from))});
    }
    return plan;
}

namespace {

// A settlement shows itself over its first roofs.
constexpr std::array kLiftsOverRoofs_m{2.0F, 7.0F, 12.0F};

// How high over what must be cleared, and how far up or down the eyes are turned, to the usual.
struct Manner {
    float lift_m;
    float tilt_deg;
};

struct Flown {
    const FlightPlan& plan;
    const std::vector<float>& eyes_m;
    const std::vector<float>& pitches;

    scene::Camera camera(std::size_t i, const Manner& manner) const {
        const FlightPlan::Station& station = plan.stations[i];
        const glm::vec3 eye{station.at_m.x, eyes_m[i] + manner.lift_m, station.at_m.y};
        const float pitch = pitches[i] + glm::radians(manner.tilt_deg);
        return {eye, eye + 100.0F * glm::vec3{station.ahead.x, std::tan(pitch), station.ahead.y}, 42.0F};
    }
};

// Of some manners the one whose beginning, middle and end are the best to look at.
Manner best_manner(const Flown& flown, const Lookout& lookout) {
    Manner best{0, 0};
    float most = -1.0e6F;
    const bool is_wild = lookout.land().settlement.is_empty();
    const std::array<float, 3> lifts_m = is_wild ? std::array{0.0F, 2.0F, 6.0F} : kLiftsOverRoofs_m;
    for (const float lift_m : lifts_m) {
        for (const float tilt_deg : {0.0F, -3.5F, 3.0F}) {
            const Manner manner{lift_m, tilt_deg};
            const std::size_t last = flown.plan.stations.size() - 1;
            float merit = -0.012F * lift_m;  // what is near is best seen from low down
            for (const std::size_t i : {std::size_t{0}, last / 2, last})
                merit += view_merit(lookout.outlook(flown.camera(i, manner)));
            if (merit <= most) continue;
            most = merit;
            best = manner;
        }
    }
    return best;
}

// The plan turned and moved as one, so that its early station stands there and looks that way.
FlightPlan moved(const FlightPlan& plan, glm::vec2 at_m, glm::vec2 ahead) {
    const FlightPlan::Station early = plan.stations[plan.stations.size() / 5];
    const auto turned = [&](glm::vec2 v) {
        const float along = glm::dot(v, early.ahead);
        const float aside = early.ahead.x * v.y - early.ahead.y * v.x;
        return along * ahead + aside * glm::vec2{-ahead.y, ahead.x};
    };
    FlightPlan there;
    for (const FlightPlan::Station& station : plan.stations)
        there.stations.push_back({at_m + turned(station.at_m - early.at_m), turned(station.ahead)});
    return there;
}

// What the early station of a plan sees is worth.
float merit_of(const Lookout& lookout, const FlightPlan& plan) {
    const FlightPlan::Station& early = plan.stations[plan.stations.size() / 5];
    const glm::vec3 eye{early.at_m.x, floor_m(lookout.land(), early.at_m) + 3.0F, early.at_m.y};
    const Outlook seen = lookout.outlook({eye, eye + glm::vec3{early.ahead.x, -0.08F, early.ahead.y}, 42.0F});
    return view_merit(seen) - 4.0F * std::max(seen.water - 0.25F, 0.0F);
}

bool is_within(const FlightPlan& plan, float most_m) {
    return std::ranges::all_of(plan.stations, [&](const FlightPlan::Station& station) {
        return std::max(std::abs(station.at_m.x), std::abs(station.at_m.y)) < most_m;
    });
}

// Flights before landmarks, each seen from where it shows its face and a little beside the picture's middle. None that
// looks far away from the north: the land is composed to be seen so.
std::vector<FlightPlan> before_landmarks(const scene::Land& land, const FlightPlan& plan) {
    constexpr std::size_t kMost = 3;
    constexpr float kWidest_rad = 0.8F;
    std::vector<FlightPlan> plans;
    for (std::size_t i = 0; i < std::min(land.landmarks.size(), kMost); ++i) {
        const scene::Landmark& mark = land.landmarks[i];
        const float bearing = std::atan2(-mark.faces.x, mark.faces.y);
        for (const float sizes : {2.6F, 4.2F}) {
            // A mouth that faces east or west shows well enough from aside.
            for (const float turn : {-0.75F, -0.4F, 0.0F, 0.4F, 0.75F}) {
                if (std::abs(turn) > 0.5F && !mark.has_front) continue;
                const float toward_rad = bearing + turn;
                if (std::abs(toward_rad) > kWidest_rad) continue;
                const float away_m = std::clamp(sizes * mark.size_m, 34.0F, 170.0F);
                const glm::vec2 at = glm::vec2{mark.at_m.x, mark.at_m.z} - away_m * toward(toward_rad);
                FlightPlan there = moved(plan, at, toward(toward_rad + (turn < 0 ? 0.09F : -0.09F)));
                if (is_within(there, 440)) plans.push_back(std::move(there));
            }
        }
    }
    return plans;
}

// Flights beside roads: one leads into the picture from below, a little off its middle. Toward the north, as above.
std::vector<FlightPlan> along_roads(const scene::Land& land, const FlightPlan& plan) {
    constexpr std::size_t kMost = 8;
    constexpr float kWidest_rad = 0.7F;
    constexpr float kAhead_m = 36;  // of what is looked along
    std::vector<FlightPlan> plans;
    for (const scene::Road& road : land.roads) {
        if (road.is_lane) continue;
        for (std::size_t i = 0, next = 0; i < road.line_m.size(); i = next) {
            const glm::vec2 from{road.line_m[i].x, road.line_m[i].z};
            const auto far_from = [&](const glm::vec3& p) { return glm::distance(glm::vec2{p.x, p.z}, from); };
            for (next = i + 1; next < road.line_m.size() && far_from(road.line_m[next]) < kAhead_m;) ++next;
            if (next >= road.line_m.size()) break;
            glm::vec2 way = glm::normalize(glm::vec2{road.line_m[next].x, road.line_m[next].z} - from);
            glm::vec2 begins = from;
            if (way.y > 0) {
                way = -way;
                begins = {road.line_m[next].x, road.line_m[next].z};
            }
            const float bearing = std::atan2(way.x, -way.y);
            if (std::abs(bearing) > kWidest_rad) continue;
            const float side = plans.size() % 2 == 0 ? 1.0F : -1.0F;
            const glm::vec2 at = begins - 9.0F * way + side * (0.5F * road.width_m + 3.0F) * glm::vec2{-way.y, way.x};
            FlightPlan there = moved(plan, at, toward(bearing - 0.16F * side));
            if (is_within(there, 440)) plans.push_back(std::move(there));
        }
    }
    // Some from all along them.
    while (plans.size() > kMost)
        for (std::size_t i = plans.size(); i-- > 0 && plans.size() > kMost;)
            if (i % 2 == 1) plans.erase(plans.begin() + static_cast<std::ptrdiff_t>(i));
    return plans;
}

}  // namespace

FlightPlan fitted_to(const Lookout& lookout, FlightPlan plan) {
    // Ahead and aside, in metres; the land's edge is behind.
    constexpr std::array<glm::vec2, 9> kMoves{
        {{0, 0}, {70, 0}, {-40, 0}, {0, 80}, {0, -80}, {70, 80}, {70, -80}, {-40, 80}, {-40, -80}}};
    const FlightPlan::Station early = plan.stations[plan.stations.size() / 5];
    const glm::vec2 aside{-early.ahead.y, early.ahead.x};
    std::vector<FlightPlan> others = before_landmarks(lookout.land(), plan);
    for (FlightPlan& beside : along_roads(lookout.land(), plan)) others.push_back(std::move(beside));
    for (const glm::vec2& move : kMoves) {
        if (move == glm::vec2{0}) continue;
        others.push_back(plan);
        for (FlightPlan::Station& station : others.back().stations)
            station.at_m += move.x * early.ahead + move.y * aside;
    }
    float most = merit_of(lookout, plan) + 0.15F;
    for (FlightPlan& other : others) {
        const float merit = merit_of(lookout, other);
        if (merit <= most) continue;
        most = merit;
        plan = std::move(other);
    }
    return plan;
}

scene::Track fly(const FlightPlan& plan, const Lookout& lookout, base::Seed flight) {
    const scene::Land& land = lookout.land();
    base::RandomStream random{flight.child("height")};
    const float over_m = random.between(0.0F, 1.6F);
    std::vector<float> eyes_m;
    for (const FlightPlan::Station& station : plan.stations) {
        const float low = clear_m(land, station.at_m, over_m);
        eyes_m.push_back(std::clamp(sight_m(land, station), low, low + 2.5F));
    }
    eyes_m = smoothed_over(eyes_m, 5);
    std::vector<float> pitches;
    for (std::size_t i = 0; i < eyes_m.size(); ++i) {
        const float up = skyline_rad(land, plan.stations[i], eyes_m[i]);
        pitches.push_back(std::clamp(0.42F * up - glm::radians(1.8F), glm::radians(-5.0F), glm::radians(5.0F)));
    }
    pitches = smoothed_over(pitches, 8);
    std::vector<float> lower;
    const float lifted_m = land.settlement.is_empty() ? 0.0F : kLiftsOverRoofs_m[1];
    for (std::size_t i = 0; i < eyes_m.size(); ++i)
        lower.push_back(lower_rad(land, plan.stations[i], eyes_m[i] + lifted_m, pitches[i]));
    lower = smoothed_over(lower, 8);
    for (std::size_t i = 0; i < eyes_m.size(); ++i) pitches[i] -= lower[i];
    const Flown flown{plan, eyes_m, pitches};
    const Manner manner = best_manner(flown, lookout);
    scene::Track track;
    track.period_s = kPeriod_s;
    for (std::size_t i = 0; i < eyes_m.size(); ++i) track.cameras.push_back(flown.camera(i, manner));
    return track;
}

}  // namespace quadrat::synthesis
