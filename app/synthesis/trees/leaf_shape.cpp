// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/leaf_shape.hpp"

#include <array>
#include <span>

namespace quadrat::synthesis::trees {
namespace {

// From a side's points between foot and tip, each x along and y across, 0 to 1/2. Triangles of one side name foot as 0,
// the points as 1 to n and the tip as n + 1.
struct Half {
    std::vector<glm::vec2> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::array<std::uint32_t, 1> widest{1};  // the point that the plain form keeps
    float width = 0.5F;
    float arch = 0.1F;
};

LeafShape unfold(const Half& half) {
    LeafShape shape;
    const auto n = static_cast<std::uint32_t>(half.points.size());
    shape.width = half.width;
    shape.arch = half.arch;
    shape.tip = n + 1;
    shape.outline.push_back({0, 0});
    for (const glm::vec2& p : half.points) shape.outline.push_back(p);
    shape.outline.push_back({1, 0});
    for (std::uint32_t k = n; k-- > 0;) shape.outline.push_back({half.points[k].x, -half.points[k].y});
    for (const glm::vec2& p : shape.outline)
        shape.lightness.push_back(0.90F + 0.16F * p.x + 0.10F * (p.y < 0 ? -p.y : p.y));
    const auto other = [n](std::uint32_t v) { return v == 0 || v == n + 1 ? v : 2 * (n + 1) - v; };
    const auto add = [&](std::vector<std::uint32_t>& to, const std::array<std::uint32_t, 3>& t) {
        to.insert(to.end(), {t[0], t[2], t[1]});
        to.insert(to.end(), {other(t[0]), other(t[1]), other(t[2])});
    };
    for (const auto& t : half.triangles) add(shape.triangles, t);
    add(shape.plain, {0, half.widest[0], n + 1});
    return shape;
}

std::vector<LeafShape> make_shapes() {
    const std::vector<std::array<std::uint32_t, 3>> one{{0, 1, 2}};
    const std::vector<std::array<std::uint32_t, 3>> two{{0, 1, 2}, {0, 2, 3}};
    const std::vector<std::array<std::uint32_t, 3>> notched{{0, 1, 2}, {0, 2, 4}, {2, 3, 4}};
    const std::vector<std::array<std::uint32_t, 3>> comb{{0, 1, 2}, {0, 2, 4}, {2, 3, 4}, {0, 4, 5}};
    std::vector<LeafShape> shapes;
    shapes.push_back(unfold({{{0.24F, 0.40F}, {0.60F, 0.44F}}, two, {2}, 0.50F, 0.12F}));
    shapes.push_back(unfold({{{0.42F, 0.5F}}, one, {1}, 0.26F, 0.16F}));
    shapes.push_back(unfold({{{0.18F, 0.44F}, {0.74F, 0.48F}}, two, {2}, 0.82F, 0.08F}));
    shapes.push_back(unfold({{{0.30F, 0.38F}, {0.44F, 0.16F}, {0.74F, 0.50F}}, notched, {3}, 0.62F, 0.12F}));
    shapes.push_back(unfold({{{0.10F, 0.50F}, {0.34F, 0.20F}, {0.62F, 0.50F}}, notched, {3}, 1.0F, 0.10F}));
    shapes.push_back(unfold({{{0.46F, 0.50F}, {0.40F, 0.15F}}, two, {1}, 0.40F, 0.10F}));
    shapes.push_back(unfold({{{0.06F, 0.42F}, {0.44F, 0.46F}}, two, {2}, 0.86F, 0.14F}));
    shapes.push_back(
        unfold({{{0.26F, 0.46F}, {0.38F, 0.10F}, {0.66F, 0.50F}, {0.76F, 0.12F}}, comb, {3}, 0.50F, 0.22F}));
    // A frond: seven leaflets a side that hang from a rib.
    LeafShape frond;
    frond.width = 0.42F;
    frond.arch = 0.55F;
    constexpr std::uint32_t kLeaflets = 6;
    for (std::uint32_t k = 0; k <= kLeaflets; ++k) {
        frond.outline.push_back({static_cast<float>(k) / static_cast<float>(kLeaflets), 0});
        frond.lightness.push_back(0.86F + 0.03F * static_cast<float>(k));
    }
    frond.tip = kLeaflets;
    for (std::uint32_t k = 0; k < kLeaflets; ++k) {
        const float x = (static_cast<float>(k) + 0.9F) / static_cast<float>(kLeaflets);
        const float reach = 0.5F * (1.0F - 0.55F * x * x) * (k == 0 ? 0.7F : 1.0F);
        for (const float side : {1.0F, -1.0F}) {
            const auto v = static_cast<std::uint32_t>(frond.outline.size());
            frond.outline.push_back({x + 0.12F, side * reach});
            frond.lightness.push_back(1.08F);
            if (side > 0)
                frond.triangles.insert(frond.triangles.end(), {k, k + 1, v});
            else
                frond.triangles.insert(frond.triangles.end(), {k, v, k + 1});
        }
    }
    const std::uint32_t wide = kLeaflets + 1 + 2 * 2;
    frond.plain = {0, kLeaflets / 2, wide,          kLeaflets / 2, kLeaflets, wide,
                   0, wide + 1,      kLeaflets / 2, kLeaflets / 2, wide + 1,  kLeaflets};
    shapes.push_back(frond);
    LeafShape spines =
        unfold({{{0.30F, 0.50F}, {0.26F, 0.10F}, {0.62F, 0.34F}, {0.50F, 0.06F}}, comb, {1}, 0.7F, -0.05F});
    shapes.push_back(spines);
    return shapes;
}

}  // namespace

const LeafShape& leaf_shape(LeafKind kind) {
    static const std::vector<LeafShape> kShapes = make_shapes();
    return kShapes[static_cast<std::size_t>(kind)];
}

}  // namespace quadrat::synthesis::trees
