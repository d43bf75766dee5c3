// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "scene/colour.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"
#include "synthesis/compose/competition.hpp"
#include "synthesis/compose/track.hpp"

// What a plant finds where it would stand: how the place lies to the camera's way, its soil and its shade.
namespace quadrat::synthesis {

inline constexpr float kShore_m = 0.45F;  // nothing roots lower over the water
inline constexpr float kEdge_m = 10.0F;   // nor nearer to the land's edge

struct View {
    float along_m;   // in front of the nearest station
    float aside;     // tangent of the angle off its view
    float to_way_m;  // distance from the camera's way
};

// How places lie to the flight; the nearest station is looked up, not searched for.
class Sight {
  public:
    Sight(const FlightPlan& flight, float half_m) : flight_(flight), half_m_(half_m) {
        side_ = std::max(static_cast<int>(std::ceil(2 * half_m / kCell_m)), 1);
        nearest_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        oneapi::tbb::parallel_for(0, side_, [&](int row) {
            for (int column = 0; column < side_; ++column) {
                const glm::vec2 at = (glm::vec2{column, row} + 0.5F) * kCell_m - half_m_;
                float best = 1.0e18F;
                for (std::size_t i = 0; i < flight.stations.size(); ++i) {
                    const glm::vec2 d = at - flight.stations[i].at_m;
                    if (glm::dot(d, d) >= best) continue;
                    best = glm::dot(d, d);
                    nearest_[index(column, row)] = static_cast<std::uint16_t>(i);
                }
            }
        });
    }

    View view_of(glm::vec2 at) const {
        const auto cell = [this](float m) {
            return std::clamp(static_cast<int>((m + half_m_) / kCell_m), 0, side_ - 1);
        };
        const FlightPlan::Station& station = flight_.stations[nearest_[index(cell(at.x), cell(at.y))]];
        const glm::vec2 d = at - station.at_m;
        View view{};
        view.to_way_m = glm::length(d);
        view.along_m = glm::dot(d, station.ahead);
        view.aside = std::abs(d.x * station.ahead.y - d.y * station.ahead.x) / std::max(view.along_m, 0.1F);
        return view;
    }

    bool is_in_the_way(glm::vec2 at, float radius_m) const {
        if (view_of(at).to_way_m > radius_m + 58.0F) return false;
        for (const FlightPlan::Station& station : flight_.stations) {
            const glm::vec2 d = at - station.at_m;
            if (glm::length(d) < radius_m + 5.0F) return true;
            const float along = glm::dot(d, station.ahead);
            const float aside = std::abs(d.x * station.ahead.y - d.y * station.ahead.x);
            // Before the camera the middle of the picture stays open.
            if (along > 0 && along < 55.0F && aside < radius_m + 0.36F * along) return true;
        }
        return false;
    }

    const FlightPlan& flight() const { return flight_; }

    // The box about all places on the land that lie so near to the camera's way, and some around.
    struct Window {
        glm::vec2 low_m{1.0e6F};
        glm::vec2 high_m{-1.0e6F};
    };
    Window window(float reach_m) const {
        Window window;
        for (const FlightPlan::Station& station : flight_.stations) {
            window.low_m = glm::min(window.low_m, station.at_m - reach_m);
            window.high_m = glm::max(window.high_m, station.at_m + reach_m);
        }
        return {glm::max(window.low_m, glm::vec2{-half_m_}), glm::min(window.high_m, glm::vec2{half_m_})};
    }

    // Where a place a metre or more before its station, at most so wide off its view and so far from the way may lie:
    // true for all of them, and for some around. Cheaper than asking place by place.
    class Region {
      public:
        bool may_hold(glm::vec2 at) const { return is_near_.at(cell(at.x), cell(at.y)) != 0; }

