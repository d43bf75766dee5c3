// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/comes_back.hpp"

#include <algorithm>
#include <cmath>

#include "genome/parameter_rules.hpp"

namespace quadrat::breeding {
namespace {

constexpr double kHeard = 0.5;  // of the way to its neighbours
constexpr double kLeast = 0.12;
constexpr double kMost = 0.6;
constexpr std::size_t kNeighbours = 3;

double distance(const Point& a, const Point& b) {
    double squares = 0;
    for (std::size_t d = 0; d < a.size(); ++d) squares += (a[d] - b[d]) * (a[d] - b[d]);
    return std::sqrt(squares);
}

ComesBack how_it_comes_back(const WordMap& map, const DescribedScene& scene, double radius) {
    genome::ParameterValues again;
    map.realise(scene.aspect, map.completed(scene.words), again);
    genome::ParameterValues wanted = scene.values;
    genome::make_consistent(scene.aspect, wanted);
    ComesBack back{radius};
    const auto ids = parameters_of(scene.aspect, genome::Genome::Full);
    for (const genome::ParameterId id : ids) {
        const genome::Parameter& row = parameter(id);
        double off = std::abs(static_cast<double>(again[id]) - wanted[id]) / (static_cast<double>(row.max) - row.min);
        if (row.unit == genome::kChoice) off = off > 0 ? 1 : 0;
        back.error += off * off / static_cast<double>(ids.size());
        if (off <= back.worst_error) continue;
        back.worst = id;
        back.worst_error = off;
    }
    back.error = std::sqrt(back.error);
    return back;
}

}  // namespace

std::vector<double> hearing_of(std::span<const Point> places) {
    std::vector<double> hearing;
    for (const Point& at : places) {
        std::vector<double> apart;
        for (const Point& other : places)
            if (const double d = distance(at, other); d > 0) apart.push_back(d);
        const std::size_t count = std::min(apart.size(), kNeighbours);
        std::ranges::partial_sort(apart, apart.begin() + static_cast<std::ptrdiff_t>(count));
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += apart[i];
        hearing.push_back(count == 0 ? kMost : std::clamp(kHeard * sum / static_cast<double>(count), kLeast, kMost));
    }
    return hearing;
}

std::vector<ComesBack> how_scenes_come_back(const WordMap& map) {
    genome::PerAspect<std::vector<Point>> places;
    for (const DescribedScene& scene : map.scenes()) {
        const genome::Description words = map.completed(scene.words);
        Point& place = places[scene.aspect].emplace_back();
        for (const genome::Word& word : genome::vocabulary(scene.aspect)) place.push_back(words[word.id]);
    }
    genome::PerAspect<std::vector<double>> hearing;
    for (const genome::Aspect aspect : genome::kAspects) hearing[aspect] = hearing_of(places[aspect]);
    genome::PerAspect<std::size_t> next;
    std::vector<ComesBack> all;
    for (const DescribedScene& scene : map.scenes())
        all.push_back(how_it_comes_back(map, scene, hearing[scene.aspect][next[scene.aspect]++]));
    return all;
}

}  // namespace quadrat::breeding
