// SPDX-License-Identifier: Apache-2.0
#include "exhibit/family.hpp"

#include <gtest/gtest.h>

#include <set>

#include "visit_fixture.hpp"

namespace quadrat::exhibit {
namespace {

using namespace std::chrono_literals;

// 0 - 1 - 2 - 5
//       \ 3 - 4
std::vector<Ancestor> branched() {
    std::vector<Ancestor> family(6);
    for (const auto& [node, parent] : {std::pair{1, 0}, {2, 1}, {3, 1}, {4, 3}, {5, 2}}) {
        family[static_cast<std::size_t>(node)].parent = parent;
        family[static_cast<std::size_t>(node)].pick = pick_of(node % 4, 0, 1);
    }
    return family;
}

TEST(Family, IsWalkedByTheButtons) {
    const auto family = branched();
    EXPECT_EQ(step_to(family, 2, Choice::A, 5), 1);
    EXPECT_FALSE(step_to(family, 0, Choice::A, 5));
    EXPECT_EQ(step_to(family, 1, Choice::B, 5), 2) << "toward where the landscape came from";
    EXPECT_EQ(step_to(family, 1, Choice::B, 4), 3);
    EXPECT_FALSE(step_to(family, 5, Choice::B, 5));
    EXPECT_EQ(step_to(family, 4, Choice::C, 5), 5) << "the next of its depth";
    EXPECT_EQ(step_to(family, 5, Choice::C, 5), 4) << "and the first again";
    EXPECT_FALSE(step_to(family, 1, Choice::C, 5)) << "there is no other";
    EXPECT_FALSE(step_to(family, 1, Choice::D, 5));
    EXPECT_EQ(depth_of(family, 4), 3);
    EXPECT_EQ(picks_to(family, 4), (std::vector{pick_of(1, 0, 1), pick_of(3, 0, 1), pick_of(0, 0, 1)}));
}

TEST(Meaning, IsOfTheButtonsThatLeadSomewhere) {
    using Four = std::array<bool, 4>;
    State state;
    state.screen = Screen::Ask;
    EXPECT_EQ(meant_by(state, {}), (Four{true, true, true, true}));
    state.screen = Screen::Finale;
    EXPECT_EQ(meant_by(state, {}), (Four{true, true, true, true})) << "any press leaves it";
    state.finale_asks = true;
    state.family = {{-1, {}, true}, {0, {}, true}, {1, {}, false}};
    Timings timings;
    EXPECT_EQ(meant_by(state, timings), (Four{true, true, false, true})) << "there is no printer";
    timings.can_print = true;
    EXPECT_EQ(meant_by(state, timings), (Four{true, true, true, true}));
    state.screen = Screen::Family;
    state.here = 2;
    for (const auto& [walked, meant] : {std::pair{0, Four{false, true, false, true}},
                                        {1, Four{true, true, false, true}},
                                        {2, Four{true, false, false, true}}}) {
        state.walked = walked;
        EXPECT_EQ(meant_by(state, timings), meant) << walked;
    }
    state.screen = Screen::Language;
    timings.languages = 2;
    EXPECT_EQ(meant_by(state, timings), (Four{true, true, false, false}));
}

TEST(Family, GivesEveryNodeAPlaceOfItsOwnRightOfItsParent) {
    base::RandomStream chance(base::Seed{3});
    for (int i = 0; i < 200; ++i) {
        std::vector<Ancestor> family(1);
        while (family.size() < 2 + chance.below(40))
            family.push_back({static_cast<int>(chance.below(static_cast<std::uint32_t>(family.size()))), {}, true});
        const auto places = places_of(family);
        std::set<std::pair<int, int>> taken;
        for (std::size_t node = 0; node < family.size(); ++node) {
            EXPECT_TRUE(taken.emplace(places[node].column, places[node].row).second);
            EXPECT_EQ(places[node].column, depth_of(family, static_cast<int>(node)));
            if (family[node].parent >= 0) {
                EXPECT_GE(places[node].row, places[static_cast<std::size_t>(family[node].parent)].row);
            }
        }
    }
}

Timings asking() {
    Timings timings;
    timings.rounds = 3;
    timings.finale_asks = true;
    timings.describe_words = 0;
    return timings;
}

// Two rounds, the second taken back and answered otherwise, then the third.
Visitor branched_visitor() {
    Visitor visitor(asking());
    visitor.arrive().whole_round().whole_round().press(Choice::Back).grown().press(Choice::A).grown();
    return visitor;
}

TEST(Family, RemembersBranchesThatWereTakenBack) {
    Visitor visitor = branched_visitor();
    ASSERT_EQ(visitor.state().family.size(), 4U);
    EXPECT_EQ(visitor.state().family[2].parent, 1);
    EXPECT_EQ(visitor.state().family[3].parent, 1);
    EXPECT_EQ(visitor.state().family[3].pick, pick_of(0, 1, 0));
    EXPECT_EQ(visitor.state().here, 3);
    visitor.whole_round();
    ASSERT_EQ(visitor.screen(), Screen::Finale);
    EXPECT_TRUE(visitor.state().finale_asks);
    EXPECT_FALSE(visitor.state().family[4].was_seen) << "the finale came in their place";
}

TEST(Family, LeadsBackToAnyFourAndOnFromThere) {
    Visitor visitor = branched_visitor();
    visitor.whole_round().wait(2s).press(Choice::A);
    ASSERT_EQ(visitor.screen(), Screen::Family);
    EXPECT_EQ(visitor.state().walked, 4);
    visitor.press(Choice::A).press(Choice::C);
    EXPECT_EQ(visitor.state().walked, 2) << "the branch that was taken back";
    visitor.press(Choice::D);
    const auto* wish = visitor.wished<ReturnTo>();
    ASSERT_NE(wish, nullptr);
    EXPECT_EQ(wish->node, 2);
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    EXPECT_EQ(visitor.state().rounds, 2);
    EXPECT_EQ(visitor.state().past_answers, (std::vector{pick_of(0, 1, 2), pick_of(0, 1, 2)}));
    visitor.grown();
    ASSERT_EQ(visitor.screen(), Screen::Ask);
    visitor.whole_round();
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    EXPECT_EQ(visitor.state().family.back().parent, 2);
}

TEST(Family, GoesOnFromTheFinaleItself) {
    Visitor visitor(asking());
    visitor.arrive().whole_round().whole_round().whole_round().wait(2s).press(Choice::B);
    ASSERT_NE(visitor.wished<ReturnTo>(), nullptr);
    visitor.grown();
    ASSERT_EQ(visitor.screen(), Screen::Ask);
    EXPECT_EQ(visitor.state().rounds, 3);
    EXPECT_TRUE(visitor.state().family[3].was_seen);
    visitor.press(Choice::A).press(Choice::A).press(Choice::A);
    EXPECT_NE(visitor.wished<GrowFinale>(), nullptr) << "one round more";
}

TEST(Family, IsLeftByBackAndTheFinaleByDone) {
    Visitor visitor = branched_visitor();
    visitor.whole_round().wait(2s).press(Choice::A).press(Choice::Back);
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    visitor.wait(2s).press(Choice::C);
    EXPECT_EQ(visitor.screen(), Screen::Finale) << "there is no printer";
    visitor.press(Choice::D);
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_TRUE(visitor.state().family.empty());
}

TEST(Family, WarnsBeforeItGoesAndEveryPressIsMoreTime) {
    Visitor visitor = branched_visitor();
    visitor.whole_round().wait(2s).press(Choice::A);
    EXPECT_FALSE(countdown_s(visitor.state(), visitor.now(), visitor.timings()));
    visitor.wait(20s);
    EXPECT_LE(countdown_s(visitor.state(), visitor.now(), visitor.timings()).value(), 5);
    visitor.press(Choice::A);
    EXPECT_FALSE(countdown_s(visitor.state(), visitor.now(), visitor.timings()));
    visitor.wait(20s);
    EXPECT_EQ(visitor.screen(), Screen::Family);
    visitor.wait(10s);
    EXPECT_EQ(visitor.screen(), Screen::Attract);
}

TEST(Family, GrowsNoLargerThanItsLimit) {
    Timings timings = asking();
    timings.rounds = 1;
    Visitor visitor(timings);
    visitor.arrive().whole_round();
    for (int i = 0; i < 100 && visitor.screen() == Screen::Finale; ++i) {
        visitor.wait(2s).press(Choice::B);
        if (visitor.screen() != Screen::Breed) break;
        visitor.grown().whole_round();
    }
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    EXPECT_EQ(visitor.state().family.size(), kMostFamily);
}

TEST(Postcard, IsWishedForOnceAFinaleWhenItIsAskedForOrAlways) {
    Timings timings = asking();
    timings.can_print = true;
    Visitor visitor(timings);
    visitor.arrive().whole_round().whole_round().whole_round().wait(2s);
    EXPECT_EQ(visitor.wished<PrintPostcard>(), nullptr);
    visitor.press(Choice::C);
    EXPECT_NE(visitor.wished<PrintPostcard>(), nullptr);
    visitor.press(Choice::C);
    EXPECT_EQ(visitor.wished<PrintPostcard>(), nullptr) << "one is enough";
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    timings.prints_all = true;
    Visitor other(timings);
    other.arrive().whole_round().whole_round().press(Choice::A).press(Choice::A).press(Choice::A).grown();
    ASSERT_EQ(other.screen(), Screen::Finale);
    EXPECT_NE(other.wished<PrintPostcard>(), nullptr);
}

}  // namespace
}  // namespace quadrat::exhibit
