// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstdint>

#include "base/seed.hpp"
#include "mesh/field.hpp"

namespace quadrat::tests {

inline constexpr int kSide = 129;
inline constexpr float kCell_m = 2;

// Hills, and on them single samples that stick out: so far, west and east of the middle.
inline mesh::Field rugged(float west_m, float east_m) {
    mesh::Field field(kSide, kSide);
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
            field.at(column, row) =
                6 * std::sin(0.11F * static_cast<float>(column)) * std::cos(0.07F * static_cast<float>(row)) +
                base::unit_of(base::hash_of(base::Seed{9}, column, row)) * (column > 64 ? east_m : west_m);
    return field;
}

struct Corner {
    int column;
    int row;
};
inline Corner corner(std::uint32_t index) { return {static_cast<int>(index) % kSide, static_cast<int>(index) / kSide}; }

}  // namespace quadrat::tests
