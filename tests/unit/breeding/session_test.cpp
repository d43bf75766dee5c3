// SPDX-License-Identifier: Apache-2.0
#include "breeding/session.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/error.hpp"
#include "genome/recipe.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

constexpr base::Seed kSeed{7};

Session session_of(BreederKind kind) {
    BreederOptions options;
    options.kind = kind;
    return {Breeder(options), kSeed};
}

genome::Pick random_pick(base::RandomStream& chance) {
    genome::Pick pick;
    for (const Aspect aspect : kAspects)
        if (chance.below(4) != 0) pick[aspect] = chance.below(4);
    return pick;
}

class EveryBreeder : public testing::TestWithParam<BreederKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryBreeder,
                         testing::Values(BreederKind::Belief, BreederKind::Chance, BreederKind::Pbil,
                                         BreederKind::PbilGaussian, BreederKind::Random, BreederKind::Sliders));

TEST_P(EveryBreeder, IsFoundByItsName) {
    const Session session = session_of(GetParam());
    EXPECT_EQ(breeder_named(session.breeder().name()), GetParam());
    EXPECT_THROW(breeder_named("oracle"), base::InputError);
}

TEST_P(EveryBreeder, CountsItsRoundsInTheOffer) {
    Session session = session_of(GetParam());
    for (int round = 1; round <= 5; ++round) {
        EXPECT_EQ(session.offer().round, round);
        EXPECT_EQ(session.breeder().round(), round);
        session.next({});
    }
}

TEST_P(EveryBreeder, GoesBackToTheIdenticalOfferAndBeliefByUndo) {
    Session session = session_of(GetParam());
    base::RandomStream chance(kSeed);
    std::vector<Session> moments;
    for (int round = 0; round < 50; ++round) {
        moments.push_back(session);
        session.next(random_pick(chance));
    }
    while (!moments.empty()) {
        ASSERT_TRUE(session.undo());
        EXPECT_EQ(session.offer(), moments.back().offer());
        EXPECT_EQ(session.breeder(), moments.back().breeder());
        EXPECT_EQ(session.favourite(), moments.back().favourite());
        EXPECT_EQ(session.flight(), moments.back().flight());
        moments.pop_back();
    }
    EXPECT_FALSE(session.can_undo());
    EXPECT_FALSE(session.undo());
}

TEST_P(EveryBreeder, ReturnsToAnyNodeOfItsTreeAsItWas) {
    Session session = session_of(GetParam());
    base::RandomStream chance(kSeed);
    std::vector<Session> moments{session};
    for (int round = 0; round < 30; ++round) {
        if (chance.below(3) == 0) session.undo();
        session.next(random_pick(chance));
        moments.push_back(session);
        ASSERT_EQ(session.here(), round + 1) << "numbered as they came";
    }
    for (int i = 0; i < 60; ++i) {
        const auto node = static_cast<int>(chance.below(31));
        ASSERT_TRUE(session.return_to(node));
        const Session& then = moments[static_cast<std::size_t>(node)];
        EXPECT_EQ(session.offer(), then.offer());
        EXPECT_EQ(session.breeder(), then.breeder());
        EXPECT_EQ(session.favourite(), then.favourite());
        EXPECT_EQ(session.favourite_of(node), then.favourite());
        EXPECT_EQ(session.can_undo(), then.can_undo());
    }
    EXPECT_FALSE(session.return_to(31));
    EXPECT_FALSE(session.return_to(-1));
}

TEST(Session, BegunWithALandscapeOffersItAndWhatFollows) {
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    const Session fresh(Breeder(options), kSeed);
    const genome::Candidate liked = genome::candidate_of(genome::random_recipe(base::Seed{4}));
    const Session begun = fresh.begun_with(liked);
    EXPECT_FALSE(begun.can_undo());
    EXPECT_EQ(begun.here(), 0);
    const auto holds = [&](const genome::Candidate& candidate, Aspect aspect) {
        for (const auto id : parameters_of(aspect, genome::Genome::Full))
            if (candidate.values[id] != liked.values[id]) return false;
        return candidate.seeds[aspect] == liked.seeds[aspect];
    };
    const auto is_liked = [&](const genome::Candidate& candidate) {
        return std::ranges::all_of(kAspects, [&](Aspect aspect) { return holds(candidate, aspect); });
    };
    EXPECT_EQ(std::ranges::count_if(begun.offer().candidates, is_liked), 1) << "and others beside it";
    EXPECT_EQ(fresh.offer(), Session(Breeder(options), kSeed).offer());
}

TEST_P(EveryBreeder, ForgetsTheWayBackBeyondItsDepth) {
    Session session = session_of(GetParam());
    const int rounds = static_cast<int>(Session::kUndoDepth) + 5;
    for (int round = 0; round < rounds; ++round) session.next({});
    std::size_t undone = 0;
    while (session.undo()) ++undone;
    EXPECT_EQ(undone, Session::kUndoDepth);
    EXPECT_EQ(session.offer().round, 6);
}

