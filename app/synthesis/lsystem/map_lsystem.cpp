// SPDX-License-Identifier: Apache-2.0
// Edge-controlled binary propagating map systems with markers (Lindenmayer & Rozenberg 1979; Nakamura, Lindenmayer &
// Aizawa 1986), as in "The Algorithmic Beauty of Plants", 1990, chapter 7. Our walls stay straight, and chance may move
// where one divides.
#include "synthesis/lsystem/map_lsystem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/error.hpp"

namespace quadrat::synthesis::lsystem {
namespace {

constexpr std::size_t kWallsACell = 12;  // at most: walls that only cut themselves up make no cells

float cross(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

// What a cell must have: of less, rounding would decide on which side of a wall it lies.
float least_area(const Map& map) {
    constexpr float kOfSquare = 1.0e-6F;
    glm::vec2 low = map.corners.front();
    glm::vec2 high = low;
    for (const glm::vec2 corner : map.corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    return kOfSquare * glm::dot(high - low, high - low);
}

// A wall of the step before: its corners and pieces in the order it runs, and what sprouts at each corner.
struct Sprout {
    MapProduction::Part part;
};
struct Rewritten {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> walls;          // one fewer
    std::vector<bool> is_turned;               // of each piece, against how its wall ran
    std::vector<std::vector<Sprout>> sprouts;  // of each corner
};

bool do_match(const MapProduction::Part& a, const MapProduction::Part& b) {
    if (a.letter != b.letter) return false;
    if (a.course == Course::Plain || b.course == Course::Plain) return a.course == b.course;
    return a.course != b.course;
}

class Step {
  public:
    Step(const MapGrammar& grammar, const Map& before, const MapOptions& options, base::Seed seed)
        : grammar_(grammar), before_(before), options_(options), seed_(seed), least_area_(least_area(before)) {
        map_.corners = before.corners;
    }

    Map take() {
        is_divided_.resize(before_.cells.size());
        for (std::size_t i = 0; i < is_divided_.size(); ++i)
            is_divided_[i] = options_.most_area <= 0 || before_.area(i) > options_.most_area;
        // A wall between two cells that stay as they are has nothing to become.
        is_rewritten_.resize(before_.walls.size());
        for (std::size_t i = 0; i < before_.cells.size(); ++i)
            for (const Map::Side& side : before_.cells[i])
                is_rewritten_[side.wall] = is_rewritten_[side.wall] || is_divided_[i];
        for (std::size_t i = 0; i < before_.walls.size(); ++i) rewrite(i);
        for (std::size_t i = 0; i < before_.cells.size(); ++i) divide(i);
        return std::move(map_);
    }

  private:
    const MapProduction* production_of(char letter) const {
        const auto found = std::ranges::find(grammar_.productions, letter, &MapProduction::predecessor);
        return found == grammar_.productions.end() ? nullptr : &*found;
    }
    std::uint32_t add_wall(char letter, std::uint32_t from, std::uint32_t to) {
        if (map_.walls.size() >= kWallsACell * options_.most_cells)
            throw base::InputError(fmt::format("{}: more than {} walls; ask for fewer steps", grammar_.source,
                                               kWallsACell * options_.most_cells));
        map_.walls.push_back({letter, from, to});
        return static_cast<std::uint32_t>(map_.walls.size()) - 1;
    }

    void rewrite(std::size_t i) {
        const Map::Wall& wall = before_.walls[i];
        Rewritten out;
        const MapProduction* production = is_rewritten_[i] ? production_of(wall.letter) : nullptr;
        const std::vector<MapProduction::Part> same{{wall.letter, Course::Along, 0}};
        const auto& parts = production != nullptr ? production->successor : same;
        const auto pieces = std::ranges::count(parts, 0, &MapProduction::Part::side);
        const glm::vec2 from = before_.corners[wall.from];
        const glm::vec2 run = before_.corners[wall.to] - from;
        out.corners.push_back(wall.from);
        out.sprouts.emplace_back();
        long at = 0;
        for (const MapProduction::Part& part : parts) {
            if (part.side != 0) {
                out.sprouts.back().push_back({part});
                continue;
            }
            std::uint32_t corner = wall.to;
            if (++at < pieces) {
                const float aside =
                    options_.chance * (base::unit_of(base::hash_of(seed_, static_cast<int>(i), at)) - 0.5F);
                map_.corners.push_back(from + (static_cast<float>(at) + aside) / static_cast<float>(pieces) * run);
                corner = static_cast<std::uint32_t>(map_.corners.size()) - 1;
            }
            const bool is_turned = part.course == Course::Against;
            const std::uint32_t begin = out.corners.back();
            out.walls.push_back(is_turned ? add_wall(part.letter, corner, begin)
                                          : add_wall(part.letter, begin, corner));
            out.is_turned.push_back(is_turned);
            out.corners.push_back(corner);
            out.sprouts.emplace_back();
        }
        rewritten_.push_back(std::move(out));
    }

    // Going round a cell: the walls as they are now, and the sprouts into it before each.
    struct Round {
        std::vector<Map::Side> sides;
        std::vector<std::uint32_t> corners;  // where each side begins
        struct At {
            std::size_t side;  // before which one
            MapProduction::Part part;
        };
        std::vector<At> sprouts;
    };
    Round round_of(std::size_t cell) const {
        Round round;
        for (const Map::Side& side : before_.cells[cell]) {
            const Rewritten& wall = rewritten_[side.wall];
            const std::size_t count = wall.walls.size();
            const int inward = side.is_along ? 1 : -1;  // counter-clockwise, the cell lies on the left
            for (std::size_t k = 0; k <= count; ++k) {
                const std::size_t corner = side.is_along ? k : count - k;
                for (const Sprout& sprout : wall.sprouts[corner])
                    if (sprout.part.side == inward) round.sprouts.push_back({round.sides.size(), sprout.part});
                if (k == count) break;
                const std::size_t piece = side.is_along ? k : count - 1 - k;
                round.sides.push_back({wall.walls[piece], side.is_along != wall.is_turned[piece]});
                round.corners.push_back(wall.corners[corner]);
            }
        }
        return round;
    }

    void divide(std::size_t cell) {
        const Round round = round_of(cell);
        const std::size_t n = round.sides.size();
        if (is_divided_[cell]) {
            for (std::size_t a = 0; a < round.sprouts.size(); ++a) {
                for (std::size_t b = a + 1; b < round.sprouts.size(); ++b) {
                    const std::size_t i = round.sprouts[a].side % n;
                    const std::size_t k = round.sprouts[b].side % n;
                    if (!do_match(round.sprouts[a].part, round.sprouts[b].part)) continue;
                    if (round.corners[i] == round.corners[k] || !has_room(round, i, k)) continue;
                    const bool leads_back = round.sprouts[a].part.course == Course::Against;
                    const std::uint32_t from = round.corners[leads_back ? k : i];
                    const std::uint32_t to = round.corners[leads_back ? i : k];
                    const std::uint32_t wall = add_wall(round.sprouts[a].part.letter, from, to);
                    // From i on to k, and back over the new wall; and the rest.
                    map_.cells.push_back(sides_between(round, i, k));
                    map_.cells.back().push_back({wall, round.corners[k] == from});
                    map_.cells.push_back(sides_between(round, k, i));
                    map_.cells.back().push_back({wall, round.corners[i] == from});
                    if (map_.cells.size() > options_.most_cells)
                        throw base::InputError(fmt::format("{}: more than {} cells; ask for fewer steps",
                                                           grammar_.source, options_.most_cells));
                    return;
                }
            }
        }
        map_.cells.push_back(round.sides);
    }

    static std::vector<Map::Side> sides_between(const Round& round, std::size_t from, std::size_t to) {
        std::vector<Map::Side> sides;
        for (std::size_t i = from; i != to; i = (i + 1) % round.sides.size()) sides.push_back(round.sides[i]);
        return sides;
    }
    // Whether a wall between the two would leave a cell on either side of it, and go through none that is there.
    bool has_room(const Round& round, std::size_t i, std::size_t k) const {
        const auto at = [&](std::size_t side) { return map_.corners[round.corners[side % round.corners.size()]]; };
        const glm::vec2 run = at(k) - at(i);
        for (const auto& [from, to] : {std::pair{i, k}, std::pair{k, i}}) {
            float twice_area = cross(at(to) - at(i), at(from) - at(i));
            for (std::size_t side = from; side != to; side = (side + 1) % round.sides.size())
                twice_area += cross(at(side) - at(i), at(side + 1) - at(i));
            if (twice_area < std::max(1.0e-4F * glm::dot(run, run), 2 * least_area_)) return false;
        }
        for (std::size_t side = 0; side < round.sides.size(); ++side) {
            const glm::vec2 along = at(side + 1) - at(side);
            const bool is_split = cross(run, at(side) - at(i)) * cross(run, at(side + 1) - at(i)) < 0;
            if (is_split && cross(along, at(i) - at(side)) * cross(along, at(k) - at(side)) < 0) return false;
        }
        return true;
    }

    const MapGrammar& grammar_;
    const Map& before_;
    const MapOptions& options_;
    base::Seed seed_;
    float least_area_;
    Map map_;
    std::vector<Rewritten> rewritten_;
    std::vector<bool> is_divided_;    // of a cell before
    std::vector<bool> is_rewritten_;  // of a wall before
};

// Corners within draw toward the middle of those they hang on, where no cell is turned over by it.
void pull_walls(Map& map, int rounds) {
    std::vector<std::vector<std::uint32_t>> beside(map.corners.size());
    std::vector<int> cells_at(map.walls.size(), 0);
    std::vector<std::vector<std::size_t>> cells_of(map.corners.size());
    std::vector<bool> is_rim(map.corners.size(), false);
    for (std::size_t c = 0; c < map.cells.size(); ++c)
        for (const Map::Side& side : map.cells[c]) {
            ++cells_at[side.wall];
            cells_of[map.walls[side.wall].from].push_back(c);
            cells_of[map.walls[side.wall].to].push_back(c);
        }
    for (std::size_t i = 0; i < map.walls.size(); ++i) {
        const Map::Wall& wall = map.walls[i];
        if (cells_at[i] == 0) continue;
        beside[wall.from].push_back(wall.to);
        beside[wall.to].push_back(wall.from);
        if (cells_at[i] == 1) is_rim[wall.from] = is_rim[wall.to] = true;
    }
    const float least = least_area(map);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < map.corners.size(); ++i) {
            if (is_rim[i] || beside[i].empty()) continue;
            const glm::vec2 old = map.corners[i];
            glm::vec2 sum{0};
            for (const std::uint32_t other : beside[i]) sum += map.corners[other];
            map.corners[i] = glm::mix(old, sum / static_cast<float>(beside[i].size()), 0.5F);
            if (std::ranges::any_of(cells_of[i], [&](std::size_t cell) { return map.area(cell) < least; }))
                map.corners[i] = old;
        }
}

}  // namespace

std::vector<glm::vec2> Map::outline(std::size_t cell) const {
    std::vector<glm::vec2> out;
    for (const Side& side : cells[cell])
        out.push_back(corners[side.is_along ? walls[side.wall].from : walls[side.wall].to]);
    return out;
}

float Map::area(std::size_t cell) const {
    const std::vector<glm::vec2> ring = outline(cell);
    float twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return 0.5F * twice;
}

std::vector<glm::vec2> regular_outline(std::size_t sides) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const auto count = static_cast<float>(sides);
    const float radius = 0.5F / std::cos(kPi / count);
    std::vector<glm::vec2> outline;
    for (std::size_t i = 0; i < sides; ++i) {
        const float turn = kPi * ((2 * static_cast<float>(i) - 1) / count - 0.5F);
        outline.push_back(0.5F + radius * glm::vec2{std::cos(turn), std::sin(turn)});
    }
    return outline;
}

Map derive_map(const MapGrammar& grammar, std::span<const glm::vec2> outline, const MapOptions& options,
               base::Seed seed) {
    if (outline.size() != grammar.start.size())
        throw base::InputError(fmt::format("{}: the first cell has {} walls, and {} corners were given", grammar.source,
                                           grammar.start.size(), outline.size()));
    Map map;
    map.corners.assign(outline.begin(), outline.end());
    map.cells.emplace_back();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto from = static_cast<std::uint32_t>(i);
        const auto to = static_cast<std::uint32_t>((i + 1) % outline.size());
        const bool is_along = grammar.start[i].course != Course::Against;
        map.walls.push_back({grammar.start[i].letter, is_along ? from : to, is_along ? to : from});
        map.cells.back().push_back({from, is_along});
    }
    const int steps = options.steps >= 0 ? options.steps : grammar.steps;
    for (int step = 0; step < steps; ++step) {
        map = Step(grammar, map, options, seed.child(static_cast<std::uint64_t>(step))).take();
        if (options.pull > 0) pull_walls(map, options.pull);
    }
    return map;
}

}  // namespace quadrat::synthesis::lsystem
