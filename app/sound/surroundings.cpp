// SPDX-License-Identifier: Apache-2.0
#include "sound/surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "scene/parameters.hpp"
#include "sound/tones.hpp"

namespace quadrat::sound {
namespace {

// What of a day decides who sings.
struct Hour {
    float day = 1;      // 1 by day, 0 at night
    float morning = 0;  // the sun is low in the east
    float evening = 0;  // the sun is low in the west
    float dry = 1;      // 1 without rain or snow
    float warm = 1;     // 0 where snow lies, or falls
    float calm = 1;     // 0 in a gale
};

Hour hour_of(const scene::SceneParameters& p) {
    Hour hour;
    hour.day = 1.0F - share_of(p.sky.night_share, -0.1F, 0.4F);
    const float low = 1.0F - share_of(p.sky.sun_elevation_deg, 8, 26);
    (p.sky.sun_azimuth_deg > 0 ? hour.morning : hour.evening) = low * hour.day;
    const float falling = std::max(share_of(p.sky.rain_share, 0, 0.3F), share_of(p.sky.snowfall_share, 0, 0.3F));
    hour.dry = 1.0F - falling;
    hour.warm = share_of(p.land.ground_snow_line, 0.3F, 0.8F) * (1.0F - share_of(p.sky.snowfall_share, 0, 0.1F));
    hour.calm = 1.0F - 0.8F * share_of(p.sky.cloud_wind_m_s, 10, 22);
    return hour;
}

// How much of a tree is leaf, and how much of that is needles.
struct Foliage {
    float cover = 0;
    float needles = 0;
    float leaves = 0;
};

// Of kinds with leaves of their own, by the numbers of tree.habit, whether these are needles; of the others as the gene
// says. The kinds' files (app/synthesis/trees/kinds/) decide; a test compares them with these lists.
bool has_needles(const scene::TreeParameters& trees) {
    constexpr std::array kNeedlesOfTheirOwn{2L, 10L, 13L, 15L, 18L};  // fir, stone pine, pine, cypress, mountain pine
    constexpr std::array kOtherLeavesOfTheirOwn{3L, 4L, 5L};          // palm, cactus, willow
    constexpr long kNeedles = 5;
    const long habit = std::lround(trees.tree_habit);
    if (std::ranges::find(kNeedlesOfTheirOwn, habit) != kNeedlesOfTheirOwn.end()) return true;
    if (std::ranges::find(kOtherLeavesOfTheirOwn, habit) != kOtherLeavesOfTheirOwn.end()) return false;
    return std::lround(trees.tree_leaf_shape) == kNeedles;
}

Foliage foliage_of(const scene::TreeParameters& trees) {
    Foliage foliage;
    foliage.cover = 1.0F - 0.8F * share_of(trees.tree_spacing_m, 5, 22);
    const float leafy =
        (1.0F - share_of(trees.tree_bareness, 0.3F, 0.9F)) * share_of(trees.tree_leaf_density, 0.2F, 1.2F);
    const float needly = has_needles(trees) ? 1.0F : 0.0F;
    foliage.needles = foliage.cover * leafy * needly;
    foliage.leaves = foliage.cover * leafy * (1.0F - needly);
    return foliage;
}

void set_wind(Surroundings& heard, const scene::SceneParameters& p, const Foliage& foliage) {
    const float wind = share_of(p.sky.cloud_wind_m_s, 0.5F, 20);
    heard.set(Voice::Wind, wind * (1.0F - 0.4F * foliage.cover));
    heard.set(Voice::Leaves, foliage.leaves * (0.15F + 0.85F * wind));
    const float grass = 0.3F * (1.0F - foliage.cover);
    heard.set(Voice::Needles, (foliage.needles + grass) * (0.1F + 0.9F * wind));
}

void set_water(Surroundings& heard, const scene::SceneParameters& p) {
    const float sea = share_of(p.land.land_sea_level, 0.12F, 0.45F);
    const float islands = share_of(p.land.island_share, 0, 0.6F);
    const float wind = share_of(p.sky.cloud_wind_m_s, 0.5F, 20);
    heard.set(Voice::Surf, std::max(sea, islands) * (0.25F + 0.75F * wind));
    // The smaller the ground that feeds a river, the nearer the next one is.
    const float rivers = 1.0F - share_of(p.land.river_area_m2, 20'000, 140'000);
    const float falls = 0.5F + 0.5F * share_of(p.land.fall_height_m, 1.5F, 9);
    heard.set(Voice::Stream, 0.8F * rivers * falls * (1.0F - 0.6F * heard[Voice::Surf]));
    heard.set(Voice::Rain, share_of(p.sky.rain_share, 0, 1));
    heard.set(Voice::Thunder, share_of(p.sky.rain_share, 0.35F, 1) * share_of(p.sky.cloud_tower, 0.6F, 1.6F));
}

void set_animals(Surroundings& heard, const scene::SceneParameters& p, const Foliage& foliage) {
    const Hour hour = hour_of(p);
    const float quiet_weather = hour.dry * hour.calm;
    const float chorus = std::max({hour.morning, 0.7F * hour.evening, 0.35F * hour.day});
    heard.set(Voice::Songbirds, chorus * quiet_weather * (0.3F + 0.7F * foliage.cover) * (0.25F + 0.75F * hour.warm));
    heard.set(Voice::Gulls, 0.7F * heard[Voice::Surf] * hour.day * hour.dry);
    const float night = 1.0F - hour.day;
    heard.set(Voice::Owls, night * quiet_weather * foliage.cover);
    const float still_water = std::max(share_of(p.land.marsh_share, 0, 0.5F), 0.6F * heard[Voice::Stream]);
    heard.set(Voice::Frogs, std::max(night, 0.5F * hour.evening) * hour.warm * still_water);
    const float dry_ground = 1.0F - share_of(p.land.ground_lushness, 0, 1);
    heard.set(Voice::Crickets, std::max(night, hour.evening) * hour.warm * quiet_weather * (0.4F + 0.6F * dry_ground));
    const float hot = hour.warm * dry_ground * share_of(p.sky.sun_elevation_deg, 30, 60);
    heard.set(Voice::Cicadas, hour.day * hot * quiet_weather * foliage.cover);
}

}  // namespace

std::string_view name_of(Voice voice) {
    constexpr std::array<std::string_view, kVoices> kNames{"wind",  "leaves",   "needles",   "stream", "surf",
                                                           "rain",  "thunder",  "songbirds", "gulls",  "owls",
                                                           "frogs", "crickets", "cicadas",   "bells"};
    return kNames[static_cast<std::size_t>(voice)];
}

void Surroundings::set(Voice voice, float share) {
    shares_[static_cast<std::size_t>(voice)] = std::clamp(share, 0.0F, 1.0F);
}

Surroundings surroundings_of(const scene::SceneParameters& parameters) {
    Surroundings heard;
    const Foliage foliage = foliage_of(parameters.trees);
    set_wind(heard, parameters, foliage);
    set_water(heard, parameters);
    set_animals(heard, parameters, foliage);
    const bool has_chapel = parameters.land.settle_chapel > 0 && parameters.land.settle_age > 0.2F;
    heard.set(Voice::Bells, has_chapel ? 0.4F + 0.6F * share_of(parameters.land.settle_age, 0.2F, 1) : 0);
    return heard;
}

Surroundings blend(std::span<const Surroundings> several) {
    Surroundings mean;
    if (several.empty()) return mean;
    for (std::size_t i = 0; i < kVoices; ++i) {
        const auto voice = static_cast<Voice>(i);
        float sum = 0;
        for (const Surroundings& one : several) sum += one[voice];
        mean.set(voice, sum / static_cast<float>(several.size()));
    }
    return mean;
}

Surroundings between(const Surroundings& from, const Surroundings& to, float share) {
    Surroundings mixed;
    for (std::size_t i = 0; i < kVoices; ++i) {
        const auto voice = static_cast<Voice>(i);
        mixed.set(voice, from[voice] + (to[voice] - from[voice]) * std::clamp(share, 0.0F, 1.0F));
    }
    return mixed;
}

}  // namespace quadrat::sound
