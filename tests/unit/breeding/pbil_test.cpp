// SPDX-License-Identifier: Apache-2.0
#include "breeding/pbil.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

constexpr base::Seed kSeed{7};

genome::Pick pick_of(std::optional<std::size_t> trees, std::optional<std::size_t> land,
                     std::optional<std::size_t> sky) {
    genome::Pick pick;
    pick.each = {trees, land, sky};
    return pick;
}

PbilState with_every_probability(double p) {
    PbilState state = initial_pbil(genome::Genome::Classic);
    for (const Aspect aspect : kAspects)
        for (double& each : state.probability[aspect]) each = p;
    return state;
}

TEST(Pbil, BeginsUndecidedAboutAll70Bits) {
    const PbilState state = initial_pbil(genome::Genome::Classic);
    std::size_t bits = 0;
    for (const Aspect aspect : kAspects) {
        bits += state.probability[aspect].size();
        for (const double p : state.probability[aspect]) EXPECT_EQ(p, 0.5);
    }
    EXPECT_EQ(bits, 70U);
    EXPECT_EQ(state.round, 1);
}

TEST(Pbil, DrawsOnesAsOftenAsTheProbabilitySays) {
    for (const double p : {0.0, 0.1, 0.5, 0.83, 1.0}) {
        PbilState state = with_every_probability(p);
        int ones = 0;
        int bits = 0;
        for (state.round = 1; state.round <= 200; ++state.round)
            for (const genome::Candidate& candidate : propose(state, kSeed).candidates)
                for (const Aspect aspect : kAspects)
                    for (const auto bit : candidate.bits[aspect]) {
                        ones += bit;
                        ++bits;
                    }
        EXPECT_EQ(bits, 200 * 4 * 70);
        EXPECT_NEAR(ones / static_cast<double>(bits), p, 0.01);
        if (p == 0.0 || p == 1.0) {
            EXPECT_EQ(ones, p == 0.0 ? 0 : bits);
        }
    }
}

TEST(Pbil, OffersFourCandidatesWhoseValuesAreTheirBits) {
    const genome::Offer offer = propose(initial_pbil(genome::Genome::Classic), kSeed);
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        EXPECT_EQ(offer.candidates[c].values, decode(offer.candidates[c].bits, genome::Genome::Classic));
        for (std::size_t other = 0; other < c; ++other)
            for (const Aspect aspect : kAspects) {
                EXPECT_NE(offer.candidates[c].bits[aspect], offer.candidates[other].bits[aspect]);
                EXPECT_NE(offer.candidates[c].seeds[aspect], offer.candidates[other].seeds[aspect]);
            }
    }
}

TEST(Pbil, DrawsABitByItsOwnIdentityNotByWhatWasDrawnBefore) {
    PbilState state = initial_pbil(genome::Genome::Classic);
    const genome::Offer before = propose(state, kSeed);
    for (double& p : state.probability[Aspect::Trees]) p = 1.0;
    state.probability[Aspect::Land].front() = 0.0;
    const genome::Offer after = propose(state, kSeed);
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        EXPECT_EQ(after.candidates[c].bits[Aspect::Sky], before.candidates[c].bits[Aspect::Sky]);
        EXPECT_EQ(after.candidates[c].seeds, before.candidates[c].seeds);
        genome::Bits land = before.candidates[c].bits[Aspect::Land];
        land.front() = 0;
        EXPECT_EQ(after.candidates[c].bits[Aspect::Land], land);
    }
}

TEST(Pbil, OffersOtherCandidatesForAnotherRoundOrSeed) {
    PbilState state = initial_pbil(genome::Genome::Classic);
    const genome::Offer first = propose(state, kSeed);
    EXPECT_EQ(propose(state, kSeed), first);
    EXPECT_NE(propose(state, base::Seed{8}).candidates, first.candidates);
    state.round = 2;
    EXPECT_NE(propose(state, kSeed).candidates, first.candidates);
}

TEST(Pbil, LeavesLockedAndUnjudgedAspectsExactlyAsTheyAreUnderBothMutations) {
    for (const MutationForm form : {MutationForm::TowardHalf, MutationForm::Random}) {
        const PbilOptions options{0.2, 0.5, form};
        PbilState state = with_every_probability(0.3);
        state.locked[Aspect::Trees] = true;
        const genome::Offer offer = propose(state, kSeed);
        const PbilState next = learn(state, offer, pick_of(1, {}, 2), options, kSeed);
        EXPECT_EQ(next.probability[Aspect::Trees], state.probability[Aspect::Trees]) << "locked";
        EXPECT_EQ(next.probability[Aspect::Land], state.probability[Aspect::Land]) << "not judged";
        EXPECT_NE(next.probability[Aspect::Sky], state.probability[Aspect::Sky]);
        EXPECT_EQ(next.locked, state.locked);
        EXPECT_EQ(next.round, 2);
    }
}

