// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <optional>

#include "exhibit/visit.hpp"
#include "mesh/image.hpp"

namespace quadrat::stage {

// Small pictures of what a visit has seen, by the nodes of its family tree: the four of each, or, of one in whose place
// the Finale came, its landscape. Nothing here draws or reads them: it says which is due, and keeps it.
class Miniatures {
  public:
    static constexpr int kWidth = 640;

    struct Miniature {
        mesh::Image picture;
        bool is_of_four = true;
        int number = 0;  // of all that were ever kept: another number is another picture
    };

    struct Due {
        int node = 0;
        bool is_of_four = true;
    };
    // Once a frame. Whose picture is due now, of what is on show for so long; nothing mostly. Those of the visit before
    // go when it ends.
    std::optional<Due> due(const exhibit::State& state, exhibit::Instant shown_for);
    void keep(const Due& due, mesh::Image picture);
    const Miniature* find(int node) const;  // null: there is none (yet)

  private:
    std::map<int, Miniature> kept_;
    int number_ = 0;
};

}  // namespace quadrat::stage
