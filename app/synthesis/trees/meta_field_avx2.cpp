// SPDX-License-Identifier: Apache-2.0
// Compiled with -mavx2 (CMakeLists.txt); called only where the processor has it.
#if defined(__x86_64__)
#include "synthesis/trees/meta_field_kernel.hpp"
#include "synthesis/trees/meta_surface_kernel.hpp"

namespace quadrat::synthesis::trees::kernel {

void feel_avx2(const Tube& tube, float* best) { FieldKernel<xsimd::avx2>::feel(tube, best); }
void add_avx2(float* best, float* sum) { FieldKernel<xsimd::avx2>::add(best, sum); }

void tell_avx2(const Piece* pieces, const std::uint32_t* list, std::size_t count, const float (&points)[3][8],
               float surface, Told& told) {
    SurfaceKernel<xsimd::avx2>::tell(pieces, list, count, points, surface, told);
}

}  // namespace quadrat::synthesis::trees::kernel
#endif
