// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "breeding/belief/coordinates.hpp"
#include "breeding/simulation/tournament.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;
using testing::HasSubstr;

constexpr int kVisitors = 120;

Tournament tournament_of(genome::Genome genome) {
    Tournament tournament;
    tournament.genome = genome;
    tournament.visitors = kVisitors;
    return tournament;
}

genome::ParameterValues wish_of(const SimulatedVisitor& visitor) {
    genome::ParameterValues values;
    for (const Aspect aspect : kAspects) set_values(values, visitor.genome(), aspect, visitor.wish(aspect));
    return values;
}

genome::ParameterValues by_chance(genome::Genome genome, base::RandomStream& chance) {
    genome::ParameterValues values;
    for (const Aspect aspect : kAspects) {
        Place place(parameters_of(aspect, genome).size());
        for (double& x : place) x = chance.unit();
        set_values(values, genome, aspect, place);
    }
    return values;
}

class Visitors : public testing::TestWithParam<genome::Genome> {};
INSTANTIATE_TEST_SUITE_P(Genomes, Visitors, testing::Values(genome::Genome::Classic, genome::Genome::Full),
                         [](const auto& one) { return one.param == genome::Genome::Classic ? "Classic" : "Words"; });

TEST_P(Visitors, AreAsCloseAsCanBeAtTheirWishAndNotAtAllToRandomScenes) {
    double sum = 0;
    base::RandomStream chance{base::Seed{2}};
    for (int number = 0; number < 20; ++number) {
        const SimulatedVisitor visitor = visitor_of(tournament_of(GetParam()), number);
        EXPECT_NEAR(visitor.closeness(wish_of(visitor)), 1, 1e-3);
        for (int scene = 0; scene < 50; ++scene) sum += visitor.closeness(by_chance(GetParam(), chance));
    }
    EXPECT_NEAR(sum / 1000, 0, 0.05);
}

TEST_P(Visitors, CareForFewParametersMuch) {
    double largest_tenth = 0;
    for (int number = 0; number < 20; ++number) {
        std::vector<double> weights = visitor_of(tournament_of(GetParam()), number).weights(Aspect::Land);
        std::ranges::sort(weights, std::greater{});
        const std::size_t tenth = std::max<std::size_t>(1, weights.size() / 10);
        for (std::size_t i = 0; i < tenth; ++i) largest_tenth += weights[i] / 20;
    }
    EXPECT_GT(largest_tenth, 0.3);
}

TEST(OneVisitor, ChoosesByPlackettAndLuceExceptForOnePickInTen) {
    const SimulatedVisitor visitor = visitor_of(tournament_of(genome::Genome::Classic), 3);
    base::RandomStream scenes{base::Seed{9}};
    const std::vector<Place> places{
        place_of(by_chance(genome::Genome::Classic, scenes), genome::Genome::Classic, Aspect::Sky),
        place_of(by_chance(genome::Genome::Classic, scenes), genome::Genome::Classic, Aspect::Sky)};
    const auto looks = [&](const Place& place) { return 1.3 * std::tanh(visitor.distance(place, Aspect::Sky) / 1.3); };
    const double odds = std::exp((looks(places[1]) - looks(places[0])) / 0.05);
    const double expected = 0.9 * odds / (1 + odds) + 0.1 / 2;
    base::RandomStream chance{base::Seed{10}};
    int first = 0;
    constexpr int kPicks = 20'000;
    for (int i = 0; i < kPicks; ++i) first += visitor.pick(places, Aspect::Sky, chance) == 0;
    EXPECT_NEAR(static_cast<double>(first) / kPicks, expected, 0.015);
}

TEST(Tournament, IsTheSameWhoeverPlaysTheOthers) {
    const Tournament tournament = tournament_of(genome::Genome::Classic);
    const SimulatedVisitor visitor = visitor_of(tournament, 7);
    const Played alone = play(tournament, visitor, 7, Method::Belief);
    play(tournament, visitor, 7, Method::Pbil);
    EXPECT_EQ(play(tournament, visitor_of(tournament, 7), 7, Method::Belief).closeness, alone.closeness);
    EXPECT_NE(play(tournament, visitor_of(tournament, 8), 8, Method::Belief).closeness, alone.closeness);
}

std::vector<Standing> standings_of(const Tournament& tournament, const std::vector<Method>& methods) {
    std::vector<Standing> standings;
    for (const Method method : methods) {
        std::vector<Played> played;
        for (int number = 0; number < tournament.visitors; ++number)
            played.push_back(play(tournament, visitor_of(tournament, number), number, method));
        standings.push_back(standing_of(method, played));
    }
    return standings;
}

// What the exhibit is built for, in wide margins: the table itself is printed by quadrat simulate.
TEST(Tournament, InTheClassicParametersABeliefIsMineByTheThirdRound) {
    const Figures figures =
        figures_of(standings_of(tournament_of(genome::Genome::Classic),
                                {Method::Belief, Method::Pbil, Method::SlidersNovice3, Method::Projection}));
    EXPECT_GT(figures.after_5.value, 0.46);
    EXPECT_GT(figures.times_pbil.value, 1.6);
    EXPECT_GE(figures.rounds_to_pbil_15, 1);
    EXPECT_LE(figures.rounds_to_pbil_15, 5);
    EXPECT_LT(figures.worse.value, 0.16);
    EXPECT_GT(figures.ahead_of_novice_5.value, -0.02);
}

