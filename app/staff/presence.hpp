// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "base/owned.hpp"

namespace quadrat::staff {

// Held while an exhibit runs, and gone with it however it ends: who asks it for something knows whether to wait.
class Presence {
  public:
    // A folder that cannot be written in, or where another exhibit runs, leaves it unheld.
    explicit Presence(const std::filesystem::path& runtime);

  private:
    base::OwnedDescriptor file_;
};

// Whether an exhibit runs in this folder; it may be busy.
bool is_exhibit_present(const std::filesystem::path& runtime);

}  // namespace quadrat::staff
