// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

// The inner loop of drain(), for any vector width: compiled once for the baseline and once for each wider instruction
// set, so nothing else may be included here and nothing here has linkage.
namespace quadrat::synthesis::land {
namespace {

// One row of interior cells: the steepest way down, as an offset to a neighbour; 0: a pit. Whole rows at a time and
// without branches. chance and best are room to work in.
inline void steepest_of_row(const float* here, int columns, std::uint32_t first_cell, std::uint32_t wander,
                            std::int32_t* offset, std::uint32_t* chance, float* best) {
    for (int x = 1; x < columns - 1; ++x) {
        std::uint32_t c = ((first_cell + static_cast<std::uint32_t>(x)) ^ wander) * 0x9E3779B9U;
        c = (c ^ (c >> 15U)) * 0x2C1B3C6DU;
        chance[x] = c ^ (c >> 13U);
        best[x] = 0;
        offset[x] = 0;
    }
    const std::int32_t steps[8] = {1, -1, columns, -columns, columns + 1, columns - 1, 1 - columns, -1 - columns};
    for (int k = 0; k < 8; ++k) {
        const std::int32_t step = steps[k];
        const float* next = here + step;
        const float reach = k < 4 ? 1.0F : 0.70710678F;
        const int shift = 4 * k;
        for (int x = 1; x < columns - 1; ++x) {
            const float luck =
                0.55F + 0.06F * static_cast<float>(static_cast<std::int32_t>((chance[x] >> shift) & 15U));
            const float slope = (here[x] - next[x]) * luck * reach;
            const bool is_steeper = slope > best[x];
            best[x] = is_steeper ? slope : best[x];
            offset[x] = is_steeper ? step : offset[x];
        }
    }
}

}  // namespace

#if defined(__x86_64__)
void steepest_of_row_avx2(const float* here, int columns, std::uint32_t first_cell, std::uint32_t wander,
                          std::int32_t* offset, std::uint32_t* chance, float* best);
#endif

}  // namespace quadrat::synthesis::land
