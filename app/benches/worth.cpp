// SPDX-License-Identifier: Apache-2.0
// What a procedural system is judged by: "how fast, how diverse, how easy" (Watson et al. 2008, as the report on
// procedural modelling takes it up). How believable it is the exhibit asks its visitors: Describe, and the report.
#include <algorithm>
#include <cmath>

#include "benches/benches.hpp"
#include "breeding/breeder.hpp"
#include "breeding/reach.hpp"
#include "breeding/session.hpp"
#include "breeding/simulation/tournament.hpp"
#include "nursery/growing.hpp"
#include "stage/eye.hpp"

namespace quadrat::benches {
namespace {

constexpr double kAsWished = 0.25;  // closeness from which on somebody has about what they wished for

double apart(const stage::Sight& a, const stage::Sight& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

::quadrat::breeding::BreederOptions as_delivered() {
    ::quadrat::breeding::BreederOptions options;
    options.kind = ::quadrat::breeding::BreederKind::Belief;
    options.genome = genome::Genome::Full;
    return options;
}

// Of two of a first offer, as somebody sees them who glances at them.
double pictures_apart(int offers) {
    const ::quadrat::breeding::BreederOptions options = as_delivered();
    stage::Eye eye;
    double sum = 0;
    int pairs = 0;
    for (int number = 1; number <= offers; ++number) {
        const ::quadrat::breeding::Session session(::quadrat::breeding::Breeder(options),
                                                   base::Seed{static_cast<std::uint64_t>(number)});
        std::vector<genome::Recipe> four;
        for (const genome::Candidate& candidate : session.offer().candidates)
            four.push_back(genome::recipe_of(candidate, session.flight()));
        const std::vector<stage::Sight> sights = eye.look(four);
        for (std::size_t i = 0; i < sights.size(); ++i)
            for (std::size_t j = 0; j < i; ++j, ++pairs) sum += apart(sights[i], sights[j]);
    }
    return sum / pairs;
}

// Rounds until somebody has it; whoever never has it counts as one more than they played.
double rounds_to_a_wish(::quadrat::breeding::Method method) {
    ::quadrat::breeding::Tournament tournament;
    tournament.genome = genome::Genome::Full;
    tournament.visitors = 40;
    double rounds = 0;
    for (int number = 0; number < tournament.visitors; ++number) {
        const auto visitor = ::quadrat::breeding::visitor_of(tournament, number);
        const auto played = ::quadrat::breeding::play(tournament, visitor, number, method);
        const auto at = std::ranges::find_if(played.closeness, [](double c) { return c >= kAsWished; });
        rounds += static_cast<double>(at - played.closeness.begin()) + 1;
    }
    return rounds / tournament.visitors;
}

}  // namespace

void worth(Results& results) {
    results.push_back({"worth.fastest_scene_ms",
                       median_over_scenes(8, [](const genome::Recipe& recipe) { nursery::grow(recipe); }),
                       "ms from nothing to a landscape, the median of eight", cores()});
    const ::quadrat::breeding::Reach reach = ::quadrat::breeding::reach_of(as_delivered(), {40, 1});
    results.push_back({"worth.diverse_parameters", reach.difference,
                       "between two of a first offer, of a parameter's range, root mean square", 1});
    results.push_back({"worth.diverse_pictures", pictures_apart(6),
                       "between two of a first offer, OKLab of small pictures, root mean square", cores()});
    using ::quadrat::breeding::Method;
    results.push_back({"worth.easy_rounds", rounds_to_a_wish(Method::Belief),
                       "rounds until a simulated visitor is a quarter of the way to their wish", 1});
    results.push_back({"worth.easy_rounds_by_sliders", rounds_to_a_wish(Method::SlidersNovice3),
                       "the same, with as many sliders moved a round by a novice", 1});
}

}  // namespace quadrat::benches
