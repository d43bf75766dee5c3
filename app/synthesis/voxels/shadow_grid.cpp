// SPDX-License-Identifier: Apache-2.0
// The shadow propagation of Palubicki et al., "Self-organizing tree models for image synthesis" (SIGGRAPH 2009). Ours
// counts in whole numbers and goes layer by layer, so that threads share no cell. Its pyramids are short, for a cell of
// the air under a lone tree has light from the side; a coarse grid adds what a roof of crowns keeps from the ground.
#include "synthesis/voxels/shadow_grid.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace quadrat::synthesis::voxels {
namespace {

constexpr int kBlock = 4;  // cells

}  // namespace

ShadowGrid::ShadowGrid(const Shade& shade, const glm::vec3& low, const glm::ivec3& cells)
    : shade_(shade),
      low_(low),
      cells_(cells),
      shadow_(static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) *
              static_cast<std::size_t>(cells.z)),
      blocks_((cells + kBlock - 1) / kBlock),
      within_(static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y) *
              static_cast<std::size_t>(blocks_.z)),
      roof_(within_.size()) {
    float each = shade.a;
    for (int q = 0; q <= shade.q_max; ++q, each /= shade.b)
        added_.push_back(static_cast<std::int32_t>(std::lround(each * kWhole)));
}

glm::ivec3 ShadowGrid::cell_of(const glm::vec3& at) const { return glm::ivec3{glm::floor(at - low_)}; }

bool ShadowGrid::holds(const glm::vec3& at) const {
    const glm::ivec3 cell = cell_of(at);
    for (int k = 0; k < 3; ++k)
        if (cell[k] < 0 || cell[k] >= cells_[k]) return false;
    return true;
}

std::int32_t ShadowGrid::shadow_in(const glm::ivec3& cell) const {
    for (int k = 0; k < 3; ++k)
        if (cell[k] < 0 || cell[k] >= cells_[k]) return 0;
    return shadow_[flat(cell.x, cell.y, cell.z)];
}

float ShadowGrid::light_at(const glm::vec3& at) const {
    const float s = static_cast<float>(shadow_in(cell_of(at))) / kWhole;
    return std::clamp(1 - s + shade_.a, 0.0F, 1.0F) * std::exp(-shade_.far * roof_over(at));
}

float ShadowGrid::roof_over(const glm::vec3& at) const {
    // Between the middles of blocks.
    const glm::vec3 place = (at - low_) / static_cast<float>(kBlock) - 0.5F;
    const glm::ivec3 first{glm::floor(place)};
    const glm::vec3 part = place - glm::vec3{first};
    float sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step{corner & 1, corner >> 1 & 1, corner >> 2};
        const glm::ivec3 block = first + step;
        float share = 1;
        bool is_inside = true;
        for (int k = 0; k < 3; ++k) {
            share *= step[k] == 1 ? part[k] : 1 - part[k];
            is_inside = is_inside && block[k] >= 0 && block[k] < blocks_[k];
        }
        if (is_inside) sum += share * roof_[flat_block(block.x, block.y, block.z)];
    }
    return sum;
}

// From the top down: over a block is what is over the 25 above it and in them, each its share. No share is less than 0,
// so that more to shade never means more light.
void ShadowGrid::raise_roof() {
    constexpr float kShares[5] = {0.12F, 0.24F, 0.28F, 0.24F, 0.12F};
    std::vector<float> above(static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.z));
    for (int y = blocks_.y - 2; y >= 0; --y) {
        for (int z = 0; z < blocks_.z; ++z) {
            for (int x = 0; x < blocks_.x; ++x) {
                float sum = 0;
                for (int dx = std::max(-2, -x); dx <= std::min(2, blocks_.x - 1 - x); ++dx) {
                    const std::size_t i = flat_block(x + dx, y + 1, z);
                    sum += kShares[dx + 2] * (roof_[i] + static_cast<float>(within_[i]));
                }
                above[static_cast<std::size_t>(z * blocks_.x + x)] = sum;
            }
        }
        for (int z = 0; z < blocks_.z; ++z) {
            for (int x = 0; x < blocks_.x; ++x) {
                float sum = 0;
                for (int dz = std::max(-2, -z); dz <= std::min(2, blocks_.z - 1 - z); ++dz)
                    sum += kShares[dz + 2] * above[static_cast<std::size_t>((z + dz) * blocks_.x + x)];
                roof_[flat_block(x, y, z)] = sum;
            }
        }
    }
}

