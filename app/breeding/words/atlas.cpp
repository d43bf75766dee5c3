// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/portable_math.hpp"
#include "base/seed.hpp"
#include "breeding/words/detail_axes.hpp"
#include "breeding/words/word_map.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;

// Shares of a blend are Dirichlet: below 1, one scene mostly outweighs the others.
constexpr double kConcentration = 0.6;
constexpr float kStep = 0.5F;       // of a word, to see what it moves
constexpr double kWordRidge = 0.3;  // of the largest; words that move nearly the same are told apart no further
constexpr double kNothingLeft = 1e-3;
constexpr double kUnseen = 0.5;  // how much counts what no picture shows: people see more than 64 × 36 pixels

double dot(const Point& a, const Point& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

Point place_of(const genome::ParameterValues& values, const std::vector<genome::ParameterId>& ids) {
    Point place;
    for (const genome::ParameterId id : ids) {
        const genome::Parameter& p = parameter(id);
        place.push_back((static_cast<double>(values[id]) - p.min) / (static_cast<double>(p.max) - p.min));
    }
    return place;
}

// Gamma of a shape below 1: an exponential number times a power of a uniform one (Stuart 1962).
double gamma(double shape, base::RandomStream& chance) {
    const auto logarithm = [&] { return base::portable_log(std::max(chance.unit(), 1e-300)); };
    const double exponential = -logarithm();
    return exponential * base::portable_exp(logarithm() / shape);
}

Blend random_blend(std::size_t named, base::RandomStream& chance) {
    Blend blend;
    double sum = 0;
    for (std::size_t i = 0; i < blend.of.size(); ++i) {
        blend.of[i] = chance.below(static_cast<std::uint32_t>(named));
        blend.shares[i] = gamma(kConcentration, chance) + 1e-12;
        sum += blend.shares[i];
    }
    for (double& share : blend.shares) share /= sum;
    return blend;
}

void blend_named(Atlas& atlas, Aspect aspect) {
    if (atlas.named.empty()) return;
    base::RandomStream chance{base::Seed{1}.child("blends").child(name_of(aspect))};
    for (std::size_t i = 0; i < Atlas::kBlends; ++i) {
        atlas.blends.push_back(random_blend(atlas.named.size(), chance));
        const Blend& blend = atlas.blends.back();
        Point place(atlas.ids.size(), 0.0);
        for (std::size_t k = 0; k < blend.of.size(); ++k)
            for (std::size_t p = 0; p < place.size(); ++p) place[p] += blend.shares[k] * atlas.named[blend.of[k]][p];
        atlas.blend_places.push_back(std::move(place));
    }
}

Point mean_of(const std::vector<Point>& points, std::size_t dimensions, double otherwise) {
    if (points.empty()) return Point(dimensions, otherwise);
    Point mean(dimensions, 0.0);
    for (const Point& point : points)
        for (std::size_t i = 0; i < dimensions; ++i) mean[i] += point[i] / static_cast<double>(points.size());
    return mean;
}

// How the amounts among the parameters go when one word goes from 0 to 1, at the middle of the named scenes.
Point moved_by(const WordMap& map, const Atlas& atlas, Aspect aspect, std::size_t word) {
    const auto vocabulary = genome::vocabulary(aspect);
    std::array<Point, 2> ends;
    for (std::size_t end = 0; end < 2; ++end) {
        genome::Description words;
        for (std::size_t w = 0; w < vocabulary.size(); ++w)
            words.set(vocabulary[w].id,
                      static_cast<float>(atlas.middle_words[w]) + (w == word ? (end == 0 ? -kStep : kStep) : 0.0F));
        genome::ParameterValues values;
        map.realise(aspect, words, values);
        ends[end] = place_of(values, atlas.ids);
    }
    Point moved(atlas.ids.size(), 0.0);
    for (std::size_t p = 0; p < moved.size(); ++p)
        if (parameter(atlas.ids[p]).unit != genome::kChoice) moved[p] = (ends[1][p] - ends[0][p]) / (2 * kStep);
    return moved;
}

// Gram and Schmidt, twice for the sake of rounding; what lies in the axes already is left out.
bool add_axis(std::vector<Point>& axes, Point direction) {
    const double before = std::sqrt(dot(direction, direction));
    if (before < 1e-9) return false;
    for (int pass = 0; pass < 2; ++pass)
        for (const Point& axis : axes) {
            const double share = dot(axis, direction);
            for (std::size_t i = 0; i < direction.size(); ++i) direction[i] -= share * axis[i];
        }
    const double length = std::sqrt(dot(direction, direction));
    if (length < kNothingLeft * before) return false;
    for (double& x : direction) x /= length;
    axes.push_back(std::move(direction));
    return true;
}

// What was never measured is as visible as others are on average.
void add_details(Atlas& atlas, const DetailAxes& measured) {
    for (const auto& parts : measured.axes) {
        Point direction(atlas.ids.size(), 0.0);
        for (std::size_t p = 0; p < atlas.ids.size(); ++p)
            if (const auto part = parts.find(atlas.ids[p]); part != parts.end()) direction[p] = part->second;
        add_axis(atlas.axes, std::move(direction));
    }
    atlas.detail_axes = atlas.axes.size() - atlas.word_axes;
    double sum = 0;
    for (const genome::ParameterId id : atlas.ids) {
        const auto seen = measured.seen.find(id);
        sum += atlas.seen.emplace_back(kUnseen + (1 - kUnseen) * (seen == measured.seen.end() ? 1 : seen->second));
    }
    for (double& seen : atlas.seen) seen *= static_cast<double>(atlas.ids.size()) / sum;
}

void add_rest(Atlas& atlas) {
    for (std::size_t p = 0; p < atlas.ids.size(); ++p) {
        if (parameter(atlas.ids[p]).unit == genome::kChoice) continue;
        Point direction(atlas.ids.size(), 0.0);
        direction[p] = 1;
        add_axis(atlas.axes, std::move(direction));
    }
}

// x with (A + ridge) x = b for symmetric positive A, by Gauss and Jordan, all columns of b at once.
std::vector<Point> solved(std::vector<Point> a, std::vector<Point> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double pivot = a[i][i];
        for (double& x : a[i]) x /= pivot;
        for (double& x : b[i]) x /= pivot;
        for (std::size_t j = 0; j < a.size(); ++j) {
            if (j == i) continue;
            const double factor = a[j][i];
            for (std::size_t k = 0; k < a.size(); ++k) a[j][k] -= factor * a[i][k];
            for (std::size_t k = 0; k < b[j].size(); ++k) b[j][k] -= factor * b[i][k];
        }
    }
    return b;
}

