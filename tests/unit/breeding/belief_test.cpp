// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/session.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

Session session_of(genome::Genome genome, std::uint64_t seed = 3) {
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome;
    return {Breeder(options), base::Seed{seed}};
}

// In one dimension a half-space of a Gaussian has moments in closed form; noise and doubt are small against it here.
TEST(Wish, MovesToTheSideOfWhatWasNamed) {
    const Wish before = isotropic_wish(1);
    const std::vector<Place> shown{{0.9}, {0.1}};
    const Wish after = learnt(before, shown, 0);
    EXPECT_GT(after.mean[0], 0.55);
    EXPECT_LT(after.mean[0], 0.5 + before.covariance[0] / std::sqrt(before.covariance[0]) * std::sqrt(2 / 3.14159265));
    EXPECT_LT(after.covariance[0], before.covariance[0]);
    EXPECT_GT(after.covariance[0], before.covariance[0] * (1 - 2 / 3.14159265));
    // Symmetric: the other answer moves as far the other way.
    EXPECT_NEAR(learnt(before, shown, 1).mean[0], 1 - after.mean[0], 1e-12);
    EXPECT_NEAR(after.evidence, std::log(0.5), 1e-9);  // before any pick both were as likely
}

TEST(Wish, LearnsNothingOfDirectionsThatWereNotCompared) {
    const Wish before = isotropic_wish(3);
    const Wish after = learnt(before, std::vector<Place>{{0.8, 0.5, 0.5}, {0.2, 0.5, 0.5}}, 0);
    EXPECT_GT(after.mean[0], 0.5);
    EXPECT_EQ(after.mean[1], 0.5);
    EXPECT_EQ(after.covariance[4], before.covariance[4]);
}

TEST(Wish, StaysAProperBeliefThroughAThousandContradictoryPicks) {
    base::RandomStream chance{base::Seed{5}};
    Wish wish = isotropic_wish(7);
    for (int i = 0; i < 1000; ++i) {
        std::vector<Place> shown(4, Place(7));
        for (Place& place : shown)
            for (double& x : place) x = chance.unit();
        wish = learnt(std::move(wish), shown, chance.below(4));
    }
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_GT(wish.covariance[i * 7 + i], 0);
        EXPECT_GE(wish.mean[i], 0);
        EXPECT_LE(wish.mean[i], 1);
    }
    for (const double x : root_of(wish)) EXPECT_TRUE(std::isfinite(x));
}

TEST(FourMeans, FindFourHeaps) {
    base::RandomStream chance{base::Seed{6}};
    std::vector<Place> samples;
    for (int i = 0; i < 200; ++i)
        samples.push_back({(i % 2) + 0.01 * chance.unit(), (i / 2 % 2) + 0.01 * chance.unit()});
    const FourPlaces four = four_means(samples);
    for (const Place& corner : std::vector<Place>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
        double nearest = 9;
        for (const Place& place : four) nearest = std::min(nearest, squared_distance(place, corner));
        EXPECT_LT(nearest, 0.001);
    }
}

// A visitor who always names what is nearest to a wish in words.
std::size_t nearest(const genome::Offer& offer, Aspect aspect, const Place& wish, genome::Genome genome) {
    std::size_t best = 0;
    for (std::size_t c = 1; c < genome::kCandidates; ++c)
        if (squared_distance(place_of(offer.candidates[c], genome, aspect), wish) <
            squared_distance(place_of(offer.candidates[best], genome, aspect), wish))
            best = c;
    return best;
}

// In words, half of one named scene and half of another: no landscape has words by chance. Otherwise anything.
Place wish_of(genome::Genome genome, Aspect aspect, base::RandomStream& chance) {
    Place wish;
    const std::vector<Place> named = archetype_places(genome, aspect, default_word_map());
    const Place& one = named[chance.below(static_cast<std::uint32_t>(named.size()))];
    const Place& other = named[chance.below(static_cast<std::uint32_t>(named.size()))];
    for (std::size_t i = 0; i < dimensions_of(genome, aspect); ++i)
        wish.push_back(genome == genome::Genome::Full ? (one[i] + other[i]) / 2 : chance.unit());
    return wish;
}

