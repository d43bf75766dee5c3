// SPDX-License-Identifier: Apache-2.0
#include "mesh/field.hpp"

#include <algorithm>

namespace quadrat::mesh {

float sample(const Field& field, float column, float row) {
    if (field.samples.empty()) return 0.0F;
    const float x = std::clamp(column, 0.0F, static_cast<float>(field.columns - 1));
    const float y = std::clamp(row, 0.0F, static_cast<float>(field.rows - 1));
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, field.columns - 1);
    const int y1 = std::min(y0 + 1, field.rows - 1);
    const float tx = x - static_cast<float>(x0);
    const float ty = y - static_cast<float>(y0);
    const float above = field.at(x0, y0) + tx * (field.at(x1, y0) - field.at(x0, y0));
    const float below = field.at(x0, y1) + tx * (field.at(x1, y1) - field.at(x0, y1));
    return above + ty * (below - above);
}

}  // namespace quadrat::mesh
