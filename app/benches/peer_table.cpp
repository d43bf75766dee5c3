// SPDX-License-Identifier: Apache-2.0
#include "benches/peer_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/markup.hpp"
#include "benches/rivals.hpp"
#include "genome/json_text.hpp"

namespace quadrat::benches {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(std::string_view place, std::string_view key, const json& value, std::string_view right) {
    throw base::InputError(fmt::format("{}: {} is {}; it should be {}", place, key, genome::brief(value), right));
}

std::string text(const json& object, std::string_view key, const std::string& place) {
    const json& value = genome::member(object, key, place);
    if (!value.is_string()) refuse(place, key, value, "a text");
    return value.get<std::string>();
}

std::string text_if_any(const json& object, std::string_view key, const std::string& place) {
    return object.contains(key) ? text(object, key, place) : "";
}

std::optional<double> number_or_null(const json& object, std::string_view key, const std::string& place) {
    const json& value = genome::member(object, key, place);
    if (value.is_null()) return std::nullopt;
    if (!value.is_number() || value.get<double>() < 0) refuse(place, key, value, "a number from 0 on, or null");
    return value.get<double>();
}

PeerRatio ratio_from(const json& row, const std::string& place) {
    if (!row.is_object())
        throw base::InputError(fmt::format("{} is {}; it should be an object", place, genome::brief(row)));
    const std::string why = text_if_any(row, "why", place);
    return {text(row, "name", place),
            text(row, "against", place),
            number_or_null(row, "ratio", place),
            number_or_null(row, "spread", place),
            number_or_null(row, "goal", place),
            why.empty() ? text_if_any(row, "note", place) : why};
}

std::string cell(const std::optional<double>& value) {
    return fmt::format(R"(<td class="n">{}</td>)", value ? figure_text(*value) : "–");
}

std::string row_of(const PeerRatio& row) {
    const bool is_missed = row.ratio && row.goal && *row.ratio > *row.goal;
    return fmt::format("<tr><th><code>{}</code></th>{}{}{}<td>{}</td><td>{}</td></tr>\n", base::escaped(row.name),
                       cell(row.ratio), cell(row.spread), cell(row.goal), is_missed ? "missed" : "",
                       base::escaped(row.note.empty() ? row.against : row.against + "; " + row.note));
}

}  // namespace

PeerTable peer_table_from(std::string_view text_of_file, std::string_view source) {
    const json whole = genome::parse_json(text_of_file, source);
    const std::string place(source);
    if (!whole.is_object())
        throw base::InputError(
            fmt::format("{}: the table is {}; it should be an object", source, genome::brief(whole)));
    PeerTable table{text(whole, "machine", place), {}};
    const json& rows = genome::member(whole, "results", source);
    if (!rows.is_array()) refuse(place, "results", rows, "a list");
    for (std::size_t i = 0; i < rows.size(); ++i)
        table.rows.push_back(ratio_from(rows[i], fmt::format("{}: results[{}]", source, i)));
    return table;
}

std::string section_of(const PeerTable& table) {
    std::string html = fmt::format(
        "<section id=\"peers\">\n<h2>peers</h2>\n<p>What we need of what others need for the same, measured in turns "
        "on "
        "{}: the median of the turns, and how far apart their first and third quartiles are.</p>\n"
        "<div class=\"wide\"><table>\n<thead><tr><th>what</th><th class=\"n\">ratio</th>"
        "<th class=\"n\">spread</th><th class=\"n\">at most</th><th></th><th>beside</th></tr></thead>\n<tbody>\n",
        base::escaped(table.machine));
    for (const PeerRatio& row : table.rows) html += row_of(row);
    return html + "</tbody></table></div>\n</section>\n";
}

}  // namespace quadrat::benches
