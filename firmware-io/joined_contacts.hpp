// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "firmware-io/button_source.hpp"

namespace quadrat::firmware_io {

// Several streams of edges as one, in order of time. A button that is down on two of them is down once, until both let
// go. Each stream must alternate Down and Up.
class JoinedContacts {
  public:
    // What all of them told since the last call, in any order, and what their contacts are now.
    std::vector<ButtonEdge> join(std::vector<ButtonEdge> edges, std::span<const Contacts* const> contacts);

    // A stream that has ended: what its contacts counted stays counted.
    void retire(const Contacts& contacts);

    const Contacts& contacts() const { return contacts_; }

  private:
    bool is_news(const ButtonEdge& edge);

    std::array<std::size_t, kButtons.size()> down_on_{};  // how many streams hold this button down
    std::array<std::uint64_t, kButtons.size()> retired_edges_{};
    Contacts contacts_{};
    Instant last_at_ = Instant::min();
};

}  // namespace quadrat::firmware_io
