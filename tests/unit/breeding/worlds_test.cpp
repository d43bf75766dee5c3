// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/belief/taste.hpp"
#include "breeding/simulation/replay.hpp"
#include "breeding/simulation/seeing.hpp"
#include "breeding/simulation/study.hpp"
#include "breeding/words/detail_axes.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;
using testing::HasSubstr;

// Pictures that show parameters as they are.
std::vector<Picture> bare(const std::vector<Look>& looks) {
    std::vector<Picture> pictures;
    for (const Look& look : looks) {
        const Place place = place_of(look.in.values, genome::Genome::Full, look.aspect);
        pictures.emplace_back(place.begin(), place.end());
    }
    return pictures;
}

TEST(SeeingWorld, BreedingComesNearerThanChanceAndTheSameAgain) {
    SeeingWorld world;
    world.visitors = 8;
    world.rounds = 5;
    const SeenWorld seen = play_seeing(world, bare);
    ASSERT_EQ(seen.belief.size(), 5U);
    EXPECT_LT(seen.belief[4].nearest.value, 0.8 * seen.biased_random[0].nearest.value);
    EXPECT_GT(seen.belief[4].apart, 0.2);
    const SeenWorld again = play_seeing(world, bare);
    EXPECT_EQ(seen.belief[4].nearest.value, again.belief[4].nearest.value);
    EXPECT_THAT(table_of(world, seen), HasSubstr("biased random, any round"));
}

TEST(SeeingWorld, ShowsOneAspectAtATimeInTheLandscapeThatIsWishedFor) {
    SeeingWorld world;
    world.visitors = 2;
    world.rounds = 1;
    int looks_at_one = 0;
    play_seeing(world, [&](const std::vector<Look>& looks) {
        for (const Look& look : looks) {
            const Look& first = looks[look.visitor * 15];  // the visitor's own wish, of the trees
            for (const Aspect other : kAspects) {
                if (other == look.aspect || other == first.aspect) continue;
                EXPECT_EQ(place_of(look.in.values, genome::Genome::Full, other),
                          place_of(first.in.values, genome::Genome::Full, other));
                ++looks_at_one;
            }
        }
        return bare(looks);
    });
    EXPECT_GT(looks_at_one, 0);
}

std::vector<PastVisit> visits_of(Noise noise, bool picks_anything) {
    Tournament tournament;
    tournament.genome = genome::Genome::Full;
    tournament.noise = noise;
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    std::vector<PastVisit> visits;
    for (int v = 0; v < 12; ++v) {
        const SimulatedVisitor visitor = visitor_of(tournament, v);
        Session session(Breeder(options), base::Seed{static_cast<std::uint64_t>(v)});
        base::RandomStream chance{base::Seed{99}.child(v)};
        PastVisit& visit = visits.emplace_back();
        for (int round = 0; round < 6; ++round) {
            genome::Pick pick;
            for (const Aspect aspect : kAspects) {
                std::vector<Place> places;
                for (const genome::Candidate& candidate : session.offer().candidates)
                    places.push_back(place_of(candidate.values, genome::Genome::Full, aspect));
                pick[aspect] = picks_anything ? chance.below(4) : visitor.pick(places, aspect, chance);
            }
            visit.push_back({session.offer(), pick});
            session.next(pick);
        }
    }
    return visits;
}

TEST(Replay, TellsVisitorsWhoMeanItFromThoseWhoPressAnything) {
    const WordMap& map = default_word_map();
    const auto meant = visits_of(Noise::None, false);
    const auto anything = visits_of(Noise::None, true);
    const Foretelling of_meant = foretelling(BreederKind::Belief, genome::Genome::Full, map, meant);
    const Foretelling of_anything = foretelling(BreederKind::Belief, genome::Genome::Full, map, anything);
    EXPECT_EQ(of_meant.picks, 12 * 5 * 3);
    EXPECT_GT(of_meant.bits.value, 0.1);
    EXPECT_LT(of_anything.bits.value, 0.05);
    EXPECT_GT(of_anything.indifference, 4 * of_meant.indifference);
    EXPECT_THAT(table_of(std::vector{of_meant}), HasSubstr("belief"));
}

TEST(Replay, OfNoVisitsKnowsNothing) {
    const Foretelling none = foretelling(BreederKind::Belief, genome::Genome::Full, default_word_map(), {});
    EXPECT_EQ(none.picks, 0);
    EXPECT_EQ(none.bits.value, 0);
}

// Two parameters that a picture shows, one of which no word moves much.
TEST(DetailAxes, PointWherePicturesChangeMostAndSayHowMuchIsSeen) {
    const WordMap& map = default_word_map();
    const Atlas& atlas = map.atlas(Aspect::Sky);
    PictureJacobian pictures = PictureJacobian::Zero(static_cast<Eigen::Index>(atlas.ids.size()), 4);
    const auto row_of = [&](genome::ParameterId id) {
        return static_cast<Eigen::Index>(std::ranges::find(atlas.ids, id) - atlas.ids.begin());
    };
    pictures(row_of(*genome::parameter_named("cirrus.bearing_deg")), 0) = 3;
    pictures(row_of(*genome::parameter_named("star.band_deg")), 1) = 1;
    const DetailAxes axes = detail_axes(map, Aspect::Sky, std::vector{pictures}, 2);
    ASSERT_GE(axes.axes.size(), 1U);
    EXPECT_GT(std::abs(axes.axes[0].at(*genome::parameter_named("cirrus.bearing_deg"))), 0.8);
    EXPECT_GT(axes.seen.at(*genome::parameter_named("cirrus.bearing_deg")),
              2.9 * axes.seen.at(*genome::parameter_named("star.band_deg")));
    const std::string json = to_json(axes, Aspect::Sky);
    const DetailAxes read = detail_axes_from(json, "axes", Aspect::Sky);
    EXPECT_EQ(to_json(read, Aspect::Sky), json);
    EXPECT_THROW(detail_axes_from(json, "axes", Aspect::Land), base::InputError);
    EXPECT_THROW(detail_axes_from("{}", "axes", Aspect::Sky), base::InputError);
}

