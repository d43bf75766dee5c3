// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/markup.hpp"
#include "benches/markup.hpp"
#include "benches/shader_table.hpp"

namespace quadrat::benches {
namespace {

using Chips = std::map<std::string, const CompiledShader*>;
using Stages = std::map<std::string, Chips>;
using Pairs = std::map<std::pair<std::string, std::string>, Stages>;

std::set<std::string> chips_of(const ShaderTable& table) {
    std::set<std::string> chips;
    for (const CompiledShader& shader : table.shaders) chips.insert(shader.chip);
    return chips;
}

Pairs pairs_of(const ShaderTable& table) {
    Pairs pairs;
    for (const CompiledShader& shader : table.shaders)
        pairs[{shader.vertex, shader.fragment}][shader.stage][shader.chip] = &shader;
    return pairs;
}

std::string head_of(const std::set<std::string>& chips) {
    std::string above = R"(<tr><th rowspan="2">pair</th><th rowspan="2">stage</th>)";
    std::string below = "<tr>";
    for (const std::string& chip : chips) {
        above += fmt::format(R"(<th class="chip" colspan="4">V3D {}</th>)", base::escaped(chip));
        below += R"(<th class="chip n">instructions</th><th class="n">threads</th>)"
                 R"(<th class="n">spills</th><th class="n">fills</th>)";
    }
    return "<thead>" + above + R"(<th class="n" rowspan="2">budget</th></tr>)" + below + "</tr></thead>\n";
}

std::string cell(int count, bool is_breach, bool is_first = false) {
    return fmt::format(R"(<td class="n{}{}">{}</td>)", is_first ? " chip" : "", is_breach ? " breach" : "", count);
}

std::string cells_of(const Chips& chips, const std::string& chip) {
    const auto found = chips.find(chip);
    if (found == chips.end()) return R"(<td class="n chip">?</td><td></td><td></td><td></td>)";
    const CompiledShader& shader = *found->second;
    return cell(shader.instructions, is_over_budget(shader), true) + cell(shader.threads, has_few_threads(shader)) +
           cell(shader.spills, shader.spills > 0) + cell(shader.fills, shader.fills > 0);
}

// With a bar: of the budget, what the chip that needs most of it does.
std::string budget_of(const Chips& chips) {
    const CompiledShader& dearest =
        *std::ranges::max_element(chips, {}, [](const auto& chip) { return chip.second->instructions; })->second;
    if (!dearest.budget) return "<td></td>";
    const double share = *dearest.budget > 0 ? static_cast<double>(dearest.instructions) / *dearest.budget : 1;
    return fmt::format(R"(<td class="n">{} {}</td>)", *dearest.budget, bar_of(share, 1));
}

std::string rows_of(const Pairs::value_type& pair, const std::set<std::string>& chips) {
    const auto& [names, stages] = pair;
    std::string html = "<tbody>";
    bool is_first = true;
    for (const char* stage : {"fragment", "vertex", "binning"}) {
        const auto found = stages.find(stage);
        if (found == stages.end()) continue;
        html += "<tr>";
        if (is_first)
            html += fmt::format(R"(<th rowspan="{}"><code>{}<br>{}</code></th>)", stages.size(),
                                base::escaped(names.first), base::escaped(names.second));
        is_first = false;
        html += fmt::format("<td>{}</td>", stage);
        for (const std::string& chip : chips) html += cells_of(found->second, chip);
        html += budget_of(found->second) + "</tr>\n";
    }
    return html + "</tbody>\n";
}

std::string verdict_on(const ShaderTable& table) {
    const auto breaches = std::ranges::count_if(table.shaders, [](const CompiledShader& shader) {
        return has_few_threads(shader) || is_over_budget(shader) || spills(shader);
    });
    if (breaches == 0) return "None spills, and each keeps to its budget.";
    return fmt::format(R"(<span class="breach">{} of {} do not keep to what is allowed.</span>)", breaches,
                       table.shaders.size());
}

}  // namespace

std::string section_of(const ShaderTable& table) {
    const std::set<std::string> chips = chips_of(table);
    std::string html = fmt::format(
        "<section id=\"shaders\">\n<h2>shaders</h2>\n<p>What {} makes of each pair that the program links, for the V3D "
        "4.2 of a Raspberry Pi 4 and the 7.1 of a 5. Budget: instructions that the fragment shader may have on either; "
        "fewer than 4 threads would not hide its fetches. {}</p>\n<div class=\"wide\"><table class=\"shaders\">\n",
        base::escaped(table.compiler), verdict_on(table));
    html += head_of(chips);
    for (const auto& pair : pairs_of(table)) html += rows_of(pair, chips);
    return html + "</table></div>\n</section>\n";
}

}  // namespace quadrat::benches
