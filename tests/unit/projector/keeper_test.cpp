// SPDX-License-Identifier: Apache-2.0
#include "projector/keeper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace quadrat::projector {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

// On a clock that is handed in. It takes so long to warm up, and to cool down.
struct SlowProjector : Projector {
    Power power() override {
        ++asked;
        if (!trouble.empty()) throw Trouble(trouble, "mend it");
        if ((is == Power::Warming || is == Power::Cooling) && now >= arrives)
            is = is == Power::Warming ? Power::On : Power::Off;
        return is;
    }
    void turn_on() override { go(Power::Warming); }
    void turn_off() override { go(Power::Cooling); }
    std::string ailments() override { return reports; }
    void go(Power way) {
        ++told;
        if (is_deaf) return;
        is = way;
        arrives = now + takes;
    }

    Keeper::Moment now{};
    Keeper::Moment arrives{};
    std::chrono::seconds takes{30};
    Power is = Power::Off;
    std::string trouble, reports;
    bool is_deaf = false;
    int asked = 0, told = 0;
};

class AKeeper : public testing::Test {
  protected:
    void live(std::optional<Wanted> wanted, std::chrono::seconds span) {
        for (const auto until = projector.now + span; projector.now < until; projector.now += 500ms)
            keeper.look(wanted, projector.now);
    }
    SlowProjector projector;
    Keeper keeper{projector};
};

TEST_F(AKeeper, SwitchesOncePerWishAndWaitsForItToCome) {
    live(std::nullopt, 60s);
    EXPECT_EQ(projector.asked, 0) << "nothing is wanted";
    live(Wanted::On, 60s);
    EXPECT_EQ(projector.is, Power::On);
    EXPECT_EQ(projector.told, 1);
    EXPECT_EQ(keeper.told(), (Told{Power::On, "", ""}));
    live(Wanted::Off, 60s);
    EXPECT_EQ(projector.is, Power::Off);
    EXPECT_EQ(projector.told, 2);
}

TEST_F(AKeeper, AsksSeldomAndPutsRightWhatAPlugUndid) {
    live(Wanted::On, 60s);
    const int asked = projector.asked;
    live(Wanted::On, 1h);
    EXPECT_LE(projector.asked - asked, 13);
    EXPECT_EQ(projector.told, 1);
    projector.is = Power::Off;
    live(Wanted::On, Keeper::kCheckEvery + 60s);
    EXPECT_EQ(projector.is, Power::On);
    EXPECT_EQ(keeper.told().trouble, "");
}

TEST_F(AKeeper, IsPatientWithOneThatCoolsDownFirst) {
    projector.takes = 90s;
    projector.is = Power::Cooling;
    projector.arrives = projector.now + 60s;
    live(Wanted::On, 10s);
    projector.is_deaf = true;  // as one is while it cools down
    live(Wanted::On, 50s);
    projector.is_deaf = false;
    live(Wanted::On, 110s);
    EXPECT_EQ(projector.is, Power::On);
    EXPECT_EQ(keeper.told().trouble, "");
}

TEST_F(AKeeper, NamesWhatIsWrongAndAsksLessAndLessOften) {
    projector.trouble = "it does not answer";
    live(Wanted::On, 1h);
    EXPECT_EQ(keeper.told(), (Told{std::nullopt, "it does not answer", "mend it"}));
    EXPECT_LE(projector.asked, 20);
    projector.trouble = "";
    live(Wanted::On, Keeper::kLongestTry + 60s);
    EXPECT_EQ(keeper.told(), (Told{Power::On, "", ""}));
    projector.trouble = "it does not answer";
    live(Wanted::Off, 1s);
    EXPECT_EQ(keeper.told().trouble, "it does not answer") << "another wish is tried at once";
}

TEST_F(AKeeper, NamesOneThatIsToldAndStaysAsItWasWithWhatItReports) {
    projector.is_deaf = true;
    projector.reports = "lamp: error";
    live(Wanted::On, Keeper::kLongestWay + 10s);
    EXPECT_EQ(keeper.told().trouble, "the projector was told to go on, and does not; it reports lamp: error");
    projector.is_deaf = false;
    projector.reports = "";
    live(Wanted::On, Keeper::kLongestTry + 60s);
    EXPECT_EQ(keeper.told().trouble, "");
}

TEST_F(AKeeper, TellsWhatOneReportsThoughItIsOn) {
    projector.reports = "filter: warning";
    live(Wanted::On, 60s);
    EXPECT_EQ(keeper.told(),
              (Told{Power::On, "the projector reports filter: warning", "look at its lamps and its menu"}));
}

TEST_F(AKeeper, TakesAScreenThatSaysNothingForOff) {
    projector.is = Power::Unknown;
    projector.is_deaf = true;
    live(Wanted::Off, Keeper::kLongestWay + 10s);
    EXPECT_EQ(keeper.told(), (Told{Power::Unknown, "", ""}));
    live(Wanted::On, Keeper::kLongestWay + 10s);
    EXPECT_THAT(keeper.told().trouble, HasSubstr("was told to go on, and does not"));
}

TEST(WhatAKeeperTells, IsReadByOthersAndGrowsOld) {
    const tests::TemporaryFolder runtime;
    const auto now = [&] { return std::filesystem::last_write_time(runtime / kTold); };
    EXPECT_EQ(told_in(runtime.path(), {}), std::nullopt);
    for (const Told& told : {Told{Power::On, "", ""}, Told{std::nullopt, "it does not answer", "look at its cable"},
                             Told{Power::Cooling, "a \"word\"\xff", ""}}) {
        runtime.write(kTold, to_json(told));
        auto read = told_in(runtime.path(), now());
        ASSERT_TRUE(read);
        EXPECT_EQ(read->power, told.power);
        EXPECT_EQ(read->trouble.substr(0, 8), told.trouble.substr(0, 8));
    }
    EXPECT_EQ(told_in(runtime.path(), now() + 4 * Keeper::kCheckEvery), std::nullopt);
    for (const char* wrong : {"", "[]", "{", "\xff"}) {
        runtime.write(kTold, wrong);
        EXPECT_EQ(told_in(runtime.path(), now()), std::nullopt) << wrong;
    }
    runtime.write(kTold, R"({"power": 3, "trouble": []})");
    EXPECT_EQ(told_in(runtime.path(), now()), (Told{std::nullopt, "", ""}));
}

}  // namespace
}  // namespace quadrat::projector
