// SPDX-License-Identifier: Apache-2.0
// What a collapse costs and where it leads.
#include <algorithm>

#include "mesh/collapsing_mesh.hpp"

namespace quadrat::mesh {
namespace {

// A direction in which planes bend by less, of their weight, says nothing about where the vertex should be.
constexpr float kFlat = 1e-4F;
// Of a rim's own planes, against a surface of the same extent.
constexpr float kRimWeight = 4.0F;
// Of each vertex's own place, against its planes: where those are one plane, the short edges go first.
constexpr float kPointWeight = 1e-6F;
// Stands in for a divisor of nothing.
constexpr float kLeast = 1e-37F;

float squared(glm::vec3 v) { return glm::dot(v, v); }

}  // namespace

void CollapsingMesh::make_quadrics() {
    for (const std::uint32_t v : live_) {
        vertices_[v].quadric = {};
        vertices_[v].weight = 0;
    }
    for (const std::uint32_t v : live_) add_planes(v);
    if (places_.empty()) return;
    for (const std::uint32_t v : live_)
        if (kind(v) != Kind::Free) add_rim_planes(v);
    for (const std::uint32_t v : live_)
        if (vertices_[v].twin != v && places_[v] == v) share_quadric(v);
}

// Of the triangles whose first corner this is, at all three.
void CollapsingMesh::add_planes(std::uint32_t v) {
    Vertex& a = vertices_[v];
    for (const Edge& e : around(v)) {
        if (e.from < v || e.to < v) continue;
        Vertex& b = vertices_[e.from];
        Vertex& c = vertices_[e.to];
        const glm::vec3 n = glm::cross(b.at - a.at, c.at - a.at);
        const float twice = glm::length(n);
        if (!(twice > 0)) continue;
        Quadric plane;
        plane.add_plane(n / twice, twice);
        plane.add_point(kPointWeight * twice);
        for (Vertex* corner : {&a, &b, &c}) {
            corner->quadric += plane;
            corner->weight += twice;
        }
    }
}

// Planes that stand on the rim, so that it keeps its course.
void CollapsingMesh::add_rim_planes(std::uint32_t v) {
    const auto ring = around(v);
    const glm::vec3 at = vertices_[v].at;
    for (const Edge& e : ring) {
        const glm::vec3 from = vertices_[e.from].at;
        const glm::vec3 to = vertices_[e.to].at;
        const glm::vec3 normal = glm::cross(from - at, to - at);
        const auto stand_on = [&](glm::vec3 edge) {
            const glm::vec3 across = glm::cross(edge, normal);
            const float length = glm::length(across);
            if (length > 0) vertices_[v].quadric.add_plane(across / length, kRimWeight * glm::dot(edge, edge));
        };
        if (!ring.has_to(e.from)) stand_on(from - at);
        if (!ring.has_from(e.to)) stand_on(to - at);
    }
}

// One sum for all vertices at a place.
void CollapsingMesh::share_quadric(std::uint32_t v) {
    Quadric sum = vertices_[v].quadric;
    float weight = vertices_[v].weight;
    for (std::uint32_t o = vertices_[v].twin; o != v; o = vertices_[o].twin) {
        sum += vertices_[o].quadric;
        weight += vertices_[o].weight;
    }
    std::uint32_t o = v;
    do {
        vertices_[o].quadric = sum;
        vertices_[o].weight = weight;
        o = vertices_[o].twin;
    } while (o != v);
}

// Four at a time, as processors like it: collapse_of() with one step.
CollapsingMesh::Four CollapsingMesh::costs_of(const Vertex& from, const std::array<const Vertex*, 4>& into) const {
    const auto each = [&](const auto& member) {
        return Four{member(*into[0]), member(*into[1]), member(*into[2]), member(*into[3])};
    };
    const auto larger = [](Four a, Four b) { return a > b ? a : b; };
    const Four none{0, 0, 0, 0};
    const Four one{1, 1, 1, 1};
    const Quadric& u = from.quadric;
    const Four x = each([](const Vertex& v) { return v.at.x; }) - from.at.x;
    const Four y = each([](const Vertex& v) { return v.at.y; }) - from.at.y;
    const Four z = each([](const Vertex& v) { return v.at.z; }) - from.at.z;
    const Four xx = each([](const Vertex& v) { return v.quadric.xx; });
    const Four yy = each([](const Vertex& v) { return v.quadric.yy; });
    const Four zz = each([](const Vertex& v) { return v.quadric.zz; });
    const Four xy = each([](const Vertex& v) { return v.quadric.xy; });
    const Four xz = each([](const Vertex& v) { return v.quadric.xz; });
    const Four yz = each([](const Vertex& v) { return v.quadric.yz; });
    const Four bx = each([](const Vertex& v) { return v.quadric.b.x; });
    const Four by = each([](const Vertex& v) { return v.quadric.b.y; });
    const Four bz = each([](const Vertex& v) { return v.quadric.b.z; });
    const Four c = each([](const Vertex& v) { return v.quadric.c; });
    const Four weight = each([](const Vertex& v) { return v.weight; }) + from.weight;
    // Each quadric's A times the edge, then along it.
    const Four ux = u.xx * x + u.xy * y + u.xz * z;
    const Four uy = u.xy * x + u.yy * y + u.yz * z;
    const Four uz = u.xz * x + u.yz * y + u.zz * z;
    const Four vx = xx * x + xy * y + xz * z;
    const Four vy = xy * x + yy * y + yz * z;
    const Four vz = xz * x + yz * y + zz * z;
    const Four of_v = x * vx + y * vy + z * vz;
    const Four slope_v = x * bx + y * by + z * bz;
    const Four square = x * ux + y * uy + z * uz + of_v;
    const Four linear = x * u.b.x + y * u.b.y + z * u.b.z + slope_v - of_v;
    const Four best = -linear / larger(square, none + kLeast);
    const Four t = larger(none, best < one ? best : one);
    // The slope there, and how far down it goes that way.
    const Four gx = t * ux + u.b.x + (t - 1.0F) * vx + bx;
    const Four gy = t * uy + u.b.y + (t - 1.0F) * vy + by;
    const Four gz = t * uz + u.b.z + (t - 1.0F) * vz + bz;
    const Four sx = (u.xx + xx) * gx + (u.xy + xy) * gy + (u.xz + xz) * gz;
    const Four sy = (u.xy + xy) * gx + (u.yy + yy) * gy + (u.yz + yz) * gz;
    const Four sz = (u.xz + xz) * gx + (u.yz + yz) * gy + (u.zz + zz) * gz;
    const Four slope2 = gx * gx + gy * gy + gz * gz;
    const Four bend = larger(gx * sx + gy * sy + gz * sz, kFlat * weight * slope2 + kLeast);
    const float fit = is_fitted_ ? 1.0F : 0.0F;
    const Four constant = u.c + c + of_v - 2.0F * slope_v;
    return larger(none, constant + t * (2.0F * linear + t * square) - fit * slope2 * slope2 / bend);
}

void CollapsingMesh::enqueue(std::uint32_t v, Which which) {
    const auto ring = around(v);
    const Kind own = kind(v);
    const Vertex& from = vertices_[v];
    std::array<std::uint32_t, 4> targets{};
    std::array<const Vertex*, 4> into{&from, &from, &from, &from};
    std::size_t count = 0;
    const auto price = [&] {
        const auto costs = costs_of(from, into);
        for (std::size_t i = 0; i < count; ++i)
            queue_.push({v, targets[i], versions_[v] + versions_[targets[i]]}, costs[i]);
        count = 0;
    };
    const auto offer = [&](std::uint32_t target) {
        if (which == Which::Later && target < v) return;
        const Kind other = kind(target);
        if (own != other) {  // the freer one joins the other, where that is
            const bool is_turned = own > other;
            const float cost =
                is_turned ? collapse_of(vertices_[target], from, 0).cost : collapse_of(from, vertices_[target], 0).cost;
            queue_.push({is_turned ? target : v, is_turned ? v : target, versions_[v] + versions_[target]}, cost);
            return;
        }
        targets[count] = target;
        into[count++] = &vertices_[target];
        if (count == 4) price();
    };
    for (const Edge& e : ring) offer(e.from);
    if (own != Kind::Free) {
        for (const Edge& e : ring)
            if (!ring.has_from(e.to)) offer(e.to);
    }
    if (count > 0) price();
}

CollapsingMesh::Collapse CollapsingMesh::collapse_of(const Vertex& from, const Vertex& into, int steps) const {
    const glm::vec3 edge = into.at - from.at;
    const OnLine line(from.quadric, into.quadric, edge);
    if (from.kind != into.kind) return {1, into.at, line.at(1)};
    const float along = line.least(0, 1);
    Collapse collapse{along, from.at + along * edge, line.at(along)};
    glm::vec3 slope = from.quadric.half_slope_at(along * edge) + into.quadric.half_slope_at((along - 1) * edge);
    glm::vec3 direction = slope;
    const float least_bend = kFlat * (from.weight + into.weight);
    for (int i = 0; i < steps; ++i) {
        const glm::vec3 turned = from.quadric.times_a(direction) + into.quadric.times_a(direction);
        const float bend = glm::dot(direction, turned);
        if (!(bend > least_bend * squared(direction))) break;
        const float slope2 = squared(slope);
        const float step = slope2 / bend;
        collapse.to -= step * direction;
        collapse.cost -= step * slope2;
        slope -= step * turned;
        direction = slope + squared(slope) / slope2 * direction;
    }
    collapse.cost = std::max(0.0F, collapse.cost);
    return collapse;
}

}  // namespace quadrat::mesh
