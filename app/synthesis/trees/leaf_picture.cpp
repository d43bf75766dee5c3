// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/leaf_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/field.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kColumns = 32;  // half a blade, from the midrib to the rim
constexpr int kRows = 64;     // from the foot to the tip

float smooth(float t) {
    const float u = std::clamp(t, 0.0F, 1.0F);
    return u * u * (3.0F - 2.0F * u);
}

// A ridge of this half width about the whole numbers.
float vein(float phase, float half_width) { return smooth(1.0F - std::abs(phase - std::round(phase)) / half_width); }

// Where the side veins are, 0 to 1. across: midrib 0 to rim 1; along: foot 0 to tip 1.
float side_veins(Venation way, float across, float along, float number) {
    const float thin = 1.0F - 0.55F * across;
    switch (way) {
        case Venation::Pinnate: {
            // Each leaves the midrib at an angle and bends toward the tip.
            const float left_at = along - 0.30F * across - 0.14F * across * across;
            return left_at < -0.02F ? 0.0F : vein(left_at * number, 0.13F * thin);
        }
        case Venation::Palmate: {
            const float angle = std::atan2(0.5F * across, along + 0.03F);
            return vein(angle * number / 2.2F, 0.11F * thin) * smooth(4.0F * (across + along));
        }
        case Venation::Parallel:
            return vein(across * 0.5F * number, 0.22F);
    }
    return 0;
}

std::vector<float> noise_over_blade(base::Seed seed, float scale, const noise::Octaves& octaves) {
    std::vector<float> xs;
    std::vector<float> ys;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            xs.push_back(scale * (static_cast<float>(column) + 0.5F) / kRows);
            ys.push_back(scale * (static_cast<float>(row) + 0.5F) / kRows);
        }
    }
    std::vector<float> values(xs.size());
    noise::fbm(noise::Key(seed), xs, ys, values, octaves);
    return values;
}

}  // namespace

Venation venation(LeafKind kind) {
    constexpr std::array<Venation, kLeafKinds> kWays{
        Venation::Pinnate,  Venation::Parallel, Venation::Pinnate, Venation::Pinnate,  Venation::Palmate,
        Venation::Parallel, Venation::Palmate,  Venation::Pinnate, Venation::Parallel, Venation::Parallel};
    return kWays[static_cast<std::size_t>(kind)];
}

mesh::Image leaf_picture(LeafKind kind, base::Seed seed) {
    const Venation way = venation(kind);
    base::RandomStream random{seed.child("veins")};
    const float number = way == Venation::Pinnate ? random.between(6.0F, 10.0F) : random.between(5.0F, 7.0F);
    const std::vector<float> patches = noise_over_blade(seed.child("patches"), 3, {.count = 3});
    const std::vector<float> net = noise_over_blade(seed.child("net"), 22, {.count = 1, .basis = noise::Basis::Cracks});
    std::vector<float> lightness(patches.size());
    float mean = 0;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const auto i = static_cast<std::size_t>(row * kColumns + column);
            const float across = (static_cast<float>(column) + 0.5F) / kColumns;
            const float along = (static_cast<float>(row) + 0.5F) / kRows;
            const float midrib = smooth(1.0F - across / (0.16F * (1.0F - 0.7F * along)));
            const float veins = std::max(midrib, 0.75F * side_veins(way, across, along, number));
            const float seams = way == Venation::Parallel ? 0.0F : 1.0F - smooth((net[i] + 0.7F) / 0.35F);
            lightness[i] = 0.34F * veins + 0.07F * seams * (1.0F - veins) + 0.22F * patches[i] -
                           0.16F * smooth((across - 0.72F) / 0.28F);
            mean += lightness[i] / static_cast<float>(lightness.size());
        }
    }
    mesh::Image picture(kColumns, kRows, 1);
    for (std::size_t i = 0; i < lightness.size(); ++i)
        picture.bytes[i] = static_cast<std::uint8_t>(std::clamp(128.5F + 128.0F * (lightness[i] - mean), 0.0F, 255.0F));
    return picture;
}

}  // namespace quadrat::synthesis::trees
