// SPDX-License-Identifier: Apache-2.0
// Compiled with -mavx2 (CMakeLists.txt); called only where the processor has it.
#if defined(__x86_64__)
#include "synthesis/noise/gradient_kernel.hpp"

namespace quadrat::synthesis::noise::kernel {

void run_avx2(const Sum& sum, const float* xs, const float* ys, float* out, std::size_t count) {
    Kernel<xsimd::avx2>::run(sum, xs, ys, out, count);
}

}  // namespace quadrat::synthesis::noise::kernel
#endif
