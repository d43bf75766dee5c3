// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "doctor/diagnosis.hpp"

namespace quadrat::commands {

// All that the doctor looks at, or the parts of these names alone. "" stands for the service's settings and state.
std::vector<doctor::Finding> examine_parts(const std::string& named_configuration, const std::string& named_state,
                                           const std::vector<std::string>& only = {});

}  // namespace quadrat::commands
