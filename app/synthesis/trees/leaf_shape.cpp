// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/leaf_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "synthesis/trees/inhibition.hpp"

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

// Around the rim, in the order of the outline.
void set_single(LeafShape& shape) {
    const auto count = static_cast<float>(shape.outline.size());
    for (std::size_t k = 0; k < shape.outline.size(); ++k) {
        const glm::vec2 p = shape.outline[k];
        const float turn = 6.2831853F * static_cast<float>(k) / count;
        shape.on_blade.push_back({2 * std::abs(p.y), p.x});
        shape.disc.push_back({std::cos(turn), std::sin(turn)});
    }
}

LeafShape unfold(const Half& half) {
    LeafShape shape;
    const auto n = static_cast<std::uint32_t>(half.points.size());
    shape.width = half.width;
    shape.arch = half.arch;
    shape.outline.push_back({0, 0});
    for (const glm::vec2& p : half.points) shape.outline.push_back(p);
    shape.outline.push_back({1, 0});
    for (std::uint32_t k = n; k-- > 0;) shape.outline.push_back({half.points[k].x, -half.points[k].y});
    for (const glm::vec2& p : shape.outline)
        shape.lightness.push_back(0.74F + 0.42F * p.x + 0.14F * (p.y < 0 ? -p.y : p.y));
    const auto other = [n](std::uint32_t v) { return v == 0 || v == n + 1 ? v : 2 * (n + 1) - v; };
    const auto add = [&](std::vector<std::uint32_t>& to, const std::array<std::uint32_t, 3>& t) {
        to.insert(to.end(), {t[0], t[2], t[1]});
        to.insert(to.end(), {other(t[0]), other(t[1]), other(t[2])});
    };
    for (const auto& t : half.triangles) add(shape.triangles, t);
    add(shape.plain, {0, half.widest[0], n + 1});
    set_single(shape);
    return shape;
}

// Leaves of two triangles along a twig, a pair at a time, and one at its tip.
struct Twig {
    int pairs = 2;
    float first = 0.10F;       // where the lowest pair stands, of the twig's length
    float leaf_length = 0.5F;  // of a leaf, to the spray's
    float leaf_width = 0.24F;  // likewise
    float widest = 0.45F;      // where a leaf is widest, of its length
    float angle_rad = 0.95F;   // between a leaf and the twig
    float width = 0.8F;        // of the spray, to its length
    float arch = 0.14F;
};

void add_leaflet(LeafShape& shape, const Twig& twig, glm::vec2 foot, float angle_rad, float length, float turn_rad) {
    const auto first = static_cast<std::uint32_t>(shape.outline.size());
    const glm::vec2 along{std::cos(angle_rad), std::sin(angle_rad)};
    const glm::vec2 aside{-along.y, along.x};
    const float half = 0.5F * twig.leaf_width * length / twig.leaf_length;
    const glm::vec2 middle = foot + twig.widest * length * along;
    for (const glm::vec2& p : {foot, middle - half * aside, foot + length * along, middle + half * aside})
        shape.outline.push_back({p.x, p.y / twig.width});
    shape.on_blade.insert(shape.on_blade.end(), {{0, 0}, {1, twig.widest}, {0, 1}, {1, twig.widest}});
    const float half_turn = 3.14159265F / static_cast<float>(2 * twig.pairs + 1);
    shape.disc.push_back({0, 0});
    for (const float off : {-half_turn, 0.0F, half_turn})
        shape.disc.push_back({std::cos(turn_rad + off), std::sin(turn_rad + off)});
    // A flower each: the first in the middle, the others about it.
    constexpr float kFlower = 0.42F;
    const glm::vec2 way{std::cos(turn_rad), std::sin(turn_rad)};
    const glm::vec2 at = first == 0 ? glm::vec2{0} : (1.05F - kFlower) * way;
    for (const glm::vec2& p : {-way, glm::vec2{way.y, -way.x}, way, glm::vec2{-way.y, way.x}})
        shape.cluster.push_back(at + kFlower * p);
    const float light = 0.76F + 0.36F * foot.x;  // the youngest leaves are the lightest
    shape.lightness.insert(shape.lightness.end(), {0.78F * light, light, 1.18F * light, light});
    for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) shape.triangles.push_back(first + k);
}

