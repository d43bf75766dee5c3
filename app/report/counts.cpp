// SPDX-License-Identifier: Apache-2.0
#include "report/counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "archive/visit_rows.hpp"
#include "genome/word_answer.hpp"

namespace quadrat::report {
namespace {

using std::chrono::days;
using std::chrono::sys_days;

// Bounds in milliseconds that no house's time zone falls outside of; the calendar decides within them.
std::pair<std::int64_t, std::int64_t> wide_bounds(const Days& asked) {
    const auto ms_of = [](sys_days day) {
        return std::chrono::duration_cast<std::chrono::milliseconds>(day.time_since_epoch()).count();
    };
    constexpr std::chrono::year_month_day kNever{std::chrono::year{2200}, std::chrono::January, std::chrono::day{1}};
    return {asked.from ? ms_of(sys_days(*asked.from) - days(1)) : 0,
            ms_of(asked.to ? sys_days(*asked.to) + days(2) : sys_days(kNever))};
}

bool is_within(const Days& asked, Date date) {
    return !(asked.from && date < *asked.from) && !(asked.to && date > *asked.to);
}

// The days without a visit are there as well: a plot shows them as what they are.
class Calendar {
  public:
    DayCount& at(Date date) {
        const int day = static_cast<int>(sys_days(date).time_since_epoch().count());
        if (counts_.empty()) first_ = day;
        if (day < first_) {
            counts_.insert(counts_.begin(), static_cast<std::size_t>(first_ - day), DayCount{});
            first_ = day;
        }
        const auto index = static_cast<std::size_t>(day - first_);
        if (index >= counts_.size()) counts_.resize(index + 1);
        return counts_[index];
    }
    std::vector<DayCount> take() {
        for (std::size_t i = 0; i < counts_.size(); ++i)
            counts_[i].date = Date(sys_days(days(first_ + static_cast<int>(i))));
        return std::move(counts_);
    }

  private:
    std::vector<DayCount> counts_;
    int first_ = 0;
};

// Rounds that were answered whole.
int count_answers(const archive::VisitRow& visit, Counts& counts, DayCount& day) {
    std::int64_t before_ms = 0;
    int whole = 0;
    for (const archive::RoundRow& round : visit.rounds) {
        int answers = 0;
        for (std::size_t aspect = 0; aspect < round.picked.size(); ++aspect) {
            const int picked = round.picked[aspect];
            if (picked < 0 || picked > 3) continue;
            ++answers;
            ++counts.letters[aspect][static_cast<std::size_t>(picked)];
            const std::int64_t at_ms = round.answered_ms[aspect];
            if (before_ms != 0 && at_ms >= before_ms)
                ++counts.answer_s[aspect][static_cast<std::size_t>(
                    std::min<std::int64_t>((at_ms - before_ms) / 1000, kSlowestAnswer_s))];
            before_ms = at_ms;
        }
        day.picks += answers;
        if (answers == 3) ++whole;
    }
    day.rounds += whole;
    ++counts.rounds[static_cast<std::size_t>(std::min(whole, kMostRounds))];
    return whole;
}

// Where somebody went away: the round they were in, and the first question of it that has no answer.
void count_where_given_up(const archive::VisitRow& visit, Counts& counts) {
    if (visit.rounds.empty()) return;
    const archive::RoundRow& last = visit.rounds.back();
    const auto round = static_cast<std::size_t>(std::clamp(last.round, 1, kMostRounds) - 1);
    for (std::size_t aspect = 0; aspect < last.picked.size(); ++aspect) {
        if (last.picked[aspect] >= 0) continue;
        ++counts.given_up[round][aspect];
        return;
    }
    // All three were answered: they left while the next four were growing.
    ++counts.given_up[std::min(round + 1, std::size_t{kMostRounds - 1})][0];
}

void count_ending(const archive::VisitRow& visit, Counts& counts, DayCount& day) {
    if (visit.ending == "finished")
        ++day.finished;
    else if (visit.ending == "left")
        ++day.left;
    else if (visit.ending == "stuck")
        ++day.stuck;
    else
        ++day.cut;
    if (visit.ending == "left" || visit.ending == "stuck") count_where_given_up(visit, counts);
}

struct Sum {
    int answers = 0;
    double sum = 0, squares = 0;
    void add(double value) {
        ++answers;
        sum += value;
        squares += value * value;
    }
    double mean() const { return answers == 0 ? 0 : sum / answers; }
    double error() const {
        if (answers < 2) return 0;
        const double variance = (squares - sum * sum / answers) / (answers - 1);
        return std::sqrt(std::max(0.0, variance) / answers);
    }
};

// One after the other, bred and by chance.
class ArmSums {
  public:
    void add(const archive::VisitRow& visit, int whole_rounds) {
        if (visit.rounds.empty()) return;
        ++arm_.visits;
        arm_.finished += visit.ending == "finished";
        rounds_.add(whole_rounds);
        if (visit.ended_ms >= visit.began_ms && visit.ended_ms > 0)
            lengths_s_.add(static_cast<double>(visit.ended_ms - visit.began_ms) / 1000);
    }
    Arm take() {
        arm_.rounds = rounds_.mean();
        arm_.rounds_error = rounds_.error();
        arm_.length_s = lengths_s_.mean();
        arm_.length_error_s = lengths_s_.error();
        return arm_;
    }

