// SPDX-License-Identifier: Apache-2.0
#include "mesh/pieces.hpp"

#include <cstddef>
#include <map>
#include <tuple>

namespace quadrat::mesh {
namespace {

std::vector<std::uint32_t> welded(const std::vector<glm::vec3>& places) {
    std::map<std::tuple<float, float, float>, std::uint32_t> first_at;
    std::vector<std::uint32_t> of(places.size());
    for (std::uint32_t i = 0; i < of.size(); ++i)
        of[i] = first_at.try_emplace({places[i].x, places[i].y, places[i].z}, i).first->second;
    return of;
}

std::uint32_t root_of(std::vector<std::uint32_t>& joined, std::uint32_t v) {
    while (joined[v] != v) v = joined[v] = joined[joined[v]];
    return v;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> pieces_of(const Mesh& mesh) {
    std::vector<std::uint32_t> joined = welded(mesh.positions_m);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 1; k < 3; ++k)
            joined[root_of(joined, mesh.indices[i + k])] = root_of(joined, mesh.indices[i]);
    std::map<std::uint32_t, std::size_t> piece_of_root;
    std::vector<std::vector<std::uint32_t>> pieces;
    for (std::uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto [at, is_new] = piece_of_root.try_emplace(root_of(joined, mesh.indices[i]), pieces.size());
        if (is_new) pieces.emplace_back();
        pieces[at->second].push_back(i);
    }
    return pieces;
}

}  // namespace quadrat::mesh