      private:
        friend class Sight;
        Region(float half_m, int side) : half_m_(half_m), is_near_(side, side, 0) {}
        int cell(float m) const {
            return std::clamp(static_cast<int>((m + half_m_) / kCell_m), 0, is_near_.columns - 1);
        }
        float half_m_;
        mesh::Grid<std::uint8_t> is_near_;
    };
    Region region(float widest_aside, float reach_m) const {
        constexpr float kHalfDiagonal_m = 0.7072F * kCell_m;
        Region region(half_m_, side_);
        for (int row = 0; row < side_; ++row) {
            for (int column = 0; column < side_; ++column) {
                const FlightPlan::Station& station = flight_.stations[nearest_[index(column, row)]];
                const glm::vec2 d = (glm::vec2{column, row} + 0.5F) * kCell_m - half_m_ - station.at_m;
                const float along_m = glm::dot(d, station.ahead) + kHalfDiagonal_m;
                const float aside_m = std::abs(d.x * station.ahead.y - d.y * station.ahead.x) - kHalfDiagonal_m;
                if (along_m < 1 || aside_m > widest_aside * along_m || glm::length(d) - kHalfDiagonal_m > reach_m)
                    continue;
                // And the cells about it: who asks for the middle of a small square means all of it.
                for (int y = std::max(row - 1, 0); y <= std::min(row + 1, side_ - 1); ++y)
                    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, side_ - 1); ++x)
                        region.is_near_.at(x, y) = 1;
            }
        }
        return region;
    }

  private:
    static constexpr float kCell_m = 8;
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column);
    }
    const FlightPlan& flight_;
    float half_m_;
    int side_ = 1;
    std::vector<std::uint16_t> nearest_;
};

// The lines on which landmarks are looked at from the way: what the flight came to see, no tree hides.
class Vistas {
  public:
    Vistas(const scene::Land& land, const FlightPlan& flight) {
        constexpr float kFarthest_m = 240;
        constexpr float kWidest = 0.6F;  // tangent off the view
        if (flight.stations.empty()) return;
        const std::size_t last = flight.stations.size() - 1;
        for (const scene::Landmark& mark : land.landmarks) {
            for (const std::size_t i : {last / 5, last / 2}) {
                const FlightPlan::Station& station = flight.stations[i];
                const glm::vec2 to = glm::vec2{mark.at_m.x, mark.at_m.z} - station.at_m;
                const float along_m = glm::dot(to, station.ahead);
                const float aside_m = std::abs(to.x * station.ahead.y - to.y * station.ahead.x);
                if (along_m <= 0 || along_m > kFarthest_m || aside_m > kWidest * along_m) continue;
                lines_.push_back({station.at_m, to, 0.5F * mark.size_m});
            }
        }
    }

    bool are_closed_by(glm::vec2 at_m, float crown_m) const {
        return std::ranges::any_of(lines_, [&](const Line& line) {
            const float t = glm::dot(at_m - line.from_m, line.to) / std::max(glm::dot(line.to, line.to), 1.0F);
            if (t <= 0 || t >= 1) return false;
            return glm::length(at_m - line.from_m - t * line.to) < crown_m + t * line.half_m;
        });
    }

  private:
    struct Line {
        glm::vec2 from_m;
        glm::vec2 to;
        float half_m;  // of the landmark's breadth
    };
    std::vector<Line> lines_;
};

// What a plant finds where it stands.
struct Soil {
    float height_m;
    float slope;     // rise over run
    float moisture;  // 0 dry to 1 wet
    float stone;     // share of bare rock and scree, 0 to 1
    float snow_m;  // how far it lies above the snow line, where there is one that not all of the land lies above; or 0
    bool is_snowy;
};

// Where on an island a place lies: the beach, the bare dry land, the grass, as Hultquist, Gain and Cairns ("Affective
// scene generation", 2006) place palms, cacti and firs. Both 0 on grass.
struct Zone {
    float shore = 0;  // 1 on the lowest ground over the sea
    float arid = 0;   // 1 where nothing green covers what lies higher
};

class Ground {
  public:
    explicit Ground(const scene::Land& land) : land_(land) {}

    bool is_on_land(glm::vec2 at) const {
        return std::max(std::abs(at.x), std::abs(at.y)) < 0.5F * land_.side_m() - kEdge_m;
    }
    bool is_dry(glm::vec2 at, float lowest_m = kShore_m) const {
        return scene::ground_height_m(land_, at) >= lowest_m && scene::water_depth_m(land_, at) <= 0;
    }
    // Neither in the water nor on a road or a settlement's ground, nor nearer to one than room_m.
    bool is_free(glm::vec2 at, float room_m, float lowest_m = kShore_m) const {
        return is_dry(at, lowest_m) && scene::to_road_m(land_, at) > room_m;
    }

