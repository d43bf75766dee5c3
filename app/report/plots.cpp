// SPDX-License-Identifier: Apache-2.0
#include "report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/markup.hpp"

namespace quadrat::report {
namespace {

constexpr double kWidth = 960;
constexpr double kLeft = 56;  // for the numbers of the axis

std::string opened(double height, const std::string& says) {
    return fmt::format(R"(<svg viewBox="0 0 {} {}" role="img" aria-label="{}">)", kWidth, height, base::escaped(says));
}

std::string text_at(double x, double y, std::string_view anchor, const std::string& text) {
    return fmt::format(R"(<text class="label" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                       base::escaped(text));
}

// 1, 2 or 5 times a power of ten: about four steps to the highest.
double step_of(double highest) {
    const double rough = std::max(highest, 1.0) / 4;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) return std::max(1.0, factor * power);
    return std::max(1.0, 10 * power);
}

double days_between(Date a, Date b) {
    return static_cast<double>((std::chrono::sys_days(b) - std::chrono::sys_days(a)).count());
}

}  // namespace

std::string bars_svg(const std::vector<Bar>& bars, const std::string& says) {
    constexpr double kHeight = 210;
    constexpr double kTop = 8;
    constexpr double kGround = 182;
    double highest = 0;
    for (const Bar& bar : bars) highest = std::max(highest, bar.solid + bar.pale);
    const double step = step_of(highest);
    const double top = step * std::max(1.0, std::ceil(highest / step));
    const auto y_of = [&](double value) { return kGround - value / top * (kGround - kTop); };
    std::string svg = opened(kHeight, says);
    for (double value = 0; value <= top + step / 2; value += step) {
        svg += fmt::format(R"(<path class="rule" d="M{} {:.1f}H{}"/>)", kLeft, y_of(value), kWidth);
        svg += text_at(kLeft - 8, y_of(value) + 4, "end", fmt::format("{:.0f}", value));
    }
    const double pitch = (kWidth - kLeft) / static_cast<double>(std::max<std::size_t>(bars.size(), 1));
    const double width = std::min(pitch * (pitch < 4 ? 1.0 : 0.78), 60.0);
    std::size_t longest = 1;
    for (const Bar& bar : bars) longest = std::max(longest, bar.label.size());
    const auto every =
        static_cast<std::size_t>(std::ceil((7.5 * static_cast<double>(longest) + 10) / std::max(pitch, 0.1)));
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const Bar& bar = bars[i];
        const double middle = kLeft + (static_cast<double>(i) + 0.5) * pitch;
        const double solid_y = y_of(bar.solid);
        const double pale_y = y_of(bar.solid + bar.pale);
        svg += fmt::format(
            R"(<g><title>{}</title><rect class="pale" x="{:.2f}" y="{:.1f}" width="{:.2f}" height="{:.1f}"/>)"
            R"(<rect class="solid" x="{:.2f}" y="{:.1f}" width="{:.2f}" height="{:.1f}"/></g>)",
            base::escaped(bar.hint), middle - width / 2, pale_y, width, solid_y - pale_y, middle - width / 2, solid_y,
            width, kGround - solid_y);
        if (i % std::max<std::size_t>(every, 1) == 0) svg += text_at(middle, kGround + 18, "middle", bar.label);
    }
    return svg + "</svg>";
}

std::string hours_svg(const std::array<std::array<int, 24>, 7>& by_hour, const std::string& says) {
    constexpr double kNames = 96;
    constexpr double kRow = 24;
    const double cell = (kWidth - kNames) / 24;
    int most = 1;
    for (const auto& day : by_hour) most = std::max(most, *std::ranges::max_element(day));
    std::string svg = opened(7 * kRow + 24, says);
    for (std::size_t day = 0; day < by_hour.size(); ++day) {
        const double y = static_cast<double>(day) * kRow;
        svg += text_at(kNames - 10, y + kRow / 2 + 4, "end", kWeekdays[day]);
        for (std::size_t hour = 0; hour < by_hour[day].size(); ++hour) {
            const int visits = by_hour[day][hour];
            // The eye tells light steps apart better where they grow as the root.
            const double share = std::sqrt(static_cast<double>(visits) / most);
            svg += fmt::format(R"(<rect class="{}" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{}" opacity="{:.2f}">)"
                               R"(<title>{}, {:02}:00: {} {}</title></rect>)",
                               visits == 0 ? "growing" : "solid", kNames + static_cast<double>(hour) * cell + 1, y + 1,
                               cell - 2, kRow - 2, visits == 0 ? 0.5 : 0.15 + 0.85 * share, kWeekdays[day], hour,
                               visits, visits == 1 ? "visit" : "visits");
        }
    }
    for (int hour = 0; hour < 24; hour += 3)
        svg += text_at(kNames + (hour + 0.5) * cell, 7 * kRow + 16, "middle", fmt::format("{:02}", hour));
    return svg + "</svg>";
}

std::string weeks_svg(const std::vector<WordWeek>& weeks, Date first, Date last, const std::string& says) {
    constexpr double kHeight = 74;
    constexpr double kMiddle = 37;
    constexpr double kHalf = 30;
    const double span = std::max(7.0, days_between(first, last) + 7);
    const auto x_of = [&](Date monday) { return 12 + (days_between(first, monday) + 3.5) / span * (kWidth - 24); };
    const auto y_of = [](double value) { return kMiddle - kHalf * std::clamp(value, -1.0, 1.0); };
    std::string svg = opened(kHeight, says);
    for (const double value : {-1.0, 0.0, 1.0})
        svg += fmt::format(R"(<path class="rule" d="M0 {:.1f}H{}"/>)", y_of(value), kWidth);
    std::string line;
    for (const WordWeek& week : weeks) {
        const double x = x_of(week.monday);
        line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, y_of(week.mean));
        svg += fmt::format(R"(<path class="band" d="M{:.1f} {:.1f}V{:.1f}"/>)", x, y_of(week.mean - week.error),
                           y_of(week.mean + week.error));
        svg += fmt::format(R"(<circle class="dot" cx="{:.1f}" cy="{:.1f}" r="4">)"
                           R"(<title>week of {}: {:+.2f} ± {:.2f}, {} {}</title></circle>)",
                           x, y_of(week.mean), text_of(week.monday), week.mean, week.error, week.answers,
                           week.answers == 1 ? "answer" : "answers");
    }
    return svg + fmt::format(R"(<path class="line" d="{}"/></svg>)", line);
}

}  // namespace quadrat::report