// Least squares with a ridge: the words that would move the parameters as they were moved.
void answer_in_words(Atlas& atlas, const std::vector<Point>& moved) {
    std::vector<Point> gram(moved.size(), Point(moved.size()));
    double largest = 1e-9;
    for (std::size_t a = 0; a < moved.size(); ++a)
        for (std::size_t b = 0; b < moved.size(); ++b) {
            gram[a][b] = dot(moved[a], moved[b]);
            largest = std::max(largest, gram[a][b]);
        }
    for (std::size_t a = 0; a < moved.size(); ++a) gram[a][a] += kWordRidge * largest;
    const std::vector<Point> words = solved(std::move(gram), moved);
    atlas.words_by_parameter.assign(atlas.ids.size(), Point(moved.size()));
    for (std::size_t w = 0; w < words.size(); ++w)
        for (std::size_t p = 0; p < atlas.ids.size(); ++p) atlas.words_by_parameter[p][w] = words[w][p];
}

}  // namespace

Atlas atlas_of(const WordMap& map, Aspect aspect) {
    Atlas atlas;
    atlas.ids = parameters_of(aspect, genome::Genome::Full);
    const auto vocabulary = genome::vocabulary(aspect);
    for (const DescribedScene& scene : map.scenes()) {
        if (scene.name.empty() || scene.aspect != aspect) continue;
        atlas.names.push_back(scene.name);
        atlas.named.push_back(place_of(scene.values, atlas.ids));
        const genome::Description words = map.completed(scene.words);
        Point& said = atlas.named_words.emplace_back();
        for (const genome::Word& word : vocabulary) said.push_back(words[word.id]);
    }
    atlas.middle = mean_of(atlas.named, atlas.ids.size(), 0.5);
    atlas.middle_words = mean_of(atlas.named_words, vocabulary.size(), 0.0);
    blend_named(atlas, aspect);
    std::vector<Point> moved;
    for (std::size_t w = 0; w < vocabulary.size(); ++w) moved.push_back(moved_by(map, atlas, aspect, w));
    for (const Point& direction : moved) add_axis(atlas.axes, direction);
    atlas.word_axes = atlas.axes.size();
    answer_in_words(atlas, moved);
    add_details(atlas, measured_axes(aspect));
    add_rest(atlas);
    return atlas;
}

Point words_at(const Atlas& atlas, const Point& parameters) {
    Point words = atlas.middle_words;
    for (std::size_t p = 0; p < parameters.size(); ++p)
        for (std::size_t w = 0; w < words.size(); ++w)
            words[w] += (parameters[p] - atlas.middle[p]) * atlas.words_by_parameter[p][w];
    for (double& word : words) word = std::clamp(word, -1.0, 1.0);
    return words;
}

Point along_axes(const Atlas& atlas, const Point& parameters) {
    Point along;
    along.reserve(atlas.axes.size());
    for (const Point& axis : atlas.axes) along.push_back(dot(axis, parameters));
    return along;
}

Point from_axes(const Atlas& atlas, const Point& along) {
    Point parameters(atlas.ids.size(), 0.0);
    for (std::size_t a = 0; a < along.size(); ++a)
        for (std::size_t p = 0; p < parameters.size(); ++p) parameters[p] += along[a] * atlas.axes[a][p];
    return parameters;
}

}  // namespace quadrat::breeding
