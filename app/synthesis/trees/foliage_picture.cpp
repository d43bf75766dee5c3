// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "synthesis/trees/leaf_picture.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kSide = 128;
constexpr int kLeaves = 260;
constexpr float kLength_px = 25;  // of a leaf
constexpr float kGap = 0.42F;     // light between leaves, of that of the mean leaf

float twice_area(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A tile that goes on at its sides.
class Tile {
  public:
    Tile() : light_(static_cast<std::size_t>(kSide * kSide), kGap) {}

    // Light at its corners.
    void fill(const std::array<glm::vec2, 3>& at, const std::array<float, 3>& light) {
        const float area = twice_area(at[0], at[1], at[2]);
        if (std::abs(area) < 1e-3F) return;
        const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
        const auto [top, bottom] = std::minmax({at[0].y, at[1].y, at[2].y});
        for (int y = pixel(top); y <= pixel(bottom); ++y) {
            for (int x = pixel(left); x <= pixel(right); ++x) {
                const glm::vec2 p{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F};
                const float a = twice_area(at[1], at[2], p) / area;
                const float b = twice_area(at[2], at[0], p) / area;
                if (a < 0 || b < 0 || a + b > 1) continue;
                this->at(x, y) = a * light[0] + b * light[1] + (1 - a - b) * light[2];
            }
        }
    }
    const std::vector<float>& light() const { return light_; }

  private:
    static int pixel(float at) { return static_cast<int>(std::floor(at)); }
    static int wrapped(int i) { return (i % kSide + kSide) % kSide; }
    float& at(int x, int y) { return light_[static_cast<std::size_t>(wrapped(y) * kSide + wrapped(x))]; }
    std::vector<float> light_;
};

}  // namespace

mesh::Image foliage_picture(LeafKind kind, base::Seed seed) {
    const LeafShape& leaf = leaf_shape(kind);
    base::RandomStream random{seed.child("foliage")};
    Tile tile;
    for (int i = 0; i < kLeaves; ++i) {
        const glm::vec2 foot{random.between(0, kSide), random.between(0, kSide)};
        // Tips hang rather than rise.
        const float down = 1.5708F + random.between(-2.2F, 2.2F);
        const glm::vec2 along = kLength_px * random.between(0.7F, 1.2F) * glm::vec2{std::cos(down), std::sin(down)};
        const glm::vec2 aside = std::max(leaf.width, 0.3F) * random.between(0.4F, 1.0F) * glm::vec2{-along.y, along.x};
        // What is drawn last lies outermost, in the light.
        const float outer = static_cast<float>(i) / kLeaves;
        const float light = random.between(0.62F, 1.0F) * (0.75F + 0.6F * outer);
        for (std::size_t t = 0; t + 2 < leaf.triangles.size(); t += 3) {
            std::array<glm::vec2, 3> corners{};
            std::array<float, 3> lights{};
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec2 p = leaf.outline[leaf.triangles[t + k]];
                corners[k] = foot + p.x * along + p.y * aside;
                // One half of a folded leaf turns from the light.
                lights[k] = light * (0.9F + 0.25F * p.x) * (p.y < 0 ? 0.86F : 1.06F);
            }
            tile.fill(corners, lights);
        }
    }
    double mean = 0;
    for (const float light : tile.light()) mean += light;
    const auto to_bytes = static_cast<float>(128.0 * static_cast<double>(kSide * kSide) / mean);
    mesh::Image picture(kSide, kSide, 1);
    std::ranges::transform(tile.light(), picture.bytes.begin(), [to_bytes](float light) {
        return static_cast<std::uint8_t>(std::clamp(to_bytes * light + 0.5F, 0.0F, 255.0F));
    });
    return picture;
}

}  // namespace quadrat::synthesis::trees
