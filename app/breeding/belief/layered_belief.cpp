// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/layered_belief.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/portable_math.hpp"

namespace quadrat::breeding {
namespace {

constexpr double kPersonal = 0.15;  // deviation of a wish from a blend, a parameter
constexpr double kUniformDeviation = 0.28867513459481287;
constexpr double kAnywherePrior = 0.1;    // how likely it is before any pick that named scenes tell nothing
constexpr double kEyeNoise = 0.1;         // of a comparison, in the same units as the scaled difference
constexpr double kUnknownWeights = 0.5;   // nobody cares for all parameters alike
constexpr double kContrast = 6;           // scales a difference to where picks saturate
constexpr double kMeaningless = 0.10;     // share of picks that children make with their eyes elsewhere
constexpr double kIndifference = 0.06;    // of a difference that is named one time in e
constexpr double kRandomDistance = 0.27;  // of random scenes; what looks_apart calls 1
constexpr double kSaturation = 0.4;       // differences beyond it look alike
constexpr double kStride = 2;             // heavier tails than a Gaussian's: few parameters matter much
constexpr double kOutward = 1.15;         // blends are shown a little farther apart than they are
constexpr double kBold = 0.4;             // how far candidates go along the axes, in deviations
constexpr double kCalm = 0.25;            // the one nearest to what is expected, of that
constexpr double kLeastApart = 0.13;      // any two of the four, root mean square over the parameters
constexpr double kBolder = 1.2;           // who is nearer goes so much farther, in so many passes at most
constexpr int kPasses = 16;
constexpr std::size_t kSamples = 192;
constexpr double kLeastVariance = 1e-5;

double squared(double x) { return x * x; }

bool is_choice(const Atlas& atlas, std::size_t p) { return parameter(atlas.ids[p]).unit == genome::kChoice; }

std::vector<double> weights_of(const LayeredBelief& belief) {
    std::vector<double> weights;
    double sum = 0;
    for (const double log_weight : belief.blends) sum += weights.emplace_back(base::portable_exp(log_weight));
    for (double& weight : weights) weight /= sum;
    return weights;
}

// How much of each named scene.
using Recipe = std::vector<double>;

void add(Recipe& recipe, const Blend& blend, double weight) {
    for (std::size_t k = 0; k < blend.of.size(); ++k) recipe[blend.of[k]] += weight * blend.shares[k];
}

Recipe mean_recipe(const Atlas& atlas, const std::vector<double>& weights) {
    Recipe recipe(atlas.named.size(), 0.0);
    for (std::size_t b = 0; b < weights.size(); ++b) add(recipe, atlas.blends[b], weights[b]);
    return recipe;
}

Place mean_place(const Atlas& atlas, const std::vector<double>& weights) {
    if (weights.empty()) return atlas.middle;
    Place place(atlas.ids.size(), 0.0);
    for (std::size_t b = 0; b < weights.size(); ++b)
        for (std::size_t p = 0; p < place.size(); ++p) place[p] += weights[b] * atlas.blend_places[b][p];
    return place;
}

// Between two kinds lies neither: the kind most of the recipe is of.
double voted(const Atlas& atlas, const Recipe& recipe, std::size_t p) {
    std::map<double, double> votes;
    for (std::size_t k = 0; k < recipe.size(); ++k) votes[atlas.named[k][p]] += recipe[k];
    const auto most = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
    return most->first;
}

// Those of the recipe, and what words go with what is beside it.
Point words_of(const Atlas& atlas, const Recipe& recipe, const Place& parameters) {
    if (recipe.empty()) return words_at(atlas, parameters);
    Point words(atlas.middle_words.size(), 0.0);
    Place beside = parameters;
    for (std::size_t k = 0; k < recipe.size(); ++k) {
        for (std::size_t w = 0; w < words.size(); ++w) words[w] += recipe[k] * atlas.named_words[k][w];
        for (std::size_t p = 0; p < beside.size(); ++p) beside[p] -= recipe[k] * atlas.named[k][p];
    }
    for (std::size_t w = 0; w < words.size(); ++w) {
        for (std::size_t p = 0; p < beside.size(); ++p) words[w] += beside[p] * atlas.words_by_parameter[p][w];
        words[w] = std::clamp(words[w], -1.0, 1.0);
    }
    return words;
}

Sketch sketched(const Atlas& atlas, const Recipe& recipe, Place parameters) {
    Sketch sketch{std::move(parameters), {}};
    sketch.words = words_of(atlas, recipe, sketch.parameters);
    for (std::size_t p = 0; p < atlas.ids.size(); ++p) {
        if (is_choice(atlas, p) && !recipe.empty()) sketch.parameters[p] = voted(atlas, recipe, p);
        sketch.parameters[p] = std::clamp(sketch.parameters[p], 0.0, 1.0);
    }
    return sketch;
}

Place place_of(const Atlas& atlas, const Shown& shown) {
    Place place;
    for (std::size_t p = 0; p < atlas.ids.size(); ++p) {
        const genome::Parameter& row = parameter(atlas.ids[p]);
        place.push_back((static_cast<double>(shown.parameters[p]) - row.min) /
                        (static_cast<double>(row.max) - row.min));
    }
    return place;
}

Place plus(Place a, const Place& b, double factor = 1) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
    return a;
}

// Variances of the parameters, where those along the axes are given.
Place variance_of_parameters(const Atlas& atlas, const std::vector<double>& along) {
    Place variance(atlas.ids.size(), 0.0);
    for (std::size_t a = 0; a < along.size(); ++a)
        for (std::size_t p = 0; p < variance.size(); ++p) variance[p] += along[a] * squared(atlas.axes[a][p]);
    return variance;
}

// What is compared: one place was named, another was not, and of the wish a mean and variances are believed.
struct Comparison {
    Place along;         // the scaled difference, a parameter
    double distance;     // of the expected wish from the plane between them, on the side of what was named
    double unknown = 0;  // by weights that are not known
};

Comparison compared(const Atlas& atlas, const Place& better, const Place& worse, const Place& mean,
                    const Place& variance) {
    const auto n = static_cast<double>(mean.size());
    Comparison c{Place(mean.size()), 0, 0};
    for (std::size_t p = 0; p < mean.size(); ++p) {
        c.along[p] = kContrast / n * atlas.seen[p] * (better[p] - worse[p]);
        const double off = mean[p] - (better[p] + worse[p]) / 2;
        c.distance += c.along[p] * off;
        c.unknown += squared(c.along[p]) * (variance[p] + squared(off));
    }
    return c;
}

// A half-space, taken in by a rank-one probit update of which the diagonal is kept (assumed-density filtering: Minka
// 2001). `blurred` is what else the comparison is unsure by.
void take_in(Personal& personal, const Place& along_axis, double distance, double blurred) {
    double variance = squared(kEyeNoise) + blurred;
    for (std::size_t a = 0; a < along_axis.size(); ++a) variance += personal.variance[a] * squared(along_axis[a]);
    const double deviation = std::sqrt(variance);
    const double z = distance / deviation;
    const double sure = 1 - kMeaningless;
    const double likely = kMeaningless / 2 + sure * base::normal_cumulative(z);
    const double slope = sure * base::normal_density(z) / likely;
    const double curvature = std::max(0.0, slope * (slope + z));
    for (std::size_t a = 0; a < along_axis.size(); ++a) {
        const double spread = personal.variance[a] * along_axis[a];
        personal.mean[a] += kStride * spread * slope / deviation;
        personal.variance[a] = std::max(kLeastVariance, personal.variance[a] - squared(spread) * curvature / variance);
    }
}

// How much the blends disagree along a direction.
double disagreement(const Atlas& atlas, const std::vector<double>& weights, const Place& along) {
    double mean = 0;
    double square = 0;
    for (std::size_t b = 0; b < weights.size(); ++b) {
        double at = 0;
        for (std::size_t p = 0; p < along.size(); ++p) at += along[p] * atlas.blend_places[b][p];
        mean += weights[b] * at;
        square += weights[b] * at * at;
    }
    return std::max(0.0, square - mean * mean);
}

void take_in_personal(const Atlas& atlas, Personal& personal, const Place& centre, const std::vector<double>& weights,
                      const FourPlaces& shown, std::size_t picked) {
    for (std::size_t other = 0; other < shown.size(); ++other) {
        if (other == picked) continue;
        const Place mean = plus(centre, from_axes(atlas, personal.mean));
        const Place variance = variance_of_parameters(atlas, personal.variance);
        const Comparison c = compared(atlas, shown[picked], shown[other], mean, variance);
        const double blurred = kUnknownWeights * c.unknown + disagreement(atlas, weights, c.along);
        take_in(personal, along_axes(atlas, c.along), c.distance, blurred);
    }
}

// How far a place looks from a wish: differences saturate, and random scenes are about 1 apart.
double looks_apart(const Atlas& atlas, const Place& a, const Place& b, const Place& shift) {
    double sum = 0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        const double square = squared(a[p] - b[p] - shift[p]);
        sum += atlas.seen[p] * square / (1 + square / squared(kSaturation));
    }
    return std::sqrt(sum / static_cast<double>(a.size())) / kRandomDistance;
}

