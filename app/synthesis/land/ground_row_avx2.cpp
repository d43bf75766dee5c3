// SPDX-License-Identifier: Apache-2.0
#if defined(__x86_64__)
#include "synthesis/land/ground_row.hpp"

namespace quadrat::synthesis::land {

void paint_ground_row_avx2(const GroundRow& row, const GroundLook& look) {
    GroundKernel<xsimd::avx2>::paint(row, look);
}

void interpolate_ground_row_avx2(const float* above, const float* below, float down, int samples,
                                 const std::int32_t* first, const float* share, int width, float* between, float* out) {
    interpolate_ground_row(above, below, down, samples, first, share, width, between, out);
}

}  // namespace quadrat::synthesis::land
#endif
