// SPDX-License-Identifier: Apache-2.0
#include "benches/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "base/markup.hpp"
#include "benches/markup.hpp"

namespace quadrat::benches {
namespace {

Rival rival_of(const std::string& text) {
    static const std::regex named(R"(\D+ (\d+(?:\.\d+)?)(?:-(\d+(?:\.\d+)?))?(?: .*)?)");
    std::smatch found;
    if (!std::regex_match(text, found, named)) return {text, std::nullopt};
    const double least = std::stod(found[1]);
    return {text, Rival::Figure{least, found[2].matched ? std::max(least, std::stod(found[2])) : least}};
}

std::string line_of(std::string_view bar, std::string_view text) {
    return fmt::format("<li>{}{}</li>", bar, base::escaped(text));
}

}  // namespace

std::vector<Rival> rivals_of(std::string_view others) {
    std::vector<Rival> rivals;
    while (!others.empty()) {
        const std::size_t end = std::min(others.find("; "), others.size());
        rivals.push_back(rival_of(std::string(others.substr(0, end))));
        others.remove_prefix(std::min(end + 2, others.size()));
    }
    return rivals;
}

std::string rivals_html(const machine::Measurement& measurement) {
    const std::vector<Rival> rivals = rivals_of(measurement.others);
    if (rivals.empty()) return {};
    double most = measurement.value;
    for (const Rival& rival : rivals) most = std::max(most, rival.figure ? rival.figure->most : 0);
    const auto share = [most](double value) { return most > 0 ? value / most : 0; };
    const bool is_compared = std::ranges::any_of(rivals, [](const Rival& r) { return r.figure.has_value(); });
    std::string html = R"(<ul class="rivals">)";
    if (is_compared)
        html += line_of(bar_of(share(measurement.value), 0), fmt::format("here {}", figure_text(measurement.value)));
    for (const Rival& rival : rivals)
        html += line_of(rival.figure ? bar_of(share(rival.figure->least), share(rival.figure->most)) : "", rival.text);
    return html + "</ul>";
}

std::string figure_text(double value) {
    constexpr double kAllDigits = 1e15;  // of a double's whole numbers
    if (value == std::floor(value) && std::abs(value) < kAllDigits) return fmt::format("{:.0f}", value);
    const double size = std::abs(value);
    return size >= 100 ? fmt::format("{:.1f}", value)
           : size >= 1 ? fmt::format("{:.2f}", value)
                       : fmt::format("{:.3g}", value);
}

}  // namespace quadrat::benches
