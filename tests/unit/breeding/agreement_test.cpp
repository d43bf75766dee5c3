// SPDX-License-Identifier: Apache-2.0
#include "breeding/agreement.hpp"

#include <gtest/gtest.h>

#include "breeding/belief/coordinates.hpp"
#include "breeding/session.hpp"
#include "breeding/simulation/tournament.hpp"

namespace quadrat::breeding {
namespace {

using genome::kAspects;

Session session_of(BreederKind kind, genome::Genome genome, base::Seed seed) {
    BreederOptions options;
    options.kind = kind;
    options.genome = genome;
    options.map = known_half();
    return {Breeder(options), seed};
}

// After six rounds.
struct Six {
    int narrow = 0;
    int changing = 0;
};

Six six_rounds_of(int visitors, bool is_by_chance) {
    Tournament tournament;
    tournament.genome = genome::Genome::Full;
    tournament.noise = Noise::None;
    Six six;
    for (int number = 0; number < visitors; ++number) {
        const SimulatedVisitor visitor = visitor_of(tournament, number);
        const base::Seed seed = base::Seed{9}.child(static_cast<std::uint64_t>(number));
        Session session = session_of(BreederKind::Belief, genome::Genome::Full, seed);
        base::RandomStream chance(seed.child("chance"));
        for (int round = 0; round < 6; ++round) {
            genome::Pick pick;
            for (const genome::Aspect aspect : kAspects) {
                std::vector<Place> places;
                for (const genome::Candidate& candidate : session.offer().candidates)
                    places.push_back(place_of(candidate.values, genome::Genome::Full, aspect));
                pick[aspect] = is_by_chance ? chance.below(4) : visitor.pick(places, aspect, chance);
            }
            session.next(pick);
        }
        const Agreement agreed = agreement(session.breeder_before(), session.breeder());
        six.narrow += agreed.is_narrow;
        six.changing += agreed.is_changing;
    }
    return six;
}

TEST(Agreement, IsNarrowForWhoKnowsWhatTheyWantAndNotForWhoPressesByChance) {
    const Six sure = six_rounds_of(24, false);
    const Six chance = six_rounds_of(24, true);
    EXPECT_GE(sure.narrow, 17);
    EXPECT_LE(chance.narrow, 2);
    EXPECT_LE(sure.changing, 6);
    EXPECT_GE(chance.changing, sure.changing + 3);
}

TEST(Agreement, BeginsWithAllItsDoubtAndLosesSomeWithTheFirstPick) {
    Session session = session_of(BreederKind::Belief, genome::Genome::Full, base::Seed{1});
    EXPECT_NEAR(doubt_left(session.breeder()).value(), 1, 1e-9);
    genome::Pick pick;
    pick.each.fill(1);
    session.next(pick);
    EXPECT_LT(doubt_left(session.breeder()).value(), 1);
    EXPECT_FALSE(agreement(session.breeder_before(), session.breeder()).is_changing);
}

TEST(Agreement, IsUnknownWhereNothingIsBelieved) {
    for (const BreederKind kind : {BreederKind::Chance, BreederKind::Pbil, BreederKind::Random, BreederKind::Sliders}) {
        const auto genome = kind == BreederKind::Chance ? genome::Genome::Full : genome::Genome::Classic;
        Session session = session_of(kind, genome, base::Seed{1});
        session.next({});
        EXPECT_FALSE(doubt_left(session.breeder()));
        const Agreement agreed = agreement(session.breeder_before(), session.breeder());
        EXPECT_FALSE(agreed.is_narrow || agreed.is_changing);
    }
    Session locked = session_of(BreederKind::Belief, genome::Genome::Full, base::Seed{1});
    for (const genome::Aspect aspect : kAspects) locked.set_lock(aspect, Lock::Locked);
    EXPECT_FALSE(doubt_left(locked.breeder()));
}

}  // namespace
}  // namespace quadrat::breeding