// The same leaves where the shoot's own pattern has them: across the twig they show their whole length, toward and away
// from its upper side they stand on end.
LeafShape arranged_as_wide(const Twig& twig, float inhibition) {
    LeafShape shape;
    shape.width = twig.width;
    shape.arch = twig.arch;
    const int laterals = 2 * twig.pairs;
    const float reach = 1 - twig.leaf_length;
    add_leaflet(shape, twig, {reach, 0}, 0, twig.leaf_length, 0);
    shape.lift.assign(shape.outline.size(), 0);
    const std::vector<Primordium> leaves = leaves_of_shoot(inhibition, laterals);
    const float longest = std::max(leaves.front().below, 1.0e-3F);
    for (int k = 0; k < laterals; ++k) {
        const Primordium& leaf = leaves[static_cast<std::size_t>(k)];
        // The oldest lies in the spray's plane, the youngest stand at the foot of the one at its tip.
        const float turn = leaf.turn_rad - leaves.front().turn_rad;
        const float share = 1 - leaf.below / longest;
        const float at = twig.first + share * (reach - twig.first) * 0.9F;
        const float open = twig.angle_rad - 0.25F * share;
        const float side = std::cos(turn);
        const float up = std::sin(turn);
        const float length = twig.leaf_length * (1.0F - 0.12F * share);
        const std::size_t before = shape.outline.size();
        const float in_plane = std::atan2(std::sin(open) * side, std::cos(open));
        const float shown = std::hypot(std::sin(open) * side, std::cos(open));
        add_leaflet(shape, twig, {at, 0}, in_plane, length * std::max(shown, 0.45F),
                    6.2831853F * static_cast<float>(k + 1) / static_cast<float>(laterals + 1));
        const float high = 0.8F * length * std::sin(open) * up;
        for (std::size_t v = before; v < shape.outline.size(); ++v) {
            const std::size_t corner = v - before;
            shape.lift.push_back(corner == 0 ? 0 : corner == 2 ? high : 0.5F * high);
        }
    }
    return shape;
}

LeafShape spray_of(const Twig& twig) {
    LeafShape shape;
    shape.width = twig.width;
    shape.arch = twig.arch;
    const int leaves = 2 * twig.pairs + 1;
    int number = 0;
    const auto turn = [&] { return 6.2831853F * static_cast<float>(number++) / static_cast<float>(leaves); };
    const float reach = 1 - twig.leaf_length;
    add_leaflet(shape, twig, {reach, 0}, 0, twig.leaf_length, turn());
    for (int pair = 0; pair < twig.pairs; ++pair) {
        const float share = static_cast<float>(pair) / static_cast<float>(twig.pairs);
        const float at = twig.first + share * (reach - twig.first) + 0.04F;
        for (const float side : {-1.0F, 1.0F}) {
            // The two of a pair stand a little apart, as most leaves do.
            const glm::vec2 foot{at + 0.05F * side, 0};
            add_leaflet(shape, twig, foot, side * (twig.angle_rad - 0.25F * share),
                        twig.leaf_length * (1.0F - 0.12F * share), turn());
        }
    }
    return shape;
}

float area_of(const LeafShape& shape) {
    float sum = 0;
    for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
        const glm::vec2 a = shape.outline[shape.triangles[t + 1]] - shape.outline[shape.triangles[t]];
        const glm::vec2 b = shape.outline[shape.triangles[t + 2]] - shape.outline[shape.triangles[t]];
        sum += 0.5F * std::abs(a.x * b.y - a.y * b.x);
    }
    return sum;
}

