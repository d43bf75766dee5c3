// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/cgal.hpp"

#ifdef QUADRAT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/create_straight_skeleton_2.h>

namespace quadrat::peers {

const char* why_no_cgal() { return ""; }

std::size_t simplified_by_cgal(const mesh::Mesh& mesh, std::size_t vertices) {
    namespace simplification = CGAL::Surface_mesh_simplification;
    using Kernel = CGAL::Simple_cartesian<double>;
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    using Policies = simplification::GarlandHeckbert_policies<Surface, Kernel>;
    Surface surface;
    for (const glm::vec3& p : mesh.positions_m) surface.add_vertex({p.x, p.y, p.z});
    using Vertex = Surface::Vertex_index;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        surface.add_face(Vertex(mesh.indices[i]), Vertex(mesh.indices[i + 1]), Vertex(mesh.indices[i + 2]));
    const std::size_t edges = 3 * (vertices - 2);  // of a closed surface without handles
    const Policies policies(surface);
    simplification::edge_collapse(
        surface, simplification::Count_stop_predicate<Surface>(edges),
        CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
    return surface.number_of_vertices();
}

std::size_t skeleton_by_cgal(const mesh::Plan& plan) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Polygon_2<Kernel> polygon;
    for (const glm::dvec2& p : plan.outer) polygon.push_back({p.x, p.y});
    return CGAL::create_interior_straight_skeleton_2(polygon)->size_of_vertices();
}

}  // namespace quadrat::peers
#else
namespace quadrat::peers {

const char* why_no_cgal() { return "built without libcgal-dev"; }
std::size_t simplified_by_cgal(const mesh::Mesh&, std::size_t) { return 0; }
std::size_t skeleton_by_cgal(const mesh::Plan&) { return 0; }

}  // namespace quadrat::peers
#endif
