// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/markup.hpp"
#include "genome/aspect.hpp"
#include "report/page_style.hpp"
#include "report/plots.hpp"
#include "report/writers.hpp"

namespace quadrat::report {
namespace {

using std::chrono::days;
using std::chrono::sys_days;

constexpr int kWordsShown = 12;
constexpr int kAnswersShown = 5;  // of a word, or it is left to the table

std::string percent(const Share& share) {
    const std::string low = fmt::format("{:.0f}", 100 * share.low);
    const std::string high = fmt::format("{:.0f}", 100 * share.high);
    const std::string value = fmt::format("{:.0f} %", 100 * share.value);
    return low == high ? value : fmt::format("{} ({} to {})", value, low, high);
}

std::string number(std::int64_t value) {
    std::string digits = std::to_string(value);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > (value < 0 ? 1 : 0); at -= 3)
        digits.insert(static_cast<std::size_t>(at), "\u202f");
    return digits;
}

// "1 day", "12 days".
std::string counted(std::int64_t value, const char* noun) {
    return fmt::format("{} {}{}", number(value), noun, value == 1 ? "" : "s");
}

std::string figure(const std::string& svg, const std::string& caption) {
    return "<figure>" + svg + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string card(const std::string& value, const std::string& what) {
    return fmt::format("<li><b>{}</b><span>{}</span></li>\n", value, what);
}

std::string cards_of(const Counts& counts) {
    const DayCount& all = counts.all;
    const auto open_days = std::ranges::count_if(counts.days, [](const DayCount& day) { return day.visits > 0; });
    std::string html = "<ul class=\"cards\">\n";
    html += card(number(all.visits), all.visits == 1 ? "visit" : "visits");
    html += card(
        fmt::format("{:.0f}", open_days == 0 ? 0.0 : static_cast<double>(all.visits) / static_cast<double>(open_days)),
        fmt::format("a day, on {} with visits", counted(open_days, "day")));
    const Share finished = share_of(all.finished, all.visits);
    html += card(fmt::format("{:.0f} %", 100 * finished.value),
                 fmt::format("went on to the end (interval of 95 %: {:.0f} to {:.0f})", 100 * finished.low,
                             100 * finished.high));
    html += card(counts.median_length_s ? duration_text(*counts.median_length_s) : "–", "is the median visit's length");
    html += card(number(all.picks), "answers were given");
    html += card(number(all.rounds), "rounds of three answers");
    return html + "</ul>\n";
}

// The days, or weeks or months where there are many.
struct Period {
    DayCount sum;  // its date: the period's first day
    std::string label, name;
};

std::vector<Period> periods_of(const Counts& counts, std::string& unit) {
    const std::size_t all = counts.days.size();
    unit = all <= 100 ? "day" : all <= 1100 ? "week" : "month";
    const bool spans_years = all > 0 && counts.days.front().date.year() != counts.days.back().date.year();
    std::vector<Period> periods;
    Date before{};
    for (const DayCount& day : counts.days) {
        Date first = day.date;
        if (unit == "week") first = monday_of(day.date);
        if (unit == "month") first = day.date.year() / day.date.month() / 1;
        if (periods.empty() || first != before) {
            before = first;
            const std::string text = text_of(first);
            const std::string label = unit == "month" ? text.substr(0, 7) : text.substr(spans_years ? 2 : 5);
            periods.push_back({DayCount{first}, label,
                               unit == "week"    ? "week of " + text
                               : unit == "month" ? label
                                                 : text});
        }
        add(periods.back().sum, day);
    }
    return periods;
}

std::string when_html(const Counts& counts) {
    std::string unit;
    std::vector<Bar> bars;
    for (const Period& period : periods_of(counts, unit)) {
        const DayCount& sum = period.sum;
        bars.push_back({period.label, static_cast<double>(sum.finished), static_cast<double>(sum.visits - sum.finished),
                        fmt::format("{}: {} visits, {} to the end", period.name, sum.visits, sum.finished)});
    }
    std::string html = "<h2>When visitors came</h2>\n";
    html += figure(bars_svg(bars, fmt::format("Visits by {}, {} in all, {} of them to the end.", unit,
                                              counts.all.visits, counts.all.finished)),
                   fmt::format("<span class=\"key done\"></span>to the end<span class=\"key other\"></span>not to the "
                               "end; by {}",
                               unit));
    html += figure(hours_svg(counts.by_hour, "Visits by weekday and hour at which they began."),
                   "By weekday and hour at which they began, in the house's own time");
    return html;
}

std::string how_long_html(const Counts& counts) {
    std::vector<Bar> minutes;
    for (int i = 0; i <= kLongest_min; ++i)
        minutes.push_back({i == kLongest_min ? fmt::format("{}+", i) : std::to_string(i), 0,
                           static_cast<double>(counts.lengths[static_cast<std::size_t>(i)]),
                           fmt::format("{} min{}: {} visits", i, i == kLongest_min ? " and longer" : "",
                                       counts.lengths[static_cast<std::size_t>(i)])});
    for (Bar& bar : minutes) std::swap(bar.solid, bar.pale);
    std::vector<Bar> rounds;
    int most = 6;
    for (int i = 0; i <= kMostRounds; ++i)
        if (counts.rounds[static_cast<std::size_t>(i)] > 0) most = std::max(most, i);
    for (int i = 0; i <= most; ++i)
        rounds.push_back({i == kMostRounds ? fmt::format("{}+", i) : std::to_string(i),
                          static_cast<double>(counts.rounds[static_cast<std::size_t>(i)]), 0,
                          fmt::format("{} rounds: {} visits", i, counts.rounds[static_cast<std::size_t>(i)])});
    std::string html = "<h2>How long they stayed</h2>\n";
    html += figure(bars_svg(minutes, "Visits by their length in minutes."), "Visits by their length in whole minutes");
    html += figure(bars_svg(rounds, "Visits by rounds answered."),
                   "Visits by the rounds of which all three questions were answered");
    return html;
}

std::string row(std::initializer_list<std::string> cells) {
    std::string html = "<tr>";
    bool is_first = true;
    for (const std::string& cell : cells) {
        html += is_first ? "<th>" + cell + "</th>" : "<td class=\"n\">" + cell + "</td>";
        is_first = false;
    }
    return html + "</tr>\n";
}

std::string where_left_html(const Counts& counts) {
    const DayCount& all = counts.all;
    std::string html =
        "<h2>Where they left</h2>\n<p>Before which answer a visitor went away: nobody answered “Still there?”, "
        "or the next four never came.</p>\n<div class=\"wide\"><table><thead><tr><th>round</th>"
        "<th class=\"n\">before the trees</th><th class=\"n\">before the land</th><th class=\"n\">before "
        "the sky</th><th class=\"n\">of all visits</th></tr></thead><tbody>\n";
    for (std::size_t round = 0; round < counts.given_up.size(); ++round) {
        const auto& given_up = counts.given_up[round];
        const int sum = given_up[0] + given_up[1] + given_up[2];
        if (sum == 0) continue;
        html += row({std::to_string(round + 1), number(given_up[0]), number(given_up[1]), number(given_up[2]),
                     percent(share_of(sum, all.visits))});
    }
    html += "</tbody></table></div>\n";
    html += fmt::format(
        "<p>{} visits were left, in {} the next four never came, and of {} no end was written: the power "
        "went, or they go on.</p>\n",
        number(all.left), number(all.stuck), number(all.cut));
    return html;
}

// Nothing where no visit was bred by chance.
std::string control_html(const Counts& counts) {
    if (counts.by_chance.visits == 0) return "";
    constexpr double kOf95 = 1.96;  // standard errors, each way
    std::string html =
        "<h2>What breeding adds</h2>\n<p>Some visits were bred by chance alone, and nobody was told. Of visits whose "
        "rounds are kept, with intervals of 95 %:</p>\n<div class=\"wide\"><table><thead><tr><th></th><th "
        "class=\"n\">visits</th><th class=\"n\">to the end</th><th class=\"n\">rounds</th><th "
        "class=\"n\">length</th></tr></thead><tbody>\n";
    for (const auto& [name, arm] : {std::pair{"bred", &counts.bred}, {"by chance", &counts.by_chance}}) {
        const Share finished = share_of(arm->finished, arm->visits);
        html += row(
            {name, number(arm->visits),
             fmt::format("{:.0f} % ({:.0f} to {:.0f})", 100 * finished.value, 100 * finished.low, 100 * finished.high),
             fmt::format("{:.1f} ± {:.1f}", arm->rounds, kOf95 * arm->rounds_error),
             fmt::format("{:.0f} ± {:.0f} s", arm->length_s, kOf95 * arm->length_error_s)});
    }
    return html + "</tbody></table></div>\n";
}

std::string answers_html(const Counts& counts) {
    std::string html =
        "<h2>What they answered</h2>\n<p>How often each letter was pressed. Where visitors look at the "
        "pictures, letters are alike; one that is far ahead hints at a button that sticks, or that is "
        "nearest to the entrance.</p>\n<div class=\"wide\"><table><thead><tr><th>best</th><th "
        "class=\"n\">A</th><th class=\"n\">B</th><th class=\"n\">C</th><th class=\"n\">D</th><th "
        "class=\"n\">median time for it</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < genome::kAspects.size(); ++i) {
        const auto& letters = counts.letters[i];
        const int all = letters[0] + letters[1] + letters[2] + letters[3];
        const auto median = median_of(counts.answer_s[i].data(), static_cast<int>(counts.answer_s[i].size()));
        html += row({std::string(name_of(genome::kAspects[i])), percent(share_of(letters[0], all)),
                     percent(share_of(letters[1], all)), percent(share_of(letters[2], all)),
                     percent(share_of(letters[3], all)),
                     median ? (*median >= kSlowestAnswer_s ? "a minute or more" : fmt::format("{} s", *median)) : "–"});
    }
    return html + "</tbody></table></div>\n";
}

std::string words_html(const Counts& counts) {
    if (counts.words.empty() || counts.days.empty()) return "";
    std::string html =
        "<h2>What they called the landscapes</h2>\n<p>Answers to questions such as “how warm is this?”, "
        "week by week: the middle line is neither, the upper one is the word itself. Bars are standard "
        "errors. A line that climbs is a taste, or a season, that drifts.</p>\n";
    Date first = counts.words.front().weeks.front().monday;
    Date last = first;
    for (const WordCount& word : counts.words) {
        first = std::min(first, word.weeks.front().monday);
        last = std::max(last, word.weeks.back().monday);
    }
    int shown = 0;
    for (const WordCount& word : counts.words) {
        if (word.answers < kAnswersShown || shown == kWordsShown) break;
        ++shown;
        const std::string says =
            fmt::format("{}: {:+.2f} in the mean of {} answers", base::escaped(word.word), word.mean, word.answers);
        html += figure(weeks_svg(word.weeks, first, last, says), says);
    }
    html +=
        "<details><summary>All words</summary><table><thead><tr><th>word</th><th class=\"n\">answers</th><th "
        "class=\"n\">mean</th></tr></thead><tbody>\n";
    for (const WordCount& word : counts.words)
        html += row({base::escaped(word.word), number(word.answers), fmt::format("{:+.2f}", word.mean)});
    return html + "</tbody></table></details>\n";
}

// An exhibit that is switched on in the morning starts once a day.
std::string starts_html(const Counts& counts) {
    std::vector<const DayCount*> often;
    for (const DayCount& day : counts.days)
        if (day.starts > 2) often.push_back(&day);
    std::string html = fmt::format("<h2>The exhibit</h2>\n<p>It was started {}. ", counted(counts.all.starts, "time"));
    if (often.empty()) return html + "No day saw more than two starts.</p>\n";
    std::ranges::stable_sort(often, std::greater<>{}, &DayCount::starts);
    html += fmt::format("On {} days it was started more than twice; those days are worth a look at its log:</p>\n<p>",
                        number(static_cast<std::int64_t>(often.size())));
    for (std::size_t i = 0; i < std::min<std::size_t>(often.size(), 12); ++i)
        html += fmt::format("{}{} ({})", i == 0 ? "" : ", ", text_of(often[i]->date), often[i]->starts);
    return html + (often.size() > 12 ? ", …" : "") + "</p>\n";
}

std::string days_html(const Counts& counts) {
    std::string unit;
    const std::vector<Period> periods = periods_of(counts, unit);
    std::string html = fmt::format(
        "<details><summary>All numbers, by {}</summary><table><thead><tr><th>{}</th><th "
        "class=\"n\">visits</th><th class=\"n\">to the end</th><th class=\"n\">left</th><th "
        "class=\"n\">stuck</th><th class=\"n\">no end</th><th class=\"n\">starts</th></tr></thead>"
        "<tbody>\n",
        unit, unit);
    for (const Period& period : periods)
        html += row({period.name, number(period.sum.visits), number(period.sum.finished), number(period.sum.left),
                     number(period.sum.stuck), number(period.sum.cut), number(period.sum.starts)});
    return html + "</tbody></table></details>\n";
}

std::string body_of(const Counts& counts) {
    if (counts.days.empty()) return "<p>There were no visits in these days.</p>\n";
    return cards_of(counts) + when_html(counts) + how_long_html(counts) + where_left_html(counts) +
           control_html(counts) + answers_html(counts) + words_html(counts) + starts_html(counts) + days_html(counts);
}

}  // namespace

std::string html_of(const Counts& counts, const Heading& heading) {
    const std::string title = base::escaped(heading.title);
    const std::string span = counts.days.empty()
                                 ? "no visits"
                                 : text_of(counts.days.front().date) + " to " + text_of(counts.days.back().date);
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<title>{0}, "
        "{1}</title>\n<style>{2}</style>\n</head>\n<body>\n"
        "<main>\n{6}<h1>{0}</h1>\n<p>{1}. Counted {3} by quadrat {4}. Nothing here tells who a visitor "
        "was.</p>\n{5}</main>\n"
        "</body>\n</html>\n",
        title, span, kPageStyle, base::escaped(heading.made_at), base::escaped(heading.version), body_of(counts),
        heading.back.empty() ? "" : "<p><a href=\"/\">" + base::escaped(heading.back) + "</a></p>\n");
}

}  // namespace quadrat::report