TEST_P(EveryBreeder, KeepsALockWhenARoundIsTakenBack) {
    Session session = session_of(GetParam());
    session.next({});
    session.set_lock(Aspect::Land, Lock::Locked);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.breeder().lock(Aspect::Land), Lock::Locked);
    EXPECT_EQ(session.breeder().lock(Aspect::Sky), Lock::Open);
}

TEST_P(EveryBreeder, PreviewsWhatAJudgedAspectWillBeWhateverTheOthersAreJudged) {
    Session session = session_of(GetParam());
    base::RandomStream chance(kSeed);
    for (int round = 0; round < 20; ++round) {
        const genome::Pick whole = random_pick(chance);
        for (const Aspect aspect : kAspects) {
            genome::Pick part;
            part[aspect] = whole[aspect];
            const genome::Offer early = session.preview(part);
            const genome::Offer late = session.preview(whole);
            for (std::size_t c = 0; c < genome::kCandidates; ++c) {
                EXPECT_EQ(early.candidates[c].bits[aspect], late.candidates[c].bits[aspect]);
                EXPECT_EQ(early.candidates[c].seeds[aspect], late.candidates[c].seeds[aspect]);
                for (const auto id : parameters_of(aspect, genome::Genome::Full))
                    EXPECT_EQ(early.candidates[c].values[id], late.candidates[c].values[id]);
            }
        }
        const genome::Offer foreseen = session.preview(whole);
        session.next(whole);
        EXPECT_EQ(session.offer(), foreseen);
    }
}

TEST_P(EveryBreeder, GoesOnFromItsKeptBeliefAsIfNothingHadHappened) {
    Session session = session_of(GetParam());
    base::RandomStream chance(kSeed);
    for (int round = 0; round < 30; ++round) session.next(random_pick(chance));
    session.set_lock(Aspect::Sky, Lock::Locked);
    Breeder kept = session_of(GetParam()).breeder();
    kept.believe(session.breeder().belief_json(), "state");
    EXPECT_EQ(kept, session.breeder());
    Session again(kept, kSeed);
    EXPECT_EQ(again.offer(), session.offer());
    const genome::Pick pick = random_pick(chance);
    again.next(pick);
    session.next(pick);
    EXPECT_EQ(again.offer(), session.offer());
    EXPECT_EQ(again.breeder().belief_json(), session.breeder().belief_json());
}

TEST_P(EveryBreeder, RefusesADamagedBeliefAndKeepsItsOwn) {
    Session session = session_of(GetParam());
    session.next({});
    Breeder breeder = session.breeder();
    const std::string json = breeder.belief_json();
    for (std::size_t length = 0; length < json.size(); length += 3)
        EXPECT_THROW(breeder.believe(json.substr(0, length), "state"), base::InputError);
    for (const char* wrong : {"{}", "[]", R"({"round":0,"locked":[]})", R"({"round":1,"locked":["water"]})",
                              R"({"round":1,"locked":[],"probability":{"trees":[],"land":[],"sky":[]}})"})
        EXPECT_THROW(breeder.believe(wrong, "state"), base::InputError) << wrong;
    EXPECT_EQ(breeder, session.breeder());
}

TEST(Favourite, IsMadeOfTheAspectsLastNamedBest) {
    Session session = session_of(BreederKind::Pbil);
    const genome::Offer first = session.offer();
    genome::Pick pick;
    pick[Aspect::Trees] = 2;
    pick[Aspect::Sky] = 3;
    session.next(pick);
    const genome::Offer second = session.offer();
    genome::Pick sky;
    sky[Aspect::Sky] = 1;
    session.next(sky);
    const genome::Candidate& favourite = session.favourite();
    EXPECT_EQ(favourite.bits[Aspect::Trees], first.candidates[2].bits[Aspect::Trees]);
    EXPECT_EQ(favourite.bits[Aspect::Land], first.candidates[0].bits[Aspect::Land]);
    EXPECT_EQ(favourite.bits[Aspect::Sky], second.candidates[1].bits[Aspect::Sky]);
    EXPECT_EQ(favourite.seeds[Aspect::Sky], second.candidates[1].seeds[Aspect::Sky]);
    EXPECT_EQ(favourite.values, decode(favourite.bits, genome::Genome::Classic));
}

TEST(Flight, IsAnotherEveryRound) {
    Session session = session_of(BreederKind::Pbil);
    const base::Seed first = session.flight();
    session.next({});
    EXPECT_NE(session.flight(), first);
}

TEST(RandomBreeder, LearnsNothing) {
    Session taught = session_of(BreederKind::Random);
    Session ignored = session_of(BreederKind::Random);
    genome::Pick pick;
    for (const Aspect aspect : kAspects) pick[aspect] = 1;
    for (int round = 0; round < 20; ++round) {
        taught.next(pick);
        ignored.next({});
        EXPECT_EQ(taught.offer(), ignored.offer());
    }
    EXPECT_EQ(taught.breeder().state_json(), ignored.breeder().state_json());
}

}  // namespace
}  // namespace quadrat::breeding