// Leaves on end cover less: wider ones make up for it, or every crown would be thinner.
LeafShape arranged(const Twig& twig, float inhibition) {
    Twig wider = twig;
    wider.leaf_width *= std::clamp(area_of(spray_of(twig)) / area_of(arranged_as_wide(twig, inhibition)), 1.0F, 2.0F);
    return arranged_as_wide(wider, inhibition);
}

// The twig itself, a sliver that tapers to where the last leaf stands: without it a spray would float beside its limb.
void add_twig(LeafShape& shape, const Twig& twig) {
    constexpr float kHalf = 0.012F;  // to the spray's length
    constexpr float kBark = 0.5F;
    const auto first = static_cast<std::uint32_t>(shape.outline.size());
    for (const glm::vec2& p : {glm::vec2{0, -kHalf}, glm::vec2{0, kHalf}, glm::vec2{1 - twig.leaf_length, 0}}) {
        shape.outline.push_back({p.x, p.y / twig.width});
        shape.on_blade.push_back({0, p.x});
        shape.disc.push_back({0, 0});
        shape.cluster.push_back({0, 0});
        shape.lightness.push_back(kBark);
    }
    shape.twig_foot = {first, first + 1};
    shape.triangles.insert(shape.triangles.end(), {first, first + 1, first + 2});
}

// From afar a spray is three leaves of a triangle each that cover as much, about a gap: each shares its corners with
// its neighbours, six vertices in all.
LeafShape with_plain_form(LeafShape shape, const Twig& twig) {
    // The corners of the gap lie on a circle, and the tips between them on a wider one; both are then sized to cover as
    // much as the spray does.
    constexpr float kGap = 0.42F;
    constexpr float kTurn_rad = 2.0943951F;
    constexpr glm::vec2 kMiddle{0.52F, 0};
    const float wanted = area_of(shape) * shape.width;
    // Each leaf: a side of the gap times what the tip stands over it, halved.
    const float unit_area = 3 * 0.5F * (1.7320508F * kGap) * (1 - 0.5F * kGap);
    const float size = std::sqrt(wanted / unit_area);
    add_twig(shape, twig);
    const auto first = static_cast<std::uint32_t>(shape.outline.size());
    for (std::uint32_t k = 0; k < 3; ++k) {
        const float turn = kTurn_rad * static_cast<float>(k);
        for (const bool is_tip : {false, true}) {
            const float at = is_tip ? turn : turn - 0.5F * kTurn_rad;
            const glm::vec2 p = kMiddle + size * (is_tip ? 1.0F : kGap) * glm::vec2{std::cos(at), std::sin(at)};
            shape.outline.push_back({p.x, p.y / shape.width});
            shape.on_blade.push_back(is_tip ? glm::vec2{0, 1} : glm::vec2{1, 0.1F});
            shape.lightness.push_back(is_tip ? 1.24F : 0.80F);
            // A disc's is a star about it.
            shape.disc.push_back((is_tip ? 1.3F : 0.75F) * glm::vec2{std::cos(at), std::sin(at)});
            shape.cluster.push_back(shape.disc.back());
        }
    }
    shape.plain.clear();
    for (std::uint32_t k = 0; k < 3; ++k)
        shape.plain.insert(shape.plain.end(), {first + 2 * k, first + 2 * k + 1, first + (2 * k + 2) % 6});
    return shape;
}

