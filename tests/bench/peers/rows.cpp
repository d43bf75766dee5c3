// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/rows.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace quadrat::peers {
namespace {

std::optional<double> median_of(const std::vector<double>& samples) {
    return samples.empty() ? std::nullopt : std::optional(quantile(samples, 0.5));
}

template <typename Value>
nlohmann::ordered_json or_null(const std::optional<Value>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

std::string figure(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : "-"; }

std::string verdict(const Row& row, const std::optional<Ratio>& ratio) {
    if (!row.goal) return "";
    return fmt::format("at most {:.3g}{}", *row.goal, !ratio ? "" : ratio->median <= *row.goal ? ": met" : ": missed");
}

}  // namespace

double quantile(std::vector<double> samples, double share) {
    if (samples.empty()) return 0;
    std::ranges::sort(samples);
    const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, samples.size() - 1);
    return std::lerp(samples[below], samples[above], at - std::floor(at));
}

std::optional<Ratio> ratio_of(const Turns& turns) {
    if (turns.ours.empty() || turns.ours.size() != turns.yardstick.size()) return std::nullopt;
    std::vector<double> ratios;
    for (std::size_t turn = 0; turn < turns.ours.size(); ++turn) {
        if (!(turns.yardstick[turn] > 0)) return std::nullopt;
        ratios.push_back(turns.ours[turn] / turns.yardstick[turn]);
    }
    return Ratio{quantile(ratios, 0.5), quantile(ratios, 0.75) - quantile(ratios, 0.25)};
}

Turns in_turns(int count, const std::function<double()>& ours, const std::function<double()>& yardstick) {
    Turns turns;
    for (int turn = -1; turn < count; ++turn) {
        const double ours_took = ours();
        const double yardstick_took = yardstick ? yardstick() : 0;
        if (turn < 0) continue;
        turns.ours.push_back(ours_took);
        if (yardstick) turns.yardstick.push_back(yardstick_took);
    }
    return turns;
}

double own_ms(const std::function<void()>& work) {
    const auto now_ms = [] {
        timespec now{};
        ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
    };
    const double begun_ms = now_ms();
    work();
    return now_ms() - begun_ms;
}

std::string table_of(const std::string& machine, const std::vector<Row>& rows) {
    std::string out = machine + "\n\n";
    out += fmt::format("{:<16} {:>10} {:>10} {:<4} {:>8} {:>8}  {}\n", "", "ours", "yardstick", "", "ratio", "spread",
                       "goal");
    for (const Row& row : rows) {
        const std::optional<Ratio> ratio = ratio_of(row.turns);
        out += fmt::format("{:<16} {:>10} {:>10} {:<4} {:>8} {:>8}  {}\n", row.name, figure(median_of(row.turns.ours)),
                           figure(median_of(row.turns.yardstick)), row.unit,
                           ratio ? fmt::format("{:.3f}", ratio->median) : "-",
                           ratio ? fmt::format("{:.3f}", ratio->spread) : "-", verdict(row, ratio));
        for (const std::string& line : {row.against, row.note, row.why})
            if (!line.empty()) out += fmt::format("    {}\n", line);
    }
    return out;
}

std::string json_of(const std::string& machine, const std::vector<Row>& rows) {
    nlohmann::ordered_json json;
    json["machine"] = machine;
    json["results"] = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
        const std::optional<Ratio> ratio = ratio_of(row.turns);
        nlohmann::ordered_json result;
        result["name"] = row.name;
        result["ours"] = or_null(median_of(row.turns.ours));
        result["yardstick"] = or_null(median_of(row.turns.yardstick));
        result["ratio"] = ratio ? nlohmann::ordered_json(ratio->median) : nullptr;
        result["spread"] = ratio ? nlohmann::ordered_json(ratio->spread) : nullptr;
        result["goal"] = or_null(row.goal);
        result["unit"] = row.unit;
        result["against"] = row.against;
        result["turns"] = row.turns.ours.size();
        if (!row.note.empty()) result["note"] = row.note;
        if (!row.why.empty()) result["why"] = row.why;
        json["results"].push_back(std::move(result));
    }
    return json.dump();
}

}  // namespace quadrat::peers
