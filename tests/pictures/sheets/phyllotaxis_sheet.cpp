// SPDX-License-Identifier: Apache-2.0
// One parameter through all modes of leaves on a shoot, as Douady & Couder's figures draw them: each picture a shoot
// from above, its oldest leaves outermost and darkest. To be looked at:
//     phyllotaxis_sheet OUT.png [FROM TO COUNT]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "mesh/image.hpp"
#include "pictures/picture.hpp"
#include "synthesis/trees/inhibition.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis::trees;

constexpr int kSide = 300;
constexpr int kLeaves = 22;

// A pointed leaf from the middle outward.
void draw_leaf(mesh::Image& image, float turn_rad, float reach, float age) {
    const float cosine = std::cos(turn_rad);
    const float sine = std::sin(turn_rad);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const float px = static_cast<float>(x) - 0.5F * kSide;
            const float py = static_cast<float>(y) - 0.5F * kSide;
            const float along = (px * cosine + py * sine) / reach;
            const float across = std::abs(py * cosine - px * sine) / reach;
            if (along < 0.12F || along > 1) continue;
            const float half = 0.2F * std::sin(3.1415927F * std::pow((along - 0.12F) / 0.88F, 0.8F));
            if (across > half) continue;
            const float light = (across < 0.012F ? 0.75F : 1.0F) * (across > half - 0.02F ? 0.6F : 1.0F);
            auto* pixel = &image.bytes[4 * static_cast<std::size_t>(y * kSide + x)];
            pixel[0] = static_cast<std::uint8_t>(light * (175 - 105 * age));
            pixel[1] = static_cast<std::uint8_t>(light * (205 - 80 * age));
            pixel[2] = static_cast<std::uint8_t>(light * (95 - 40 * age));
        }
    }
}

mesh::Image shoot(float gamma) {
    mesh::Image image(kSide, kSide, 4);
    std::fill(image.bytes.begin(), image.bytes.end(), std::uint8_t{238});
    const std::vector<Primordium> leaves = leaves_of_shoot(gamma, kLeaves);
    const float oldest = std::max(leaves.front().below, 1.0e-3F);
    for (const Primordium& leaf : leaves) {
        const float age = leaf.below / oldest;
        draw_leaf(image, leaf.turn_rad, 0.49F * kSide * (0.22F + 0.78F * age), age);
    }
    return image;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const float from = argc > 4 ? std::strtof(argv[2], nullptr) : kMostInhibition;
    const float to = argc > 4 ? std::strtof(argv[3], nullptr) : kLeastInhibition;
    const int count = argc > 4 ? std::max(std::atoi(argv[4]), 2) : 18;
    std::vector<pictures::SheetEntry> entries;
    for (int i = 0; i < count; ++i) {
        const float gamma = from + (to - from) * static_cast<float>(i) / static_cast<float>(count - 1);
        entries.push_back({shoot(gamma), fmt::format("leaves keep off by {:.2f} radii", gamma)});
    }
    pictures::write_image(argv[1], pictures::contact_sheet(entries, 6, kSide));
    return 0;
}
