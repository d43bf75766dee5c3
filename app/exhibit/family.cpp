// SPDX-License-Identifier: Apache-2.0
#include "exhibit/family.hpp"

#include <algorithm>

namespace quadrat::exhibit {
namespace {

const Ancestor& at(const std::vector<Ancestor>& family, int node) { return family.at(static_cast<std::size_t>(node)); }

bool descends_from(const std::vector<Ancestor>& family, int node, int from) {
    while (node > from) node = at(family, node).parent;
    return node == from;
}

// Rows are given depth first, so that a branch lies below all of the one before it.
void place(const std::vector<Ancestor>& family, int node, FamilyPlace where, int& rows,
           std::vector<FamilyPlace>& places) {
    places[static_cast<std::size_t>(node)] = where;
    bool is_first = true;
    for (int child = node + 1; child < static_cast<int>(family.size()); ++child) {
        if (at(family, child).parent != node) continue;
        const int row = is_first ? where.row : rows++;
        is_first = false;
        place(family, child, {where.column + 1, row}, rows, places);
    }
}

}  // namespace

int depth_of(const std::vector<Ancestor>& family, int node) {
    int depth = 0;
    for (; at(family, node).parent >= 0; node = at(family, node).parent) ++depth;
    return depth;
}

std::vector<genome::Pick> picks_to(const std::vector<Ancestor>& family, int node) {
    std::vector<genome::Pick> picks;
    for (; at(family, node).parent >= 0; node = at(family, node).parent) picks.push_back(at(family, node).pick);
    std::ranges::reverse(picks);
    return picks;
}

int next_beside(const std::vector<Ancestor>& family, int node) {
    const int depth = depth_of(family, node);
    const int count = static_cast<int>(family.size());
    for (int i = 1; i < count; ++i)
        if (const int other = (node + i) % count; depth_of(family, other) == depth) return other;
    return node;
}

std::optional<int> step_to(const std::vector<Ancestor>& family, int node, Choice button, int home) {
    std::optional<int> to;
    if (button == Choice::A && at(family, node).parent >= 0) to = at(family, node).parent;
    if (button == Choice::C && next_beside(family, node) != node) to = next_beside(family, node);
    if (button != Choice::B) return to;
    for (int child = node + 1; child < static_cast<int>(family.size()); ++child) {
        if (at(family, child).parent != node) continue;
        to = child;
        if (descends_from(family, home, child)) break;
    }
    return to;
}

std::vector<FamilyPlace> places_of(const std::vector<Ancestor>& family) {
    std::vector<FamilyPlace> places(family.size());
    int rows = 1;
    if (!family.empty()) place(family, 0, {0, 0}, rows, places);
    return places;
}

}  // namespace quadrat::exhibit
