// SPDX-License-Identifier: Apache-2.0
#include "commands/words_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "base/file.hpp"
#include "breeding/belief/four_means.hpp"
#include "breeding/words/detail_axes.hpp"
#include "stage/eye.hpp"

namespace quadrat::commands {
namespace {

using breeding::Atlas;
using breeding::WordMap;
using genome::Aspect;

constexpr std::size_t kLandscapes = 8;  // that parameters are moved in
constexpr std::size_t kAxes = 10;
constexpr float kStep = 0.3F;  // of a range
constexpr float kChoice = 1;   // a kind that is another one is all of it

// Named scenes far from one another, each on the next ones of the other aspects.
std::vector<genome::Recipe> landscapes(const WordMap& map) {
    std::vector<genome::Recipe> all(kLandscapes);
    for (const Aspect aspect : genome::kAspects) {
        const Atlas& atlas = map.atlas(aspect);
        const auto order = breeding::farthest_first(atlas.named_words, 0, kLandscapes);
        std::vector<const breeding::DescribedScene*> named;
        for (const breeding::DescribedScene& scene : map.scenes())
            if (!scene.name.empty() && scene.aspect == aspect) named.push_back(&scene);
        for (std::size_t i = 0; i < kLandscapes; ++i) {
            for (const genome::ParameterId id : atlas.ids) all[i].values.set(id, named[order[i]]->values[id]);
            all[i].seeds[aspect] = base::Seed{i + 1}.child(name_of(aspect));
            all[i].flight = base::Seed{i + 1};
        }
    }
    return all;
}

// Away from the nearer end; for kinds, the next one. Returns how far it went, as a share of all the way.
float moved(genome::ParameterValues& values, genome::ParameterId id) {
    const genome::Parameter& p = parameter(id);
    const float range = p.max - p.min;
    const bool is_low = values[id] - p.min < range / 2;
    if (p.unit == genome::kChoice) {
        values.set(id, values[id] + (is_low ? 1.0F : -1.0F));
        return kChoice;
    }
    values.set(id, values[id] + (is_low ? kStep : -kStep) * range);
    return is_low ? kStep : -kStep;
}

breeding::PictureJacobian jacobian(stage::Eye& eye, const genome::Recipe& landscape, const Atlas& atlas) {
    std::vector<genome::Recipe> recipes{landscape};
    std::vector<float> steps;
    for (const genome::ParameterId id : atlas.ids) {
        recipes.push_back(landscape);
        steps.push_back(moved(recipes.back().values, id));
    }
    const std::vector<stage::Sight> sights = eye.look(recipes);
    breeding::PictureJacobian rows(static_cast<Eigen::Index>(steps.size()),
                                   static_cast<Eigen::Index>(sights.front().size()));
    for (std::size_t p = 0; p < steps.size(); ++p)
        for (std::size_t f = 0; f < sights.front().size(); ++f)
            rows(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(f)) =
                (sights[p + 1][f] - sights[0][f]) / steps[p];
    return rows;
}

}  // namespace

int measure_axes(const std::filesystem::path& directory) {
    const WordMap& map = breeding::default_word_map();
    stage::Eye eye;
    const std::vector<genome::Recipe> places = landscapes(map);
    for (const Aspect aspect : genome::kAspects) {
        std::vector<breeding::PictureJacobian> pictures;
        for (const genome::Recipe& landscape : places) {
            pictures.push_back(jacobian(eye, landscape, map.atlas(aspect)));
            std::cerr << fmt::format("{}: {} of {} landscapes\n", name_of(aspect), pictures.size(), kLandscapes);
        }
        const auto axes = breeding::detail_axes(map, aspect, pictures, kAxes);
        const std::filesystem::path file = directory / fmt::format("{}.json", name_of(aspect));
        base::write_file(file, breeding::to_json(axes, aspect));
        std::cout << file.string() << '\n';
    }
    return 0;
}

}  // namespace quadrat::commands
