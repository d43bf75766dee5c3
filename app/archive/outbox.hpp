// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "archive/archive.hpp"

namespace quadrat::archive {

// What the archive of a running exhibit keeps for the fleet, seen from another process: it changes nothing but to take
// away what was sent.
class Outbox {
  public:
    // Nothing while there is no state file, or none of this version.
    static std::optional<Outbox> open(const std::filesystem::path& directory);

    std::vector<Archive::Message> waiting(int most) const;  // oldest first; none where it cannot be read
    [[nodiscard]] Trouble forget(std::int64_t up_to_id);

  private:
    explicit Outbox(Connection connection) : connection_(std::move(connection)) {}
    Connection connection_;
};

// What is published of a visit that has ended, as JSON.
std::string told_of_visit(exhibit::Ending ending, int rounds, WallTime at);

}  // namespace quadrat::archive
