// SPDX-License-Identifier: Apache-2.0
// What two shapes have in common is what lies in both, whichever is named first; or it is said that it cannot be told.
#include "mesh/clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <optional>

#include "mesh/plan_check.hpp"
#include "support/plans.hpp"

namespace mesh = quadrat::mesh;

namespace {

using quadrat::tests::Loop;
using Loops = std::vector<Loop>;

// Nothing if it is no plan.
std::optional<Loops> shape_of(const std::uint8_t* data, std::size_t size, glm::dvec2 moved) {
    const mesh::Plan plan = quadrat::tests::plan_of_bytes(data, size, 0.37);
    try {
        const mesh::CheckedPlan plain = mesh::checked(plan);
        Loops loops;
        for (const std::vector<int>& points : plain.loops) {
            Loop& turned = loops.emplace_back();
            for (const int p : points) turned.push_back(plain.metres(static_cast<std::size_t>(p)) + moved);
        }
        return loops;
    } catch (const mesh::PlanError&) {
        return std::nullopt;
    }
}

double distance_to(const Loops& loops, glm::dvec2 at) {
    double nearest = 1e300;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 along = loop[(i + 1) % loop.size()] - loop[i];
            const double t =
                std::clamp(glm::dot(at - loop[i], along) / std::max(glm::dot(along, along), 1e-300), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(at, loop[i] + t * along));
        }
    return nearest;
}

double area_of(const Loops& loops) {
    double area = 0;
    for (const Loop& loop : loops) area += mesh::signed_area(loop);
    return area;
}

void check(const Loops& a, const Loops& b, const Loops& common) {
    double size = 1;
    for (const Loops* loops : {&a, &b})
        for (const Loop& loop : *loops)
            for (const glm::dvec2 p : loop) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    const double area = area_of(common);
    const double rounding = 1e-7 * size * size;
    if (area < -rounding || area > std::min(area_of(a), area_of(b)) + rounding) std::abort();
    // Points beside the corners of all, and between them.
    std::vector<glm::dvec2> asked;
    for (const Loops* loops : {&a, &b, &common})
        for (const Loop& loop : *loops)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                asked.push_back(loop[i] + 1e-4 * size * glm::dvec2{0.6, 0.8});
                asked.push_back(0.5 * (loop[i] + loop[(i + 2) % loop.size()]));
            }
    for (const glm::dvec2 at : asked) {
        if (std::min({distance_to(a, at), distance_to(b, at), distance_to(common, at)}) < 1e-6 * size) continue;
        if (mesh::is_inside(common, at) != (mesh::is_inside(a, at) && mesh::is_inside(b, at))) std::abort();
    }
}

}  // namespace

// A byte for how many points the first shape has and one for how far the second is moved.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 26 || size > 400) return 0;
    const std::size_t first = std::min<std::size_t>(4U * data[0], size - 2);
    const double moved = data[1] / 97.0;
    const auto a = shape_of(data + 2, first, {0, 0});
    const auto b = shape_of(data + 2 + first, size - 2 - first, {moved, 0.7 * moved});
    if (!a || !b) return 0;
    const auto common = mesh::common_area(*a, *b);
    const auto turned = mesh::common_area(*b, *a);
    if (common.has_value() != turned.has_value()) std::abort();
    if (!common) return 0;
    check(*a, *b, *common);
    check(*b, *a, *turned);
    double outlines = 0;
    for (const Loops& shape : mesh::sorted_into_shapes(*common)) {
        if (shape.empty() || mesh::signed_area(shape.front()) <= 0) std::abort();
        outlines += area_of(shape);
    }
    if (std::abs(outlines - area_of(*common)) > 1e-6 * (1 + std::abs(outlines))) std::abort();
    return 0;
}