  private:
    Arm arm_;
    Sum rounds_, lengths_s_;
};

void count_visits(const archive::Connection& connection, const Days& asked, const ToLocal& to_local, Counts& counts,
                  Calendar& calendar) {
    const auto [from_ms, until_ms] = wide_bounds(asked);
    std::vector<float> lengths_s;
    ArmSums bred, by_chance;
    archive::each_visit(connection, from_ms, until_ms, [&](const archive::VisitRow& visit) {
        const LocalTime began = to_local(visit.began_ms);
        if (!is_within(asked, began.date)) return;
        DayCount& day = calendar.at(began.date);
        ++day.visits;
        const auto weekday = std::chrono::weekday(sys_days(began.date)).iso_encoding() - 1;
        ++counts.by_hour[weekday][static_cast<std::size_t>(std::clamp(began.minute / 60, 0, 23))];
        const int whole = count_answers(visit, counts, day);
        (visit.is_by_chance ? by_chance : bred).add(visit, whole);
        count_ending(visit, counts, day);
        if (visit.ended_ms < visit.began_ms) return;
        const std::int64_t length_ms = visit.ended_ms - visit.began_ms;
        lengths_s.push_back(static_cast<float>(length_ms) / 1000);
        ++counts.lengths[static_cast<std::size_t>(std::min<std::int64_t>(length_ms / 60'000, kLongest_min))];
    });
    counts.bred = bred.take();
    counts.by_chance = by_chance.take();
    if (lengths_s.empty()) return;
    const auto middle = lengths_s.begin() + static_cast<std::ptrdiff_t>(lengths_s.size() / 2);
    std::ranges::nth_element(lengths_s, middle);
    counts.median_length_s = *middle;
}

std::vector<WordCount> count_words(const archive::Connection& connection, const Days& asked, const ToLocal& to_local) {
    const auto [from_ms, until_ms] = wide_bounds(asked);
    std::map<std::string, std::map<sys_days, Sum>> weeks;
    std::map<std::string, Sum> all;
    for (const archive::WordRow& row : archive::word_rows(connection, from_ms, until_ms)) {
        const Date date = to_local(row.at_ms).date;
        if (!is_within(asked, date) || row.step < 0 || row.step >= static_cast<int>(genome::kAnswerSteps.size()))
            continue;
        const double value = static_cast<double>(genome::kAnswerSteps[static_cast<std::size_t>(row.step)]);
        all[row.word].add(value);
        weeks[row.word][sys_days(monday_of(date))].add(value);
    }
    std::vector<WordCount> words;
    for (const auto& [word, sum] : all) {
        WordCount& one = words.emplace_back(WordCount{word, sum.answers, sum.mean(), {}});
        for (const auto& [monday, of_week] : weeks[word])
            one.weeks.push_back({Date(monday), of_week.answers, of_week.mean(), of_week.error()});
    }
    std::ranges::stable_sort(words, std::greater<>{}, &WordCount::answers);
    return words;
}

}  // namespace

void add(DayCount& sum, const DayCount& day) {
    sum.visits += day.visits;
    sum.finished += day.finished;
    sum.left += day.left;
    sum.stuck += day.stuck;
    sum.cut += day.cut;
    sum.rounds += day.rounds;
    sum.picks += day.picks;
    sum.starts += day.starts;
}

Counts count(const archive::Connection& connection, const Days& asked, const ToLocal& to_local) {
    Counts counts;
    Calendar calendar;
    count_visits(connection, asked, to_local, counts, calendar);
    const auto [from_ms, until_ms] = wide_bounds(asked);
    for (const std::int64_t at_ms : archive::starts(connection, from_ms, until_ms)) {
        const Date date = to_local(at_ms).date;
        if (is_within(asked, date)) ++calendar.at(date).starts;
    }
    counts.days = calendar.take();
    for (const DayCount& day : counts.days) add(counts.all, day);
    counts.words = count_words(connection, asked, to_local);
    return counts;
}

std::optional<int> median_of(const int* counts, int size) {
    std::int64_t all = 0;
    for (int i = 0; i < size; ++i) all += counts[i];
    if (all == 0) return std::nullopt;
    std::int64_t seen = 0;
    for (int i = 0; i < size; ++i) {
        seen += counts[i];
        if (2 * seen >= all) return i;
    }
    return size - 1;
}

Share share_of(int part, int whole) {
    if (whole <= 0) return {};
    const double n = whole;
    const double p = part / n;
    constexpr double kZ = 1.96;
    const double centre = (p + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
    const double half = kZ * std::sqrt(p * (1 - p) / n + kZ * kZ / (4 * n * n)) / (1 + kZ * kZ / n);
    return {p, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

std::string text_of(Date date) {
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

Date monday_of(Date date) {
    const sys_days day(date);
    return Date(day - days(static_cast<int>(std::chrono::weekday(day).iso_encoding()) - 1));
}

std::string duration_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace quadrat::report
