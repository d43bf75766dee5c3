// SPDX-License-Identifier: Apache-2.0
#include "render/choose/canopy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

namespace quadrat::render::choose {
namespace {

constexpr float kEllipse = 0.785F;  // of the box about it

}  // namespace

template <typename With>
void Canopy::for_each_cell(const Box& box, const With& with) {
    const glm::vec2 size{kColumns, kRows};
    const glm::vec2 low = (0.5F + 0.5F * box.low) * size;
    const glm::vec2 high = (0.5F + 0.5F * box.high) * size;
    const int first_x = std::max(static_cast<int>(std::floor(low.x)), 0);
    const int first_y = std::max(static_cast<int>(std::floor(low.y)), 0);
    const int last_x = std::min(static_cast<int>(std::floor(high.x)), kColumns - 1);
    const int last_y = std::min(static_cast<int>(std::floor(high.y)), kRows - 1);
    for (int y = first_y; y <= last_y; ++y) {
        const auto row = static_cast<float>(y);
        const float part_y = std::min(high.y, row + 1) - std::max(low.y, row);
        for (int x = first_x; x <= last_x; ++x) {
            const auto column = static_cast<float>(x);
            const float part_x = std::min(high.x, column + 1) - std::max(low.x, column);
            with(static_cast<std::size_t>(y * kColumns + x), std::max(part_x * part_y, 0.0F));
        }
    }
}

float Canopy::seen(const Box& box) const {
    // What is smaller than a cell asks about a cell's size, so that it does not jump from one to the next.
    const glm::vec2 least{1.0F / kColumns, 1.0F / kRows};
    const glm::vec2 middle = 0.5F * (box.low + box.high);
    const glm::vec2 half = glm::max(0.5F * (box.high - box.low), least);
    float seen = 0;
    float of = 0;
    for_each_cell({middle - half, middle + half}, [&](std::size_t cell, float part) {
        seen += part * left_[cell];
        of += part;
    });
    return of > 0 ? seen / of : 1;
}

void Canopy::add(const Box& box, float opacity) {
    for_each_cell(box, [&](std::size_t cell, float part) { left_[cell] *= 1 - opacity * kEllipse * part; });
}

}  // namespace quadrat::render::choose
