// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/mirror.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <vector>

#include "base/seed.hpp"
#include "scene/colour.hpp"
#include "scene/lamps.hpp"
#include "scene/night_eye.hpp"
#include "scene/withering.hpp"
#include "synthesis/compose/view_rays.hpp"

namespace quadrat::synthesis {
namespace {

constexpr int kWidth = 768;
constexpr int kHeight = 96;
constexpr float kNearest_m = 3.0F;
constexpr float kGrowth = 1.04F;  // of the distance from one look at the ground to the next
constexpr float kReach_m = 7500.0F;
constexpr float kOpen_m = 4000.0F;  // where the shore is taken to be if there is none

struct Water {
    glm::vec3 at_m;  // on its surface
    float bearing_rad;
};

constexpr int kSoftPasses = 3;
constexpr float kBelow = -1.0e8F;

// Of the ground, at one look.
struct Seen {
    float rise = -1.0e9F;  // over the water, for its distance
    glm::vec3 light{0};
};

glm::vec2 way_of(float bearing_rad) { return {std::sin(bearing_rad), -std::cos(bearing_rad)}; }

// Above the sea; none where the ground is dry.
std::optional<float> water_level_m(const scene::Land& land, glm::vec2 at) {
    const float depth_m = scene::water_depth_m(land, at);
    const float ground_m = scene::ground_height_m(land, at);
    if (depth_m > 0) return ground_m + depth_m;
    if (ground_m < 0) return 0.0F;
    return std::nullopt;
}

// The level that most of the flight's rays meet, and where they meet it first.
std::optional<Water> water_seen(const scene::Land& land, const scene::Track& track) {
    // The way out takes half of the period.
    const scene::Camera camera = scene::camera_at(track, 0.25F * track.period_s);
    std::vector<float> levels_m;
    for (const float share : {0.0F, 0.25F, 0.5F}) {
        const scene::Camera from = scene::camera_at(track, share * track.period_s);
        for (const glm::vec3& ray : view_rays(from)) {
            const Hit hit = first_hit(land, from.eye_m, ray);
            if (!hit.is_water || hit.distance_m >= kFarthest_m) continue;
            const glm::vec3 at = from.eye_m + hit.distance_m * ray;
            levels_m.push_back(std::max(water_level_m(land, {at.x, at.z}).value_or(0.0F), 0.0F));
        }
    }
    if (levels_m.empty()) return std::nullopt;
    const auto middle = levels_m.begin() + static_cast<std::ptrdiff_t>(levels_m.size() / 2);
    std::ranges::nth_element(levels_m, middle);
    const glm::vec3 ahead = camera.target_m - camera.eye_m;
    return Water{{camera.eye_m.x, *middle, camera.eye_m.z}, std::atan2(ahead.x, -ahead.z)};
}

// The sky as it is seen, clouds and all.
glm::vec3 sky_light(const scene::Sky& sky, const glm::vec3& direction) {
    const scene::CloudLayer& high = sky.clouds[1];
    glm::vec3 seen = sky.dome.radiance(direction);
    const float clear = 1.0F - std::exp2(-22.0F * std::max(direction.y, 0.0F));
    const float veil = high.opacity * high.mean_density * clear;
    seen = glm::mix(seen, glm::mix(high.shaded, high.sunlit, high.mean_lit), veil);
    const float near_disc = std::exp2(22.0F * (glm::dot(direction, sky.sun_direction) - 1.0F));
    seen += sky.glare * (near_disc * near_disc);
    if (sky.cloudscape.bytes.empty()) return scene::mean_radiance(sky, direction);
    const glm::vec2 at = scene::cloudscape_at(direction);
    const scene::Cloudscape& clouds = sky.cloudscape;
    const int x = std::clamp(static_cast<int>(at.x * static_cast<float>(clouds.width)), 0, clouds.width - 1);
    const int y = std::clamp(static_cast<int>(at.y * static_cast<float>(clouds.height)), 0, clouds.height - 1);
    const float opacity = clear * static_cast<float>(clouds.pixel(x, y)[0]) / 255.0F;
    const float light = clear * static_cast<float>(clouds.pixel(x, y)[1]) / 255.0F;
    const scene::CloudLayer& low = sky.clouds[0];
    return seen + (low.shaded - seen) * opacity + (low.sunlit - low.shaded) * light;
}

class Painting {
  public:
    Painting(const scene::Scene& scene, const Water& water)
        : scene_(scene), water_(water), light_(kWidth, kHeight), away_m_(kWidth, kHeight, 1.0e9F) {
        const glm::vec3 up{0, 1, 0};
        on_level_ = scene.sky->ambient.on(up) + scene.sky->sunlight * std::max(scene.sky->sun_direction.y, 0.0F);
        shore_m_.assign(kWidth, -1.0F);
        for (int y = 0; y < kHeight; ++y) rise_.push_back(scene::mirror_rise((static_cast<float>(y) + 0.5F) / kHeight));
    }

