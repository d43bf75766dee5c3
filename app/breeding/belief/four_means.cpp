// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/four_means.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace quadrat::breeding {
namespace {

constexpr int kIterations = 12;

std::size_t nearest(const FourPlaces& centres, const Place& place) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < centres.size(); ++k)
        if (squared_distance(centres[k], place) < squared_distance(centres[best], place)) best = k;
    return best;
}

}  // namespace

double squared_distance(const Place& a, const Place& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

std::vector<std::size_t> farthest_first(std::span<const Place> places, std::size_t first, std::size_t count) {
    std::vector<std::size_t> order;
    std::vector<double> distance(places.size(), std::numeric_limits<double>::infinity());
    std::size_t next = first;
    while (order.size() < std::min(count, places.size())) {
        order.push_back(next);
        for (std::size_t i = 0; i < places.size(); ++i)
            distance[i] = std::min(distance[i], squared_distance(places[i], places[next]));
        distance[next] = -1;
        next = static_cast<std::size_t>(std::ranges::max_element(distance) - distance.begin());
    }
    return order;
}

std::vector<std::size_t> drawn_apart(std::span<const Place> places, std::size_t count, base::RandomStream& chance) {
    assert(places.size() >= 2 * count);
    std::vector<std::size_t> drawn{chance.below(static_cast<std::uint32_t>(places.size()))};
    std::vector<double> distance(places.size(), std::numeric_limits<double>::infinity());
    while (drawn.size() < count) {
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < places.size(); ++i) {
            distance[i] = std::min(distance[i], squared_distance(places[i], places[drawn.back()]));
            if (std::ranges::find(drawn, i) == drawn.end()) others.push_back(i);
        }
        std::ranges::stable_sort(others, std::ranges::greater{}, [&](std::size_t i) { return distance[i]; });
        drawn.push_back(others[chance.below(static_cast<std::uint32_t>(others.size() / 2))]);
    }
    return drawn;
}

FourPlaces four_means(std::span<const Place> samples) {
    assert(samples.size() >= genome::kCandidates);
    FourPlaces centres;
    const auto begin = farthest_first(samples, 0, genome::kCandidates);
    for (std::size_t k = 0; k < centres.size(); ++k) centres[k] = samples[begin[k]];
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        FourPlaces sums;
        std::array<double, genome::kCandidates> counts{};
        for (Place& sum : sums) sum.assign(samples.front().size(), 0.0);
        for (const Place& sample : samples) {
            const std::size_t k = nearest(centres, sample);
            counts[k] += 1;
            for (std::size_t i = 0; i < sample.size(); ++i) sums[k][i] += sample[i];
        }
        for (std::size_t k = 0; k < centres.size(); ++k)
            if (counts[k] > 0)
                for (std::size_t i = 0; i < sums[k].size(); ++i) centres[k][i] = sums[k][i] / counts[k];
    }
    return centres;
}

}  // namespace quadrat::breeding
