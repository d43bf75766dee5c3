// SPDX-License-Identifier: Apache-2.0
#include "benches/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/markup.hpp"
#include "benches/rivals.hpp"
#include "report/page_style.hpp"

namespace quadrat::benches {
namespace {

// The figures whose names begin alike.
struct Section {
    std::string prefix;  // "frame"
    std::vector<const machine::Measurement*> figures;
};

struct About {
    std::string_view prefix;
    std::string_view text;
};
constexpr About kAbout[] = {
    {"start", "From the beginning to what is first seen."},
    {"frame", "Four landscapes drawn to one frame; the passes of ground and sky beside the plainest ones others draw."},
    {"memory", "What the process took."},
    {"generation", "The next four landscapes, grown from nothing."},
    {"trees", "Wood, crowns and grammars, and where plants stand."},
    {"land", "Fractal fields, water and erosion."},
    {"sky", "Skies, and the light that stands still, baked."},
    {"breeding", "From an answer to the next offer, and how long the map of words takes to learn."},
    {"detail", "Chains of simpler meshes, the ground in squares, and what is seen of drawing less."},
    {"worth",
     "What a procedural system is judged by: the fastest, the most diverse, the easiest to come to a wish with. How "
     "believable its landscapes are, visitors are asked after a finale."},
    {"visit",
     "Somebody who answers about every two seconds. Late frames are counted after twenty seconds, or after half of a "
     "shorter visit."},
};

std::vector<Section> sections_of(const std::vector<machine::Measurement>& figures) {
    std::vector<Section> sections;
    for (const machine::Measurement& figure : figures) {
        const std::string prefix = figure.name.substr(0, figure.name.find('.'));
        auto section = std::ranges::find(sections, prefix, &Section::prefix);
        if (section == sections.end()) section = sections.insert(section, {prefix, {}});
        section->figures.push_back(&figure);
    }
    return sections;
}

std::string row_of(const machine::Measurement& figure) {
    return fmt::format(
        R"(<tr><th><code>{}</code></th><td class="n value">{}</td><td>{}</td><td class="n">{}</td><td>{}</td></tr>)",
        base::escaped(figure.name), figure_text(figure.value), base::escaped(figure.unit), figure.threads,
        rivals_html(figure));
}

// Columns are as wide in each, so that they stand below each other.
std::string table_of(const Section& section) {
    const bool has_rivals = std::ranges::any_of(section.figures, [](const auto* f) { return !f->others.empty(); });
    std::string html = fmt::format(
        "<div class=\"wide\"><table class=\"figures\">\n<colgroup><col><col><col><col><col></colgroup>\n<thead><tr>"
        R"(<th>figure</th><th class="n">value</th><th>unit</th><th class="n">threads</th><th>{}</th></tr></thead>)"
        "\n<tbody>\n",
        has_rivals ? "what others need" : "");
    for (const machine::Measurement* figure : section.figures) html += row_of(*figure) + "\n";
    return html + "</tbody></table></div>\n";
}

std::string section_of(const Section& section, const std::string& visit_svg) {
    std::string html = fmt::format("<section id=\"{0}\">\n<h2>{0}</h2>\n", base::escaped(section.prefix));
    const auto* about = std::ranges::find(kAbout, section.prefix, &About::prefix);
    if (about != std::end(kAbout)) html += fmt::format("<p>{}</p>\n", about->text);
    html += table_of(section);
    if (section.prefix == "visit" && !visit_svg.empty()) html += "<figure>\n" + visit_svg + "</figure>\n";
    return html + "</section>\n";
}

std::string settings_html(const std::vector<Setting>& settings) {
    std::string html;
    for (const Setting& setting : settings)
        html += fmt::format("<li><code>{}</code> ({})</li>", base::escaped(setting.option),
                            base::escaped(fmt::format("{}", fmt::join(setting.groups, ", "))));
    return html.empty() ? "none that these groups heed" : "<ul>" + html + "</ul>";
}

std::string told(std::string_view what, const std::string& html) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", what, html);
}

std::string header_of(const Report& report) {
    return "<h1>Quadrat, measured</h1>\n<dl>\n" + told("machine", base::escaped(report.machine)) +
           told("GPU", report.results.gpu.empty() ? "none: nothing was drawn" : base::escaped(report.results.gpu)) +
           told("program", "quadrat " + base::escaped(report.version)) +
           told("measured", base::escaped(report.made_at)) +
           told("groups", base::escaped(fmt::format("{}", fmt::join(report.groups, ", ")))) +
           told("settings", settings_html(report.settings)) + "</dl>\n";
}

}  // namespace

std::string html_of(const Report& report) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Quadrat, measured: {}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
        base::escaped(report.made_at), report::kPageStyle);
    html += header_of(report);
    for (const Section& section : sections_of(report.results.figures))
        html += section_of(section, report.results.visit_svg);
    if (report.peers) html += section_of(*report.peers);
    if (report.shaders) html += section_of(*report.shaders);
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace quadrat::benches
