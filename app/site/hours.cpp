// SPDX-License-Identifier: Apache-2.0
#include "site/hours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace quadrat::site {
namespace {

constexpr int kDay_min = 24 * 60;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

std::optional<int> number(std::string_view text, std::size_t digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.size() != digits || text.front() == '-' || error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

// "09:30" as minutes; 24:00 is the day's end.
std::optional<int> minute_of(std::string_view text) {
    if (text.size() != 5 || text[2] != ':') return std::nullopt;
    const auto hour = number(text.substr(0, 2), 2), minute = number(text.substr(3), 2);
    if (!hour || !minute || *minute > 59 || *hour * 60 + *minute > kDay_min) return std::nullopt;
    return *hour * 60 + *minute;
}

OpenSpan parse_span(std::string_view text) {
    const std::size_t dash = text.find('-');
    const auto from = minute_of(trimmed(text.substr(0, dash)));
    const auto until = dash == std::string_view::npos ? std::nullopt : minute_of(trimmed(text.substr(dash + 1)));
    if (!from || !until || *from == *until)
        throw std::invalid_argument("\"" + std::string(text.substr(0, 40)) +
                                    "\" is no opening time; write 09:00-17:30, several with commas, or closed");
    return {*from, *until > *from ? *until : *until + kDay_min};
}

const std::vector<OpenSpan>& spans_of(const Hours& hours, std::chrono::sys_days day) {
    const auto exception = hours.exceptions.find(std::chrono::year_month_day{day});
    if (exception != hours.exceptions.end()) return exception->second;
    return hours.week[std::chrono::weekday{day}.iso_encoding() - 1];
}

bool holds(const std::vector<OpenSpan>& spans, int minute) {
    return std::any_of(spans.begin(), spans.end(),
                       [&](const OpenSpan& span) { return span.from_min <= minute && minute < span.until_min; });
}

}  // namespace

std::vector<OpenSpan> parse_spans(std::string_view text) {
    if (trimmed(text) == "closed") return {};
    std::vector<OpenSpan> spans;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        spans.push_back(parse_span(trimmed(text.substr(start, comma - start))));
        start = comma + 1;
    }
    return spans;
}

std::chrono::year_month_day parse_date(std::string_view text) {
    const bool has_dashes = text.size() == 10 && text[4] == '-' && text[7] == '-';
    const auto year = has_dashes ? number(text.substr(0, 4), 4) : std::nullopt;
    const auto month = has_dashes ? number(text.substr(5, 2), 2) : std::nullopt;
    const auto day = has_dashes ? number(text.substr(8, 2), 2) : std::nullopt;
    if (year && month && day) {
        const std::chrono::year_month_day date{std::chrono::year{*year},
                                               std::chrono::month(static_cast<unsigned>(*month)),
                                               std::chrono::day(static_cast<unsigned>(*day))};
        if (date.ok()) return date;
    }
    throw std::invalid_argument("\"" + std::string(text.substr(0, 40)) + "\" is no date; write 2026-12-24");
}

bool is_open(const Hours& hours, const WallClock& now) {
    if (hours.is_always_open) return true;
    const std::chrono::sys_days today{now.date};
    return holds(spans_of(hours, today), now.minute) ||
           holds(spans_of(hours, today - std::chrono::days{1}), now.minute + kDay_min);
}

std::optional<Turn> next_turn(const Hours& hours, const WallClock& now) {
    if (hours.is_always_open) return std::nullopt;
    const std::chrono::sys_days today{now.date};
    const bool is_open_now = is_open(hours, now);
    constexpr int kDaysAhead = 366;
    for (int ahead = -1; ahead <= kDaysAhead; ++ahead) {
        std::vector<int> edges;  // minutes after the beginning of today
        for (const OpenSpan& span : spans_of(hours, today + std::chrono::days{ahead}))
            for (const int minute : {span.from_min, span.until_min}) edges.push_back(ahead * kDay_min + minute);
        std::sort(edges.begin(), edges.end());
        for (const int edge : edges) {
            if (edge <= now.minute) continue;
            const Turn turn{today + std::chrono::days{edge / kDay_min}, edge % kDay_min};
            if (is_open(hours, {turn.date, turn.minute}) != is_open_now) return turn;
        }
    }
    return std::nullopt;
}

std::string turn_text(const Turn& turn, const WallClock& now) {
    std::string time = fmt::format("{:02}:{:02}", turn.minute / 60, turn.minute % 60);
    const auto days = std::chrono::sys_days{turn.date} - std::chrono::sys_days{now.date};
    constexpr int kMorning = 6 * 60;
    if (days.count() == 0 || (days.count() == 1 && turn.minute <= kMorning)) return time;
    constexpr const char* kNames[] = {"Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"};
    const std::chrono::weekday weekday{std::chrono::sys_days{turn.date}};
    return fmt::format("{} {} {}", kNames[weekday.iso_encoding() - 1], date_text(turn.date), time);
}

std::string opening_text(const Hours& hours, const WallClock& now) {
    if (hours.is_always_open) return "always open";
    if (!now.is_trusted) return "open: the opening hours are not followed";
    const bool is_open_now = is_open(hours, now);
    const auto turn = next_turn(hours, now);
    if (!turn) return is_open_now ? "open for good" : "closed for good";
    return fmt::format("{} until {}", is_open_now ? "open" : "closed", turn_text(*turn, now));
}

std::string date_text(std::chrono::year_month_day date) {
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

Curtain Doorkeeper::look(Instant now, const WallClock& wall, bool has_visitor, bool stands_by) {
    if (!stands_by && (!wall.is_trusted || is_open(hours_, wall))) {
        is_closing_ = false;
        return curtain_ = Curtain::Open;
    }
    if (!is_closing_) closed_since_ = now;
    is_closing_ = true;
    const bool is_awake = !stands_by && now < awake_until_;
    if (curtain_ == Curtain::Open) {
        const bool may_stay = is_awake || (has_visitor && now - closed_since_ < options_.overtime);
        if (may_stay) return curtain_;
        card_since_ = now;
        return curtain_ = Curtain::Card;
    }
    if (is_awake) return curtain_ = Curtain::Open;
    if (curtain_ == Curtain::Card && now - card_since_ >= options_.card) curtain_ = Curtain::Dark;
    return curtain_;
}

void Doorkeeper::pressed(Instant now) {
    if (!options_.wakes_by_button || !is_closing_) return;
    // Whoever is in the visit that may go on past closing does not prolong it; whoever wakes the exhibit does.
    if (curtain_ != Curtain::Open || now < awake_until_) awake_until_ = now + options_.awake;
}

}  // namespace quadrat::site
