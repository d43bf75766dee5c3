// SPDX-License-Identifier: Apache-2.0
// The user's pictures as the lattice that octaves are summed from (Schneider, Boldte & Westermann, "Real-time editing,
// synthesis, and rendering of infinite landscapes on GPUs", 2006, section 3). Ours besides: edges that do not fit are
// blended with the picture's own middle, keeping its contrast (the blend of Heitz & Neyret, "High-performance
// by-example noise", 2018), and octaves finer than the samples take a coarser picture (Williams 1983).
#include "synthesis/noise/picture_lattice.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace quadrat::synthesis::noise {
namespace {

constexpr int kMostOctaves = 16;
constexpr float kCos = 0.8F;  // as between octaves of noise
constexpr float kSin = 0.6F;

// Whether a row that ends where it began would show it: the step over the seam beside the steps within.
bool has_seam(const mesh::Field& f) {
    double within = 0;
    double over = 0;
    for (int y = 0; y < f.rows; ++y) {
        for (int x = 0; x + 1 < f.columns; ++x) within += std::abs(f.at(x + 1, y) - f.at(x, y));
        over += std::abs(f.at(0, y) - f.at(f.columns - 1, y));
    }
    constexpr double kFits = 2.5;
    constexpr double kLeast = 1.0e-3;  // of white, a row
    return over > kFits * within / (f.columns - 1) + kLeast * f.rows;
}

// Toward both ends of a row what stands half a row away comes in.
void blend_ends(mesh::Field& f) {
    const mesh::Field before = f;
    const float margin = std::max(1.0F, 0.125F * static_cast<float>(f.columns));
    double sum = 0;
    for (const float v : f.samples) sum += v;
    const auto mean = static_cast<float>(sum / static_cast<double>(f.samples.size()));
    for (int x = 0; x < f.columns; ++x) {
        const float from_end = static_cast<float>(std::min(x, f.columns - 1 - x)) + 0.5F;
        const float t = std::clamp(from_end / margin, 0.0F, 1.0F);
        const float own = t * t * (3 - 2 * t);
        if (own >= 1) continue;
        const float keep = 1.0F / std::sqrt(own * own + (1 - own) * (1 - own));
        const int other = (x + f.columns / 2) % f.columns;
        for (int y = 0; y < f.rows; ++y)
            f.at(x, y) = std::clamp(
                mean + keep * (own * (before.at(x, y) - mean) + (1 - own) * (before.at(other, y) - mean)), 0.0F, 1.0F);
    }
}

mesh::Field transposed(const mesh::Field& f) {
    mesh::Field out(f.rows, f.columns);
    for (int y = 0; y < f.rows; ++y)
        for (int x = 0; x < f.columns; ++x) out.at(y, x) = f.at(x, y);
    return out;
}

// The mean of what each sample covers; sample 0 stays over sample 0.
mesh::Field halved(const mesh::Field& f) {
    mesh::Field out(std::max(1, f.columns / 2), std::max(1, f.rows / 2));
    const float across = static_cast<float>(f.columns) / static_cast<float>(out.columns);
    const float down = static_cast<float>(f.rows) / static_cast<float>(out.rows);
    const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
    for (int y = 0; y < out.rows; ++y) {
        const int row = static_cast<int>(static_cast<float>(y) * down);
        for (int x = 0; x < out.columns; ++x) {
            const int column = static_cast<int>(static_cast<float>(x) * across);
            float sum = 0;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    sum += static_cast<float>((2 - std::abs(i)) * (2 - std::abs(j))) *
                           f.at(wrapped(column + i, f.columns), wrapped(row + j, f.rows));
            out.at(x, y) = sum / 16;
        }
    }
    return out;
}

// Catmull & Rom's cubic through four samples.
float through(float a, float b, float c, float d, float t) {
    return b + 0.5F * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

// At a place in repeats; repeated both ways.
float repeated(const mesh::Field& f, float u, float v) {
    const float x = (u - std::floor(u)) * static_cast<float>(f.columns);
    const float y = (v - std::floor(v)) * static_cast<float>(f.rows);
    const int column = std::min(static_cast<int>(x), f.columns - 1);
    const int row = std::min(static_cast<int>(y), f.rows - 1);
    std::array<float, 4> rows{};
    for (int j = 0; j < 4; ++j) {
        const int r = (row + j - 1 + f.rows) % f.rows;
        const auto at = [&](int i) { return f.at((column + i + f.columns) % f.columns, r); };
        rows[static_cast<std::size_t>(j)] = through(at(-1), at(0), at(1), at(2), x - static_cast<float>(column));
    }
    return through(rows[0], rows[1], rows[2], rows[3], y - static_cast<float>(row));
}

}  // namespace

PictureLattice::PictureLattice(const std::vector<mesh::Field>& pictures) {
    assert(!pictures.empty());
    for (mesh::Field picture : pictures) {
        assert(picture.columns >= 2 && picture.rows >= 2);
        const bool has_upright = has_seam(picture);
        if (has_upright) blend_ends(picture);
        picture = transposed(picture);
        const bool has_level = has_seam(picture);
        if (has_level) blend_ends(picture);
        picture = transposed(picture);
        blended_ += has_upright || has_level ? 1 : 0;
        Finer levels{std::move(picture)};
        while (std::min(levels.back().columns, levels.back().rows) > 2) levels.push_back(halved(levels.back()));
        pictures_.push_back(std::move(levels));
    }
}

float PictureLattice::fbm(Key key, float x, float y, float step, const Octaves& octaves) const {
    assert(octaves.count <= kMostOctaves);
    std::array<float, kMostOctaves> values{};
    float shift_x = 0;
    float shift_y = 0;
    for (int i = 0; i < octaves.count; ++i) {
        const auto which = std::min(static_cast<std::size_t>(i), pictures_.size() - 1);
        const Finer& levels = pictures_[which];
        // So many of the picture's samples lie between two of the field's.
        const float passed = step * static_cast<float>(std::max(levels.front().columns, levels.front().rows));
        const int level = std::clamp(static_cast<int>(std::floor(std::log2(std::max(passed, 1.0F)) + 0.25F)), 0,
                                     static_cast<int>(levels.size()) - 1);
        values[static_cast<std::size_t>(i)] =
            2 * repeated(levels[static_cast<std::size_t>(level)], x + shift_x, y + shift_y) - 1;
        const float turned = 2 * (kCos * x - kSin * y);
        y = 2 * (kSin * x + kCos * y);
        x = turned;
        step *= 2;
        const std::uint64_t hash = base::hash_of(base::Seed{key.value}, i, 0);
        shift_x = base::unit_of(hash);
        shift_y = base::unit_of(hash << 24U);
    }
    return mixed({values.data(), static_cast<std::size_t>(octaves.count)}, octaves);
}

}  // namespace quadrat::synthesis::noise
