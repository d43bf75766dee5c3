// SPDX-License-Identifier: Apache-2.0
// Parameters show. Of the classic genome the pictures at the two ends of every one's range differ, in one and the same
// scene. Of all of them nearly every one shows in some of a few scenes, as what a pine has for a bark shows on pines
// alone: between the scene's own value and the end that is farther from it, or between both ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

#include "genome/parameter_ids.hpp"
#include "scene/parameters.hpp"
#include "stage/easel.hpp"
#include "support/effort.hpp"
#include "unit/synthesis/scenes.hpp"

namespace quadrat::stage {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 135;
constexpr double kVisible = 12;

mesh::Image picture_with(Easel& easel, const genome::Parameter& parameter, float value) {
    pictures::Picture picture;
    picture.width = kWidth;
    picture.height = kHeight;
    genome::Recipe recipe = genome::random_recipe(base::Seed{12});
    recipe.values = genome::ParameterValues{};
    recipe.values.set(parameter.id, value);
    picture.scenes = {recipe};
    return easel.draw(picture, {nursery::grow(recipe, {129, 128, 256})});
}

// The mean over the share of pixels that differ most, of their largest channel difference in code values.
double visible_difference(const mesh::Image& a, const mesh::Image& b, double share) {
    std::vector<int> differences;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
            differences.push_back(most);
        }
    }
    std::ranges::sort(differences, std::greater<>{});
    const std::size_t few = static_cast<std::size_t>(share * static_cast<double>(differences.size()));
    double sum = 0;
    for (std::size_t i = 0; i < few; ++i) sum += differences[i];
    return sum / static_cast<double>(few);
}

TEST(Parameters, EveryClassicOneIsVisibleFromEndToEnd) {
    Easel easel(kWidth, kHeight);
    int seen = 0;
    for (const genome::Parameter& parameter : genome::parameter_table()) {
        if (parameter.genome != genome::Genome::Classic) continue;
        const mesh::Image low = picture_with(easel, parameter, parameter.min);
        const mesh::Image high = picture_with(easel, parameter, parameter.max);
        EXPECT_GT(visible_difference(low, high, 0.05), kVisible) << parameter.name;
        ++seen;
    }
    EXPECT_EQ(seen, 21);
}

// What shows only by night, in rain or before the sun is looked at there.
genome::Recipe where_it_shows(const genome::Parameter& parameter, genome::Recipe recipe) {
    using P = genome::ParameterId;
    const auto set = [&](std::initializer_list<std::pair<P, float>> values) {
        for (const auto& [id, value] : values) recipe.values.set(id, value);
    };
    const auto is_of = [&](std::string_view group) { return parameter.name.starts_with(group); };
    set({{P::mist_share, -3.0F}, {P::haze_distance_m, 3000.0F}, {P::rain_share, -4.0F}, {P::snowfall_share, -5.0F}});
    if (is_of("moon.") || is_of("star."))
        set({{P::night_share, 0.9F}, {P::cloud_cover, 0.05F}, {P::cirrus_cover, 0.0F}, {P::star_band, 0.8F}});
    if (is_of("rain."))
        set({{P::night_share, -3.0F}, {P::rain_share, 1.0F}, {P::cloud_wind_m_s, 20.0F}, {P::cloud_wind_deg, 90.0F}});
    if (is_of("bow.") || is_of("sun."))
        set({{P::night_share, -3.0F},
             {P::cloud_cover, 0.1F},
             {P::cirrus_cover, 0.0F},
             {P::sun_elevation_deg, 12.0F},
             {P::sun_azimuth_deg, is_of("bow.") ? 165.0F : 4.0F}});
    if (is_of("light.softness"))
        set({{P::night_share, -3.0F},
             {P::cloud_cover, 0.0F},
             {P::sun_elevation_deg, 8.0F},
             {P::sun_azimuth_deg, 85.0F}});
    return recipe;
}

bool is_conditional(const genome::Parameter& parameter) {
    for (const std::string_view group : {"moon.", "star.", "rain.", "bow.", "sun.size", "light.softness"})
        if (parameter.name.starts_with(group)) return true;
    return false;
}

// A scene of which one aspect at a time is grown anew.
class Stand {
  public:
    explicit Stand(const genome::Recipe& recipe) : recipe_(recipe) { parts_ = parts_of(recipe.values, nullptr); }

