// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "genome/parameter_table.hpp"

namespace quadrat::genome {

// One enumerator a row, in table order: trees, then land, then sky.
enum class ParameterId : std::size_t {
#define PARAMETER(id, ...) id,
// The order is the table's, not the alphabet's.
// clang-format off
#include "genome/parameters_trees.inc"
#include "genome/parameters_land.inc"
#include "genome/parameters_sky.inc"
// clang-format on
#undef PARAMETER
    count
};
inline constexpr std::size_t kParameterCount = static_cast<std::size_t>(ParameterId::count);

}  // namespace quadrat::genome
