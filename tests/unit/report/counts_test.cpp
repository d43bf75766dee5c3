// SPDX-License-Identifier: Apache-2.0
#include "report/counts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "archive/archive.hpp"
#include "archive/state_file.hpp"
#include "archive/visit_rows.hpp"
#include "report/plots.hpp"
#include "report/writers.hpp"
#include "support/process.hpp"

namespace quadrat::report {
namespace {

using genome::Aspect;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// Thursday 2026-11-26, 12:00 UTC.
constexpr archive::WallTime kNoon{milliseconds{1'795'694'400'000}};

LocalTime in_utc(std::int64_t ms) {
    const auto at = std::chrono::sys_time<milliseconds>(milliseconds(ms));
    const auto day = std::chrono::floor<std::chrono::days>(at);
    return {Date(day), static_cast<int>(std::chrono::duration_cast<minutes>(at - day).count())};
}

Date date(int year, unsigned month, unsigned day) {
    return std::chrono::year(year) / static_cast<int>(month) / static_cast<int>(day);
}

class CountsOfAState : public testing::Test {
  protected:
    void SetUp() override { archive_.emplace(archive::Archive::open(folder_.path(), kNoon).archive); }

    // A visitor who takes ten seconds for each answer; `last` of them in the round in which they end.
    void visit(archive::WallTime at, int whole_rounds, int last, std::optional<exhibit::Ending> ending) {
        const std::int64_t id = archive_->begin_visit(at).visit;
        for (int round = 1; round <= whole_rounds + (last >= 0 ? 1 : 0); ++round)
            at = answer(id, round, round <= whole_rounds ? 3 : last, at);
        if (ending) {
            ASSERT_EQ(archive_->end_visit(id, *ending, whole_rounds, at), std::nullopt);
        }
    }

    archive::WallTime answer(std::int64_t id, int round, int answers, archive::WallTime at) {
        archive::Generation generation;
        generation.visit = id;
        generation.round = round;
        generation.breeder = breeder_;
        generation.deeds.resize(static_cast<std::size_t>(round - 1));
        EXPECT_EQ(archive_->append(generation), std::nullopt);
        genome::Pick pick;
        for (int i = 0; i < answers; ++i) {
            at += seconds(10);
            pick[genome::kAspects[static_cast<std::size_t>(i)]] = i;
            EXPECT_EQ(archive_->keep_answers(id, round, pick, at), std::nullopt);
        }
        return at;
    }

    Counts counts(const Days& days = {}) const {
        Counts found;
        archive::read_state(folder_.path(),
                            [&](const archive::Connection& state) { found = count(state, days, in_utc); });
        return found;
    }