// Each blend by how likely it makes the pick (Luce 1959).
void weigh_blends(const Atlas& atlas, LayeredBelief& belief, const FourPlaces& shown, std::size_t picked) {
    const Place personal = from_axes(atlas, belief.near_blends.mean);
    const std::vector<double> weights = weights_of(belief);
    double foretold = 0;
    for (std::size_t b = 0; b < belief.blends.size(); ++b) {
        std::array<double, genome::kCandidates> apart{};
        for (std::size_t k = 0; k < apart.size(); ++k)
            apart[k] = looks_apart(atlas, shown[k], atlas.blend_places[b], personal);
        const double nearest = *std::ranges::min_element(apart);
        double sum = 0;
        for (const double one : apart) sum += base::portable_exp((nearest - one) / kIndifference);
        const double likely = base::portable_exp((nearest - apart[picked]) / kIndifference) / sum;
        const double meant = kMeaningless / static_cast<double>(apart.size()) + (1 - kMeaningless) * likely;
        belief.blends[b] += base::portable_log(meant);
        foretold += weights[b] * meant;
    }
    if (belief.blends.empty()) return;
    belief.near_blends.evidence += base::portable_log(foretold);
    belief.anywhere.evidence += base::portable_log(1 / static_cast<double>(shown.size()));
    const double largest = *std::ranges::max_element(belief.blends);
    for (double& one : belief.blends) one -= largest;
}

