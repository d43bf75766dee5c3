// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "synthesis/lsystem/grammar_line.hpp"
#include "synthesis/lsystem/map_lsystem.hpp"

namespace quadrat::synthesis::lsystem {
namespace {

using text::Line;
constexpr int kMostSteps = 30;

bool is_wall(char c) { return c >= 'A' && c <= 'Z'; }

MapProduction::Part part_from(Line& line, int side) {
    if (!is_wall(line.peek())) line.fail(line.seen() + " where a wall should: a capital letter, as in A -> B[-A][+A]B");
    MapProduction::Part part{line.symbol(), Course::Plain, side};
    if (line.take(">"))
        part.course = Course::Along;
    else if (line.take("<"))
        part.course = Course::Against;
    return part;
}

// "B[-A>]C<": pieces and sprouts.
std::vector<MapProduction::Part> parts_from(Line& line) {
    std::vector<MapProduction::Part> parts;
    while (!line.is_over()) {
        if (!line.take("[")) {
            parts.push_back(part_from(line, 0));
            continue;
        }
        const bool is_left = line.take("+");
        if (!is_left && !line.take("-"))
            line.fail(line.seen() + " where a sprout's side should: + for left or - for right, as in [+A]");
        parts.push_back(part_from(line, is_left ? 1 : -1));
        line.expect("]");
    }
    return parts;
}

void read_start(MapGrammar& grammar, Line& line) {
    grammar.start = parts_from(line);
    const bool sprouts = std::ranges::any_of(grammar.start, [](const auto& part) { return part.side != 0; });
    if (grammar.start.size() < 3 || sprouts)
        line.fail("a cell has three walls or more and no sprouts, as in start: A B A B");
}

void read_steps(MapGrammar& grammar, Line& line) {
    const std::string digits = line.is_over() ? "" : line.name();
    grammar.steps = -1;
    if (!digits.empty() && digits.size() <= 2 && digits.find_first_not_of("0123456789") == std::string::npos)
        grammar.steps = std::stoi(digits);
    if (grammar.steps < 0 || grammar.steps > kMostSteps || !line.is_over())
        line.fail(fmt::format("steps: a whole number, 0 to {}", kMostSteps));
}

void read_production(MapGrammar& grammar, Line& line, int number) {
    const char predecessor = part_from(line, 0).letter;
    if (std::ranges::count(grammar.productions, predecessor, &MapProduction::predecessor) > 0)
        line.fail(fmt::format("there is a production of {} already", predecessor));
    line.expect("->");
    MapProduction production{predecessor, parts_from(line), number};
    if (std::ranges::count(production.successor, 0, &MapProduction::Part::side) == 0)
        line.fail("nothing is left of the wall; a letter outside of brackets is a piece of it");
    grammar.productions.push_back(std::move(production));
}

void read_line(MapGrammar& grammar, std::string_view words, int number) {
    Line line(words, number, grammar.source);
    if (words.find("->") != std::string_view::npos) return read_production(grammar, line, number);
    if (line.take("map:")) {
        grammar.name = words.substr(words.find(':') + 1);
        grammar.name.erase(0, grammar.name.find_first_not_of(" \t"));
        grammar.name.erase(grammar.name.find_last_not_of(" \t\r") + 1);
        return;
    }
    if (line.take("start:")) return read_start(grammar, line);
    if (line.take("steps:")) return read_steps(grammar, line);
    line.fail(line.seen() + " where map:, start:, steps: or a production with -> should");
}

// Lines that say something, without their comments; until each() returns false.
template <typename Each>
void each_line(std::string_view text, const Each& each) {
    int number = 0;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view words = text.substr(at, end - at);
        at = end + 1;
        ++number;
        words = words.substr(0, words.find('#'));
        if (words.find_first_not_of(" \t\r") != std::string_view::npos && !each(words, number)) return;
    }
}

// Figure 7.3 of the book; two that are ours.
constexpr std::array<NamedMap, 3> kMaps{{{"map-cross", R"(map: cells that divide crosswise, in turn
steps: 6
start: A B A B
A -> B[-A][+A]B
B -> A
)"},
                                         {"map-leaf", R"(map: areoles between the veins of a leaf
steps: 8
start: A B A B
A -> B[-C][+C]A
B -> A
C -> D[-B][+B]C
D -> C
)"},
                                         {"map-fields", R"(map: fields that were divided among heirs
steps: 7
start: A B A C
A -> B[-C>][+C<]A
B -> A[+B][-B]C
C -> C[-B][+B]A
)"}}};

}  // namespace

MapGrammar read_map_grammar(std::string_view text, const std::string& source) {
    MapGrammar grammar;
    grammar.source = source;
    int last = 1;
    each_line(text, [&](std::string_view words, int number) {
        last = number;
        read_line(grammar, words, number);
        return true;
    });
    if (grammar.start.empty())
        throw base::InputError(fmt::format("{}:{}:1: no start; write one, as start: A B A B", source, last));
    return grammar;
}

bool is_map_grammar(std::string_view text) {
    bool is_map = false;
    each_line(text, [&](std::string_view words, int) {
        is_map = words.substr(words.find_first_not_of(" \t")).starts_with("map:");
        return false;
    });
    return is_map;
}

std::span<const NamedMap> map_library() { return kMaps; }

MapGrammar library_map(std::string_view name) {
    const auto found = std::ranges::find(kMaps, name, &NamedMap::name);
    if (found == kMaps.end()) throw base::InputError(fmt::format("{}: no map of this name comes along", name));
    return read_map_grammar(found->text, std::string(name));
}

}  // namespace quadrat::synthesis::lsystem
