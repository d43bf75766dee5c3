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

// By the corner, edge or face whose region the point lies in (Ericson 2005, Real-Time Collision Detection, 5.1.5). In
// double: areas are differences of products, and of a sliver nothing would be left of them.
glm::vec3 nearest_on_triangle(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double ab_a = glm::dot(ab, p - a);
    const double ac_a = glm::dot(ac, p - a);
    if (ab_a <= 0 && ac_a <= 0) return a;
    const double ab_b = glm::dot(ab, p - b);
    const double ac_b = glm::dot(ac, p - b);
    if (ab_b >= 0 && ac_b <= ab_b) return b;
    const double over_c = ab_a * ac_b - ab_b * ac_a;
    if (over_c <= 0 && ab_a >= 0 && ab_b <= 0) return ab_a > ab_b ? a + ab * (ab_a / (ab_a - ab_b)) : a;
    const double ab_c = glm::dot(ab, p - c);
    const double ac_c = glm::dot(ac, p - c);
    if (ac_c >= 0 && ab_c <= ac_c) return c;
    const double over_b = ab_c * ac_a - ab_a * ac_c;
    if (over_b <= 0 && ac_a >= 0 && ac_c <= 0) return ac_a > ac_c ? a + ac * (ac_a / (ac_a - ac_c)) : a;
    const double over_a = ab_b * ac_c - ab_c * ac_b;
    const double to_c = ac_b - ab_b;
    const double to_b = ab_c - ac_c;
    if (over_a <= 0 && to_c >= 0 && to_b >= 0) return to_c + to_b > 0 ? b + (c - b) * (to_c / (to_c + to_b)) : b;
    const double all = over_a + over_b + over_c;
    if (!(all > 0)) return a;
    // A sliver far away leaves rounding errors: the point is never off the triangle.
    const double of_b = glm::clamp(over_b / all, 0.0, 1.0);
    return a + ab * of_b + ac * glm::clamp(over_c / all, 0.0, 1 - of_b);
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

float Nearness::distance_m(glm::vec3 from_m) const {
    return boxes_.empty() ? std::numeric_limits<float>::infinity() : nearest(from_m).distance_m;
}

Nearness::Nearest Nearness::on(std::uint32_t triangle, glm::vec3 p) const {
    const std::uint32_t* corner = &mesh_.indices[3 * std::size_t{triangle}];
    const glm::vec3 at_m = nearest_on_triangle(p, mesh_.positions_m[corner[0]], mesh_.positions_m[corner[1]],
                                               mesh_.positions_m[corner[2]]);
    return {at_m, squared(p - at_m), triangle};
}

Nearness::Nearest Nearness::nearest(glm::vec3 p, std::uint32_t guess, float slack) const {
    const float slack2 = (1 + slack) * (1 + slack);
    Nearest best = on(guess, p);
    struct Waiting {
        std::size_t box;
        float least;
    };
    std::array<Waiting, 64> stack{};
    std::size_t depth = 0;
    stack[depth++] = {0, 0};
    while (depth > 0) {
        const Waiting next = stack[--depth];
        if (next.least * slack2 >= best.distance_m) continue;
        const Box& box = boxes_[next.box];
        for (std::uint32_t i = box.first; i < box.first + box.count; ++i) {
            const Nearest other = on(order_[i], p);
            if (other.distance_m < best.distance_m) best = other;
        }
        if (box.count > 0) continue;
        Waiting near{next.box + 1, squared_to_box(p, boxes_[next.box + 1].low, boxes_[next.box + 1].high)};
        Waiting far{box.first, squared_to_box(p, boxes_[box.first].low, boxes_[box.first].high)};
        if (far.least < near.least) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
    best.distance_m = std::sqrt(best.distance_m);
    return best;
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