// A wish lies within the ranges, and what is believed of it too.
void keep_inside(const Atlas& atlas, Personal& personal, const Place& centre) {
    Place offset = from_axes(atlas, personal.mean);
    for (std::size_t p = 0; p < offset.size(); ++p) offset[p] = std::clamp(centre[p] + offset[p], 0.0, 1.0) - centre[p];
    personal.mean = along_axes(atlas, offset);
}

}  // namespace

LayeredBelief initial_belief(const Atlas& atlas) {
    LayeredBelief belief;
    belief.blends.assign(atlas.blends.size(), 0.0);
    belief.near_blends.mean.assign(atlas.axes.size(), 0.0);
    belief.near_blends.variance.assign(atlas.axes.size(), squared(kPersonal));
    belief.anywhere.mean.assign(atlas.axes.size(), 0.0);
    belief.anywhere.variance.assign(atlas.axes.size(), squared(kUniformDeviation));
    return belief;
}

double anywhere_share(const Atlas& atlas, const LayeredBelief& belief) {
    if (atlas.blends.empty()) return 1;
    const double odds = kAnywherePrior / (1 - kAnywherePrior) *
                        base::portable_exp(belief.anywhere.evidence - belief.near_blends.evidence);
    return odds / (1 + odds);
}

namespace {

struct Middle {
    double anywhere;              // share
    std::vector<double> weights;  // of the blends
    Recipe recipe;
    Place of_blends;
    Place place;
};

Middle middle_of(const Atlas& atlas, const LayeredBelief& belief) {
    Middle middle{anywhere_share(atlas, belief), weights_of(belief), {}, {}, {}};
    middle.recipe = mean_recipe(atlas, middle.weights);
    middle.of_blends = mean_place(atlas, middle.weights);
    const Place near = plus(middle.of_blends, from_axes(atlas, belief.near_blends.mean));
    const Place far = plus(Place(near.size(), 0.5), from_axes(atlas, belief.anywhere.mean));
    for (std::size_t p = 0; p < near.size(); ++p)
        middle.place.push_back(std::clamp((1 - middle.anywhere) * near[p] + middle.anywhere * far[p], 0.0, 1.0));
    return middle;
}

}  // namespace

