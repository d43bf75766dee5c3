// SPDX-License-Identifier: Apache-2.0
#include "render/ground_by.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace quadrat::render {
namespace {

constexpr std::array<std::string_view, 2> kNames{"blocks", "roam"};  // by GroundBy

}  // namespace

std::vector<std::string> ground_names() { return {kNames.begin(), kNames.end()}; }

std::string_view name_of(GroundBy ground) { return kNames[static_cast<std::size_t>(ground)]; }

bool has_ground(std::string_view name) { return std::ranges::find(kNames, name) != kNames.end(); }

GroundBy ground_named(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    assert(found != kNames.end());
    return static_cast<GroundBy>(found - kNames.begin());
}

}  // namespace quadrat::render
