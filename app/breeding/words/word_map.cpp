// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/word_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "breeding/words/basis.hpp"
#include "breeding/words/ridge.hpp"
#include "breeding/words/word_gaussian.hpp"
#include "genome/parameter_rules.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::ParameterId;

struct AspectMap {
    std::vector<ParameterId> ids;
    Basis basis;
    std::vector<std::vector<double>> weights;  // a basis function, then a parameter; of its share of the range
    std::vector<double> spread;                // a parameter
    std::vector<Point> points;                 // the scenes' words, completed
    std::vector<genome::ParameterValues> values;
    std::vector<double> trust;
    std::optional<WordGaussian> gaussian;
};

// Between two kinds lies neither of them: scenes vote for theirs, the louder the nearer they are described.
constexpr double kHearing = 0.6;  // radius, in words

// How loud each scene is.
std::vector<double> voices(const AspectMap& map, const Point& at) {
    std::vector<double> loud;
    loud.reserve(map.points.size());
    for (std::size_t i = 0; i < map.points.size(); ++i) {
        double squares = 0;
        for (std::size_t d = 0; d < at.size(); ++d) squares += (at[d] - map.points[i][d]) * (at[d] - map.points[i][d]);
        // The far tail is a polynomial's: there is always a nearest scene, however far it is.
        const double nearness = 1 / (1 + squares / (kHearing * kHearing));
        loud.push_back(map.trust[i] * nearness * nearness * nearness * nearness);
    }
    return loud;
}

// Kinds are whole numbers of the parameter's range, in which ties go to the lowest.
float voted(const AspectMap& map, const genome::Parameter& row, const std::vector<double>& loud) {
    std::vector<double> votes(static_cast<std::size_t>(row.max - row.min) + 1, 0.0);
    for (std::size_t i = 0; i < loud.size(); ++i)
        votes[static_cast<std::size_t>(std::lround(map.values[i][row.id] - row.min))] += loud[i];
    return row.min + static_cast<float>(std::ranges::max_element(votes) - votes.begin());
}

double share_of_range(const genome::Parameter& p, float value) {
    return (static_cast<double>(value) - p.min) / (static_cast<double>(p.max) - p.min);
}

// What is expected of all words. One that would have to lie beyond its end is held there, and the others make up for
// it.
WordGaussian gone_along(const WordGaussian& rest, const Point& weights, double value) {
    // Nearly exactly: a direction is asked for, not overheard.
    constexpr double kAsked = 0.01;
    WordGaussian held = rest;
    WordGaussian gone = held.given(weights, value, kAsked);
    for (std::size_t round = 0; round < weights.size(); ++round) {
        bool is_beyond = false;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (std::abs(gone.mean()[i]) <= 1.001) continue;
            held = held.given(i, std::copysign(1.0, gone.mean()[i]));
            is_beyond = true;
        }
        if (!is_beyond) break;
        gone = held.given(weights, value, kAsked);
    }
    return gone;
}

// The words of one aspect of a description, in vocabulary order; what is missing is told by the Gaussian.
Point completed_words(const genome::PartialDescription& words, Aspect aspect, const WordGaussian& gaussian,
                      std::span<const Direction> along = {}) {
    WordGaussian rest = gaussian;
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t i = 0; i < vocabulary.size(); ++i)
        if (const auto value = words[static_cast<std::size_t>(vocabulary[i].id)]) rest = rest.given(i, *value);
    for (const Direction& direction : along)
        if (direction.aspect == aspect) rest = gone_along(rest, direction.weights, direction.value);
    Point point = rest.mean();
    for (std::size_t i = 0; i < vocabulary.size(); ++i) {
        const auto value = words[static_cast<std::size_t>(vocabulary[i].id)];
        point[i] = std::clamp(value ? static_cast<double>(*value) : point[i], -1.0, 1.0);
    }
    return point;
}

bool is_complete(const DescribedScene& scene) {
    return std::ranges::all_of(genome::vocabulary(scene.aspect), [&](const genome::Word& word) {
        return scene.words[static_cast<std::size_t>(word.id)].has_value();
    });
}

// Scenes described in full say how words go together; the others are then completed, and speak too.
void complete(AspectMap& map, const std::vector<const DescribedScene*>& scenes, Aspect aspect) {
    const std::size_t dimensions = genome::vocabulary(aspect).size();
    std::vector<Point> whole;
    std::vector<double> whole_trust;
    for (const DescribedScene* scene : scenes) {
        if (!is_complete(*scene)) continue;
        whole.push_back(completed_words(scene->words, aspect, WordGaussian(dimensions)));
        whole_trust.push_back(scene->weight);
    }
    const WordGaussian first(whole, whole_trust, dimensions);
    for (const DescribedScene* scene : scenes) {
        map.points.push_back(completed_words(scene->words, aspect, first));
        map.values.push_back(scene->values);
        map.trust.push_back(scene->weight);
    }
    map.gaussian.emplace(map.points, map.trust, dimensions);
}