// `quadrat words axes` was run, and what it wrote is what breeding searches.
TEST(DetailAxes, ComeAlongMeasuredForEveryAspect) {
    for (const Aspect aspect : kAspects) {
        const DetailAxes& measured = measured_axes(aspect);
        const Atlas& atlas = default_word_map().atlas(aspect);
        EXPECT_EQ(measured.seen.size(), atlas.ids.size());
        EXPECT_GE(measured.axes.size(), 5U);
        EXPECT_EQ(atlas.detail_axes, measured.axes.size());
        EXPECT_GT(*std::ranges::max_element(atlas.seen), 2 * *std::ranges::min_element(atlas.seen));
    }
}

TEST(Atlas, HasOrthonormalAxesThatSpanAllAmounts) {
    for (const Aspect aspect : kAspects) {
        const Atlas& atlas = default_word_map().atlas(aspect);
        const auto amounts = std::ranges::count_if(
            atlas.ids, [](genome::ParameterId id) { return parameter(id).unit != genome::kChoice; });
        EXPECT_EQ(atlas.axes.size(), static_cast<std::size_t>(amounts));
        for (std::size_t a = 0; a < atlas.axes.size(); ++a)
            for (std::size_t b = 0; b <= a; ++b) {
                double product = 0;
                for (std::size_t p = 0; p < atlas.ids.size(); ++p) product += atlas.axes[a][p] * atlas.axes[b][p];
                EXPECT_NEAR(product, a == b ? 1 : 0, 1e-9);
            }
    }
}

TEST(Study, TellsWhatThePaperTellsOfEveryWayAndSkill) {
    Study small;
    small.users = 4;
    int told = 0;
    const auto rows = study(small, [&] { ++told; });
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(told, 24);
    // In 21 parameters PBIL loses to skilled hands on sliders, as it did in the paper.
    EXPECT_EQ(rows[0].skill, Skill::Skilled);
    EXPECT_LT(rows[0].closeness.value, 0);
    // In the whole table a novice's sliders lose.
    EXPECT_EQ(rows[5].skill, Skill::Novice);
    EXPECT_GT(rows[5].closeness.value, 0);
    EXPECT_GT(rows[5].preference.value, 0);
    EXPECT_THAT(table_of(small, rows), HasSubstr("-0.75"));
}

Taste taste_for(const std::string& name, int visits) {
    Taste taste;
    taste.chosen[Aspect::Trees][name] = visits;
    return taste;
}

TEST(Taste, MovesWhatIsBelievedSlowlyAndSoFarOnly) {
    const std::string first = default_word_map().atlas(Aspect::Trees).names.front();
    const std::size_t named = default_word_map().atlas(Aspect::Trees).names.size();
    EXPECT_EQ(weight_of({}, Aspect::Trees, first, named), 1);
    const double after_one = weight_of(taste_for(first, 1), Aspect::Trees, first, named);
    EXPECT_GT(after_one, 1);
    EXPECT_LT(after_one, 1.3);
    EXPECT_EQ(weight_of(taste_for(first, 100'000), Aspect::Trees, first, named), 2);
    EXPECT_EQ(weight_of(taste_for(first, 100'000), Aspect::Trees, "another", named), 0.5) << "never given up";
    EXPECT_EQ(weight_of(taste_for(first, 100'000), Aspect::Land, first, named), 1);
}

TEST(Taste, CountsTheNamedSceneThatWasComeTo) {
    const WordMap& map = default_word_map();
    const DescribedScene& scene = archetypes(Aspect::Sky)[2];
    genome::Candidate bred;
    bred.values = scene.values;
    Taste taste;
    genome::PerAspect<bool> judged;
    judged[Aspect::Sky] = true;
    add(taste, map, bred, judged);
    EXPECT_EQ(taste.chosen[Aspect::Sky].at(scene.name), 1);
    EXPECT_TRUE(taste.chosen[Aspect::Trees].empty());
    taste.since = 12;
    EXPECT_EQ(taste_from(to_json(taste), "taste"), taste);
    EXPECT_THROW(taste_from("{}", "taste"), base::InputError);
}

TEST(Taste, NeverPullsToWhatACuratorForbade) {
    const WordMap& map = default_word_map();
    const Atlas& atlas = map.atlas(Aspect::Trees);
    const auto tallest = std::ranges::max_element(atlas.named_words, {}, [](const Point& words) { return words[2]; });
    const Taste taste = taste_for(atlas.names[static_cast<std::size_t>(tallest - atlas.named_words.begin())], 1000);
    const auto share_of_tall = [&](const WordRanges& ranges) {
        const std::vector<double> weights = blend_weights(map, Aspect::Trees, taste, ranges);
        double tall = 0;
        double all = 0;
        for (std::size_t b = 0; b < weights.size(); ++b) {
            double word = 0;
            for (std::size_t k = 0; k < 3; ++k)
                word += atlas.blends[b].shares[k] * atlas.named_words[atlas.blends[b].of[k]][2];
            all += std::exp(weights[b]);
            if (word > 0.3) tall += std::exp(weights[b]);
        }
        return tall / all;
    };
    WordRanges low;
    low[static_cast<std::size_t>(genome::WordId::tall)] = {-1, 0.3F};
    EXPECT_LT(share_of_tall(low), share_of_tall({}));
}

}  // namespace
}  // namespace quadrat::breeding