TEST(Tournament, InWordsItIsWherePbilAndSlidersNeverCome) {
    const Figures figures =
        figures_of(standings_of(tournament_of(genome::Genome::Full),
                                {Method::Belief, Method::Pbil, Method::SlidersNovice3, Method::Projection}));
    EXPECT_GT(figures.of_projection.value, 0.6);
    EXPECT_GT(figures.times_pbil.value, 4);
    EXPECT_GE(figures.rounds_to_pbil_15, 1);
    EXPECT_LE(figures.rounds_to_pbil_15, 2);
    EXPECT_LT(figures.worse.value, 0.15);
    EXPECT_GT(figures.ahead_of_novice_5.value, 0.1);
    EXPECT_GT(figures.ahead_of_novice_8.value, 0.1);
}

Standing standing_in(Party party, Method method) {
    Tournament tournament = tournament_of(genome::Genome::Full);
    tournament.party = party;
    tournament.visitors = 40;
    tournament.rounds = 8;
    std::vector<Played> played;
    for (int number = 0; number < tournament.visitors; ++number)
        played.push_back(play(tournament, guests_of(tournament, number), number, method));
    return standing_of(method, played);
}

TEST(Parties, AreWhoTheyAreSaidToBe) {
    Tournament tournament = tournament_of(genome::Genome::Full);
    EXPECT_EQ(guests_of(tournament, 5).size(), 1U);
    tournament.party = Party::Group;
    const Guests group = guests_of(tournament, 5);
    ASSERT_EQ(group.size(), static_cast<std::size_t>(kInAGroup));
    EXPECT_NE(group[0].wish(Aspect::Land), group[1].wish(Aspect::Land));
    EXPECT_NE(group[1].wish(Aspect::Land), group[2].wish(Aspect::Land));
    tournament.party = Party::Drifting;
    tournament.rounds = 8;
    const Guests drifting = guests_of(tournament, 5);
    ASSERT_EQ(drifting.size(), 8U);
    EXPECT_EQ(drifting.front().wish(Aspect::Land), visitor_of(tournament, 5).wish(Aspect::Land));
    std::size_t before = 0;
    for (const SimulatedVisitor& now : drifting) {
        const Place& first = drifting.front().wish(Aspect::Land);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < first.size(); ++i) changed += now.wish(Aspect::Land)[i] != first[i] ? 1U : 0U;
        EXPECT_GE(changed, before);
        before = changed;
    }
    const auto all = static_cast<double>(drifting.front().wish(Aspect::Land).size());
    EXPECT_NEAR(static_cast<double>(before), 0.5 * all, 0.08 * all);
}

TEST(Parties, WhoDriftIsFollowedAndWhoTakeTurnsComeNearerTogether) {
    for (const Party party : {Party::Drifting, Party::Group}) {
        const Standing belief = standing_in(party, Method::Belief);
        const Standing gaussian = standing_in(party, Method::PbilGaussian);
        const Standing none = standing_in(party, Method::NoPick);
        const double error = belief.standard_error.back() + none.standard_error.back();
        EXPECT_GT(belief.closeness.back(), none.closeness.back() + 3 * error) << name_of(party);
        EXPECT_GT(belief.closeness.back(), gaussian.closeness.back() + 3 * error) << name_of(party);
        EXPECT_EQ(belief.worse_share, 0);
    }
}

TEST(Figures, FollowFromTheStandings) {
    const auto standing = [](Method method, double at_5, double at_8, double at_15) {
        Standing one{method, std::vector<double>(15, at_5), std::vector<double>(15, 0.01), 0, 0};
        one.closeness[0] = at_5 / 2;
        one.closeness[7] = at_8;
        one.closeness[14] = at_15;
        return one;
    };
    std::vector<Standing> standings{standing(Method::Belief, 0.4, 0.5, 0.6), standing(Method::Pbil, 0.1, 0.2, 0.3),
                                    standing(Method::SlidersNovice3, 0.3, 0.7, 0.8),
                                    standing(Method::Projection, 0.8, 0.8, 0.8)};
    const Figures figures = figures_of(standings);
    EXPECT_DOUBLE_EQ(figures.of_projection.value, 0.5);
    EXPECT_NEAR(figures.of_projection.error, 0.5 * std::hypot(0.01 / 0.4, 0.01 / 0.8), 1e-12);
    EXPECT_DOUBLE_EQ(figures.times_pbil.value, 4);
    EXPECT_EQ(figures.rounds_to_pbil_15, 2);
    EXPECT_NEAR(figures.ahead_of_novice_5.value, 0.1, 1e-12);
    EXPECT_NEAR(figures.ahead_of_novice_8.value, -0.2, 1e-12);
    EXPECT_NEAR(figures.ahead_of_novice_8.error, 0.01 * std::sqrt(2), 1e-12);
    standings[1].closeness[14] = 0.9;
    EXPECT_THAT(text_of(figures_of(standings)), HasSubstr("never"));
}

TEST(Tournament, IsToldAsATableAndAPlotOfAllMethodsWithTheirErrors) {
    Tournament tournament = tournament_of(genome::Genome::Classic);
    tournament.visitors = 2;
    tournament.rounds = 5;
    const auto standings = standings_of(tournament, all_methods());
    const std::string table = table_of(tournament, standings);
    const std::string plot = plot_of(tournament, standings);
    for (const Method method : all_methods()) {
        EXPECT_THAT(table, HasSubstr(std::string(name_of(method))));
        EXPECT_THAT(plot, HasSubstr(std::string(name_of(method))));
    }
    EXPECT_THAT(table, HasSubstr("±"));
    EXPECT_THAT(plot, testing::StartsWith("<svg"));
    EXPECT_THAT(plot, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(plot, testing::Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace quadrat::breeding
