// SPDX-License-Identifier: Apache-2.0
// Compiled with -mavx2 (CMakeLists.txt); called only where the processor has it.
#if defined(__x86_64__)
#include "synthesis/trees/meta_field_kernel.hpp"

namespace quadrat::synthesis::trees::kernel {

void feel_avx2(const Tube& tube, float* best) { FieldKernel<2>::feel(tube, best); }
void add_avx2(float* best, float* sum) { FieldKernel<2>::add(best, sum); }

}  // namespace quadrat::synthesis::trees::kernel
#endif
