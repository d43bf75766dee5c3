// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>

#include "projector/keeper.hpp"

namespace quadrat::commands {

// What the exhibit beside us last said that it shows, in its runtime folder.
class ExhibitsScreen {
  public:
    explicit ExhibitsScreen(std::filesystem::path runtime) : runtime_(std::move(runtime)) {}

    // Nothing where none runs, or its screen has failed: then the projector stays as it is.
    std::optional<projector::Wanted> wanted();

  private:
    void read();

    std::filesystem::path runtime_;
    std::filesystem::file_time_type read_at_{};
    std::optional<projector::Wanted> wanted_;
};

}  // namespace quadrat::commands