glm::vec3 ShadowGrid::way_to_light(const glm::vec3& at) const {
    constexpr int kNear = 2;  // cells: one is too rough to follow
    const glm::ivec3 cell = cell_of(at);
    glm::vec3 way{0};
    for (int k = 0; k < 3; ++k) {
        glm::ivec3 step{0};
        step[k] = kNear;
        way[k] = static_cast<float>(shadow_in(cell - step) - shadow_in(cell + step)) / (2 * kNear * kWhole);
    }
    return way;
}

void ShadowGrid::shade_layer(int y, std::span<const Change> changes) {
    std::size_t shaded = 0;
    for (const Change& change : changes) {
        const int q = cell_of(change.at).y - y;
        if (q >= 0 && q <= shade_.q_max) shaded += static_cast<std::size_t>((2 * q + 1) * (2 * q + 1));
    }
    // Of many squares only the corners are written, and summed up over the layer once: the same whole numbers.
    const bool are_many = shaded > static_cast<std::size_t>(4 * cells_.x * cells_.z);
    const int stride = cells_.x + 1;
    std::vector<std::int32_t> corners(are_many ? static_cast<std::size_t>(stride * (cells_.z + 1)) : 0, 0);
    const auto corner = [&](int x, int z) -> std::int32_t& {
        return corners[static_cast<std::size_t>(z * stride + x)];
    };
    for (const Change& change : changes) {
        const glm::ivec3 cell = cell_of(change.at);
        const int q = cell.y - y;
        if (q < 0 || q > shade_.q_max) continue;
        const std::int32_t by = change.is_new ? added_[q] : -added_[q];
        const glm::ivec2 low{std::max(cell.x - q, 0), std::max(cell.z - q, 0)};
        const glm::ivec2 high{std::min(cell.x + q + 1, cells_.x), std::min(cell.z + q + 1, cells_.z)};
        if (low.x >= high.x || low.y >= high.y) continue;
        if (are_many) {
            corner(low.x, low.y) += by;
            corner(high.x, low.y) -= by;
            corner(low.x, high.y) -= by;
            corner(high.x, high.y) += by;
            continue;
        }
        for (int z = low.y; z < high.y; ++z) {
            std::int32_t* row = shadow_.data() + flat(0, y, z);
            for (int x = low.x; x < high.x; ++x) row[x] += by;
        }
    }
    if (!are_many) return;
    for (int z = 0; z < cells_.z; ++z) {
        std::int32_t* row = shadow_.data() + flat(0, y, z);
        std::int32_t sum = 0;
        for (int x = 0; x < cells_.x; ++x) {
            sum += corner(x, z);
            row[x] += sum;
            corner(x, z + 1) += corner(x, z);
        }
    }
}

void ShadowGrid::apply(std::span<const Change> changes) {
    for (const Change& change : changes) {
        const glm::ivec3 block = glm::clamp(cell_of(change.at), glm::ivec3{0}, cells_ - 1) / kBlock;
        within_[flat_block(block.x, block.y, block.z)] += change.is_new ? 1 : -1;
    }
    raise_roof();
    constexpr std::size_t kWorthThreads = 400;
    if (changes.size() < kWorthThreads) {
        for (int y = 0; y < cells_.y; ++y) shade_layer(y, changes);
        return;
    }
    oneapi::tbb::parallel_for(0, cells_.y, [&](int y) { shade_layer(y, changes); });
}

}  // namespace quadrat::synthesis::voxels
