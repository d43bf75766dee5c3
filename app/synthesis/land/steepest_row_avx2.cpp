// SPDX-License-Identifier: Apache-2.0
#if defined(__x86_64__)
#include "synthesis/land/steepest_row.hpp"

namespace quadrat::synthesis::land {

void steepest_of_row_avx2(const float* here, int columns, std::uint32_t first_cell, std::uint32_t wander,
                          std::int32_t* offset, std::uint32_t* chance, float* best) {
    steepest_of_row(here, columns, first_cell, wander, offset, chance, best);
}

}  // namespace quadrat::synthesis::land
#endif
