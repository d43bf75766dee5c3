// SPDX-License-Identifier: Apache-2.0
// Garland & Heckbert, "Surface simplification using quadric error metrics" (1997), with the new vertex held on the line
// of the collapsed edge as in "Genetic selection of parametric scenes" (2003), section 6.2. Ours then leaves the line,
// by two steps of conjugate gradients, to where the quadric is less: an edge of a bent surface lies within it, and with
// it all that collapses onto the edge. Quadrics are summed up within a level only.
#include "mesh/collapsing_mesh.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::mesh {
namespace {

// No triangle's normal turns by more in one collapse: the square of the cosine.
constexpr float kLeastTurn2 = 0.04F;

float squared(glm::vec3 v) { return glm::dot(v, v); }

}  // namespace

CollapsingMesh::Ends CollapsingMesh::ends_of(std::uint32_t rim) const {
    Ends ends{rim, rim};
    const auto ring = around(rim);
    for (const Edge& e : ring) {
        if (!ring.has_to(e.from)) ends.first = e.from;
        if (!ring.has_from(e.to)) ends.last = e.to;
    }
    return ends;
}

// Each level is measured from the one before, as if that were exact: planes summed up over many levels say more and
// more about where the surface used to bend and less about where it is.
void CollapsingMesh::begin_level() {
    error_before_ = error_;
    make_quadrics();
    queue_.clear();
    for (const std::uint32_t v : live_) enqueue(v, Which::Later);
}

// Into the cache what the next collapses will touch, each thing once what leads to it is there. All of it inline: a
// function that does nothing else has no effect in a compiler's eyes, and gcc leaves out its calls.
[[gnu::always_inline]] inline void CollapsingMesh::fetch_ahead() const {
    const auto current = [&](std::size_t steps) __attribute__((always_inline)) {
        const CollapseQueue::Entry* e = queue_.ahead(steps);
        return e != nullptr && versions_[e->from] + versions_[e->into] == e->version ? e : nullptr;
    };
    if (const auto* e = queue_.ahead(24); e != nullptr) {
        __builtin_prefetch(&versions_[e->from]);
        __builtin_prefetch(&versions_[e->into]);
    }
    if (const auto* e = current(16); e != nullptr) {
        for (const std::uint32_t v : {e->from, e->into}) __builtin_prefetch(&rings_[v]);
    }
    if (const auto* e = current(12); e != nullptr) {
        for (const std::uint32_t v : {e->from, e->into}) {
            __builtin_prefetch(&fans_[rings_[v].first]);
            __builtin_prefetch(&vertices_[v]);
            __builtin_prefetch(channels_.data() + v * channels_a_vertex_);
        }
    }
    if (const auto* e = current(8); e != nullptr) {
        for (const std::uint32_t v : {e->from, e->into}) {
            for (const Edge& edge : around(v)) {
                __builtin_prefetch(&vertices_[edge.from]);
                __builtin_prefetch(&rings_[edge.from]);
                __builtin_prefetch(&versions_[edge.from]);
            }
        }
    }
    if (const auto* e = current(4); e != nullptr) {
        for (const std::uint32_t v : {e->from, e->into})
            for (const Edge& edge : around(v)) __builtin_prefetch(&fans_[rings_[edge.from].first]);
    }
}

bool CollapsingMesh::collapse_until(std::size_t vertices) {
    begin_level();
    CollapseQueue::Entry next;
    while (alive_ > vertices) {
        if (!queue_.pop(next)) return false;
        fetch_ahead();
        if (versions_[next.from] + versions_[next.into] != next.version) continue;
        try_collapse(next.from, next.into);
    }
    return true;
}

bool CollapsingMesh::try_collapse(std::uint32_t from, std::uint32_t into) {
    if (kind(from) == Kind::Fixed ||
        (kind(from) != Kind::Free && kind(into) != kind(from) && kind(into) != Kind::Fixed))
        return false;
    const Collapse collapse = collapse_of(vertices_[from], vertices_[into], is_fitted_ ? 2 : 0);
    const bool is_seam = kind(from) == Kind::Seam;
    const std::uint32_t twin = vertices_[from].twin;
    const std::uint32_t twin_into = is_seam ? twin_target(twin, into) : into;
    if (twin_into == kNone || !may_join(from, into, collapse.to)) return false;
    if (is_seam && !may_join(twin, twin_into, collapse.to)) return false;
    place(from, into, collapse);
    join(from, into);
    enqueue(into, Which::All);
    if (!is_seam) return true;
    join(twin, twin_into);
    enqueue(twin_into, Which::All);
    return true;
}

bool CollapsingMesh::may_join(std::uint32_t from, std::uint32_t into, glm::vec3 to) {
    if (!keeps_topology(from, into)) return false;
    if (!keeps_sides(from, into, to)) return false;
    return to == vertices_[into].at || keeps_sides(into, from, to);
}

