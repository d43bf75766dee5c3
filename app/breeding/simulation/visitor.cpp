// SPDX-License-Identifier: Apache-2.0
#include "breeding/simulation/visitor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/portable_math.hpp"
#include "breeding/belief/coordinates.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

constexpr double kSaturation = 0.4;    // differences beyond it look alike
constexpr double kInteractions = 0.3;  // share of the distance that pairs make
constexpr double kGoldenShare = 0.6180339887498949;
constexpr double kGated = 0.2;        // share of parameters that matter as much as another allows
constexpr double kResidue = 0.15;     // deviation of a wish from a mixture of archetypes
constexpr double kMeaningless = 0.1;  // picks that children make
constexpr double kIndifferent = 1.3;  // distances beyond it are all too far
constexpr std::size_t kRandomScenes = 400;

double hyperbolic_tangent(double x) {
    const double e = base::portable_exp(-2 * std::abs(x));
    return std::copysign((1 - e) / (1 + e), x);
}

double saturating(double difference) { return kSaturation * hyperbolic_tangent(difference / kSaturation); }

double logarithm_of_unit(base::RandomStream& chance) { return base::portable_log(std::max(chance.unit(), 1e-300)); }

// Gamma of a shape below 1: an exponential number times a power of a uniform one (Stuart 1962).
double gamma(double shape, base::RandomStream& chance) {
    const double exponential = -logarithm_of_unit(chance);
    return exponential * base::portable_exp(logarithm_of_unit(chance) / shape);
}

void make_sum_one(std::vector<double>& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    for (double& value : values) value /= sum;
}

// Half of the visitors care for a few parameters by chance, half for each less than for the one before.
std::vector<double> random_weights(std::size_t n, base::RandomStream& chance) {
    std::vector<double> weights(n);
    const bool is_sparse = chance.unit() < 0.5;
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[chance.below(static_cast<std::uint32_t>(i))]);
    for (std::size_t i = 0; i < n; ++i)
        weights[i] = is_sparse
                         ? gamma(0.35, chance) + 1e-12
                         : base::portable_exp(-static_cast<double>(order[i]) / (0.12 * static_cast<double>(n) + 1));
    make_sum_one(weights);
    return weights;
}

struct Mixture {
    std::array<double, 3> of_archetypes;  // which, as a share of all there are
    std::vector<double> weights;
};

Mixture random_mixture(base::RandomStream& chance) {
    Mixture mixture{{chance.unit(), chance.unit(), chance.unit()}, {}};
    for (int i = 0; i < 3; ++i) mixture.weights.push_back(gamma(0.6, chance) + 1e-12);
    make_sum_one(mixture.weights);
    return mixture;
}

Place random_place(std::size_t n, base::RandomStream& chance) {
    Place place(n);
    for (double& x : place) x = chance.unit();
    return place;
}

Place near(const Mixture& mixture, const std::vector<Place>& archetypes, base::RandomStream& chance) {
    Place place(archetypes.front().size(), 0.0);
    for (std::size_t k = 0; k < mixture.weights.size(); ++k) {
        const auto which = static_cast<std::size_t>(mixture.of_archetypes[k] * static_cast<double>(archetypes.size()));
        for (std::size_t i = 0; i < place.size(); ++i) place[i] += mixture.weights[k] * archetypes[which][i];
    }
    for (double& x : place) x = std::clamp(x + kResidue * static_cast<double>(chance.normal()), 0.0, 1.0);
    return place;
}

}  // namespace

std::string_view name_of(World world) { return world == World::Anywhere ? "anywhere" : "near archetypes"; }
std::string_view name_of(Noise noise) {
    return noise == Noise::None ? "none" : noise == Noise::Mild ? "mild" : "strong";
}

double tau_of(Noise noise) {
    switch (noise) {
        case Noise::None:
            return 0;
        case Noise::Mild:
            return 0.05;
        case Noise::Strong:
            return 0.15;
    }
    return 0;
}