// A bough of needles: teeth along a rib, each a triangle.
LeafShape bough_of(int teeth, float width, float arch) {
    LeafShape shape;
    shape.width = width;
    shape.arch = arch;
    const auto n = static_cast<std::uint32_t>(teeth);
    for (std::uint32_t k = 0; k <= n; ++k) {
        shape.outline.push_back({static_cast<float>(k) / static_cast<float>(n), 0});
        shape.lightness.push_back(0.80F + 0.05F * static_cast<float>(k));
    }
    for (std::uint32_t k = 0; k < n; ++k) {
        const float x = (static_cast<float>(k) + 0.5F) / static_cast<float>(n);
        const float reach = 0.5F * std::sqrt(1.05F - x * x * 0.9F) * (k == 0 ? 0.8F : 1.0F);
        for (const float side : {1.0F, -1.0F}) {
            const auto v = static_cast<std::uint32_t>(shape.outline.size());
            shape.outline.push_back({std::min(x + 0.22F, 1.02F), side * reach});
            shape.lightness.push_back(1.16F);
            if (side > 0)
                shape.triangles.insert(shape.triangles.end(), {k, k + 1, v});
            else
                shape.triangles.insert(shape.triangles.end(), {k, v, k + 1});
        }
    }
    const std::uint32_t wide = n + 1 + 2 * (n / 3);
    shape.plain = {0, n, wide, 0, wide + 1, n};
    set_single(shape);
    return shape;
}

std::optional<Twig> twig_of(LeafKind kind) {
    switch (kind) {
        case LeafKind::Ovate:
            return Twig{};
        case LeafKind::Lance:
            return Twig{2, 0.06F, 0.56F, 0.13F, 0.42F, 0.62F, 0.62F, 0.18F};
        case LeafKind::Round:
            return Twig{2, 0.12F, 0.42F, 0.33F, 0.5F, 1.05F, 0.8F, 0.10F};
        case LeafKind::Lobed:
            return Twig{2, 0.14F, 0.46F, 0.30F, 0.6F, 0.85F, 0.8F, 0.12F};
        case LeafKind::Palmate:
            return Twig{2, 0.34F, 0.58F, 0.24F, 0.6F, 1.2F, 1.05F, 0.12F};
        case LeafKind::Heart:
            return Twig{2, 0.14F, 0.44F, 0.34F, 0.34F, 0.95F, 0.82F, 0.16F};
        case LeafKind::Feather:
            return Twig{3, 0.10F, 0.36F, 0.13F, 0.5F, 1.05F, 0.6F, 0.18F};
        default:
            return {};
    }
}

std::vector<LeafShape> make_sprays() {
    std::vector<LeafShape> sprays;
    for (int kind = 0; kind < kLeafKinds; ++kind) sprays.push_back(leaf_shape(static_cast<LeafKind>(kind)));
    for (int kind = 0; kind < kLeafKinds; ++kind)
        if (const auto twig = twig_of(static_cast<LeafKind>(kind)))
            sprays[static_cast<std::size_t>(kind)] = with_plain_form(spray_of(*twig), *twig);
    sprays[static_cast<std::size_t>(LeafKind::Needles)] = bough_of(5, 0.44F, 0.16F);
    return sprays;
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
    set_single(frond);
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

const LeafShape& spray_shape(LeafKind kind) {
    static const std::vector<LeafShape> kSprays = make_sprays();
    return kSprays[static_cast<std::size_t>(kind)];
}

const LeafShape& sliver_shape() {
    static const LeafShape kSliver = [] {
        LeafShape shape;
        shape.outline = {{0, -0.5F}, {0, 0.5F}, {1, 0}};
        shape.on_blade = {{0, 0}, {0, 0}, {0, 1}};
        shape.disc = {{-0.5F, -0.8F}, {-0.5F, 0.8F}, {1, 0}};
        shape.lightness = {1, 1, 1};
        shape.triangles = shape.plain = {0, 1, 2};
        return shape;
    }();
    return kSliver;
}

LeafShape spray_shape(LeafKind kind, float inhibition) {
    const std::optional<Twig> twig = twig_of(kind);
    if (!twig) return spray_shape(kind);
    LeafShape shape = with_plain_form(arranged(*twig, inhibition), *twig);
    shape.lift.resize(shape.outline.size(), 0);  // the plain form is flat
    return shape;
}

}  // namespace quadrat::synthesis::trees
