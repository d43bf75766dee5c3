// SPDX-License-Identifier: Apache-2.0
#include "mesh/nearness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace quadrat::mesh {
namespace {

constexpr std::uint32_t kLeaf = 4;

float squared(glm::vec3 v) { return glm::dot(v, v); }

glm::vec3 nearest_on_edge(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
    const glm::vec3 along = b - a;
    const float length2 = squared(along);
    return length2 > 0 ? a + glm::clamp(glm::dot(p - a, along) / length2, 0.0F, 1.0F) * along : a;
}

float squared_to_triangle(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::vec3 n = glm::cross(b - a, c - a);
    const float n2 = squared(n);
    const bool is_over = n2 > 0 && glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
                         glm::dot(glm::cross(c - b, p - b), n) >= 0 && glm::dot(glm::cross(a - c, p - c), n) >= 0;
    if (is_over) {
        const float height = glm::dot(p - a, n);
        return height * height / n2;
    }
    return std::min({squared(p - nearest_on_edge(p, a, b)), squared(p - nearest_on_edge(p, b, c)),
                     squared(p - nearest_on_edge(p, c, a))});
}

float squared_to_box(glm::vec3 p, glm::vec3 low, glm::vec3 high) { return squared(p - glm::clamp(p, low, high)); }

}  // namespace

Nearness::Nearness(const Mesh& mesh) : mesh_(mesh), order_(mesh.triangle_count()) {
    if (order_.empty()) return;
    std::iota(order_.begin(), order_.end(), 0U);
    std::vector<glm::vec3> middles(order_.size());
    for (std::size_t t = 0; t < middles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) middles[t] += mesh.positions_m[mesh.indices[3 * t + k]] / 3.0F;
    boxes_.push_back(bounded(0, static_cast<std::uint32_t>(order_.size())));
    split(0, middles);
}

Nearness::Box Nearness::bounded(std::uint32_t first, std::uint32_t count) const {
    Box box{glm::vec3{std::numeric_limits<float>::max()}, glm::vec3{std::numeric_limits<float>::lowest()}, first,
            count};
    for (std::uint32_t i = first; i < first + count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = mesh_.positions_m[mesh_.indices[3 * std::size_t{order_[i]} + k]];
            box.low = glm::min(box.low, p);
            box.high = glm::max(box.high, p);
        }
    }
    return box;
}

void Nearness::split(std::size_t at, std::span<const glm::vec3> middles) {
    const Box whole = boxes_[at];
    if (whole.count <= kLeaf) return;
    const glm::vec3 size = whole.high - whole.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = whole.count / 2;
    const auto first = order_.begin() + whole.first;
    std::nth_element(first, first + half, first + whole.count,
                     [&](std::uint32_t a, std::uint32_t b) { return middles[a][axis] < middles[b][axis]; });
    boxes_.push_back(bounded(whole.first, half));
    split(boxes_.size() - 1, middles);
    boxes_[at].first = static_cast<std::uint32_t>(boxes_.size());
    boxes_[at].count = 0;
    boxes_.push_back(bounded(whole.first + half, whole.count - half));
    split(boxes_.size() - 1, middles);
}

float Nearness::distance_m(glm::vec3 p) const {
    float best = std::numeric_limits<float>::infinity();
    if (boxes_.empty()) return best;
    struct Waiting {
        std::size_t box;
        float least;
    };
    std::array<Waiting, 64> stack{};
    std::size_t depth = 0;
    stack[depth++] = {0, 0};
    while (depth > 0) {
        const Waiting next = stack[--depth];
        if (next.least >= best) continue;
        const Box& box = boxes_[next.box];
        for (std::uint32_t i = box.first; i < box.first + box.count; ++i) {
            const std::size_t t = 3 * std::size_t{order_[i]};
            best = std::min(best, squared_to_triangle(p, mesh_.positions_m[mesh_.indices[t]],
                                                      mesh_.positions_m[mesh_.indices[t + 1]],
                                                      mesh_.positions_m[mesh_.indices[t + 2]]));
        }
        if (box.count > 0) continue;
        Waiting near{next.box + 1, squared_to_box(p, boxes_[next.box + 1].low, boxes_[next.box + 1].high)};
        Waiting far{box.first, squared_to_box(p, boxes_[box.first].low, boxes_[box.first].high)};
        if (far.least < near.least) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
    return std::sqrt(best);
}

Deviation deviation_of(const Mesh& coarse, const Mesh& exact) {
    double sum = 0;
    double most = 0;
    std::size_t count = 0;
    const auto measure = [&](const Mesh& from, const Nearness& to) {
        const auto add = [&](glm::vec3 at_m) {
            const double d = to.distance_m(at_m);
            sum += d * d;
            most = std::max(most, d);
            ++count;
        };
        for (const glm::vec3& p : from.positions_m) add(p);
        for (std::size_t i = 0; i + 2 < from.indices.size(); i += 3)
            add((from.positions_m[from.indices[i]] + from.positions_m[from.indices[i + 1]] +
                 from.positions_m[from.indices[i + 2]]) /
                3.0F);
    };
    measure(exact, Nearness(coarse));
    measure(coarse, Nearness(exact));
    return {count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count)), most};
}

float diagonal_m(const Mesh& mesh) {
    if (mesh.positions_m.empty()) return 0;
    glm::vec3 low = mesh.positions_m.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : mesh.positions_m) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return glm::distance(low, high);
}

}  // namespace quadrat::mesh
