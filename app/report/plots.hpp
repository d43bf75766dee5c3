// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>
#include <vector>

#include "report/counts.hpp"

// Plots as inline SVG, in the colours of the page around them (page_style.hpp). Each tells a screen reader in a
// sentence what it shows.
namespace quadrat::report {

struct Bar {
    std::string label;  // below it; where there are many, only some are written
    double solid = 0;   // from the ground
    double pale = 0;    // above that
    std::string hint;   // where a pointer rests on it
};
std::string bars_svg(const std::vector<Bar>& bars, const std::string& says);

// Weekdays down, hours across; the busiest is solid.
std::string hours_svg(const std::array<std::array<int, 24>, 7>& by_hour, const std::string& says);

// Means from -1 to 1 with their standard errors, a dot a week; in time, not in order.
std::string weeks_svg(const std::vector<WordWeek>& weeks, Date first, Date last, const std::string& says);

inline constexpr std::array kWeekdays{"Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"};

}  // namespace quadrat::report