    Soil soil(glm::vec2 at) const {
        const glm::vec3 n = scene::ground_normal(land_, at);
        const float height_m = scene::ground_height_m(land_, at);
        const float slope = std::sqrt(std::max(0.0F, 1.0F - n.y * n.y)) / std::max(n.y, 0.05F);
        // Water runs off what is steep and high and stays low and level.
        const float low = std::clamp(1.0F - height_m / 26.0F, 0.0F, 1.0F);
        const float moisture = 0.42F + 0.58F * wetness(at) + 0.22F * low * low - 0.30F * std::min(slope, 1.0F) -
                               0.12F * std::clamp(height_m / 150.0F, 0.0F, 1.0F);
        constexpr float kLowestLine_m = 25;
        const float snow_m = land_.snow_line_m < kLowestLine_m ? 0 : std::max(height_m - land_.snow_line_m, 0.0F);
        return {height_m, slope, std::clamp(moisture, 0.0F, 1.0F), stone(at), snow_m, height_m > land_.snow_line_m};
    }

  private:
    float wetness(glm::vec2 at) const {
        const scene::GroundColours& albedo = land_.albedo;
        if (albedo.is_empty()) return 0;
        const auto px = [&](float m, int size) {
            return std::clamp(static_cast<int>((m / land_.side_m() + 0.5F) * static_cast<float>(size)), 0, size - 1);
        };
        return static_cast<float>(albedo.wetness(px(at.x, albedo.width()), px(at.y, albedo.height()))) / 255.0F;
    }
    float stone(glm::vec2 at) const {
        const mesh::Image& kinds = land_.kinds;
        if (kinds.bytes.empty()) return 0;
        const auto sample = [&](float m, int count) {
            return std::clamp(static_cast<int>((m / land_.side_m() + 0.5F) * static_cast<float>(count - 1) + 0.5F), 0,
                              count - 1);
        };
        return static_cast<float>(kinds.pixel(sample(at.x, kinds.width), sample(at.y, kinds.height))[1]) / 255.0F;
    }
    const scene::Land& land_;
};

// What roots find on bare stone: who lives on little water finds more.
inline float footing(const scene::Species& species, const Soil& soil) {
    constexpr float kFrom = 0.35F;
    constexpr float kWhole = 0.75F;
    const float bare = std::clamp((soil.stone - kFrom) / (kWhole - kFrom), 0.0F, 1.0F);
    const float frugal = std::clamp((0.5F - species.moisture) / 0.25F, 0.0F, 1.0F);
    constexpr float kLastTrees_m = 22;  // above the snow line
    return (1 - (0.94F - 0.4F * frugal) * bare) * std::max(1 - soil.snow_m / kLastTrees_m, 0.04F);
}

// The ground's colour in its picture, linear.
inline glm::vec3 albedo_at(const scene::Land& land, glm::vec2 at_m) {
    if (land.albedo.is_empty()) return land.far_colour;
    const auto px = [&](float m, int size) {
        return std::clamp(static_cast<int>((m / land.side_m() + 0.5F) * static_cast<float>(size)), 0, size - 1);
    };
    const glm::u8vec3 encoded = land.albedo.colour(px(at_m.x, land.albedo.width()), px(at_m.y, land.albedo.height()));
    return glm::pow(glm::vec3(encoded) / 255.0F, glm::vec3{2.2F});
}

// Whether the ground's picture shows snow here, 0 to 1: above the snow line it is broken and drifts.
inline float snow_at(const scene::Land& land, const glm::vec3& at_m) {
    if (at_m.y <= land.snow_line_m) return 0;
    const glm::vec3 colour = albedo_at(land, {at_m.x, at_m.z});
    return glm::smoothstep(0.20F, 0.42F, std::min({colour.r, colour.g, colour.b}));
}

// How well a species does on this soil, 0 to 1.
inline float welfare(const scene::Species& species, const Soil& soil) {
    const float above = std::clamp((soil.height_m - std::max(species.lowest_m, kShore_m)) / 1.5F, 0.0F, 1.0F);
    const float below =
        std::clamp((species.treeline_m - soil.height_m) / (0.12F * species.treeline_m + 1.0F), 0.0F, 1.0F);
    const float flat = std::clamp((species.steepest_slope - soil.slope) / 0.25F, 0.0F, 1.0F);
    const float off = std::abs(soil.moisture - species.moisture);
    const float moist = std::clamp(2.0F * (species.moisture_width - off) / species.moisture_width, 0.0F, 1.0F);
    // No palm in frost where anything else would grow; where nothing would, a few that do badly.
    const float frost = soil.is_snowy && species.is_tender ? 0.03F : 1.0F;
    return soil.height_m < kShore_m ? 0 : above * below * flat * moist * frost * footing(species, soil);
}

