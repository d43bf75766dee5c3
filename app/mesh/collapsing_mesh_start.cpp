// SPDX-License-Identifier: Apache-2.0
// How a mesh is taken in: who is whose neighbour, what each vertex's planes are and where it may go.
#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <map>

#include "mesh/collapsing_mesh.hpp"

namespace quadrat::mesh {
CollapsingMesh::CollapsingMesh(const Mesh& mesh, const ProgressiveOptions& options) {
    assert(mesh.indices.size() % 3 == 0);
    assert(options.materials.empty() || options.materials.size() == mesh.triangle_count());
    assert(options.attributes.size() == options.attributes_a_vertex * mesh.positions_m.size());
    take_triangles(mesh, options.materials);
    take_vertices(mesh, options);
    make_rings();
    find_kinds();
    versions_.resize(vertices_.size());
}

// A vertex for each given one and material that a triangle uses; no triangle that has a corner twice.
void CollapsingMesh::take_triangles(const Mesh& mesh, std::span<const std::uint8_t> materials) {
    corners_.reserve(mesh.indices.size());
    std::vector<std::uint32_t> first(mesh.positions_m.size(), kNone);
    std::map<std::pair<std::uint32_t, std::uint8_t>, std::uint32_t> others;
    const auto vertex = [&](std::uint32_t source, std::uint8_t material) {
        const auto next = static_cast<std::uint32_t>(sources_.size());
        std::uint32_t* known = &first[source];
        const bool is_new = *known == kNone;
        if (!is_new && !materials.empty() && materials_[*known] != material)
            known = &others.try_emplace({source, material}, next).first->second;
        if (is_new) *known = next;
        if (*known != next) return *known;
        sources_.push_back(source);
        if (!materials.empty()) materials_.push_back(material);
        return next;
    };
    sources_.reserve(mesh.positions_m.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* abc = &mesh.indices[i];
        assert(std::max({abc[0], abc[1], abc[2]}) < mesh.positions_m.size());
        if (abc[0] == abc[1] || abc[1] == abc[2] || abc[2] == abc[0]) continue;
        const std::uint8_t material = materials.empty() ? std::uint8_t{0} : materials[i / 3];
        for (int k = 0; k < 3; ++k) corners_.push_back(vertex(abc[k], material));
        if (!materials.empty()) triangle_materials_.push_back(material);
    }
}

void CollapsingMesh::take_vertices(const Mesh& mesh, const ProgressiveOptions& options) {
    const std::size_t count = sources_.size();
    alive_ = count;
    is_fitted_ = options.placement == Placement::Fitted;
    has_normals_ = !mesh.normals.empty();
    has_texcoords_ = !mesh.texcoords.empty();
    attributes_ = options.attributes_a_vertex;
    channels_a_vertex_ = (has_normals_ ? 3U : 0U) + (has_texcoords_ ? 2U : 0U) + attributes_;
    float reach = 0;
    for (const std::uint32_t source : sources_) {
        const glm::vec3 p = glm::abs(mesh.positions_m[source]);
        reach = std::max({reach, p.x, p.y, p.z});
    }
    int exponent = 0;
    std::frexp(reach, &exponent);
    scale_ = std::ldexp(1.0F, std::clamp(-exponent, -120, 120));
    vertices_.resize(count);
    channels_.reserve(count * channels_a_vertex_);
    parents_.resize(count);
    live_.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        const std::uint32_t source = sources_[v];
        vertices_[v] = {
            .at = scale_ * mesh.positions_m[source], .quadric = {}, .weight = 0, .twin = v & kTwinBits, .kind = 0};
        parents_[v] = live_[v] = v;
        if (has_normals_)
            for (int k = 0; k < 3; ++k) channels_.push_back(mesh.normals[source][k]);
        if (has_texcoords_)
            for (int k = 0; k < 2; ++k) channels_.push_back(mesh.texcoords[source][k]);
        const auto own = options.attributes.subspan(attributes_ * source, attributes_);
        channels_.insert(channels_.end(), own.begin(), own.end());
    }
}

