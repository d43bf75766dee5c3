// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "report/counts.hpp"

// The counts as others read them.
namespace quadrat::report {

// What a report says of itself.
struct Heading {
    std::string title;      // "Visitors of the exhibit"
    std::string made_at;    // "2026-11-26 12:08 Europe/Berlin (CET, UTC+01:00)"
    std::string version;    // of the program
    std::string back = {};  // a link to "/", named so; "" for none
};

// A page that needs nothing besides itself, on a screen by day and by night and on paper.
std::string html_of(const Counts& counts, const Heading& heading);

// A row a day, each from the first with a visit to the last, as RFC 4180 has it; the first row names the columns.
std::string csv_of(const Counts& counts);

std::string json_of(const Counts& counts, const Heading& heading);

// A few lines for a terminal.
std::string text_of(const Counts& counts);

}  // namespace quadrat::report
