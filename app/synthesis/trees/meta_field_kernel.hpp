// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <xsimd/xsimd.hpp>

// The inner loops of meta-tubes over a block of 8 x 8 x 8 samples. Compiled once for the baseline and once for
// processors with AVX2, to the same bits; nothing else may be included here, so that no code of a wider set escapes
// into the rest.
namespace quadrat::synthesis::trees::kernel {

// A tapering piece of a limb in samples of the block, and the rows that it may reach.
struct Tube {
    float x, y, z;     // its beginning
    float dx, dy, dz;  // to its end
    float per_length2;
    float per_reach, per_reach_more;  // 1 / reach at its beginning; at its end, more than there
    int y0, y1, z0, z1;
};

template <typename Arch>
struct FieldKernel {
    using F = xsimd::batch<float, Arch>;
    static constexpr int kLanes = static_cast<int>(F::size);
    static_assert(8 % kLanes == 0);

    // Lowers each sample to the tube's distance from it over its reach there, squared.
    static void feel(const Tube& t, float* best) {
        constexpr float kColumns[8] = {0, 1, 2, 3, 4, 5, 6, 7};
        const F dx(t.dx);
        const F dy(t.dy);
        const F dz(t.dz);
        const F per_length2(t.per_length2);
        const F per_reach(t.per_reach);
        const F per_reach_more(t.per_reach_more);
        for (int x = 0; x < 8; x += kLanes) {
            const F qx = F::load_unaligned(kColumns + x) - F(t.x);
            const F along_x = qx * dx;
            for (int z = t.z0; z <= t.z1; ++z) {
                const F qz(static_cast<float>(z) - t.z);
                for (int y = t.y0; y <= t.y1; ++y) {
                    const F qy(static_cast<float>(y) - t.y);
                    const F along =
                        xsimd::min(xsimd::max((along_x + (qy * dy + qz * dz)) * per_length2, F(0.0F)), F(1.0F));
                    const F ex = qx - along * dx;
                    const F ey = qy - along * dy;
                    const F ez = qz - along * dz;
                    const F per = per_reach + along * per_reach_more;
                    const F share = (ex * ex + ey * ey + ez * ez) * (per * per);
                    float* row = best + (z * 8 + y) * 8 + x;
                    xsimd::min(share, F::load_unaligned(row)).store_unaligned(row);
                }
            }
        }
    }

    // Adds a limb's field to the sum and makes the shares ready for the next limb.
    static void add(float* best, float* sum) {
        for (int i = 0; i < 512; i += kLanes) {
            const F rest = F(1.0F) - F::load_unaligned(best + i);
            (F::load_unaligned(sum + i) + rest * rest * rest).store_unaligned(sum + i);
            F(1.0F).store_unaligned(best + i);
        }
    }
};

void feel_avx2(const Tube& tube, float* best);
void add_avx2(float* best, float* sum);

}  // namespace quadrat::synthesis::trees::kernel