    // Where the water ends over each bearing, on its far side; from the nearest bearing that has water where one has
    // none. False where none of them has: the flight sees water that its middle does not look over.
    [[nodiscard]] bool find_shores() {
        oneapi::tbb::parallel_for(0, kWidth, [&](int x) { shore_m_[static_cast<std::size_t>(x)] = shore_over(x); });
        if (std::ranges::all_of(shore_m_, [](float m) { return m <= 0; })) return false;
        const std::vector<float> known = shore_m_;
        for (int x = 0; x < kWidth; ++x) {
            if (known[static_cast<std::size_t>(x)] > 0) continue;
            for (int away = 1; away < kWidth; ++away) {
                const auto left = static_cast<std::size_t>(std::max(x - away, 0));
                const auto right = static_cast<std::size_t>(std::min(x + away, kWidth - 1));
                shore_m_[static_cast<std::size_t>(x)] = std::max(known[left], known[right]);
                if (shore_m_[static_cast<std::size_t>(x)] > 0) break;
            }
        }
        return true;
    }

    void paint_column(int x) {
        const glm::vec2 way = way_of(bearing_of(x));
        int filled = 0;  // rows from the horizon up that land hides
        Seen before;     // the look at the ground before this one
        for (float away_m = 0.98F * shore_m_[static_cast<std::size_t>(x)]; away_m < kReach_m; away_m *= kGrowth) {
            const glm::vec2 at = glm::vec2{water_.at_m.x, water_.at_m.z} + away_m * way;
            const float over_m = scene::ground_height_m(*scene_.land, at) - water_.at_m.y;
            const Seen now{over_m / away_m,
                           through_air(ground_light(at), {at.x, over_m + water_.at_m.y, at.y}, away_m)};
            // What lies between two looks is between them in colour too: a slope is no staircase.
            const bool is_slope = before.rise > kBelow && now.rise > before.rise;
            while (filled < kHeight && rise_[static_cast<std::size_t>(filled)] < now.rise) {
                const float rise = rise_[static_cast<std::size_t>(filled)];
                const float t = is_slope ? std::clamp((rise - before.rise) / (now.rise - before.rise), 0.0F, 1.0F) : 1;
                light_.at(x, filled) = glm::mix(before.light, now.light, t);
                away_m_.at(x, filled) = away_m;
                ++filled;
            }
            before = now;
        }
        for (int y = filled; y < kHeight; ++y) {
            const float t = rise_[static_cast<std::size_t>(y)];
            light_.at(x, y) = in_air(glm::normalize(glm::vec3{way.x, t, way.y}));
        }
    }

