// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "scene/sky.hpp"

namespace quadrat::render::choose {

inline constexpr std::size_t kDrops = 9000;  // that there are

// How many of them are drawn: a share, 0 to 1, of what falls. Any prefix of them is even in their box.
std::size_t drops_of(const scene::Precipitation& what, float share);

}  // namespace quadrat::render::choose
