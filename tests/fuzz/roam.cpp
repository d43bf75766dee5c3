// SPDX-License-Identifier: Apache-2.0
// Whatever the ground and the flight: every edge of the triangles has another on it or is the rim, and the same mesh
// comes of nothing.
#include "mesh/roam.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace mesh = quadrat::mesh;

namespace {

void require(bool is_right) {
    if (!is_right) std::abort();
}

struct Edge {
    std::uint32_t from, to;
    auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> edges_of(const mesh::Roam& roam) {
    std::vector<std::uint32_t> indices;
    require(roam.append_indices({}, indices) == roam.triangle_count());
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back({indices[i + k], indices[i + (k + 1) % 3]});
    std::sort(edges.begin(), edges.end());
    return edges;
}

void require_whole(const std::vector<Edge>& edges, std::uint32_t side) {
    require(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
    for (const Edge& e : edges) {
        const auto is_on_rim = [&](std::uint32_t a, std::uint32_t b) { return a == b && (a == 0 || a == side - 1); };
        const bool is_rim = is_on_rim(e.from % side, e.to % side) || is_on_rim(e.from / side, e.to / side);
        require(std::binary_search(edges.begin(), edges.end(), Edge{e.to, e.from}) != is_rim);
    }
}

}  // namespace

// The first byte is the side; four bytes an eye and what is asked; the last bytes are the ground, over and over.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 6 || size > 400) return 0;
    const int side = 2 + data[0] % 34;
    mesh::Field field(side, side);
    for (std::size_t i = 0; i < field.samples.size(); ++i)
        field.samples[i] = 0.25F * static_cast<float>(data[size - 1 - i % std::min<std::size_t>(size, 97)]);
    mesh::Roam flown(field, 1);
    for (std::size_t i = 1; i + 4 < size && i < 17; i += 4) {
        const auto at = [&](std::size_t k) { return static_cast<float>(data[i + k]) - 128; };
        mesh::Roam::Wish wish{{at(0), at(1), at(2)}, 100, 0.25F * static_cast<float>(1 + data[i + 3] % 4)};
        flown.update(wish);
        const auto edges = edges_of(flown);
        require_whole(edges, static_cast<std::uint32_t>(side));
        mesh::Roam fresh(field, 1);
        fresh.update(wish);
        require(edges_of(fresh) == edges);
        if (data[i + 3] < 128) continue;
        wish.triangle_budget = data[i];
        flown.update(wish);
        require_whole(edges_of(flown), static_cast<std::uint32_t>(side));
    }
    return 0;
}