    // How much a parameter shows: between its own value here and the end that is farther from it, which is one picture
    // for each parameter; only where that is too little, between both ends.
    double most_visible(Easel& easel, const genome::Parameter& parameter, double enough) {
        if (own_.width == 0) own_ = picture_of(easel, parts_);
        const float own = recipe_.values[parameter.id];
        const bool is_high = own > 0.5F * (parameter.min + parameter.max);
        const mesh::Image far_end = picture_with(easel, parameter, is_high ? parameter.min : parameter.max);
        const double from_own = visible_difference(own_, far_end, 0.01);
        if (from_own > enough) return from_own;
        return visible_difference(picture_with(easel, parameter, is_high ? parameter.max : parameter.min), far_end,
                                  0.01);
    }

  private:
    static constexpr scene::Fineness kFineness{129, 128, 256};
    struct Parts {
        std::shared_ptr<const scene::Flora> flora;
        std::shared_ptr<const scene::Land> land;
        std::shared_ptr<const scene::Sky> sky;
    };

    mesh::Image picture_with(Easel& easel, const genome::Parameter& parameter, float value) const {
        genome::ParameterValues values = recipe_.values;
        values.set(parameter.id, value);
        return picture_of(easel, parts_of(values, &parameter));
    }
    mesh::Image picture_of(Easel& easel, const Parts& parts) const {
        const auto scene = std::make_shared<const scene::Scene>(synthesis::compose(
            parts.flora, parts.land, parts.sky, recipe_.seeds[genome::Aspect::Trees], recipe_.flight, kFineness));
        pictures::Picture picture;
        picture.width = kWidth;
        picture.height = kHeight;
        picture.seconds = 20;
        picture.scenes = {recipe_};
        return easel.draw(picture, {scene});
    }
    // All of them, or those of a parameter's aspect and the rest as they were.
    Parts parts_of(const genome::ParameterValues& values, const genome::Parameter* changed) const {
        const scene::SceneParameters p = scene::realise(values);
        const auto is_new = [changed](genome::Aspect aspect) {
            return changed == nullptr || changed->aspect == aspect;
        };
        Parts parts = parts_;
        if (is_new(genome::Aspect::Trees))
            parts.flora =
                std::make_shared<scene::Flora>(synthesis::grow_trees(p.trees, recipe_.seeds[genome::Aspect::Trees]));
        if (is_new(genome::Aspect::Land))
            parts.land = std::make_shared<scene::Land>(
                synthesis::grow_land(p.land, recipe_.seeds[genome::Aspect::Land], kFineness));
        if (is_new(genome::Aspect::Sky))
            parts.sky = std::make_shared<scene::Sky>(synthesis::grow_sky(p.sky, recipe_.seeds[genome::Aspect::Sky]));
        return parts;
    }

    genome::Recipe recipe_;
    Parts parts_;
    mesh::Image own_;  // drawn once it is asked for
};

std::vector<Stand> stands() {
    std::vector<Stand> stands;
    for (std::uint64_t seed = 12; seed < 28; ++seed) {
        genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        if (seed == 12) recipe.values = synthesis::test_scenes::everything();
        stands.emplace_back(recipe);
    }
    return stands;
}

std::vector<Stand> stands_for(const genome::Parameter& parameter) {
    std::vector<Stand> some;
    for (std::uint64_t seed = 12; seed < 16; ++seed)
        some.emplace_back(where_it_shows(parameter, genome::random_recipe(base::Seed{seed})));
    return some;
}

TEST(Parameters, NearlyAllAreVisibleFromEndToEnd) {
    if (tests::kIsSanitized) GTEST_SKIP() << "hundreds of pictures, over the paths of the test above";
    Easel easel(kWidth, kHeight);
    std::vector<Stand> some = stands();
    std::string unseen;
    int asked = 0;
    int seen = 0;
    const auto table = genome::parameter_table();
    const std::size_t step = table.size() / tests::sample_of(table.size());  // 4: each aspect has its share
    for (std::size_t i = 0; i < table.size(); i += step) {
        ++asked;
        std::vector<Stand> chosen = is_conditional(table[i]) ? stands_for(table[i]) : std::vector<Stand>{};
        std::vector<Stand>& looked_at = chosen.empty() ? some : chosen;
        double most = 0;
        for (std::size_t k = 0; k < looked_at.size() && most <= kVisible; ++k)
            most = std::max(most, looked_at[k].most_visible(easel, table[i], kVisible));
        if (most > kVisible)
            ++seen;
        else
            unseen.append(" ").append(table[i].name);
    }
    std::cout << seen << " of " << asked << " parameters show; not seen:" << (unseen.empty() ? " none" : unseen)
              << '\n';
    EXPECT_GE(seen, 0.95 * asked) << unseen;
}

}  // namespace
}  // namespace quadrat::stage