    tests::TemporaryFolder folder_;
    std::optional<archive::Archive> archive_;
    std::string breeder_ = "belief";
};

TEST_F(CountsOfAState, CompareWhatWasBredWithWhatChanceMade) {
    for (int i = 0; i < 12; ++i) {
        breeder_ = i % 4 == 0 ? "chance" : "belief";
        const bool is_by_chance = breeder_ == "chance";
        visit(kNoon + minutes(10 * i), is_by_chance ? 2 : 5 + i % 2, -1,
              is_by_chance ? exhibit::Ending::Left : exhibit::Ending::Finished);
    }
    const Counts found = counts();
    EXPECT_EQ(found.by_chance.visits, 3);
    EXPECT_EQ(found.by_chance.finished, 0);
    EXPECT_EQ(found.by_chance.rounds, 2);
    EXPECT_EQ(found.by_chance.rounds_error, 0);
    EXPECT_EQ(found.by_chance.length_s, 60);
    EXPECT_EQ(found.bred.visits, 9);
    EXPECT_EQ(found.bred.finished, 9);
    EXPECT_NEAR(found.bred.rounds, 5 + 6.0 / 9, 1e-9);
    EXPECT_GT(found.bred.rounds_error, 0.1);
    EXPECT_THAT(text_of(found), HasSubstr("by chance alone  3 visits, 2.0 rounds; bred 5.7"));
    EXPECT_THAT(html_of(found, {}), HasSubstr("What breeding adds"));
    EXPECT_EQ(nlohmann::json::parse(json_of(found, {}))["control"]["chance"]["visits"], 3);
}

TEST_F(CountsOfAState, OfASiteWithoutChanceSayNothingOfIt) {
    visit(kNoon, 6, -1, exhibit::Ending::Finished);
    EXPECT_THAT(html_of(counts(), {}), Not(HasSubstr("What breeding adds")));
    EXPECT_FALSE(nlohmann::json::parse(json_of(counts(), {})).contains("control"));
}

TEST_F(CountsOfAState, AreThoseOfItsVisits) {
    visit(kNoon, 6, -1, exhibit::Ending::Finished);
    visit(kNoon + minutes(10), 2, 1, exhibit::Ending::Left);
    visit(kNoon + std::chrono::hours(48), 0, 0, exhibit::Ending::Stuck);
    visit(kNoon + std::chrono::hours(49), 1, -1, std::nullopt);
    const Counts found = counts();
    ASSERT_EQ(found.days.size(), 3U);
    EXPECT_EQ(found.days[0], (DayCount{date(2026, 11, 26), 2, 1, 1, 0, 0, 8, 25, 1}));
    EXPECT_EQ(found.days[1], (DayCount{date(2026, 11, 27)})) << "a day without a visit";
    EXPECT_EQ(found.days[2], (DayCount{date(2026, 11, 28), 2, 0, 0, 1, 1, 1, 3, 0}));
    EXPECT_EQ(found.all.visits, 4);
    EXPECT_EQ(found.by_hour[3][12], 2) << "Thursday";
    EXPECT_EQ(found.by_hour[5][13], 1);
    EXPECT_EQ(found.lengths[3], 1) << "18 answers, ten seconds each";
    EXPECT_EQ(found.median_length_s, 70) << "of 0, 70 and 180 s";
    EXPECT_EQ(found.rounds[6], 1);
    EXPECT_EQ(found.rounds[0], 1);
    EXPECT_THAT(found.given_up[2], ElementsAre(0, 1, 0)) << "the trees of round three were answered";
    EXPECT_THAT(found.given_up[0], ElementsAre(1, 0, 0));
    EXPECT_THAT(found.letters[0], ElementsAre(10, 0, 0, 0));
    EXPECT_THAT(found.letters[1], ElementsAre(0, 9, 0, 0));
    EXPECT_EQ(median_of(found.answer_s[1].data(), kSlowestAnswer_s + 1), 10);
}

TEST_F(CountsOfAState, HoldARoundThatWasTakenBackOnce) {
    const std::int64_t id = archive_->begin_visit(kNoon).visit;
    auto at = answer(id, 1, 3, kNoon);
    at = answer(id, 2, 1, at);
    at = answer(id, 1, 2, at);  // back
    ASSERT_EQ(archive_->end_visit(id, exhibit::Ending::Left, 0, at), std::nullopt);
    const Counts found = counts();
    EXPECT_EQ(found.all.picks, 2);
    EXPECT_EQ(found.all.rounds, 0);
    EXPECT_THAT(found.given_up[0], ElementsAre(0, 0, 1));
}

TEST_F(CountsOfAState, AreOfTheDaysThatWereAskedFor) {
    for (int day = 0; day < 10; ++day) visit(kNoon + std::chrono::hours(24 * day), 1, -1, exhibit::Ending::Finished);
    EXPECT_EQ(counts({date(2026, 11, 28), date(2026, 11, 30)}).all.visits, 3);
    EXPECT_EQ(counts({date(2026, 11, 28), std::nullopt}).all.visits, 8);
    EXPECT_EQ(counts({std::nullopt, date(2026, 11, 26)}).all.visits, 1);
    EXPECT_TRUE(counts({date(2027, 1, 1), std::nullopt}).days.empty());
}

TEST_F(CountsOfAState, GoByTheHousesOwnCalendar) {
    visit(kNoon + std::chrono::hours(11) + minutes(30), 1, -1, exhibit::Ending::Finished);  // 23:30 UTC
    Counts found;
    archive::read_state(folder_.path(), [&](const archive::Connection& state) {
        found = count(state, {date(2026, 11, 27), date(2026, 11, 27)},
                      [](std::int64_t ms) { return in_utc(ms + 3'600'000); });
    });
    EXPECT_EQ(found.all.visits, 1);
    EXPECT_EQ(found.by_hour[4][0], 1) << "Friday, half past midnight";
}

TEST_F(CountsOfAState, AreKeptApartByWordAndWeek) {
    const auto say = [&](archive::WallTime at, std::size_t step) {
        genome::WordAnswer answer;
        answer.word = *genome::word_named("warm");
        answer.step = step;
        ASSERT_EQ(archive_->keep_word(answer, at), std::nullopt);
    };
    visit(kNoon, 1, -1, exhibit::Ending::Finished);
    say(kNoon, 3);
    say(kNoon + seconds(1), 3);
    say(kNoon + seconds(2), 0);
    say(kNoon + seconds(3), 3);
    say(kNoon + std::chrono::hours(24 * 7), 0);
    const Counts found = counts();
    ASSERT_EQ(found.words.size(), 1U);
    EXPECT_EQ(found.words[0].answers, 5);
    ASSERT_EQ(found.words[0].weeks.size(), 2U);
    EXPECT_EQ(found.words[0].weeks[0].monday, date(2026, 11, 23));
    EXPECT_NEAR(found.words[0].weeks[0].mean, 0.5, 1e-6);
    EXPECT_NEAR(found.words[0].weeks[0].error, 0.5, 1e-6) << "of 1, 1, -1, 1";
    EXPECT_EQ(found.words[0].weeks[1].error, 0);
    EXPECT_THAT(html_of(found, {"Visitors", "today", "1"}), HasSubstr("week of 2026-11-30"));
}

TEST_F(CountsOfAState, WithoutAVisitIsSaidToBeSo) {
    const Counts none = counts({date(2030, 1, 1), std::nullopt});
    EXPECT_EQ(text_of(none), "there were no visits in these days\n");
    EXPECT_THAT(html_of(none, {"Visitors", "today", "1"}), HasSubstr("no visits"));
    EXPECT_EQ(csv_of(none), "date,visits,finished,left,stuck,cut,rounds,picks,starts\r\n");
    EXPECT_EQ(nlohmann::json::parse(json_of(none, {"Visitors", "today", "1"}))["all"]["visits"], 0);
}

TEST_F(CountsOfAState, AreWrittenAlikeInEveryForm) {
    visit(kNoon, 2, 1, exhibit::Ending::Left);
    const Counts found = counts();
    EXPECT_THAT(csv_of(found), HasSubstr("\r\n2026-11-26,1,0,1,0,0,2,7,1\r\n"));
    const auto json = nlohmann::json::parse(json_of(found, {"A \"title\"", "today", "1"}));
    EXPECT_EQ(json["days"][0]["picks"], 7);
    EXPECT_EQ(json["given_up"][2][1], 1);
    EXPECT_EQ(json["title"], "A \"title\"");
    const std::string html = html_of(found, {"<b>&", "today", "1"});
    EXPECT_THAT(html, HasSubstr("&lt;b&gt;&amp;"));
    EXPECT_THAT(html, Not(HasSubstr("src=")));
    EXPECT_THAT(html, Not(HasSubstr("http")));
}

TEST(Share, HasWilsonsInterval) {
    const Share half = share_of(5, 10);  // Wilson: 0.2366 to 0.7634
    EXPECT_NEAR(half.low, 0.2366, 1e-4);
    EXPECT_NEAR(half.high, 0.7634, 1e-4);
    EXPECT_EQ(share_of(0, 10).low, 0);
    EXPECT_NEAR(share_of(0, 10).high, 0.2775, 1e-4);
    EXPECT_EQ(share_of(0, 0).high, 0);
}

TEST(Median, IsTheValueThatHalfDoNotExceed) {
    const int counts[]{1, 1, 3, 0, 5};
    EXPECT_EQ(median_of(counts, 5), 2);
    EXPECT_EQ(median_of(counts, 1), 0);
    const int none[]{0, 0};
    EXPECT_EQ(median_of(none, 2), std::nullopt);
}

TEST(Weeks, BeginOnMondays) {
    EXPECT_EQ(monday_of(date(2026, 11, 26)), date(2026, 11, 23));
    EXPECT_EQ(monday_of(date(2026, 11, 23)), date(2026, 11, 23));
    EXPECT_EQ(monday_of(date(2027, 1, 3)), date(2026, 12, 28)) << "across a year";
}

TEST(Plots, StandWithinTheirFrameWhateverTheyShow) {
    for (const double most : {0.0, 1.0, 3.0, 999.0, 1e7}) {
        const std::string svg = bars_svg({{"a", most, 0, "one"}, {"b", 0, most, "<other>"}}, "two bars");
        EXPECT_THAT(svg, Not(HasSubstr("height=\"-"))) << most;
        EXPECT_THAT(svg, Not(HasSubstr("nan"))) << most;
        EXPECT_THAT(svg, HasSubstr("&lt;other&gt;"));
    }
    EXPECT_THAT(bars_svg({}, "none"), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace quadrat::report