class Belief : public testing::TestWithParam<genome::Genome> {};

TEST_P(Belief, ComesHalfTheWayToAWishInSixRounds) {
    double before = 0;
    double after = 0;
    for (std::uint64_t v = 0; v < 20; ++v) {
        Session session = session_of(GetParam(), v);
        base::RandomStream chance{base::Seed{v}.child("wish")};
        genome::PerAspect<Place> wish;
        for (const Aspect aspect : kAspects) wish[aspect] = wish_of(GetParam(), aspect, chance);
        for (const Aspect aspect : kAspects)
            before += std::sqrt(squared_distance(Place(wish[aspect].size(), 0.5), wish[aspect]));
        for (int round = 0; round < 6; ++round) {
            genome::Pick pick;
            for (const Aspect aspect : kAspects)
                pick[aspect] = nearest(session.offer(), aspect, wish[aspect], GetParam());
            session.next(pick);
        }
        for (const Aspect aspect : kAspects)
            after += std::sqrt(squared_distance(place_of(session.favourite(), GetParam(), aspect), wish[aspect]));
    }
    EXPECT_LT(after, 0.75 * before);
}

// Trees, land and sky that were named best are one landscape of the next four, seeds and all: each another's.
TEST_P(Belief, PutsTheLastWinnersTogetherAsTheyWere) {
    std::set<std::size_t> where;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Session session = session_of(GetParam(), seed);
        for (std::size_t k = 0; k < 4; ++k) {
            genome::Pick pick;
            pick.each = {k, (k + 1) % 4, (k + 3) % 4};
            const genome::Candidate named = chosen(session.offer(), pick, session.offer().candidates[0]);
            session.next(pick);
            const auto& four = session.offer().candidates;
            const auto again = std::ranges::find_if(
                four, [&](const genome::Candidate& c) { return c.seeds == named.seeds && c.values == named.values; });
            ASSERT_NE(again, four.end()) << "seed " << seed << ", round " << k;
            where.insert(static_cast<std::size_t>(again - four.begin()));
        }
    }
    EXPECT_EQ(where.size(), 4U) << "at every button, so that no habit keeps it";
}

// An aspect can grow as soon as it is judged: its candidates and their places are final then.
TEST_P(Belief, WhereTheWinnersStandDoesNotDependOnThePicks) {
    Session session = session_of(GetParam());
    genome::Pick pick;
    for (const Aspect aspect : kAspects) {
        const genome::Offer before = session.preview(pick);
        pick[aspect] = 2;
        const genome::Offer after = session.preview(pick);
        for (const Aspect judged : kAspects) {
            if (judged == aspect) continue;
            for (std::size_t c = 0; c < genome::kCandidates; ++c) {
                EXPECT_EQ(before.candidates[c].seeds[judged], after.candidates[c].seeds[judged]);
                EXPECT_EQ(place_of(before.candidates[c].values, genome::Genome::Full, judged),
                          place_of(after.candidates[c].values, genome::Genome::Full, judged));
            }
        }
    }
}

TEST_P(Belief, WhatOneAspectWasTaughtChangesNothingOfAnother) {
    Session taught = session_of(GetParam());
    Session other = session_of(GetParam());
    genome::Pick trees;
    trees[Aspect::Trees] = 1;
    taught.next(trees);
    other.next({});
    for (std::size_t c = 0; c < genome::kCandidates; ++c)
        for (const Aspect aspect : {Aspect::Land, Aspect::Sky}) {
            EXPECT_EQ(taught.offer().candidates[c].seeds[aspect], other.offer().candidates[c].seeds[aspect]);
            for (const auto id : parameters_of(aspect, genome::Genome::Full))
                EXPECT_EQ(taught.offer().candidates[c].values[id], other.offer().candidates[c].values[id]);
        }
}

