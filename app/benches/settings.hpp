// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "benches/benches.hpp"

namespace quadrat::benches {

// One option as it could be written on a command line, and the groups measured that it decided.
struct Setting {
    std::string option;  // "--size 1280x720"
    std::vector<std::string> groups;
};

// Those that any of the groups heeds.
std::vector<Setting> settings_of(const Options& how, const std::vector<std::string>& measured);

}  // namespace quadrat::benches