    // Those on the far side of the water, in front of what land is farther.
    void paint_plant(const scene::Plant& plant, const glm::vec3& leaf, bool is_pointed) {
        const scene::Species& species = scene_.flora->species[plant.species];
        const glm::vec2 from{plant.root_m.x - water_.at_m.x, plant.root_m.z - water_.at_m.z};
        const float away_m = glm::length(from);
        float off = std::atan2(from.x, -from.y) - water_.bearing_rad;
        off -= 6.2831853F * std::round(off / 6.2831853F);
        const float middle = scene::mirror_at(off, 0).x * kWidth;
        const float wide = species.crown_radius_m * plant.scale / away_m / scene::Mirror::kWide_rad * kWidth;
        const float tall_m = species.height_m * plant.scale;
        const float foot = (plant.root_m.y - water_.at_m.y) / away_m;
        const float top = (plant.root_m.y + tall_m - water_.at_m.y) / away_m;
        if (away_m < kNearest_m || top <= 0) return;
        const float sun = 0.25F + 0.5F * plant.sun;
        const glm::vec3 lit =
            seen(leaf) * (scene_.sky->ambient.on({0, 1, 0}) * 0.75F + scene_.sky->sunlight * (0.55F * sun));
        const glm::vec3 shown = through_air(lit, plant.root_m + glm::vec3{0, 0.5F * tall_m, 0}, away_m);
        const std::uint64_t own =
            base::hash_of(base::Seed{7}, static_cast<int>(plant.root_m.x * 8), static_cast<int>(plant.root_m.z * 8));
        for (int x = std::max(static_cast<int>(middle - wide), 0);
             x <= std::min(static_cast<int>(middle + wide), kWidth - 1); ++x) {
            if (away_m < 0.97F * shore_m_[static_cast<std::size_t>(x)] - 2.0F) continue;
            const float aside = std::min(std::abs(static_cast<float>(x) + 0.5F - middle) / std::max(wide, 0.5F), 1.0F);
            const float ragged = 0.9F + 0.2F * base::unit_of(base::hash_of(base::Seed{own}, x, 0));
            const float crown = is_pointed ? 1.0F - 0.85F * aside : 0.62F + 0.38F * std::sqrt(1.0F - aside * aside);
            const float below = is_pointed ? 0.08F : 0.62F - 0.34F * std::sqrt(1.0F - aside * aside);
            const float high = glm::mix(foot, top, std::min(crown * ragged, 1.0F));
            const float low = aside < 0.12F ? foot : glm::mix(foot, top, below);
            for (int y = 0; y < kHeight; ++y) {
                const float t = rise_[static_cast<std::size_t>(y)];
                if (t > high) break;
                if (t < low || away_m_.at(x, y) < away_m) continue;
                // Darker toward its foot.
                light_.at(x, y) = shown * (0.7F + 0.5F * (t - foot) / std::max(top - foot, 1.0e-3F));
                away_m_.at(x, y) = away_m;
            }
        }
    }

    // By the house's coarsest level; a lit window shines.
    void paint_house(const scene::Masses& masses, const scene::House& house) {
        const float lit_share = scene::lit_windows(scene_.land->settlement, *scene_.sky);
        for (std::size_t i = 0; i + 2 < masses.mesh.indices.size(); i += 3) {
            const std::uint32_t first = masses.mesh.indices[i];
            const glm::vec3 normal = scene::turned(house, masses.mesh.normals[first]);
            const float facing = std::max(glm::dot(normal, scene_.sky->sun_direction), 0.0F) * scene_.houses_sun;
            glm::vec3 lit =
                seen(masses.colours[first]) * (scene_.sky->ambient.on(normal) + facing * scene_.sky->sunlight);
            if (scene::is_lit(masses.lamps[first], house.evening, lit_share))
                lit = glm::vec3{1.0F, 0.6F, 0.2F} / std::max(scene_.exposure, 0.1F);
            std::array<glm::vec3, 3> corners;  // column, rise, distance
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = in_picture(scene::placed(house, masses.mesh.positions_m[masses.mesh.indices[i + k]]));
            paint_triangle(corners, through_air(lit, house.foot_m, std::max(corners[0].z, kNearest_m)));
        }
    }

