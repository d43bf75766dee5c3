// SPDX-License-Identifier: Apache-2.0
// Parameters show: the pictures at the two ends of a range differ. Every one of the classic genome's does in one and
// the same scene; of all of them nearly every one in some of a few scenes, as what a pine has for a bark shows on pines
// alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

#include "kiosk/easel.hpp"
#include "support/effort.hpp"
#include "unit/synthesis/scenes.hpp"

namespace quadrat::kiosk {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 135;
constexpr double kVisible = 12;

mesh::Image picture_with(Easel& easel, const genome::Parameter& parameter, float value) {
    Picture picture;
    picture.width = kWidth;
    picture.height = kHeight;
    genome::Recipe recipe = genome::random_recipe(base::Seed{12});
    recipe.values = genome::ParameterValues{};
    recipe.values.set(parameter.id, value);
    picture.scenes = {recipe};
    return easel.draw(picture, {grow(recipe, {129, 128, 256})});
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

// A scene of which one aspect at a time is grown anew.
class Stand {
  public:
    explicit Stand(const genome::Recipe& recipe) : recipe_(recipe) { parts_ = parts_of(recipe.values, nullptr); }

    mesh::Image picture_with(Easel& easel, const genome::Parameter& parameter, float value) const {
        genome::ParameterValues values = recipe_.values;
        values.set(parameter.id, value);
        const Parts parts = parts_of(values, &parameter);
        const auto scene = std::make_shared<const scene::Scene>(synthesis::compose(
            parts.flora, parts.land, parts.sky, recipe_.seeds[genome::Aspect::Trees], recipe_.flight, kFineness));
        Picture picture;
        picture.width = kWidth;
        picture.height = kHeight;
        picture.scenes = {recipe_};
        return easel.draw(picture, {scene});
    }

  private:
    static constexpr scene::Fineness kFineness{129, 128, 256};
    struct Parts {
        std::shared_ptr<const scene::Flora> flora;
        std::shared_ptr<const scene::Land> land;
        std::shared_ptr<const scene::Sky> sky;
    };
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
};

std::vector<Stand> stands() {
    std::vector<Stand> stands;
    for (std::uint64_t seed = 12; seed < (tests::kIsSanitized ? 16U : 28U); ++seed) {
        genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        if (seed == 12) recipe.values = synthesis::test_scenes::everything();
        stands.emplace_back(recipe);
    }
    return stands;
}

TEST(Parameters, NearlyAllAreVisibleFromEndToEnd) {
    Easel easel(kWidth, kHeight);
    const std::vector<Stand> some = stands();
    std::string unseen;
    int asked = 0;
    int seen = 0;
    const auto table = genome::parameter_table();
    for (std::size_t i = 0; i < table.size(); i += tests::kIsSanitized ? 32 : 1) {
        ++asked;
        double most = 0;
        for (std::size_t k = 0; k < some.size() && most <= kVisible; ++k)
            most = std::max(most, visible_difference(some[k].picture_with(easel, table[i], table[i].min),
                                                     some[k].picture_with(easel, table[i], table[i].max), 0.01));
        if (most > kVisible)
            ++seen;
        else
            unseen.append(" ").append(table[i].name);
    }
    std::cout << seen << " of " << asked << " parameters show; not seen:" << (unseen.empty() ? " none" : unseen)
              << '\n';
    EXPECT_GE(seen, (tests::kIsSanitized ? 0.5 : 0.95) * asked) << unseen;  // of few, chance counts
}

}  // namespace
}  // namespace quadrat::kiosk
