// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/openness.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrat::synthesis {

mesh::Field sky_openness(const scene::Land& land) {
    const int side = (land.height_m.columns - 1) / 2;
    mesh::Field open(side, side);
    constexpr std::array<float, 4> kSteps{2.5F, 7.0F, 17.0F, 40.0F};
    constexpr std::array<std::array<float, 2>, 8> kWays{{{1, 0},
                                                         {0.70711F, 0.70711F},
                                                         {0, 1},
                                                         {-0.70711F, 0.70711F},
                                                         {-1, 0},
                                                         {-0.70711F, -0.70711F},
                                                         {0, -1},
                                                         {0.70711F, -0.70711F}}};
    oneapi::tbb::parallel_for(0, side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            const float column = 2.0F * static_cast<float>(x) + 1.0F;
            const float row = 2.0F * static_cast<float>(y) + 1.0F;
            const float here = mesh::sample(land.height_m, column, row);
            float hidden = 0;
            for (const auto& way : kWays) {
                float steepest = 0;
                for (const float step : kSteps) {
                    const int c =
                        std::clamp(static_cast<int>(column + step * way[0] + 0.5F), 0, land.height_m.columns - 1);
                    const int r = std::clamp(static_cast<int>(row + step * way[1] + 0.5F), 0, land.height_m.rows - 1);
                    steepest = std::max(steepest, (land.height_m.at(c, r) - here) / (step * land.cell_m));
                }
                hidden += steepest * steepest / (1.0F + steepest * steepest);  // sine squared of the horizon's height
            }
            open.at(x, y) = 1.0F - hidden / static_cast<float>(kWays.size());
        }
    });
    return open;
}

namespace {

mesh::Field folds_of(const scene::Land& land) {
    constexpr float kStrength = 1.3F;
    const mesh::Field& heights = land.height_m;
    const int side = (heights.columns - 1) / 2;
    mesh::Field folds(side, side);
    oneapi::tbb::parallel_for(0, side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            const auto height_m = [&](int east, int south) {
                return heights.at(std::clamp(2 * x + 1 + east, 0, heights.columns - 1),
                                  std::clamp(2 * y + 1 + south, 0, heights.rows - 1));
            };
            float fold = 0;
            for (const int reach : {2, 6}) {
                const float about_m =
                    0.25F * (height_m(reach, 0) + height_m(-reach, 0) + height_m(0, reach) + height_m(0, -reach));
                fold += (height_m(0, 0) - about_m) / (static_cast<float>(reach) * land.cell_m);
            }
            folds.at(x, y) = 1 + kStrength * fold / (1 + 2 * std::abs(fold));
        }
    });
    return folds;
}

}  // namespace

Openness openness_of(const scene::Land& land) { return {sky_openness(land), folds_of(land)}; }

}  // namespace quadrat::synthesis