    // Still water is never glass: what it shows is a little soft, along the shore more than upward.
    void soften() {
        for (int pass = 0; pass < kSoftPasses; ++pass)
            light_ = mixed_with_neighbours(light_, pass == 0 ? glm::ivec2{0, 1} : glm::ivec2{1, 0});
    }

    scene::Mirror take() const {
        scene::Mirror mirror;
        mirror.at_m = water_.at_m;
        mirror.middle_rad = water_.bearing_rad;
        mirror.light = mesh::Image(kWidth, kHeight, 4);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const glm::vec3 root = glm::sqrt(glm::clamp(light_.at(x, y) * 0.25F, 0.0F, 1.0F)) * 255.0F + 0.5F;
                for (int c = 0; c < 3; ++c) mirror.light.pixel(x, y)[c] = static_cast<std::uint8_t>(root[c]);
            }
        }
        mirror.shore_m = shores();
        return mirror;
    }

  private:
    static mesh::Grid<glm::vec3> mixed_with_neighbours(const mesh::Grid<glm::vec3>& sharp, const glm::ivec2& step) {
        mesh::Grid<glm::vec3> soft(kWidth, kHeight);
        oneapi::tbb::parallel_for(0, kHeight, [&](int y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto at = [&](int way) -> const glm::vec3& {
                    return sharp.at(std::clamp(x + way * step.x, 0, kWidth - 1),
                                    std::clamp(y + way * step.y, 0, kHeight - 1));
                };
                soft.at(x, y) = 0.25F * (at(-1) + at(1)) + 0.5F * at(0);
            }
        });
        return soft;
    }

    glm::vec3 in_picture(const glm::vec3& at_m) const {
        const glm::vec2 from{at_m.x - water_.at_m.x, at_m.z - water_.at_m.z};
        const float away_m = std::max(glm::length(from), 1.0F);
        float off = std::atan2(from.x, -from.y) - water_.bearing_rad;
        off -= 6.2831853F * std::round(off / 6.2831853F);
        return {scene::mirror_at(off, 0).x * kWidth, (at_m.y - water_.at_m.y) / away_m, away_m};
    }

    void paint_triangle(const std::array<glm::vec3, 3>& p, const glm::vec3& seen) {
        const float left = std::min({p[0].x, p[1].x, p[2].x});
        const float right = std::max({p[0].x, p[1].x, p[2].x});
        const float away_m = (p[0].z + p[1].z + p[2].z) / 3;
        if (away_m < kNearest_m || right - left > 0.25F * kWidth) return;
        for (int x = std::max(static_cast<int>(left), 0); x <= std::min(static_cast<int>(right), kWidth - 1); ++x) {
            if (away_m < 0.97F * shore_m_[static_cast<std::size_t>(x)] - 2.0F) continue;
            const float at = std::clamp(static_cast<float>(x) + 0.5F, left, right);
            float low = 1.0e9F;
            float high = -1.0e9F;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec3& a = p[k];
                const glm::vec3& b = p[(k + 1) % 3];
                if ((a.x > at) == (b.x > at) && a.x != at) continue;
                const float t = b.x == a.x ? 0.0F : std::clamp((at - a.x) / (b.x - a.x), 0.0F, 1.0F);
                low = std::min(low, a.y + t * (b.y - a.y));
                high = std::max(high, a.y + t * (b.y - a.y));
            }
            for (int y = 0; y < kHeight && rise_[static_cast<std::size_t>(y)] <= high; ++y) {
                if (rise_[static_cast<std::size_t>(y)] < low || away_m_.at(x, y) < away_m) continue;
                light_.at(x, y) = seen;
                away_m_.at(x, y) = away_m;
            }
        }
    }

    // Less than 0: there is no water.
    float shore_over(int x) const {
        const glm::vec2 way = way_of(bearing_of(x));
        float wet_m = 0;  // of water of this level, without a break
        float widest_m = 0;
        float shore_m = -1;
        float before_m = kNearest_m;
        for (float away_m = kNearest_m; away_m < kReach_m; away_m *= kGrowth) {
            const auto level_m = water_level_m(*scene_.land, glm::vec2{water_.at_m.x, water_.at_m.z} + away_m * way);
            const bool is_wet = level_m && std::abs(*level_m - water_.at_m.y) < 2.0F;
            // What stands on the first shore is mirrored nearest; a much wider water beyond it counts more.
            if (!is_wet && wet_m > 2.5F * widest_m) {
                widest_m = wet_m;
                shore_m = 0.5F * (before_m + away_m);
            }
            wet_m = is_wet ? wet_m + away_m - before_m : 0;
            before_m = away_m;
        }
        return wet_m > 2.5F * widest_m ? kOpen_m : shore_m;
    }

    float bearing_of(int x) const {
        return water_.bearing_rad + ((static_cast<float>(x) + 0.5F) / kWidth - 0.5F) * scene::Mirror::kWide_rad;
    }

    // The middle one of each bearing's, evened out: what is mirrored is not to be torn.
    std::array<float, scene::Mirror::kBearings> shores() const {
        constexpr std::size_t kEach = kWidth / scene::Mirror::kBearings;
        constexpr int kReach = 2;
        std::array<float, scene::Mirror::kBearings> near{};
        for (std::size_t i = 0; i < near.size(); ++i) {
            std::vector<float> own(shore_m_.begin() + static_cast<std::ptrdiff_t>(i * kEach),
                                   shore_m_.begin() + static_cast<std::ptrdiff_t>((i + 1) * kEach));
            std::ranges::nth_element(own, own.begin() + kEach / 2);
            near[i] = own[kEach / 2];
        }
        std::array<float, scene::Mirror::kBearings> even{};
        const int last = static_cast<int>(near.size()) - 1;
        for (int i = 0; i <= last; ++i) {
            float sum = 0;
            for (int k = -kReach; k <= kReach; ++k)
                sum += 1.0F / near[static_cast<std::size_t>(std::clamp(i + k, 0, last))];
            even[static_cast<std::size_t>(i)] = (2 * kReach + 1) / sum;
        }
        return even;
    }

    glm::vec3 ground_light(glm::vec2 at) const {
        const scene::Land& land = *scene_.land;
        const float u = at.x / land.side_m() + 0.5F;
        const float v = at.y / land.side_m() + 0.5F;
        if (std::min(u, v) <= 0 || std::max(u, v) >= 1) return far_light(at);
        const mesh::Image& baked = scene_.light.ground;
        const auto within = [](float share, int size) {
            return std::min(static_cast<int>(share * static_cast<float>(size)), size - 1);
        };
        const std::uint8_t* lit = baked.pixel(within(u, baked.width), within(v, baked.height));
        const glm::vec3 own =
            linear(land.albedo.colour(within(u, land.albedo.width()), within(v, land.albedo.height())));
        return of_ground(own) * (glm::vec3{lit[0], lit[1], lit[2]} * (2.0F / 255));
    }
    glm::vec3 far_light(glm::vec2 at) const {
        const scene::Land& land = *scene_.land;
        const mesh::Image& colours = land.surround_albedo;
        if (colours.bytes.empty()) return land.far_colour * on_level_;
        const auto sample = [&](float along_m, int samples) {
            const float place = along_m / land.surround_cell_m + 0.5F * static_cast<float>(samples - 1);
            return std::clamp(static_cast<int>(place + 0.5F), 0, samples - 1);
        };
        const std::uint8_t* c = colours.pixel(sample(at.x, colours.width), sample(at.y, colours.height));
        const glm::vec3 normal = scene::ground_normal(land, at);
        const float facing = std::max(glm::dot(normal, scene_.sky->sun_direction), 0.0F);
        return of_ground(linear({c[0], c[1], c[2]})) * (scene_.sky->ambient.on(normal) + facing * scene_.sky->sunlight);
    }
    glm::vec3 seen(const glm::vec3& albedo) const {
        return scene::seen_by_night(albedo, scene::colour_seen(scene_.sky->darkness));
    }
    glm::vec3 of_ground(const glm::vec3& albedo) const {
        return seen(albedo * scene::withering_of(albedo, scene_.flora->cover.withered));
    }
    static glm::vec3 linear(const glm::u8vec3& encoded) {
        return {scene::linear_from_srgb(static_cast<float>(encoded.r) / 255),
                scene::linear_from_srgb(static_cast<float>(encoded.g) / 255),
                scene::linear_from_srgb(static_cast<float>(encoded.b) / 255)};
    }

    glm::vec3 haze_toward(const glm::vec3& direction) const {
        const float facing = 0.5F + 0.5F * glm::dot(direction, scene_.sky->glow_direction);
        const float sunward = facing * facing * facing * facing;
        return glm::mix(scene_.sky->haze_colour, scene_.sky->haze_sunward, sunward);
    }
    // As the renderer's air does.
    glm::vec3 through_air(const glm::vec3& light, const glm::vec3& at_m, float away_m) const {
        const scene::Sky& sky = *scene_.sky;
        const float between_m = std::max(0.5F * (at_m.y + water_.at_m.y), 0.0F);
        const float depth =
            away_m / sky.haze_distance_m * std::exp(-between_m / sky.haze_height_m) +
            away_m * sky.mist.per_m *
                std::exp(-std::max(at_m.y - scene_.floor_m - sky.mist.level_m, 0.0F) / sky.mist.depth_m);
        const glm::vec3 direction = glm::normalize(at_m - water_.at_m);
        return glm::mix(haze_toward(direction), light, std::exp(-depth));
    }
    glm::vec3 in_air(const glm::vec3& direction) const {
        const float air = std::exp2(-direction.y * (7.0F + 0.005F * scene_.sky->haze_distance_m));
        return glm::mix(sky_light(*scene_.sky, direction), haze_toward(direction), air);
    }

    const scene::Scene& scene_;
    Water water_;
    glm::vec3 on_level_{0};
    mesh::Grid<glm::vec3> light_;
    mesh::Field away_m_;
    std::vector<float> rise_;     // a row
    std::vector<float> shore_m_;  // a column: where the water ends
};