Sketch expected(const Atlas& atlas, const LayeredBelief& belief) {
    const Middle middle = middle_of(atlas, belief);
    return sketched(atlas, middle.recipe, middle.place);
}

Point word_deviation(const Atlas& atlas, const LayeredBelief& belief) {
    const Middle middle = middle_of(atlas, belief);
    Place variance = variance_of_parameters(atlas, belief.near_blends.variance);
    const Place far = variance_of_parameters(atlas, belief.anywhere.variance);
    for (std::size_t p = 0; p < variance.size(); ++p) {
        variance[p] = (1 - middle.anywhere) * variance[p] + middle.anywhere * far[p];
        for (std::size_t b = 0; b < middle.weights.size(); ++b)
            variance[p] +=
                (1 - middle.anywhere) * middle.weights[b] * squared(atlas.blend_places[b][p] - middle.of_blends[p]);
    }
    Point deviation(atlas.middle_words.size(), 0.0);
    for (std::size_t w = 0; w < deviation.size(); ++w) {
        for (std::size_t p = 0; p < variance.size(); ++p)
            deviation[w] += variance[p] * squared(atlas.words_by_parameter[p][w]);
        deviation[w] = std::sqrt(deviation[w]);
    }
    return deviation;
}

LayeredBelief learnt(const Atlas& atlas, LayeredBelief belief, const FourShown& shown, std::size_t picked) {
    FourPlaces places;
    for (std::size_t k = 0; k < places.size(); ++k) places[k] = place_of(atlas, shown[k]);
    const std::vector<double> weights = weights_of(belief);
    const Place of_blends = mean_place(atlas, weights);
    take_in_personal(atlas, belief.near_blends, of_blends, weights, places, picked);
    keep_inside(atlas, belief.near_blends, of_blends);
    const Place middle(atlas.ids.size(), 0.5);
    take_in_personal(atlas, belief.anywhere, middle, {}, places, picked);
    keep_inside(atlas, belief.anywhere, middle);
    weigh_blends(atlas, belief, places, picked);
    belief.winner = picked;
    belief.shown = shown;
    return belief;
}

namespace {

FourSketches first_four(const Atlas& atlas, base::Seed seed) {
    base::RandomStream chance(seed);
    const auto order = drawn_apart(atlas.named_words, genome::kCandidates, chance);
    FourSketches four;
    for (std::size_t k = 0; k < four.size(); ++k) four[k] = {atlas.named[order[k]], atlas.named_words[order[k]]};
    return four;
}

// Blends by their weight (systematic resampling: Kitagawa 1996).
std::vector<std::size_t> resampled(const std::vector<double>& weights, base::RandomStream& chance) {
    std::vector<std::size_t> drawn;
    double at = chance.unit() / static_cast<double>(kSamples);
    double reached = 0;
    for (std::size_t b = 0; b < weights.size(); ++b) {
        reached += weights[b];
        for (; drawn.size() < kSamples && at < reached; at += 1.0 / static_cast<double>(kSamples)) drawn.push_back(b);
    }
    while (drawn.size() < kSamples) drawn.push_back(weights.size() - 1);
    return drawn;
}

struct FourRecipes {
    std::array<Recipe, genome::kCandidates> recipes;
    FourPlaces places;
};

// The four blends that leave the least distance to the nearest of them.
FourRecipes four_blends(const Atlas& atlas, const Middle& middle, base::RandomStream& chance) {
    FourRecipes four;
    if (atlas.blends.empty()) {
        four.places.fill(middle.of_blends);
        return four;
    }
    const std::vector<std::size_t> drawn = resampled(middle.weights, chance);
    std::vector<Place> samples;
    for (const std::size_t b : drawn) samples.push_back(atlas.blend_places[b]);
    four.places = four_means(samples);
    std::array<double, genome::kCandidates> counts{};
    for (Recipe& recipe : four.recipes) recipe.assign(atlas.named.size(), 0.0);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const auto near = std::ranges::min_element(
            four.places, {}, [&](const Place& place) { return squared_distance(place, samples[i]); });
        const auto k = static_cast<std::size_t>(near - four.places.begin());
        add(four.recipes[k], atlas.blends[drawn[i]], 1);
        counts[k] += 1;
    }
    for (std::size_t k = 0; k < counts.size(); ++k)
        for (double& share : four.recipes[k]) share /= std::max(counts[k], 1.0);
    return four;
}

