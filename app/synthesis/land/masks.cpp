// SPDX-License-Identifier: Apache-2.0
// In the sense of Schneider, Boldte & Westermann, 2006, and Stachniak & Stuerzlinger, 2005: the user's picture is the
// low octaves, the process the high ones.
#include "synthesis/land/masks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/land/erosion.hpp"

namespace quadrat::synthesis::land {

mesh::Field resampled(const mesh::Field& field, int columns, int rows) {
    mesh::Field out(columns, rows);
    if (field.samples.empty()) return out;
    const float across = static_cast<float>(field.columns - 1) / static_cast<float>(std::max(columns - 1, 1));
    const float down = static_cast<float>(field.rows - 1) / static_cast<float>(std::max(rows - 1, 1));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            out.at(x, y) = mesh::sample(field, static_cast<float>(x) * across, static_cast<float>(y) * down);
    return out;
}

// The pull-push of Gortler et al., "The Lumigraph", 1996, section 3.4: a half as large field knows more.
void fill_holes(mesh::Field& field) {
    const auto is_hole = [](float value) { return std::isnan(value); };
    if (std::ranges::none_of(field.samples, is_hole) || std::ranges::all_of(field.samples, is_hole)) return;
    mesh::Field half((field.columns + 1) / 2, (field.rows + 1) / 2);
    std::vector<float> known(half.samples.size());
    for (int y = 0; y < field.rows; ++y)
        for (int x = 0; x < field.columns; ++x) {
            if (is_hole(field.at(x, y))) continue;
            half.at(x / 2, y / 2) += field.at(x, y);
            ++known[half.index(x / 2, y / 2)];
        }
    for (std::size_t i = 0; i < known.size(); ++i) half.samples[i] /= known[i];  // nothing known: no number
    fill_holes(half);
    for (int y = 0; y < field.rows; ++y)
        for (int x = 0; x < field.columns; ++x)
            if (is_hole(field.at(x, y)))
                field.at(x, y) =
                    mesh::sample(half, 0.5F * static_cast<float>(x) - 0.25F, 0.5F * static_cast<float>(y) - 0.25F);
}

float follow_mask(mesh::Field& height, const mesh::Field& mask, int reach) {
    if (height.samples.empty()) return 0;
    const mesh::Field wished = resampled(mask, height.columns, height.rows);
    mesh::Field left(height.columns, height.rows);
    const auto difference = [&] {
        for (std::size_t i = 0; i < left.samples.size(); ++i) left.samples[i] = wished.samples[i] - height.samples[i];
        smooth(left, reach);
        float largest = 0;
        for (const float d : left.samples) largest = std::max(largest, std::abs(d));
        return largest;
    };
    // A mean of a mean is not the mean: each round takes the better part of what the one before has left.
    constexpr int kRounds = 6;
    for (int round = 0; round < kRounds; ++round) {
        difference();
        for (std::size_t i = 0; i < left.samples.size(); ++i) height.samples[i] += left.samples[i];
    }
    return difference();
}

}  // namespace quadrat::synthesis::land