// The link condition (Dey et al., "Topology preserving edge contraction", 1999): what both are joined to are the far
// corners of the triangles that they share, and those have triangles left.
bool CollapsingMesh::keeps_topology(std::uint32_t from, std::uint32_t into) const {
    if (!places_.empty() && !keeps_topology_of_places(from, into)) return false;
    const auto ring = around(from);
    const auto other = around(into);
    const bool is_free = kind(from) == Kind::Free;
    const bool is_other_free = kind(into) == Kind::Free;
    const auto is_next_to_both = [&](std::uint32_t v) {
        return other.has_from(v) || (!is_other_free && other.has_to(v)) ? 1U : 0U;
    };
    std::uint32_t shared = 0;
    std::uint32_t common = 0;
    bool keeps = true;
    for (const Edge& e : ring) {
        common += is_next_to_both(e.from);
        if (!is_free && !ring.has_from(e.to)) common += is_next_to_both(e.to);
        if (e.from != into && e.to != into) continue;
        ++shared;
        const std::uint32_t across = e.from == into ? e.to : e.from;
        keeps = keeps && rings_[across].count > (kind(across) == Kind::Free ? 3U : 1U);
    }
    const std::uint32_t sides = is_free ? 2 : 1;
    return keeps && shared == sides && common == sides;
}

// The same where vertices at one place count as one.
bool CollapsingMesh::keeps_topology_of_places(std::uint32_t from, std::uint32_t into) const {
    const auto neighbours = [&](std::uint32_t v, bool is_whole) {
        std::vector<std::uint32_t> found;
        std::uint32_t at = v;
        do {
            for (const Edge& e : around(at)) {
                found.push_back(places_[e.from]);
                found.push_back(places_[e.to]);
            }
            at = vertices_[at].twin;
        } while (is_whole && at != v);
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    };
    const auto a = neighbours(from, kind(from) == Kind::Seam);
    const auto b = neighbours(into, true);
    std::vector<std::uint32_t> common;
    std::ranges::set_intersection(a, b, std::back_inserter(common));
    const std::size_t sides = kind(from) == Kind::Border ? 1 : 2;
    return common.size() == sides;
}

bool CollapsingMesh::keeps_sides(std::uint32_t of, std::uint32_t but, glm::vec3 to) const {
    const glm::vec3 at = vertices_[of].at;
    for (const Edge& e : around(of)) {
        if (e.from == but || e.to == but) continue;
        const glm::vec3 b = vertices_[e.from].at;
        const glm::vec3 edge = vertices_[e.to].at - b;
        const glm::vec3 before = glm::cross(edge, at - b);
        const glm::vec3 after = glm::cross(edge, to - b);
        const float turn = glm::dot(before, after);
        if (!(turn >= 0 && turn * turn >= kLeastTurn2 * squared(before) * squared(after))) return false;
        if (squared(after) == 0 && squared(before) > 0) return false;
    }
    return true;
}

// Across a seam from the vertex whose neighbour across it is into's.
std::uint32_t CollapsingMesh::twin_target(std::uint32_t from, std::uint32_t into) const {
    const auto [first, last] = ends_of(from);
    for (const std::uint32_t end : {first, last})
        if (end != into && places_[end] == places_[into]) return end;
    return kNone;
}

void CollapsingMesh::place(std::uint32_t from, std::uint32_t into, const Collapse& collapse) {
    const glm::vec3 to = collapse.to;
    const Vertex& gone = vertices_[from];
    Quadric sum = gone.quadric;
    sum.move(to - gone.at);
    Quadric kept = vertices_[into].quadric;
    kept.move(to - vertices_[into].at);
    sum += kept;
    const float weight = gone.weight + vertices_[into].weight;
    if (weight > 0) error_ = std::max(error_, error_before_ + std::sqrt(collapse.cost / weight));
    std::uint32_t v = into;
    do {
        vertices_[v].at = to;
        vertices_[v].quadric = sum;
        vertices_[v].weight = weight;
        v = vertices_[v].twin;
    } while (v != into);
    mix_channels(from, into, collapse.along);
    if (kind(from) == Kind::Seam) {
        const std::uint32_t twin = gone.twin;
        mix_channels(twin, twin_target(twin, into), collapse.along);
    }
}

void CollapsingMesh::mix_channels(std::uint32_t from, std::uint32_t into, float along) {
    if (along == 1) return;
    const std::size_t n = channels_a_vertex_;
    const float* a = channels_.data() + n * from;
    float* b = channels_.data() + n * into;
    for (std::size_t i = 0; i < n; ++i) b[i] = a[i] + along * (b[i] - a[i]);
    if (!has_normals_) return;
    const float length2 = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    if (!(length2 > 0)) return;
    const float inverse = 1 / std::sqrt(length2);
    for (std::size_t i = 0; i < 3; ++i) b[i] *= inverse;
}

