// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "doctor/diagnosis.hpp"

namespace quadrat::doctor {

// What is in a state folder, beside a running exhibit too: what the next start would set aside or leave unused is told
// before it does. Nothing is changed.
std::vector<Finding> examine_state_files(const std::filesystem::path& directory,
                                         const std::optional<machine::Account>& exhibit = {});

}  // namespace quadrat::doctor