void CollapsingMesh::make_rings() {
    rings_.resize(vertices_.size());
    for (const std::uint32_t v : corners_) ++rings_[v].fans;
    std::uint32_t next = 0;
    for (Ring& ring : rings_) {
        ring.fans = (ring.fans + 7) / 8;
        ring.first = next;
        next += ring.fans;
    }
    constexpr std::array<std::uint32_t, 8> kEmpty{kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
    fans_.reserve(next + next / 4);
    fans_.resize(next, {kEmpty, kEmpty});
    const auto add = [&](std::uint32_t v, Edge e) {
        Fan& fan = fans_[rings_[v].first + rings_[v].count / 8];
        const std::uint32_t i = rings_[v].count++ % 8;
        fan.from[i] = e.from;
        fan.to[i] = e.to;
    };
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
        const std::uint32_t a = corners_[i];
        const std::uint32_t b = corners_[i + 1];
        const std::uint32_t c = corners_[i + 2];
        add(a, {b, c});
        add(b, {c, a});
        add(c, {a, b});
    }
}

void CollapsingMesh::find_kinds() {
    std::vector<std::uint32_t> rims;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
        const Kind own = kind_at(v);
        vertices_[v].kind = static_cast<unsigned>(own) & 3U;
        if (own != Kind::Free) rims.push_back(v);
    }
    if (rims.empty()) return;
    find_twins(rims);
    // By now only those that are one open fan are Border.
    for (const std::uint32_t v : rims)
        if (kind(v) == Kind::Border && !is_sealed(v)) vertices_[v].kind = static_cast<unsigned>(Kind::Fixed) & 3U;
    for (const std::uint32_t v : rims)
        if (kind(v) == Kind::Border && vertices_[v].twin != v)
            vertices_[v].kind = static_cast<unsigned>(Kind::Seam) & 3U;
}

// Free: its triangles are one closed fan; Border: one open fan.
CollapsingMesh::Kind CollapsingMesh::kind_at(std::uint32_t v) const {
    const auto ring = around(v);
    // How many triangles a walk from edge to edge meets, and where it ends.
    const auto walk = [&](std::uint32_t begin) {
        std::uint32_t at = begin;
        std::uint32_t steps = 0;
        while (steps < ring.size()) {
            std::uint32_t next = kNone;
            for (const Edge& e : ring)
                if (e.from == at) next = e.to;
            if (next == kNone) break;
            at = next;
            ++steps;
            if (at == begin) break;
        }
        return std::pair{steps, at};
    };
    const std::pair whole{ring.size(), ring[0].from};
    if (walk(ring[0].from) == whole) return Kind::Free;
    for (std::uint32_t i = 0; i < ring.size(); ++i)
        for (std::uint32_t j = i + 1; j < ring.size(); ++j)
            if (ring[i].from == ring[j].from || ring[i].to == ring[j].to) return Kind::Fixed;
    const Ends ends = ends_of(v);
    return ends.first != v && walk(ends.first) == std::pair{ring.size(), ends.last} ? Kind::Border : Kind::Fixed;
}

// Vertices of rims at exactly one place.
void CollapsingMesh::find_twins(std::span<const std::uint32_t> rims) {
    places_ = parents_;
    std::vector<std::uint32_t> sorted(rims.begin(), rims.end());
    const auto key = [&](std::uint32_t v) {
        const glm::vec3& p = vertices_[v].at;
        return std::tuple{p.x, p.y, p.z};
    };
    std::ranges::sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple{key(a), a} < std::tuple{key(b), b};
    });
    for (std::size_t i = 0; i < sorted.size();) {
        std::size_t end = i + 1;
        while (end < sorted.size() && key(sorted[end]) == key(sorted[i])) ++end;
        for (std::size_t k = i; k < end; ++k) {
            places_[sorted[k]] = sorted[i];
            vertices_[sorted[k]].twin = sorted[k + 1 < end ? k + 1 : i] & kTwinBits;
        }
        i = end;
    }
}

// Whether a rim's vertex is where its rim goes on: a border, or a seam with one twin whose rim is the same, backwards.
bool CollapsingMesh::is_sealed(std::uint32_t v) const {
    const auto [first, last] = ends_of(v);
    const std::uint32_t twin = vertices_[v].twin;
    if (twin == v) return places_[first] != places_[last];
    if (vertices_[twin].twin != v || kind_at(twin) != Kind::Border) return false;
    const auto [twin_first, twin_last] = ends_of(twin);
    return places_[first] == places_[twin_last] && places_[last] == places_[twin_first] &&
           places_[first] != places_[last];
}

}  // namespace quadrat::mesh