void CollapsingMesh::join(std::uint32_t from, std::uint32_t into) {
    joined_.clear();
    const bool is_free = kind(from) == Kind::Free;
    for (const Edge& e : around(from)) {
        if (e.from == into || e.to == into) {
            drop(e.from == into ? e.to : e.from, from, into);
        } else {
            joined_.push_back(e);
        }
    }
    for (const Edge& e : around(from)) {
        if (e.from != into) replace(e.from, from, into);
        if (!is_free && e.to != into) replace(e.to, from, into);
    }
    for (const Edge& e : around(into))
        if (e.from != from && e.to != from) joined_.push_back(e);
    if (joined_.size() > 8 * std::size_t{rings_[into].fans} && rings_[from].fans > rings_[into].fans)
        std::swap(rings_[into], rings_[from]);
    set_ring(into);
    rings_[from].count = 0;
    parents_[from] = into;
    ++versions_[from];
    ++versions_[into];
    --alive_;
}

void CollapsingMesh::set_ring(std::uint32_t v) {
    Ring& ring = rings_[v];
    ring.count = static_cast<std::uint32_t>(joined_.size());
    const std::uint32_t needed = (ring.count + 7) / 8;
    if (needed > ring.fans) {
        ring.first = static_cast<std::uint32_t>(fans_.size());
        ring.fans = needed;
        fans_.resize(fans_.size() + needed);
    }
    joined_.resize(8 * std::size_t{needed}, {kNone, kNone});
    for (std::size_t i = 0; i < joined_.size(); ++i) {
        Fan& fan = fans_[ring.first + i / 8];
        fan.from[i % 8] = joined_[i].from;
        fan.to[i % 8] = joined_[i].to;
    }
}

void CollapsingMesh::replace(std::uint32_t in_ring_of, std::uint32_t from, std::uint32_t into) {
    const Ring& ring = rings_[in_ring_of];
    for (Fan* fan = &fans_[ring.first]; fan < &fans_[ring.first] + (ring.count + 7) / 8; ++fan) {
        for (std::uint32_t& v : fan->from) v = v == from ? into : v;
        for (std::uint32_t& v : fan->to) v = v == from ? into : v;
    }
}

// The triangle with these two.
void CollapsingMesh::drop(std::uint32_t in_ring_of, std::uint32_t one, std::uint32_t other) {
    Ring& ring = rings_[in_ring_of];
    Fan* fans = &fans_[ring.first];
    for (std::uint32_t i = 0; i < ring.count; ++i) {
        std::uint32_t& a = fans[i / 8].from[i % 8];
        std::uint32_t& b = fans[i / 8].to[i % 8];
        if ((a != one || b != other) && (a != other || b != one)) continue;
        const std::uint32_t last = --ring.count;
        std::uint32_t& last_from = fans[last / 8].from[last % 8];
        std::uint32_t& last_to = fans[last / 8].to[last % 8];
        a = last_from;
        b = last_to;
        last_from = last_to = kNone;
        return;
    }
}

Progressive::Level CollapsingMesh::level(std::vector<std::uint32_t>& parents) {
    const auto root = [&](std::uint32_t v) {
        while (parents_[v] != parents_[parents_[v]]) parents_[v] = parents_[parents_[v]];
        return parents_[v];
    };
    std::vector<std::uint32_t> places_in_level(vertices_.size());
    std::vector<std::uint32_t> still;
    still.reserve(alive_);
    for (const std::uint32_t v : live_) {
        if (is_dead(v)) continue;
        places_in_level[v] = static_cast<std::uint32_t>(still.size());
        still.push_back(v);
    }
    parents.resize(live_.size());
    for (std::size_t i = 0; i < live_.size(); ++i) parents[i] = places_in_level[root(live_[i])];
    Progressive::Level level;
    level.error_m = error_m();
    live_ = std::move(still);
    Mesh& mesh = level.mesh;
    mesh.positions_m.reserve(live_.size());
    mesh.normals.reserve(has_normals_ ? live_.size() : 0);
    mesh.texcoords.reserve(has_texcoords_ ? live_.size() : 0);
    level.attributes.reserve(attributes_ * live_.size());
    mesh.indices.reserve(6 * live_.size());
    for (const std::uint32_t v : live_) {
        mesh.positions_m.push_back(vertices_[v].at / scale_);
        const float* channel = channels_.data() + channels_a_vertex_ * v;
        if (has_normals_) {
            mesh.normals.emplace_back(channel[0], channel[1], channel[2]);
            channel += 3;
        }
        if (has_texcoords_) {
            mesh.texcoords.emplace_back(channel[0], channel[1]);
            channel += 2;
        }
        level.attributes.insert(level.attributes.end(), channel, channel + attributes_);
        for (const Edge& e : around(v)) {
            if (e.from < v || e.to < v) continue;  // each triangle at its first corner
            for (const std::uint32_t corner : {v, e.from, e.to}) mesh.indices.push_back(places_in_level[corner]);
            if (!materials_.empty()) level.materials.push_back(materials_[v]);
        }
    }
    return level;
}

}  // namespace quadrat::mesh
