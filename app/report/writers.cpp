// SPDX-License-Identifier: Apache-2.0
#include "report/writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "genome/aspect.hpp"
#include "report/plots.hpp"

namespace quadrat::report {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const DayCount& day, bool has_date) {
    Json json;
    if (has_date) json["date"] = text_of(day.date);
    json["visits"] = day.visits;
    json["finished"] = day.finished;
    json["left"] = day.left;
    json["stuck"] = day.stuck;
    json["cut"] = day.cut;
    json["rounds"] = day.rounds;
    json["picks"] = day.picks;
    json["starts"] = day.starts;
    return json;
}

Json json_of(const Share& share) { return Json{{"value", share.value}, {"low", share.low}, {"high", share.high}}; }

Json words_json(const std::vector<WordCount>& words) {
    Json json = Json::array();
    for (const WordCount& word : words) {
        Json weeks = Json::array();
        for (const WordWeek& week : word.weeks)
            weeks.push_back({{"monday", text_of(week.monday)},
                             {"answers", week.answers},
                             {"mean", week.mean},
                             {"error", week.error}});
        json.push_back({{"word", word.word}, {"answers", word.answers}, {"mean", word.mean}, {"weeks", weeks}});
    }
    return json;
}

Json aspects_json(const Counts& counts) {
    Json json;
    for (std::size_t i = 0; i < genome::kAspects.size(); ++i) {
        const auto median = median_of(counts.answer_s[i].data(), static_cast<int>(counts.answer_s[i].size()));
        Json& aspect = json[std::string(name_of(genome::kAspects[i]))];
        aspect["letters"] = counts.letters[i];
        aspect["median_answer_s"] = median ? Json(*median) : Json();
    }
    return json;
}

Json json_of(const Arm& arm) {
    return {{"visits", arm.visits},     {"finished", json_of(share_of(arm.finished, arm.visits))},
            {"rounds", arm.rounds},     {"rounds_error", arm.rounds_error},
            {"length_s", arm.length_s}, {"length_error_s", arm.length_error_s}};
}

}  // namespace

std::string csv_of(const Counts& counts) {
    std::string csv = "date,visits,finished,left,stuck,cut,rounds,picks,starts\r\n";
    for (const DayCount& day : counts.days)
        csv += fmt::format("{},{},{},{},{},{},{},{},{}\r\n", text_of(day.date), day.visits, day.finished, day.left,
                           day.stuck, day.cut, day.rounds, day.picks, day.starts);
    return csv;
}

std::string json_of(const Counts& counts, const Heading& heading) {
    Json json;
    json["quadrat"] = "report";
    json["version"] = 1;
    json["title"] = heading.title;
    json["made_at"] = heading.made_at;
    json["program"] = heading.version;
    json["all"] = json_of(counts.all, false);
    json["finished"] = json_of(share_of(counts.all.finished, counts.all.visits));
    json["median_length_s"] = counts.median_length_s ? Json(*counts.median_length_s) : Json();
    json["lengths_min"] = counts.lengths;
    json["rounds"] = counts.rounds;
    json["given_up"] = counts.given_up;
    json["by_hour"] = counts.by_hour;
    json["answers"] = aspects_json(counts);
    if (counts.by_chance.visits > 0)
        json["control"] = {{"bred", json_of(counts.bred)}, {"chance", json_of(counts.by_chance)}};
    json["words"] = words_json(counts.words);
    json["days"] = Json::array();
    for (const DayCount& day : counts.days) json["days"].push_back(json_of(day, true));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string text_of(const Counts& counts) {
    if (counts.days.empty()) return "there were no visits in these days\n";
    const DayCount& all = counts.all;
    const Share finished = share_of(all.finished, all.visits);
    std::string text = fmt::format("{} to {}\n", text_of(counts.days.front().date), text_of(counts.days.back().date));
    text += fmt::format("visits           {}\n", all.visits);
    text += fmt::format("to the end       {} ({:.0f} %, {:.0f} to {:.0f})\n", all.finished, 100 * finished.value,
                        100 * finished.low, 100 * finished.high);
    text += fmt::format("left, stuck, cut {}, {}, {}\n", all.left, all.stuck, all.cut);
    if (counts.median_length_s) text += fmt::format("median length    {}\n", duration_text(*counts.median_length_s));
    text += fmt::format("rounds, answers  {}, {}\n", all.rounds, all.picks);
    if (counts.by_chance.visits > 0)
        text += fmt::format("by chance alone  {} visits, {:.1f} rounds; bred {:.1f}\n", counts.by_chance.visits,
                            counts.by_chance.rounds, counts.bred.rounds);
    text += fmt::format("starts           {}\n", all.starts);
    std::array<int, 24> hours{};
    for (const auto& day : counts.by_hour)
        for (std::size_t hour = 0; hour < day.size(); ++hour) hours[hour] += day[hour];
    const auto busiest = std::ranges::max_element(hours) - hours.begin();
    if (all.visits > 0) text += fmt::format("busiest hour     {:02}:00 to {:02}:00\n", busiest, busiest + 1);
    return text;
}

}  // namespace quadrat::report
