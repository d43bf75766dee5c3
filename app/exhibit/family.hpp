// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "exhibit/visit.hpp"

// The family tree of a visit. Nodes are indices into State::family; a parent comes before its children.
namespace quadrat::exhibit {

int depth_of(const std::vector<Ancestor>& family, int node);  // 0: the first four
// The answers that led to it, from the first four on.
std::vector<genome::Pick> picks_to(const std::vector<Ancestor>& family, int node);

// The next of its depth, and the first again after the last; itself where there is no other.
int next_beside(const std::vector<Ancestor>& family, int node);

// Where a button leads in Family: A toward the first four, B away from them (toward the node `home`, else to the
// youngest), C to the next of the same depth. Nothing where it leads nowhere.
std::optional<int> step_to(const std::vector<Ancestor>& family, int node, Choice button, int home);

// Where a node is drawn: its depth, and in which row. A parent's first child is in its row; every other branch has a
// row of its own, so that no two nodes share a place and no line crosses another's node.
struct FamilyPlace {
    int column = 0;
    int row = 0;
    friend bool operator==(const FamilyPlace&, const FamilyPlace&) = default;
};
std::vector<FamilyPlace> places_of(const std::vector<Ancestor>& family);

}  // namespace quadrat::exhibit