// The zones of a land: by height, and by how green the ground is painted beside the greenest of this land. So plants
// stand where the picture says that they would.
class Zones {
  public:
    explicit Zones(const scene::Land& land) : land_(land) {
        if (land.albedo.is_empty()) return;
        std::vector<float> all;
        const int step = std::max(land.albedo.width() / 64, 1);
        for (int y = step / 2; y < land.albedo.height(); y += step)
            for (int x = step / 2; x < land.albedo.width(); x += step) {
                const float m_per_px = land.side_m() / static_cast<float>(land.albedo.width());
                const glm::vec2 at_m =
                    m_per_px * glm::vec2{static_cast<float>(x), static_cast<float>(y)} - 0.5F * land.side_m();
                if (scene::ground_height_m(land, at_m) > kInland_m) all.push_back(redness({x, y}));
            }
        if (all.empty()) return;
        const auto twentieth = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 20);
        std::nth_element(all.begin(), twentieth, all.end());
        greenest_ = *twentieth;
    }

    Zone at(glm::vec2 at_m) const {
        if (land_.albedo.is_empty()) return {};
        const auto px = [&](float m, int size) {
            return std::clamp(static_cast<int>((m / land_.side_m() + 0.5F) * static_cast<float>(size)), 0, size - 1);
        };
        const float over = redness({px(at_m.x, land_.albedo.width()), px(at_m.y, land_.albedo.height())}) - greenest_;
        const float dry = std::clamp((over - 0.004F) / 0.010F, 0.0F, 1.0F);
        const float shore =
            std::clamp((kInland_m - scene::ground_height_m(land_, at_m)) / (kInland_m - kBeach_m), 0.0F, 1.0F);
        return {shore, dry * (1 - shore)};
    }

  private:
    static constexpr float kBeach_m = 2.0F;
    static constexpr float kInland_m = 6.0F;

    // a of OKLab: the less, the greener.
    float redness(glm::ivec2 px) const {
        const glm::vec3 srgb = glm::vec3(land_.albedo.colour(px.x, px.y)) / 255.0F;
        return scene::oklab_from_linear(
                   {scene::linear_from_srgb(srgb.r), scene::linear_from_srgb(srgb.g), scene::linear_from_srgb(srgb.b)})
            .y;
    }
    const scene::Land& land_;
    float greenest_ = -0.05F;
};

inline bool keeps_to_a_zone(const scene::Species& species) {
    return species.shore_liking != 0 || species.arid_liking != 0;
}

// How much rather it stands in this zone than others do that are not particular: 1. It says who grows here, not how
// many: alone, a species takes all the land on which it does well.
inline float at_home(const scene::Species& species, const Zone& zone) {
    constexpr float kLog2 = 6;
    // Who keeps out of a zone is at home in all others; who keeps to one, in no other.
    const auto like = [](float liking, float in_zone) { return liking * (liking < 0 ? in_zone : 2 * in_zone - 1); };
    const float shore = like(species.shore_liking, zone.shore);
    const float arid = like(species.arid_liking, zone.arid);
    return std::exp2(kLog2 * std::clamp(shore + arid, -1.0F, 1.0F));
}

// How much of the sky crowns hide, on a coarse grid over the land.
class Shade {
  public:
    Shade(const scene::Flora& flora, std::span<const Candidate> trees, float half_m)
        : half_m_(half_m),
          cover_(static_cast<int>(2 * half_m / kCell_m) + 1, static_cast<int>(2 * half_m / kCell_m) + 1, 0.0F) {
        for (const Candidate& tree : trees) {
            const float r = flora.species[tree.species].crown_radius_m * tree.scale;
            const int x0 = cell(tree.at_m.x - r);
            const int x1 = cell(tree.at_m.x + r);
            const int y0 = cell(tree.at_m.y - r);
            const int y1 = cell(tree.at_m.y + r);
            for (int y = y0; y <= y1; ++y) {
                for (int x = x0; x <= x1; ++x) {
                    const glm::vec2 d = (glm::vec2{x, y} + 0.5F) * kCell_m - half_m_ - tree.at_m;
                    const float in = 1.0F - glm::dot(d, d) / (r * r);
                    if (in > 0) cover_.at(x, y) = std::max(cover_.at(x, y), std::min(1.0F, 1.6F * in));
                }
            }
        }
    }
    float at(glm::vec2 p) const {
        return mesh::sample(cover_, (p.x + half_m_) / kCell_m - 0.5F, (p.y + half_m_) / kCell_m - 0.5F);
    }

  private:
    static constexpr float kCell_m = 2;
    int cell(float m) const { return std::clamp(static_cast<int>((m + half_m_) / kCell_m), 0, cover_.columns - 1); }
    float half_m_;
    mesh::Field cover_;
};

}  // namespace quadrat::synthesis
