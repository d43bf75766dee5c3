// SPDX-License-Identifier: Apache-2.0
// The room `report`: what visitors did over days, weeks and years, counted from the state file and written as a page, a
// table or JSON. Nothing here changes the state file, knows the time, or is run by the exhibit.
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "archive/sqlite.hpp"

namespace quadrat::report {

using Date = std::chrono::year_month_day;

// A moment on the wall of the house.
struct LocalTime {
    Date date{};
    int minute = 0;  // of the day
};
using ToLocal = std::function<LocalTime(std::int64_t ms_since_1970)>;

// Days of the house's own calendar, the first and the last among them; without one there is no bound.
struct Days {
    std::optional<Date> from, to;
};

inline constexpr int kLongest_min = 20;      // lengths from here on are counted together
inline constexpr int kMostRounds = 16;       // so are rounds
inline constexpr int kSlowestAnswer_s = 60;  // and seconds before an answer

struct DayCount {
    Date date{};
    int visits = 0;
    int finished = 0;  // to the end
    int left = 0;      // nobody answered "Still there?"
    int stuck = 0;     // four landscapes never came
    int cut = 0;       // no end was written: it is going on, or the power went
    int rounds = 0;    // that were answered whole
    int picks = 0;     // answers
    int starts = 0;    // of the exhibit
    friend bool operator==(const DayCount&, const DayCount&) = default;
};

void add(DayCount& sum, const DayCount& day);  // all but the date

// What visitors said of a word, by the Monday of the week; a value is from -1 (its low end) to 1.
struct WordWeek {
    Date monday{};
    int answers = 0;
    double mean = 0;
    double error = 0;  // standard error of the mean; 0 of a single answer
};
struct WordCount {
    std::string word;
    int answers = 0;
    double mean = 0;
    std::vector<WordWeek> weeks;  // those with an answer, in order
};

// Visits of one arm, of those whose rounds are kept, and what became of them.
struct Arm {
    int visits = 0, finished = 0;
    double rounds = 0, rounds_error = 0;      // the mean, and its standard error
    double length_s = 0, length_error_s = 0;  // of those that ended
};

struct Counts {
    std::vector<DayCount> days;                              // each from the first visit's to the last visit's
    DayCount all;                                            // their sum; its date means nothing
    std::array<std::array<int, 24>, 7> by_hour{};            // visits that began then; Monday first
    std::array<int, kLongest_min + 1> lengths{};             // visits that ended, by whole minutes
    std::optional<double> median_length_s;                   // of visits that ended
    std::array<int, kMostRounds + 1> rounds{};               // visits by rounds that were answered whole
    std::array<std::array<int, 3>, kMostRounds> given_up{};  // left or stuck: in which round, before which answer
    std::array<std::array<int, 4>, 3> letters{};             // picks by aspect, A to D
    std::array<std::array<int, kSlowestAnswer_s + 1>, 3> answer_s{};  // seconds since the answer before, by aspect
    Arm bred, by_chance;                                              // what evolution is compared with
    std::vector<WordCount> words;                                     // most answers first
};

// One pass over the file: a million visits take seconds. Throws SqliteError.
Counts count(const archive::Connection& connection, const Days& days, const ToLocal& to_local);

// The value that half of a histogram's entries do not exceed, as an index; nothing where it is empty.
std::optional<int> median_of(const int* counts, int size);

// A share and its interval of 95 % (Wilson 1927); {0, 0, 0} of none.
struct Share {
    double value = 0, low = 0, high = 0;
};
Share share_of(int part, int whole);

std::string text_of(Date date);             // "2026-11-26"
Date monday_of(Date date);                  // of its week
std::string duration_text(double seconds);  // "4 min 30 s", "12 s"

}  // namespace quadrat::report
