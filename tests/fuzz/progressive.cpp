// SPDX-License-Identifier: Apache-2.0
// Any triangles at all become levels with half the vertices each: every number finite, every index and parent inside,
// no corner twice, no border where there was none; and it ends.
#include "mesh/progressive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace mesh = quadrat::mesh;

namespace {

void require(bool is_right) {
    if (!is_right) std::abort();
}

void require_sound(const mesh::Progressive& progressive) {
    for (std::size_t i = 0; i < progressive.levels.size(); ++i) {
        const auto& level = progressive.levels[i];
        const std::size_t count = level.mesh.positions_m.size();
        require(std::isfinite(level.error_m) && level.error_m >= 0);
        for (const glm::vec3& p : level.mesh.positions_m)
            require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        for (std::size_t t = 0; t + 2 < level.mesh.indices.size(); t += 3) {
            const std::uint32_t* abc = &level.mesh.indices[t];
            require(abc[0] < count && abc[1] < count && abc[2] < count);
            require(abc[0] != abc[1] && abc[1] != abc[2] && abc[2] != abc[0]);
        }
        require(level.materials.empty() || level.materials.size() == level.mesh.triangle_count());
        require(level.attributes.size() == count);
        if (i + 1 == progressive.levels.size()) continue;
        const std::size_t next = progressive.levels[i + 1].mesh.positions_m.size();
        require(next < count && level.parents.size() == count);
        for (const std::uint32_t parent : level.parents) require(parent < next);
    }
}

using Places = std::vector<std::uint32_t>;  // a vertex: which of those at one place it is one with

Places places_of(const mesh::Mesh& mesh) {
    std::map<std::array<float, 3>, std::uint32_t> known;
    Places places;
    for (const glm::vec3& p : mesh.positions_m)
        places.push_back(known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size())).first->second);
    return places;
}

// How often triangles run along an edge from its lower place to its higher one, less how often the other way: 0, left
// out, within a surface.
using Border = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

void add(Border& border, std::uint32_t from, std::uint32_t to, int times) {
    if (from > to) return add(border, to, from, -times);
    if (from == to || times == 0) return;
    const auto at = border.try_emplace({from, to}, 0).first;
    at->second += times;
    if (at->second == 0) border.erase(at);
}

Border border_of(const mesh::Mesh& mesh, const Places& places) {
    Border border;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        add(border, places[mesh.indices[i]], places[mesh.indices[next]], 1);
    }
    return border;
}

// An edge within the surface has become one within it, or none; and nothing else has become of the border.
void require_whole_borders(const mesh::Progressive::Level& level, const mesh::Mesh& next) {
    const Places places = places_of(level.mesh);
    const Places places_after = places_of(next);
    std::map<std::pair<std::uint32_t, std::uint32_t>, Border> become;  // of each edge
    Border all;
    for (std::size_t i = 0; i < level.mesh.indices.size(); ++i) {
        const std::uint32_t a = level.mesh.indices[i];
        const std::uint32_t b = level.mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        const std::uint32_t from = places_after[level.parents[a]];
        const std::uint32_t to = places_after[level.parents[b]];
        add(become[std::minmax({places[a], places[b]})], from, to, 1);
        add(all, from, to, 1);
    }
    require(border_of(next, places_after) == all);
    const Border before = border_of(level.mesh, places);
    for (const auto& [edge, after] : become) require(before.contains(edge) || after.empty());
}

}  // namespace

// Its first byte says how many vertices, on a coarse lattice so that they meet and lie in one plane, and what else;
// four bytes a vertex, then four a triangle.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1 || size > 4000) return 0;
    const std::span<const std::uint8_t> bytes(data + 1, size - 1);
    const std::size_t vertices = std::min<std::size_t>(3 + data[0] % 64, bytes.size() / 4);
    if (vertices < 3) return 0;
    mesh::Mesh any;
    std::vector<float> ages;
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::uint8_t* b = &bytes[4 * v];
        any.positions_m.emplace_back(b[0] % 16, b[1] % 16, b[2] % 4);
        any.texcoords.emplace_back(b[3] % 2, b[3] / 2 % 2);
        ages.push_back(b[3]);
    }
    std::vector<std::uint8_t> materials;
    for (std::size_t i = 4 * vertices; i + 3 < bytes.size(); i += 4) {
        for (std::size_t k = 0; k < 3; ++k) any.indices.push_back(bytes[i + k] % static_cast<std::uint32_t>(vertices));
        materials.push_back(bytes[i + 3] % 2);
    }
    mesh::ProgressiveOptions options;
    options.fewest = 4;
    options.attributes = ages;
    options.attributes_a_vertex = 1;
    options.placement = data[0] >= 128 ? mesh::Placement::Line : mesh::Placement::Fitted;
    for (const bool has_materials : {false, true}) {
        if (has_materials) options.materials = materials;
        const mesh::Progressive progressive = mesh::make_progressive(any, options);
        require_sound(progressive);
        for (std::size_t i = 0; i + 1 < progressive.levels.size(); ++i)
            require_whole_borders(progressive.levels[i], progressive.levels[i + 1].mesh);
    }
    return 0;
}
