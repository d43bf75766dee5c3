// SPDX-License-Identifier: Apache-2.0
// Chains of ever coarser meshes of one sphere with hills, each level with half the vertices of the one before.
// Everybody has the same vertices; what each errs by is said beside its time.
#include <fmt/format.h>

#include <algorithm>

#include "bench/peers/cgal.hpp"
#include "bench/peers/peers.hpp"
#include "mesh/displaced_sphere.hpp"
#include "mesh/nearness.hpp"
#include "mesh/progressive.hpp"
#ifdef QUADRAT_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace quadrat::peers {
namespace {

constexpr std::size_t kFewest = 60;

#ifdef QUADRAT_HAS_MESHOPTIMIZER
constexpr const char* kWhyNot = "";

mesh::Mesh half_by_meshoptimizer(const mesh::Mesh& mesh, std::size_t vertices) {
    mesh::Mesh coarse;
    coarse.indices.resize(mesh.indices.size());
    constexpr float kAnyError = 1e9F;
    const std::size_t indices =
        meshopt_simplify(coarse.indices.data(), mesh.indices.data(), mesh.indices.size(), &mesh.positions_m[0].x,
                         mesh.positions_m.size(), sizeof(glm::vec3), 6 * (vertices - 2), kAnyError, 0, nullptr);
    coarse.indices.resize(indices);
    coarse.positions_m.resize(mesh.positions_m.size());
    coarse.positions_m.resize(meshopt_optimizeVertexFetch(coarse.positions_m.data(), coarse.indices.data(), indices,
                                                          mesh.positions_m.data(), mesh.positions_m.size(),
                                                          sizeof(glm::vec3)));
    return coarse;
}

std::vector<mesh::Mesh> by_meshoptimizer(const mesh::Mesh& mesh, const std::vector<std::size_t>& vertices) {
    std::vector<mesh::Mesh> levels;
    for (const std::size_t count : vertices)
        levels.push_back(half_by_meshoptimizer(levels.empty() ? mesh : levels.back(), count));
    return levels;
}
#else
constexpr const char* kWhyNot = "built without libmeshoptimizer-dev";

std::vector<mesh::Mesh> by_meshoptimizer(const mesh::Mesh&, const std::vector<std::size_t>&) { return {}; }
#endif

// Of levels with the same vertices: how far ours lies from the sphere, of how far the other's does.
std::string errors_beside(const mesh::Progressive& ours, const std::vector<mesh::Mesh>& theirs,
                          const mesh::Mesh& sphere) {
    double least = 1e30;
    double most = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        const double error = mesh::deviation_of(ours.levels[i + 1].mesh, sphere).rms_m;
        const double share = error / mesh::deviation_of(theirs[i], sphere).rms_m;
        least = std::min(least, share);
        most = std::max(most, share);
    }
    return fmt::format("at the same vertices ours errs {:.2f} to {:.2f} times as much (root of the mean square)", least,
                       most);
}

}  // namespace

std::vector<Row> chain(const Options& how) {
    const mesh::Mesh sphere = mesh::displaced_sphere(how.is_quick ? 40 : 159, base::Seed{1});
    const mesh::Progressive progressive = mesh::make_progressive(sphere, {.fewest = kFewest});
    std::vector<std::size_t> vertices;
    for (std::size_t i = 1; i < progressive.levels.size(); ++i)
        vertices.push_back(progressive.levels[i].mesh.positions_m.size());
    const auto ours = [&] { return own_ms([&] { mesh::make_progressive(sphere, {.fewest = kFewest}); }); };
    const auto beside = [&](Row row, const std::function<double()>& theirs) {
        if (is_asked(how, row.name)) row.turns = in_turns(how.turns, ours, row.why.empty() ? theirs : nullptr);
        return row;
    };
    Row of_meshoptimizer{"chain", "ms", "meshoptimizer, each level from the one before", 0.95};
    of_meshoptimizer.why = kWhyNot;
    if (is_asked(how, "chain") && of_meshoptimizer.why.empty())
        of_meshoptimizer.note = errors_beside(progressive, by_meshoptimizer(sphere, vertices), sphere);
    Row of_cgal{"chain_cgal", "ms", "CGAL's collapses by Garland and Heckbert, the coarsest level alone", {}};
    of_cgal.why = why_no_cgal();
    return {beside(of_meshoptimizer, [&] { return own_ms([&] { by_meshoptimizer(sphere, vertices); }); }),
            beside(of_cgal, [&] { return own_ms([&] { simplified_by_cgal(sphere, vertices.back()); }); })};
}

}  // namespace quadrat::peers