AspectMap trained(const std::vector<const DescribedScene*>& scenes, Aspect aspect) {
    AspectMap map;
    map.ids = parameters_of(aspect, genome::Genome::Full);
    complete(map, scenes, aspect);
    map.spread.assign(map.ids.size(), 0.0);
    if (scenes.empty()) return map;
    map.basis = Basis(map.points);
    Eigen::MatrixXd design(static_cast<Eigen::Index>(scenes.size()), static_cast<Eigen::Index>(map.basis.size()));
    std::vector<double> row(map.basis.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        map.basis.evaluate(map.points[i], row);
        for (std::size_t j = 0; j < row.size(); ++j)
            design(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = row[j];
    }
    const RidgeRegression regression(design, map.trust, map.basis.gaussians());
    std::vector<double> targets(scenes.size());
    map.weights.assign(map.basis.size(), std::vector<double>(map.ids.size()));
    for (std::size_t p = 0; p < map.ids.size(); ++p) {
        for (std::size_t i = 0; i < scenes.size(); ++i)
            targets[i] = share_of_range(parameter(map.ids[p]), scenes[i]->values[map.ids[p]]);
        const RidgeFit fit = regression.fit(targets);
        map.spread[p] = fit.leave_one_out;
        for (std::size_t j = 0; j < fit.weights.size(); ++j) map.weights[j][p] = fit.weights[j];
    }
    return map;
}

}  // namespace

struct WordMap::Trained {
    std::vector<DescribedScene> scenes;
    genome::PerAspect<AspectMap> aspects;
    genome::PerAspect<Atlas> atlases;
};

WordMap::WordMap(std::vector<DescribedScene> scenes) {
    auto made = std::make_shared<Trained>();
    made->scenes = std::move(scenes);
    for (const Aspect aspect : genome::kAspects) {
        std::vector<const DescribedScene*> of_aspect;
        for (const DescribedScene& scene : made->scenes)
            if (scene.aspect == aspect) of_aspect.push_back(&scene);
        made->aspects[aspect] = trained(of_aspect, aspect);
    }
    trained_ = made;
    for (const Aspect aspect : genome::kAspects) made->atlases[aspect] = atlas_of(*this, aspect);
}

void WordMap::realise(Aspect aspect, const genome::Description& words, genome::ParameterValues& values) const {
    const AspectMap& map = trained_->aspects[aspect];
    const genome::ParameterValues defaults;
    if (map.weights.empty()) {
        for (const ParameterId id : map.ids) values.set(id, defaults[id]);
        return;
    }
    Point at;
    for (const genome::Word& word : genome::vocabulary(aspect)) at.push_back(words[word.id]);
    std::vector<double> basis(map.basis.size());
    map.basis.evaluate(at, basis);
    std::vector<double> shares(map.ids.size(), 0.0);
    for (std::size_t j = 0; j < basis.size(); ++j)
        for (std::size_t p = 0; p < shares.size(); ++p) shares[p] += map.weights[j][p] * basis[j];
    std::vector<double> loud;  // only where something is a choice
    for (std::size_t p = 0; p < map.ids.size(); ++p) {
        const genome::Parameter& row = parameter(map.ids[p]);
        if (row.unit == genome::kChoice) {
            if (loud.empty()) loud = voices(map, at);
            values.set(row.id, voted(map, row, loud));
            continue;
        }
        values.set(row.id, static_cast<float>(row.min + shares[p] * (static_cast<double>(row.max) - row.min)));
    }
    genome::make_consistent(aspect, values);
}

genome::ParameterValues WordMap::operator()(const genome::Description& words) const {
    genome::ParameterValues values;
    for (const Aspect aspect : genome::kAspects) realise(aspect, words, values);
    return values;
}

genome::Description WordMap::completed(const genome::PartialDescription& words,
                                       std::span<const Direction> along) const {
    genome::Description description;
    for (const Aspect aspect : genome::kAspects) {
        const Point point = completed_words(words, aspect, *trained_->aspects[aspect].gaussian, along);
        const auto vocabulary = genome::vocabulary(aspect);
        for (std::size_t i = 0; i < vocabulary.size(); ++i)
            description.set(vocabulary[i].id, static_cast<float>(point[i]));
    }
    return description;
}

double WordMap::spread(ParameterId id) const {
    const AspectMap& map = trained_->aspects[parameter(id).aspect];
    return map.spread[static_cast<std::size_t>(std::ranges::find(map.ids, id) - map.ids.begin())];
}

double WordMap::leave_one_out(Aspect aspect) const {
    const std::vector<double>& spread = trained_->aspects[aspect].spread;
    double sum = 0;
    for (const double one : spread) sum += one;
    return spread.empty() ? 0 : sum / static_cast<double>(spread.size());
}

const std::vector<DescribedScene>& WordMap::scenes() const { return trained_->scenes; }

const Atlas& WordMap::atlas(Aspect aspect) const { return trained_->atlases[aspect]; }

const WordMap& default_word_map() {
    static const WordMap kMap(default_scenes());
    return kMap;
}

}  // namespace quadrat::breeding
