// SPDX-License-Identifier: Apache-2.0
// What the regression smooths away comes back near each scene by Shepard's inverse distance weights ("A two-dimensional
// interpolation function for irregularly-spaced data", 1968), made local by a radius a scene as in Franke & Nielson
// ("Smooth interpolation of large sets of scattered data", 1980); the regression itself is one more voice, everywhere
// as loud, so that far from all scenes it alone is heard.
#include "breeding/words/word_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "breeding/words/basis.hpp"
#include "breeding/words/comes_back.hpp"
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
    std::vector<double> hearing;                 // a scene's radius, in words
    std::vector<std::vector<double>> left_over;  // a scene, then a parameter; what the regression misses, of its range
    std::optional<WordGaussian> gaussian;
};

double squared_distance(const Point& a, const Point& b) {
    double squares = 0;
    for (std::size_t d = 0; d < a.size(); ++d) squares += (a[d] - b[d]) * (a[d] - b[d]);
    return squares;
}

// At its own words a scene that is trusted fully speaks so many times as loud as the regression.
constexpr double kOwnWords = 1000;

// How loud each scene is, the regression's voice being 1. One that is trusted less is never followed all the way.
std::vector<double> voices(const AspectMap& map, const Point& at) {
    std::vector<double> loud;
    loud.reserve(map.points.size());
    for (std::size_t i = 0; i < map.points.size(); ++i) {
        const double far = squared_distance(at, map.points[i]) / (map.hearing[i] * map.hearing[i]);
        const double doubt = std::max(0.0, 1 - map.trust[i]);
        loud.push_back(map.trust[i] / (far * far + doubt + 1 / kOwnWords));
    }
    return loud;
}

// What the scenes add to the regression, a parameter, of its range.
void add_left_over(const AspectMap& map, const std::vector<double>& loud, std::vector<double>& shares) {
    double sum = 1;
    for (const double one : loud) sum += one;
    for (std::size_t i = 0; i < loud.size(); ++i)
        for (std::size_t p = 0; p < shares.size(); ++p) shares[p] += loud[i] / sum * map.left_over[i][p];
}

// Between two kinds lies neither of them: scenes vote for theirs, the louder the nearer they are described.
// Kinds are whole numbers of the parameter's range, in which ties go to the lowest.
float voted(const AspectMap& map, const genome::Parameter& row, const std::vector<double>& loud) {
    std::vector<double> votes(static_cast<std::size_t>(row.max - row.min) + 1, 0.0);
    for (std::size_t i = 0; i < loud.size(); ++i)
        votes[static_cast<std::size_t>(std::lround(map.values[i][row.id] - row.min))] +=
            loud[i] * loud[i] / map.trust[i];
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

// What the regression says at some words, a parameter, of its range.
std::vector<double> regressed(const AspectMap& map, const Point& at) {
    std::vector<double> basis(map.basis.size());
    map.basis.evaluate(at, basis);
    std::vector<double> shares(map.ids.size(), 0.0);
    for (std::size_t j = 0; j < basis.size(); ++j)
        for (std::size_t p = 0; p < shares.size(); ++p) shares[p] += map.weights[j][p] * basis[j];
    return shares;
}

void keep_left_over(AspectMap& map) {
    map.hearing = hearing_of(map.points);
    for (std::size_t i = 0; i < map.points.size(); ++i) {
        std::vector<double> missed = regressed(map, map.points[i]);
        for (std::size_t p = 0; p < missed.size(); ++p)
            missed[p] = share_of_range(parameter(map.ids[p]), map.values[i][map.ids[p]]) - missed[p];
        map.left_over.push_back(std::move(missed));
    }
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
    keep_left_over(map);
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
    std::vector<double> shares = regressed(map, at);
    const std::vector<double> loud = voices(map, at);
    add_left_over(map, loud, shares);
    for (std::size_t p = 0; p < map.ids.size(); ++p) {
        const genome::Parameter& row = parameter(map.ids[p]);
        if (row.unit == genome::kChoice) {
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