TEST_P(Belief, IsKeptOnDiskExactly) {
    Session session = session_of(GetParam());
    for (std::size_t round = 0; round < 4; ++round) {
        genome::Pick pick;
        pick[Aspect::Trees] = round;
        if (round % 2 == 0) pick[Aspect::Sky] = 3 - round;
        session.next(pick);
        BreederOptions options;
        options.kind = BreederKind::Belief;
        options.genome = GetParam();
        Breeder again(options);
        again.believe(session.breeder().belief_json(), "state");
        EXPECT_EQ(again, session.breeder());
        EXPECT_EQ(again.propose(base::Seed{3}), session.offer());
    }
}

INSTANTIATE_TEST_SUITE_P(Genomes, Belief, testing::Values(genome::Genome::Classic, genome::Genome::Full),
                         [](const auto& one) { return one.param == genome::Genome::Classic ? "Classic" : "Words"; });

TEST(Belief, BeginsWithFourArchetypesThatDiffer) {
    const Session session = session_of(genome::Genome::Full);
    for (const Aspect aspect : {Aspect::Land, Aspect::Sky})
        for (std::size_t a = 0; a < genome::kCandidates; ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_GT(squared_distance(place_of(session.offer().candidates[a], genome::Genome::Full, aspect),
                                           place_of(session.offer().candidates[b], genome::Genome::Full, aspect)),
                          0.2);
}

TEST(Belief, KeepsToTheCuratorsRanges) {
    Session session = session_of(genome::Genome::Full);
    session.set_range(genome::WordId::wet, {0.2F, 0.4F});
    for (int round = 0; round < 5; ++round) {
        genome::Pick pick;
        pick[Aspect::Land] = 2;
        session.next(pick);
        for (const genome::Candidate& candidate : session.offer().candidates) {
            if (round == 0) continue;  // the winner stays as it was shown
            EXPECT_GE((*candidate.words)[genome::WordId::wet], 0.2F - 1e-6F);
            EXPECT_LE((*candidate.words)[genome::WordId::wet], 0.4F + 1e-6F);
        }
    }
}

TEST(Belief, RefusesABrokenBeliefByKeyAndStaysAsItWas) {
    Session session = session_of(genome::Genome::Full);
    session.next({});
    const std::string good = session.breeder().belief_json();
    Breeder breeder = session.breeder();
    const auto message = [&](const auto& change) -> std::string {
        auto belief = nlohmann::json::parse(good);
        change(belief);
        try {
            breeder.believe(belief.dump(), "state");
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(message([](auto& b) { b["aspects"]["land"]["blends"].push_back(0); }),
                testing::HasSubstr("aspects.land.blends should be a list of 768 numbers"));
    EXPECT_THAT(message([](auto& b) { b["aspects"]["land"]["near"]["mean"].push_back(0.5); }),
                testing::HasSubstr("aspects.land.near.mean should be a list of"));
    EXPECT_THAT(message([](auto& b) { b["aspects"]["land"]["near"]["variance"][0] = -1; }),
                testing::HasSubstr("a variance is more than 0"));
    EXPECT_THAT(message([](auto& b) { b["aspects"]["sky"]["anywhere"]["evidence"] = 3; }),
                testing::HasSubstr("aspects.sky.anywhere.evidence is 3"));
    EXPECT_THAT(message([](auto& b) { b["aspects"]["sky"]["winner"] = 9; }),
                testing::HasSubstr("a candidate is 0, 1, 2 or 3"));
    EXPECT_EQ(breeder.belief_json(), good);
}

// {"mean":[…],"covariance":[…],"evidence":0}: sure of one word, and of no other.
std::string wish_in_words(std::size_t words, std::size_t sure_of, double at) {
    nlohmann::json wish{{"mean", std::vector<double>(words, 0.5)}, {"evidence", -1.5}};
    std::vector<double> covariance(words * words, 0.0);
    for (std::size_t w = 0; w < words; ++w) covariance[w * words + w] = 0.08;
    covariance[sure_of * words + sure_of] = 0.002;
    wish["mean"][sure_of] = at;
    wish["covariance"] = covariance;
    return wish.dump();
}

// Until there were blends a belief was kept as a Gaussian in words.
TEST(Belief, ReadsWhatWasKeptInWordsAloneAndGoesOnFromThere) {
    const auto kept = [](double tall) {
        std::string aspects;
        for (const Aspect aspect : kAspects) {
            const std::size_t words = genome::vocabulary(aspect).size();
            const std::string wish = wish_in_words(words, 2, aspect == Aspect::Trees ? tall : 0.5);
            aspects += (aspects.empty() ? "\"" : ",\"") + std::string(name_of(aspect)) + R"(":{"isotropic":)" + wish +
                       R"(,"archetypes":)" + wish + "}";
        }
        return R"({"round":4,"locked":["sky"],"aspects":{)" + aspects + "}}";
    };
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    const auto tall_of = [&](double tall) {
        Breeder breeder(options);
        breeder.believe(kept(tall), "state");
        EXPECT_EQ(breeder.round(), 4);
        EXPECT_EQ(breeder.lock(Aspect::Sky), Lock::Locked);
        return nlohmann::json::parse(breeder.state_json())["trees"]["tall"]["mean"].get<double>();
    };
    EXPECT_GT(tall_of(0.85), 0.2);
    EXPECT_LT(tall_of(0.2), -0.2);
    EXPECT_EQ(genome::vocabulary(Aspect::Trees)[2].id, genome::WordId::tall);
}

// What belief is compared with: nothing is learnt, and nothing else differs.
TEST(Chance, BeginsAsBeliefDoesKeepsWhatWasNamedBestAndLearnsNothing) {
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    const Session belief(Breeder(options), base::Seed{5});
    options.kind = BreederKind::Chance;
    Session session(Breeder(options), base::Seed{5});
    EXPECT_EQ(session.offer(), belief.offer());
    const std::string knew = session.breeder().state_json();
    for (int round = 1; round <= 5; ++round) {
        const genome::Offer before = session.offer();
        genome::Pick pick;
        pick.each = {1, 2, 3};
        session.next(pick);
        EXPECT_EQ(session.breeder().state_json(), knew);
        for (const Aspect aspect : kAspects) {
            const std::size_t best = *pick[aspect];
            const auto place = [&](const genome::Offer& offer, std::size_t c) {
                return place_of(offer.candidates[c].values, genome::Genome::Full, aspect);
            };
            std::size_t kept = 0;
            double changed = 0;
            for (std::size_t c = 0; c < genome::kCandidates; ++c) {
                if (place(session.offer(), c) == place(before, best)) ++kept;
                changed += squared_distance(place(session.offer(), c), place(before, best));
            }
            EXPECT_GE(kept, 1U);
            EXPECT_GT(changed, 0.5) << "the others are drawn anew";
        }
    }
}

TEST(Belief, ShowsFourThatStillDifferAfterEightRounds) {
    double after_five = 9;
    double after_eight = 9;
    for (std::uint64_t v = 0; v < 5; ++v) {
        Session session = session_of(genome::Genome::Full, v);
        base::RandomStream chance{base::Seed{v}};
        for (int round = 1; round <= 8; ++round) {
            genome::Pick pick;
            for (const Aspect aspect : kAspects) pick[aspect] = chance.below(4);
            session.next(pick);
            if (round != 5 && round != 8) continue;
            for (const Aspect aspect : kAspects)
                for (std::size_t a = 0; a < genome::kCandidates; ++a)
                    for (std::size_t b = 0; b < a; ++b) {
                        const Place one = place_of(session.offer().candidates[a].values, genome::Genome::Full, aspect);
                        const Place other =
                            place_of(session.offer().candidates[b].values, genome::Genome::Full, aspect);
                        const double apart = std::sqrt(squared_distance(one, other) / static_cast<double>(one.size()));
                        double& least = round == 5 ? after_five : after_eight;
                        least = std::min(least, apart);
                    }
        }
    }
    EXPECT_GE(after_five, 0.12);
    EXPECT_GE(after_eight, 0.10);
}

}  // namespace
}  // namespace quadrat::breeding