struct Foliage {
    glm::vec3 colour;
    bool is_pointed;
};

// By what a crown is mostly: the mean of its leaves, or bark where it has none.
Foliage foliage_of(const scene::Species& species) {
    Foliage foliage{species.bark_colour, species.height_m > 5.0F * species.crown_radius_m};
    const auto& leaves = species.leaves.vertices;
    if (leaves.empty()) return foliage;
    glm::vec3 sum{0};
    std::size_t count = 0;
    for (std::size_t i = 0; i < leaves.size(); i += 97, ++count)
        sum += leaves[i].colour * (0.4F + 0.6F * leaves[i].shade);
    foliage.colour = sum / static_cast<float>(count);
    return foliage;
}

}  // namespace

scene::Mirror hold_up_mirror(const scene::Scene& scene) {
    const auto water = water_seen(*scene.land, scene.track);
    if (!water || scene.light.ground.bytes.empty() || scene.land->albedo.is_empty()) return {};
    Painting painting(scene, *water);
    if (!painting.find_shores()) return {};
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, kWidth, 16), [&](const auto& columns) {
        for (int x = columns.begin(); x != columns.end(); ++x) painting.paint_column(x);
    });
    std::vector<Foliage> foliage;
    for (const scene::Species& species : scene.flora->species) foliage.push_back(foliage_of(species));
    for (const scene::Plant& plant : scene.plants)
        if (scene.flora->species[plant.species].storey != scene::Storey::Herb)
            painting.paint_plant(plant, foliage[plant.species].colour, foliage[plant.species].is_pointed);
    for (const scene::House& house : scene.land->settlement.houses)
        painting.paint_house(scene.land->settlement.buildings[house.building].levels.back(), house);
    painting.soften();
    return painting.take();
}

}  // namespace quadrat::synthesis
