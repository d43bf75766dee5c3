// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <map>

#include "mesh/roof_mesh.hpp"
#include "support/plans.hpp"

namespace quadrat::tests {
namespace {

double cot(double degrees) { return 1 / std::tan(degrees * std::numbers::pi / 180); }

struct Edge {
    glm::dvec2 from, to, inward;
};

std::vector<Edge> edges_of(const mesh::Plan& plan) {
    std::vector<Edge> edges;
    for (std::size_t l = 0; l <= plan.holes.size(); ++l) {
        const Loop& loop = l == 0 ? plan.outer : plan.holes[l - 1];
        const double side = (signed_area(loop) > 0) == (l == 0) ? 1 : -1;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 a = loop[i];
            const glm::dvec2 b = loop[(i + 1) % loop.size()];
            const glm::dvec2 d = glm::normalize(b - a);
            edges.push_back({a, b, side * glm::dvec2(-d.y, d.x)});
        }
    }
    return edges;
}

// How far inward of its edge the profile is at a height.
double inward_of(const mesh::Profile& profile, double height) {
    double reach = 0;
    for (std::size_t i = 0; i < profile.courses.size(); ++i) {
        const double from = profile.courses[i].from_m;
        const double to = i + 1 < profile.courses.size() ? std::min(height, profile.courses[i + 1].from_m) : height;
        if (to > from) reach += (to - from) * cot(profile.courses[i].slope_deg);
    }
    return reach;
}

}  // namespace

std::string fault_of(const mesh::Plan& plan, const mesh::RoofOptions& options, const mesh::Roof& roof) {
    const std::vector<Edge> edges = edges_of(plan);
    double extent = 0;
    for (const glm::dvec3& v : roof.vertices) extent = std::max({extent, std::abs(v.x), std::abs(v.y), v.z});
    const double little = 1.0e-6 * extent;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    double area = 0;
    for (const mesh::RoofFace& face : roof.faces) {
        const Edge& edge = edges[static_cast<std::size_t>(face.edge)];
        const auto which =
            options.profile_of_edge.empty() ? 0 : options.profile_of_edge[static_cast<std::size_t>(face.edge)];
        const mesh::Profile& profile = options.profiles[static_cast<std::size_t>(which)];
        std::vector<std::vector<std::uint32_t>> loops{face.outline};
        loops.insert(loops.end(), face.holes.begin(), face.holes.end());
        for (const auto& loop : loops) {
            Loop flat;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const glm::dvec3 v = roof.vertices[loop[i]];
                flat.emplace_back(v);
                ++uses[{loop[i], loop[(i + 1) % loop.size()]}];
                const double off = glm::dot(glm::dvec2(v) - edge.from, edge.inward) - inward_of(profile, v.z);
                if (std::abs(off) > little)
                    return fmt::format("a vertex of edge {}'s face is {} off its plane", face.edge, off);
            }
            area += signed_area(flat);
        }
        double triangles = 0;
        const std::vector<std::uint32_t> corners = mesh::face_triangles(roof, face);
        glm::dvec3 whole(0);
        glm::dvec3 in_parts(0);
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            const glm::dvec3 cross = glm::cross(roof.vertices[corners[i + 1]] - roof.vertices[corners[i]],
                                                roof.vertices[corners[i + 2]] - roof.vertices[corners[i]]);
            in_parts += cross;
            triangles += glm::length(cross);
        }
        for (const auto& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i)
                whole += glm::cross(roof.vertices[loop[i]] - roof.vertices[loop[0]],
                                    roof.vertices[loop[(i + 1) % loop.size()]] - roof.vertices[loop[0]]);
        if (std::abs(triangles - glm::length(whole)) > little * extent ||
            glm::length(in_parts - whole) > little * extent)
            return fmt::format("the triangles of edge {}'s face do not cover it: {} of {}", face.edge, triangles,
                               glm::length(whole));
    }
    for (const auto& top : roof.tops) {
        Loop flat;
        for (std::size_t i = 0; i < top.size(); ++i) {
            flat.emplace_back(roof.vertices[top[i]]);
            ++uses[{top[i], top[(i + 1) % top.size()]}];
        }
        area += signed_area(flat);
    }
    if (std::abs(area - area_of(plan)) > little * extent)
        return fmt::format("faces cover {} of {} square metres", area, area_of(plan));
    // Every line between faces is walked once each way; what is walked one way alone is the plan's own.
    int open = 0;
    for (const auto& [step, count] : uses) {
        const auto back = uses.find({step.second, step.first});
        if (back != uses.end() && back->second == count) continue;
        if (roof.vertices[step.first].z != 0 || roof.vertices[step.second].z != 0)
            return fmt::format("a line from {} to {} has a face on one side alone", step.first, step.second);
        ++open;
    }
    if (open == 0) return "it is not bounded by the plan";
    return {};
}

}  // namespace quadrat::tests
