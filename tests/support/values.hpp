// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/image.hpp"

// What a painter would measure of a picture: its values, from dark to light, and how much of it is empty.
namespace quadrat::tests {

// Luma of each pixel, 0 to 1, as encoded; row by row.
inline std::vector<float> lumas_of(const mesh::Image& picture) {
    std::vector<float> lumas;
    lumas.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* p = picture.pixel(x, y);
            lumas.push_back((0.2126F * p[0] + 0.7152F * p[1] + 0.0722F * p[2]) / 255);
        }
    return lumas;
}

struct ValueRange {
    float dark = 0;   // 5th percentile of luma
    float light = 0;  // 95th
    float mean = 0;
    float range() const { return light - dark; }
};

inline ValueRange values_of(const mesh::Image& picture) {
    std::vector<float> lumas = lumas_of(picture);
    double sum = 0;
    for (const float luma : lumas) sum += luma;
    ValueRange values;
    values.mean = static_cast<float>(sum / static_cast<double>(lumas.size()));
    const auto percentile = [&lumas](double share) {
        const auto nth = lumas.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(lumas.size() - 1));
        std::nth_element(lumas.begin(), nth, lumas.end());
        return *nth;
    };
    values.dark = percentile(0.05);
    values.light = percentile(0.95);
    return values;
}

// Of the lower half, cut into tiles of 8 by 8 pixels: the share whose luma deviates by less than a hundredth.
inline float flat_share(const mesh::Image& picture) {
    constexpr int kTile = 8;
    constexpr float kFlat = 0.01F;
    const std::vector<float> lumas = lumas_of(picture);
    int tiles = 0;
    int flat = 0;
    for (int top = picture.height / 2; top + kTile <= picture.height; top += kTile)
        for (int left = 0; left + kTile <= picture.width; left += kTile) {
            double sum = 0;
            double squares = 0;
            for (int y = top; y < top + kTile; ++y)
                for (int x = left; x < left + kTile; ++x) {
                    const double luma = lumas[static_cast<std::size_t>(y * picture.width + x)];
                    sum += luma;
                    squares += luma * luma;
                }
            const double mean = sum / (kTile * kTile);
            const double variance = std::max(squares / (kTile * kTile) - mean * mean, 0.0);
            ++tiles;
            if (std::sqrt(variance) < kFlat) ++flat;
        }
    return tiles == 0 ? 0 : static_cast<float>(flat) / static_cast<float>(tiles);
}

// Where the eye goes first: the sixteenth of the picture whose mean luma stands out most from what is around it.
// 0 to 1 from the left and from the top.
struct Place {
    float across = 0.5F;
    float down = 0.5F;
};

inline Place subject_of(const mesh::Image& picture) {
    constexpr int kColumns = 16;
    constexpr int kRows = 9;
    const std::vector<float> lumas = lumas_of(picture);
    std::vector<float> cells(static_cast<std::size_t>(kColumns * kRows), 0.0F);
    std::vector<float> counts(cells.size(), 0.0F);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto cell =
                static_cast<std::size_t>(y * kRows / picture.height * kColumns + x * kColumns / picture.width);
            cells[cell] += lumas[static_cast<std::size_t>(y * picture.width + x)];
            ++counts[cell];
        }
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] /= std::max(counts[i], 1.0F);
    Place place;
    float most = -1;
    for (int row = 1; row + 1 < kRows; ++row)
        for (int column = 1; column + 1 < kColumns; ++column) {
            float around = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    around += cells[static_cast<std::size_t>((row + dy) * kColumns + column + dx)];
            const float own = cells[static_cast<std::size_t>(row * kColumns + column)];
            const float apart = std::abs(own - (around - own) / 8);
            if (apart <= most) continue;
            most = apart;
            place = {(static_cast<float>(column) + 0.5F) / kColumns, (static_cast<float>(row) + 0.5F) / kRows};
        }
    return place;
}

}  // namespace quadrat::tests
