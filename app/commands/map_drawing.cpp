// SPDX-License-Identifier: Apache-2.0
#include "commands/map_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>

#include "base/markup.hpp"
#include "base/text_file.hpp"

namespace quadrat::commands {

using namespace synthesis::lsystem;

bool names_a_map(const std::string& name) {
    if (std::filesystem::exists(name)) return is_map_grammar(base::read_text(name));
    const auto library = map_library();
    return std::ranges::find(library, name, &NamedMap::name) != library.end();
}

MapGrammar map_grammar_from(const std::string& name) {
    if (std::filesystem::exists(name)) return read_map_grammar(base::read_text(name), name);
    return library_map(name);
}

Map derived_from_polygon(const MapGrammar& grammar, const MapOptions& options, base::Seed seed) {
    return derive_map(grammar, regular_outline(grammar.start.size()), options, seed);
}

std::string text_of_map(const Map& map) {
    std::string text;
    for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
        std::string line;
        for (const glm::vec2 corner : map.outline(cell))
            line += fmt::format("{}{:.6f},{:.6f}", line.empty() ? "" : " ", corner.x, corner.y);
        text += line + "\n";
    }
    return text;
}

std::string svg_of_map(const Map& map, const std::string& name) {
    constexpr float kSide = 1000;
    glm::vec2 low = map.corners.front();
    glm::vec2 high = low;
    for (const glm::vec2 corner : map.corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const float margin = 0.03F * kSide;
    const float scale = (kSide - 2 * margin) / std::max({high.x - low.x, high.y - low.y, 1.0e-6F});
    const auto point = [&](glm::vec2 at) {
        return fmt::format("{:.2f},{:.2f}", margin + scale * (at.x - low.x), margin + scale * (high.y - at.y));
    };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n<title>{}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#f6f3ea\"/>\n"
        "<g stroke=\"#4a3a2c\" stroke-width=\"{:.2f}\" stroke-linejoin=\"round\">\n",
        2 * margin + scale * (high.x - low.x), 2 * margin + scale * (high.y - low.y), base::escaped(name),
        std::clamp(60.0F / std::sqrt(static_cast<float>(map.cells.size())), 0.8F, 4.0F));
    constexpr std::array<const char*, 4> kTints{"#a9bf7c", "#c3cf92", "#8fac6a", "#d3d3a4"};
    for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
        svg += fmt::format("<polygon fill=\"{}\" points=\"",
                           kTints[base::hash_of(base::Seed{1}, static_cast<std::int64_t>(cell), 0) % kTints.size()]);
        for (const glm::vec2 corner : map.outline(cell)) svg += point(corner) + " ";
        svg.back() = '"';
        svg += "/>\n";
    }
    return svg + "</g>\n</svg>\n";
}

}  // namespace quadrat::commands
