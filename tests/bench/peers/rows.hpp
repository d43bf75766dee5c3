// SPDX-License-Identifier: Apache-2.0
// Ours beside yardsticks: what others need for the same, on the same machine, in turns. A ratio outlives a machine; a
// millisecond does not.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quadrat::peers {

// What both needed, a figure a turn in one unit; smaller is better.
struct Turns {
    std::vector<double> ours;
    std::vector<double> yardstick;  // as many; or none, where there is nothing to compare with
};

struct Row {
    std::string name;  // "chain"
    std::string unit;
    std::string against;         // what the yardstick is
    std::optional<double> goal;  // of the ratio, at most
    Turns turns{};
    std::string note{};  // what else decides; may be empty
    std::string why{};   // there is no yardstick; empty where there is
};

// The share-th quantile, 0 to 1, on the line between the two nearest; 0 for none.
double quantile(std::vector<double> samples, double share);

struct Ratio {
    double median = 0;
    double spread = 0;  // from the first to the third quartile
};
// Of what each turn needed: ours to the yardstick's. None where a yardstick is missing, or needed nothing.
std::optional<Ratio> ratio_of(const Turns& turns);

// So many turns, each first ours, then the yardstick's; one of each before them that does not count. An empty function
// is a yardstick that is missing.
Turns in_turns(int count, const std::function<double()>& ours, const std::function<double()>& yardstick);

// Processor time of the whole process for work on one thread: what other programs do is not in it.
double own_ms(const std::function<void()>& work);

std::string table_of(const std::string& machine, const std::vector<Row>& rows);
// {"machine": "...", "results": [{"name", "ours", "yardstick", "ratio", "spread", "goal", "unit", "against", "turns",
// "note", "why"}]}. ours and yardstick are medians. What is not known is null; note and why are left out if empty.
std::string json_of(const std::string& machine, const std::vector<Row>& rows);

}  // namespace quadrat::peers
