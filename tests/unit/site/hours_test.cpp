// SPDX-License-Identifier: Apache-2.0
#include "site/hours.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace quadrat::site {
namespace {

using namespace std::chrono_literals;
using std::chrono::year_month_day;

// 2026-11-23 is a Monday.
WallClock at(const char* date, int hour, int minute = 0) { return {parse_date(date), hour * 60 + minute, true}; }

Hours museum() {
    Hours hours;
    hours.is_always_open = false;
    for (int day = 1; day < 7; ++day)
        hours.week[static_cast<std::size_t>(day)] = parse_spans("09:00-12:30, 13:30-18:00");
    hours.week[4] = parse_spans("18:00-02:00");
    hours.exceptions[parse_date("2026-12-24")] = parse_spans("10:00-13:00");
    hours.exceptions[parse_date("2026-12-25")] = {};
    return hours;
}

TEST(Hours, FollowTheWeekAndItsExceptions) {
    const Hours hours = museum();
    EXPECT_FALSE(is_open(hours, at("2026-11-23", 11))) << "closed on Mondays";
    EXPECT_FALSE(is_open(hours, at("2026-11-24", 8, 59)));
    EXPECT_TRUE(is_open(hours, at("2026-11-24", 9)));
    EXPECT_FALSE(is_open(hours, at("2026-11-24", 12, 30)));
    EXPECT_TRUE(is_open(hours, at("2026-11-24", 17, 59)));
    EXPECT_FALSE(is_open(hours, at("2026-12-24", 9)));
    EXPECT_TRUE(is_open(hours, at("2026-12-24", 12)));
    EXPECT_FALSE(is_open(hours, at("2026-12-25", 23)));
    EXPECT_TRUE(is_open(Hours{}, at("2026-12-25", 3))) << "no hours are no reason to close";
}

TEST(Hours, MayEndAfterMidnight) {
    const Hours hours = museum();
    EXPECT_TRUE(is_open(hours, at("2026-11-27", 23, 59)));
    EXPECT_TRUE(is_open(hours, at("2026-11-28", 1, 59)));
    EXPECT_FALSE(is_open(hours, at("2026-11-28", 2)));
    EXPECT_FALSE(is_open(hours, at("2026-12-26", 1))) << "the day before was an exception";
}

TEST(Hours, RefuseWhatIsNoTimeAndNoDate) {
    for (const char* text :
         {"", "9:00-17:00", "09:00", "09:00-09:00", "25:00-26:00", "09:60-10:00", "09:00-17:00,", "a"})
        EXPECT_THROW(parse_spans(text), std::invalid_argument) << text;
    for (const char* text : {"", "2026-13-01", "2026-02-30", "24.12.2026", "2026-1-1", "-026-01-01"})
        EXPECT_THROW(parse_date(text), std::invalid_argument) << text;
    EXPECT_EQ(parse_spans("00:00-24:00"), (std::vector<OpenSpan>{{0, 1440}}));
}

struct AnEvening : testing::Test {
    AnEvening() { keeper.follow(museum(), {60s, 900s, true, 300s}); }
    Curtain look(std::chrono::seconds after_closing, bool has_visitor = false) {
        const int minute = 18 * 60 + static_cast<int>(after_closing.count() / 60);
        return keeper.look(1h + after_closing, {parse_date("2026-11-24"), minute, true}, has_visitor);
    }
    Doorkeeper keeper;
};

TEST_F(AnEvening, ShowsTheCardAndThenSwitchesTheScreenOff) {
    EXPECT_EQ(look(-60s), Curtain::Open);
    EXPECT_EQ(look(0s), Curtain::Card);
    EXPECT_EQ(look(59s), Curtain::Card);
    EXPECT_EQ(look(60s), Curtain::Dark);
    EXPECT_EQ(look(5h), Curtain::Dark);
    EXPECT_EQ(keeper.look(20h, at("2026-11-25", 9), false), Curtain::Open) << "it wakes by itself";
}

TEST_F(AnEvening, IsAnyHourOnStandBy) {
    const auto by_day = [this](std::chrono::seconds after, bool has_visitor, bool stands_by) {
        return keeper.look(1h + after, at("2026-11-24", 12), has_visitor, stands_by);
    };
    EXPECT_EQ(by_day(0s, true, true), Curtain::Open) << "the visit that has begun goes on";
    EXPECT_EQ(by_day(60s, false, true), Curtain::Card);
    EXPECT_EQ(by_day(120s, false, true), Curtain::Dark);
    keeper.pressed(1h + 121s);
    EXPECT_EQ(by_day(122s, false, true), Curtain::Dark) << "no button wakes it";
    EXPECT_EQ(by_day(123s, false, false), Curtain::Open);
    EXPECT_EQ(keeper.look(2h, {parse_date("2026-11-24"), 720, false}, false, true), Curtain::Card)
        << "also with a clock that is not trusted";
}

TEST_F(AnEvening, LetsAVisitEndButNotForEver) {
    EXPECT_EQ(look(-60s, true), Curtain::Open);
    EXPECT_EQ(look(0s, true), Curtain::Open);
    EXPECT_EQ(look(899s, true), Curtain::Open);
    keeper.pressed(1h + 899s);
    EXPECT_EQ(look(901s, true), Curtain::Card);
}

TEST_F(AnEvening, IsWokenByAButtonForAWhile) {
    look(0s);
    EXPECT_EQ(look(100s), Curtain::Dark);
    keeper.pressed(1h + 200s);
    EXPECT_EQ(look(200s), Curtain::Open);
    keeper.pressed(1h + 400s);
    EXPECT_EQ(look(600s), Curtain::Open);
    EXPECT_EQ(look(701s), Curtain::Card);
}

TEST_F(AnEvening, StaysDarkWhereButtonsMayNotWakeIt) {
    keeper.follow(museum(), {60s, 900s, false, 300s});
    look(0s);
    look(100s);
    keeper.pressed(1h + 200s);
    EXPECT_EQ(look(200s), Curtain::Dark);
}

TEST_F(AnEvening, AClockThatIsNotTrustedNeverBlanksTheScreen) {
    look(0s);
    EXPECT_EQ(look(100s), Curtain::Dark);
    EXPECT_EQ(keeper.look(2h, {parse_date("1970-01-01"), 3 * 60, false}, false), Curtain::Open);
}

TEST(Hours, SayUntilWhen) {
    const Hours hours = museum();
    EXPECT_EQ(opening_text(hours, at("2026-11-24", 10)), "open until 12:30");
    EXPECT_EQ(opening_text(hours, at("2026-11-24", 12, 30)), "closed until 13:30");
    EXPECT_EQ(opening_text(hours, at("2026-11-22", 18)), "closed until Tuesday 2026-11-24 09:00") << "over a Monday";
    EXPECT_EQ(opening_text(hours, at("2026-11-27", 23)), "open until 02:00") << "past midnight";
    EXPECT_EQ(opening_text(hours, at("2026-11-28", 1)), "open until 02:00");
    EXPECT_EQ(opening_text(hours, at("2026-12-24", 13)), "closed until Saturday 2026-12-26 09:00") << "over Christmas";
    EXPECT_EQ(opening_text(Hours{}, at("2026-11-24", 10)), "always open");
    WallClock doubtful = at("2026-11-23", 10);
    doubtful.is_trusted = false;
    EXPECT_EQ(opening_text(hours, doubtful), "open: the opening hours are not followed");
}

TEST(Hours, WhoseSpansTouchStayOpenOverTheSeam) {
    Hours hours;
    hours.is_always_open = false;
    hours.week.fill({{0, 24 * 60}});
    EXPECT_EQ(opening_text(hours, at("2026-11-24", 10)), "open for good");
    hours.exceptions[parse_date("2026-11-26")] = {};
    EXPECT_EQ(opening_text(hours, at("2026-11-24", 10)), "open until Thursday 2026-11-26 00:00");
    EXPECT_EQ(opening_text(hours, at("2026-11-26", 10)), "closed until 00:00");
    hours.week.fill({});
    hours.exceptions.clear();
    EXPECT_EQ(opening_text(hours, at("2026-11-26", 10)), "closed for good");
}

// The next turn is where the house really opens or closes, minute for minute.
TEST(Hours, TurnNextWhereAMinuteForMinuteSearchFindsIt) {
    const Hours hours = museum();
    const WallClock start = at("2026-12-21", 0);
    for (int minute = 0; minute < 8 * 24 * 60; minute += 37) {
        const auto wall_at = [&](int m) {
            return WallClock{std::chrono::sys_days{start.date} + std::chrono::days{m / 1440}, m % 1440, true};
        };
        int until = minute;
        while (is_open(hours, wall_at(until)) == is_open(hours, wall_at(minute))) ++until;
        const WallClock then = wall_at(until);
        EXPECT_EQ(next_turn(hours, wall_at(minute)), (Turn{then.date, then.minute})) << minute;
    }
}

}  // namespace
}  // namespace quadrat::site
