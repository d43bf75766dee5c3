// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inner loops of meta-tubes over a block of 8 x 8 x 8 samples. Instantiated a second time for processors with AVX2;
// both give the same bits.
namespace quadrat::synthesis::trees::kernel {

// A tapering piece of a limb in samples of the block, and the rows that it may reach.
struct Tube {
    float x, y, z;     // its beginning
    float dx, dy, dz;  // to its end
    float per_length2;
    float reach, reach_more;
    int y0, y1, z0, z1;
};

template <int Processor>
struct FieldKernel {
    // Lowers each sample to the tube's distance from it over its reach there, squared.
    static void feel(const Tube& t, float* best) {
        for (int z = t.z0; z <= t.z1; ++z) {
            const float qz = static_cast<float>(z) - t.z;
            for (int y = t.y0; y <= t.y1; ++y) {
                const float qy = static_cast<float>(y) - t.y;
                const float across = qy * t.dy + qz * t.dz;
                float* row = best + (z * 8 + y) * 8;
                for (int x = 0; x < 8; ++x) {
                    const float qx = static_cast<float>(x) - t.x;
                    float along = (qx * t.dx + across) * t.per_length2;
                    along = along < 0.0F ? 0.0F : along;
                    along = along > 1.0F ? 1.0F : along;
                    const float ex = qx - along * t.dx;
                    const float ey = qy - along * t.dy;
                    const float ez = qz - along * t.dz;
                    const float reach = t.reach + along * t.reach_more;
                    const float share = (ex * ex + ey * ey + ez * ez) / (reach * reach);
                    row[x] = share < row[x] ? share : row[x];
                }
            }
        }
    }

    // Adds a limb's field to the sum and makes the shares ready for the next limb.
    static void add(float* best, float* sum) {
        for (int i = 0; i < 512; ++i) {
            const float rest = 1.0F - best[i];
            sum[i] += rest * rest * rest;
            best[i] = 1.0F;
        }
    }
};

void feel_avx2(const Tube& tube, float* best);
void add_avx2(float* best, float* sum);

}  // namespace quadrat::synthesis::trees::kernel