SimulatedVisitor::SimulatedVisitor(genome::Genome genome, World world, Noise noise,
                                   const genome::PerAspect<std::vector<Place>>& archetypes, base::Seed seed)
    : genome_(genome), noise_(noise) {
    base::RandomStream chance(seed.child("visitor"));
    const bool is_coherent = chance.unit() < 0.5;  // wants the same mixture in all aspects
    Mixture mixture = random_mixture(chance);
    for (const Aspect aspect : kAspects) {
        Eye& eye = aspects_[aspect];
        const std::size_t n = parameters_of(aspect, genome).size();
        if (!is_coherent) mixture = random_mixture(chance);
        eye.wish = world == World::Anywhere ? random_place(n, chance) : near(mixture, archetypes[aspect], chance);
        eye.weights = random_weights(n, chance);
        const auto some = [&] { return static_cast<std::size_t>(chance.below(static_cast<std::uint32_t>(n))); };
        for (std::size_t pair = 0; pair < n / 2; ++pair) eye.together.push_back({some(), some()});
        for (std::size_t i = 0; i < n; ++i) eye.gate.push_back(chance.unit() < kGated ? some() : i);
    }
    base::RandomStream scenes(seed.child("random scenes"));
    std::vector<double> distances(kRandomScenes, 0.0);
    for (const Aspect aspect : kAspects) {
        Eye& eye = aspects_[aspect];
        std::vector<double> raw;
        for (std::size_t s = 0; s < kRandomScenes; ++s)
            raw.push_back(raw_distance(eye, random_place(eye.wish.size(), scenes)));
        eye.norm = std::accumulate(raw.begin(), raw.end(), 0.0) / kRandomScenes;
        for (std::size_t s = 0; s < kRandomScenes; ++s)
            distances[s] += raw[s] * raw[s] / (eye.norm * eye.norm) / static_cast<double>(kAspects.size());
    }
    random_distance_ = 0;
    for (const double square : distances) random_distance_ += std::sqrt(square) / kRandomScenes;
}

double SimulatedVisitor::raw_distance(const Eye& eye, const Place& place) const {
    double alone = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const double gate = eye.gate[i] == i ? 1 : 0.3 + 0.7 * place[eye.gate[i]];
        const double difference = saturating(place[i] - eye.wish[i]);
        alone += eye.weights[i] * gate * difference * difference;
    }
    double together = 0;
    double weights = 0;
    for (const auto& [a, b] : eye.together) {
        const double difference = saturating(place[a] * place[b] - eye.wish[a] * eye.wish[b]);
        const double weight = std::sqrt(eye.weights[a] * eye.weights[b]);
        together += weight * difference * difference;
        weights += weight;
    }
    if (weights > 0) together /= weights;
    return std::sqrt((1 - kInteractions) * alone + kInteractions * together);
}

SimulatedVisitor SimulatedVisitor::drifted(const SimulatedVisitor& to, double share) const {
    SimulatedVisitor moved = *this;
    for (const Aspect aspect : kAspects) {
        Place& wish = moved.aspects_[aspect].wish;
        const Place& other = to.aspects_[aspect].wish;
        for (std::size_t i = 0; i < wish.size(); ++i) {
            const double turn = kGoldenShare * static_cast<double>(i + 1);
            if (turn - std::floor(turn) < share) wish[i] = other[i];
        }
    }
    return moved;
}

double SimulatedVisitor::distance(const Place& place, Aspect aspect) const {
    return raw_distance(aspects_[aspect], place) / aspects_[aspect].norm;
}

double SimulatedVisitor::distance(const genome::ParameterValues& values) const {
    double squares = 0;
    for (const Aspect aspect : kAspects) {
        const double one = distance(place_of(values, genome_, aspect), aspect);
        squares += one * one / static_cast<double>(kAspects.size());
    }
    return std::sqrt(squares);
}

// Gumbel noise makes the largest utility a Plackett-Luce choice.
double SimulatedVisitor::seen(double distance, base::RandomStream& chance) const {
    const double looks = kIndifferent * hyperbolic_tangent(distance / kIndifferent);
    return looks + tau_of(noise_) * base::portable_log(-logarithm_of_unit(chance) + 1e-300);
}

std::size_t SimulatedVisitor::pick(std::span<const Place> places, Aspect aspect, base::RandomStream& chance) const {
    const bool is_meaningless = noise_ != Noise::None && chance.unit() < kMeaningless;
    const auto any = chance.below(static_cast<std::uint32_t>(places.size()));
    std::size_t best = 0;
    double least = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double looks = seen(distance(places[k], aspect), chance);
        if (k == 0 || looks < least) {
            least = looks;
            best = k;
        }
    }
    return is_meaningless ? any : best;
}

}  // namespace quadrat::breeding
