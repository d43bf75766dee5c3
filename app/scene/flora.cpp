// SPDX-License-Identifier: Apache-2.0
#include "scene/flora.hpp"

#include <glm/geometric.hpp>

namespace quadrat::scene {
namespace {

template <typename Element>
std::size_t bytes_in(const std::vector<Element>& elements) {
    return elements.size() * sizeof(Element);
}

}  // namespace

float area_m2(const Leaves& leaves) {
    float area_m2 = 0;
    const auto corner = [&](std::size_t i) {
        const Leaves::Vertex& v = leaves.vertices[leaves.indices[i]];
        return v.site_m + v.corner_m;
    };
    for (std::size_t i = 0; i + 2 < leaves.indices.size(); i += 3)
        area_m2 += 0.5F * glm::length(glm::cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i)));
    return area_m2;
}

std::size_t bytes_of(const Species& species) {
    std::size_t bytes = species.bark.bytes.size() + species.leaf.bytes.size() + species.foliage.bytes.size() +
                        bytes_in(species.leaves.vertices) + bytes_in(species.leaves.indices) +
                        bytes_in(species.leaves.plain_indices);
    for (const Wood& wood : species.wood)
        bytes += bytes_in(wood.mesh.positions_m) + bytes_in(wood.mesh.normals) + bytes_in(wood.mesh.texcoords) +
                 bytes_in(wood.mesh.indices) + bytes_in(wood.grains) + bytes_in(wood.ages) + bytes_in(wood.sways) +
                 bytes_in(wood.coarser_m) + bytes_in(wood.coarser_sways);
    for (const CrownMass& mass : species.masses)
        bytes += bytes_in(mass.mesh.positions_m) + bytes_in(mass.mesh.normals) + bytes_in(mass.mesh.indices) +
                 bytes_in(mass.colours) + bytes_in(mass.shades) + bytes_in(mass.ages) + bytes_in(mass.sways) +
                 bytes_in(mass.coarser_m);
    return bytes;
}

}  // namespace quadrat::scene
