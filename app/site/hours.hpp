// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// When the house is open, and what the exhibit shows about it.
namespace quadrat::site {

// From a minute of a day until another, which may lie in the next day: 18:00 to 02:00 is 1080 to 1560.
struct OpenSpan {
    int from_min = 0;
    int until_min = 0;
    friend bool operator==(const OpenSpan&, const OpenSpan&) = default;
};

struct Hours {
    bool is_always_open = true;
    std::array<std::vector<OpenSpan>, 7> week;                                // Monday first
    std::map<std::chrono::year_month_day, std::vector<OpenSpan>> exceptions;  // instead of the day of the week
    friend bool operator==(const Hours&, const Hours&) = default;
};

// "09:00-12:30, 13:30-18:00", "18:00-02:00", "closed". Throws std::invalid_argument: what is wrong and what would be
// right.
std::vector<OpenSpan> parse_spans(std::string_view text);
// "2026-12-24". Throws as above.
std::chrono::year_month_day parse_date(std::string_view text);
std::string date_text(std::chrono::year_month_day date);

// What the wall says, in the site's own time.
struct WallClock {
    std::chrono::year_month_day date{};
    int minute = 0;           // of the day
    bool is_trusted = false;  // false: never a reason to close
    std::string zone{};       // "Europe/Berlin (CET, UTC+01:00)"
    std::string source{};     // why it is trusted: "synchronised", "rtc0"; "" where it is not
    std::string doubt{};      // why it is not: what is wrong
    std::string remedy{};     // and what mends that
};

bool is_open(const Hours& hours, const WallClock& now);

// When the house opens or closes next, on the same wall; nothing within a year: it stays as it is.
struct Turn {
    std::chrono::year_month_day date{};
    int minute = 0;  // of the day
    friend bool operator==(const Turn&, const Turn&) = default;
};
std::optional<Turn> next_turn(const Hours& hours, const WallClock& now);
// "18:00"; on another day, unless it is the coming night, "Tuesday 2026-11-24 09:00".
std::string turn_text(const Turn& turn, const WallClock& now);
// "always open", "open until 18:00", "closed until Tuesday 2026-11-24 09:00", "closed for good"; with a clock that is
// not trusted "open: the opening hours are not followed".
std::string opening_text(const Hours& hours, const WallClock& now);

enum class Curtain {
    Open,  // the exhibit
    Card,  // a card says that the house is closed
    Dark,  // the screen is switched off
};

struct DoorkeeperOptions {
    std::chrono::seconds card{60};       // how long the card is shown before the screen goes dark
    std::chrono::seconds overtime{900};  // a visit that has begun may go on so long
    bool wakes_by_button = true;
    std::chrono::seconds awake{300};  // after the last press that woke it
};

// Opens and closes. A visit is never broken off at the minute of closing; a clock that is not to be trusted never
// closes anything.
class Doorkeeper {
  public:
    using Instant = std::chrono::nanoseconds;

    void follow(const Hours& hours, const DoorkeeperOptions& options) {
        hours_ = hours;
        options_ = options;
    }
    // On stand-by it is closed whatever the hours say, and no button wakes it.
    Curtain look(Instant now, const WallClock& wall, bool has_visitor, bool stands_by = false);
    void pressed(Instant now);  // any button

  private:
    Hours hours_;
    DoorkeeperOptions options_;
    Curtain curtain_ = Curtain::Open;
    Instant closed_since_{0};  // since the hours ended
    Instant card_since_{0};
    bool is_closing_ = false;
    Instant awake_until_{0};
};

}  // namespace quadrat::site