TEST(Pbil, OnePickNeverMovesAnotherAspect) {
    const PbilState state = initial_pbil(genome::Genome::Classic);
    const genome::Offer offer = propose(state, kSeed);
    for (const Aspect judged : kAspects) {
        genome::Pick pick;
        pick[judged] = 3;
        const PbilState next = learn(state, offer, pick, {}, kSeed);
        for (const Aspect aspect : kAspects)
            EXPECT_EQ(next.probability[aspect] == state.probability[aspect], aspect != judged);
    }
}

TEST(Pbil, KeepsItsProbabilitiesBetweenNoughtAndOneForAnyOptions) {
    for (const MutationForm form : {MutationForm::TowardHalf, MutationForm::Random})
        for (const double rate : {0.0, 0.2, 1.0})
            for (const double mutation : {0.0, 0.02, 1.0}) {
                PbilState state = initial_pbil(genome::Genome::Classic);
                for (std::size_t round = 0; round < 100; ++round)
                    state =
                        learn(state, propose(state, kSeed), pick_of(round % 4, 0, 3), {rate, mutation, form}, kSeed);
                for (const Aspect aspect : kAspects)
                    for (const double p : state.probability[aspect]) {
                        EXPECT_GE(p, 0.0);
                        EXPECT_LE(p, 1.0);
                    }
            }
}

TEST(Pbil, MutatesByTheAverageWithOneRandomNumberABit) {
    const PbilState state = initial_pbil(genome::Genome::Classic);
    const genome::Offer offer = propose(state, kSeed);
    const PbilState next = learn(state, offer, pick_of({}, 2, {}), {0.2, 0.1, MutationForm::Random}, kSeed);
    const base::Seed mutation = kSeed.child("mutation").child(1).child("land");
    for (std::size_t i = 0; i < next.probability[Aspect::Land].size(); ++i) {
        const double learnt = 0.5 * (1.0 - 0.2) + 0.2 * offer.candidates[2].bits[Aspect::Land][i];
        const double u = base::RandomStream(mutation.child(i)).unit();
        EXPECT_EQ(next.probability[Aspect::Land][i], learnt * (1.0 - 0.1) + 0.1 * u) << "bit " << i;
    }
}

// How far the belief is from the target, a bit: 0.5 at the start, 0 when it is sure and right.
double distance(const PbilState& state, const genome::BitGenome& target) {
    double sum = 0;
    for (const Aspect aspect : kAspects)
        for (std::size_t i = 0; i < target[aspect].size(); ++i)
            sum += std::abs(state.probability[aspect][i] - target[aspect][i]);
    return sum / 70.0;
}

std::size_t nearest(const genome::Offer& offer, const genome::Bits& target, Aspect aspect) {
    std::size_t best = 0;
    std::size_t most = 0;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        std::size_t same = 0;
        for (std::size_t i = 0; i < target.size(); ++i)
            same += offer.candidates[c].bits[aspect][i] == target[i] ? 1 : 0;
        if (same > most) {
            most = same;
            best = c;
        }
    }
    return best;
}

TEST(Pbil, MovesTowardsATargetWhoseNearestCandidateIsAlwaysPicked) {
    for (std::uint64_t visitor = 0; visitor < 20; ++visitor) {
        const base::Seed seed = base::Seed{100}.child(visitor);
        const genome::BitGenome target =
            propose(initial_pbil(genome::Genome::Classic), seed.child("target")).candidates[0].bits;
        PbilState state = initial_pbil(genome::Genome::Classic);
        double after_15 = 0;
        for (int round = 1; round <= 60; ++round) {
            const genome::Offer offer = propose(state, seed);
            genome::Pick pick;
            for (const Aspect aspect : kAspects) pick[aspect] = nearest(offer, target[aspect], aspect);
            state = learn(state, offer, pick, {}, seed);
            if (round == 15) after_15 = distance(state, target);
        }
        EXPECT_LT(after_15, 0.45) << "visitor " << visitor;
        EXPECT_LT(distance(state, target), 0.35) << "visitor " << visitor;
    }
}

}  // namespace
}  // namespace quadrat::breeding