// Along every axis one of the three others goes as the last winner does, and two the other way: whatever the pick, it
// tells about all axes, and any two of the four differ along two axes of three.
std::array<Place, genome::kCandidates> pattern(const Atlas& atlas, const Middle& middle, const LayeredBelief& belief,
                                               base::RandomStream& chance) {
    std::array<Place, genome::kCandidates> along;
    for (Place& one : along) one.assign(atlas.axes.size(), 0.0);
    Place of_winner(atlas.axes.size(), 1.0);
    const std::size_t winner = belief.winner.value_or(0);
    if (belief.winner) of_winner = along_axes(atlas, plus(place_of(atlas, belief.shown[winner]), middle.place, -1));
    for (std::size_t a = 0; a < atlas.axes.size(); ++a) {
        const double variance =
            (1 - middle.anywhere) * belief.near_blends.variance[a] + middle.anywhere * belief.anywhere.variance[a];
        const double step = std::copysign(kBold * std::sqrt(variance), of_winner[a]);
        const std::size_t alike = chance.below(genome::kCandidates - 1);
        std::size_t other = 0;
        for (std::size_t k = 0; k < along.size(); ++k) along[k][a] = k == winner || other++ == alike ? step : -step;
    }
    return along;
}

// Ends of ranges and a belief that is nearly sure make four alike: nobody could choose among them.
bool is_too_near(const FourSketches& four, std::size_t k) {
    for (std::size_t other = 0; other < four.size(); ++other) {
        if (other == k) continue;
        const auto n = static_cast<double>(four[k].parameters.size());
        if (squared_distance(four[k].parameters, four[other].parameters) < squared(kLeastApart) * n) return true;
    }
    return false;
}

}  // namespace

FourSketches proposed(const Atlas& atlas, const LayeredBelief& belief, base::Seed seed) {
    if (!belief.winner && atlas.named.size() >= 2 * genome::kCandidates) return first_four(atlas, seed);
    base::RandomStream chance(seed);
    const Middle middle = middle_of(atlas, belief);
    FourRecipes blends = four_blends(atlas, middle, chance);
    const auto along = pattern(atlas, middle, belief, chance);
    if (belief.winner) {
        const Place stays = place_of(atlas, belief.shown[*belief.winner]);
        const Place offset = plus(middle.place, middle.of_blends, -1);
        const auto near = static_cast<std::size_t>(
            std::ranges::min_element(blends.places, {},
                                     [&](const Place& place) { return squared_distance(plus(place, offset), stays); }) -
            blends.places.begin());
        std::swap(blends.places[near], blends.places[*belief.winner]);
        std::swap(blends.recipes[near], blends.recipes[*belief.winner]);
    }
    std::size_t calm = belief.winner == 0 ? 1 : 0;
    for (std::size_t k = 0; k < genome::kCandidates; ++k)
        if (k != belief.winner && squared_distance(blends.places[k], middle.of_blends) <
                                      squared_distance(blends.places[calm], middle.of_blends))
            calm = k;
    std::array<double, genome::kCandidates> bold;
    bold.fill(1);
    bold[calm] = kCalm;
    FourSketches four;
    const auto sketch = [&](std::size_t k) {
        if (k == belief.winner) {
            const std::vector<float>& words = belief.shown[k].words;
            four[k] = {place_of(atlas, belief.shown[k]), Point(words.begin(), words.end())};
            return;
        }
        const double outward = kOutward * (1 - middle.anywhere);
        Place place = plus(middle.place, plus(blends.places[k], middle.of_blends, -1), outward);
        place = plus(place, from_axes(atlas, along[k]), bold[k]);
        four[k] = sketched(atlas, blends.recipes[k], std::move(place));
    };
    for (std::size_t k = 0; k < four.size(); ++k) sketch(k);
    for (int pass = 0; pass < kPasses; ++pass)
        for (std::size_t k = 0; k < four.size(); ++k) {
            if (k == belief.winner || !is_too_near(four, k)) continue;
            bold[k] *= kBolder;
            sketch(k);
        }
    return four;
}

}  // namespace quadrat::breeding
