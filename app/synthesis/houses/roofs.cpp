// SPDX-License-Identifier: Apache-2.0
// Roofs by the weighted straight skeleton of the eaves' outline: a gable is a vertical face, which is left open.
#include "synthesis/houses/roofs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/roof_mesh.hpp"
#include "synthesis/houses/masses.hpp"
#include "synthesis/houses/walls.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr double kThick_m = 0.16;
constexpr double kThatch_m = 0.38;
constexpr double kTrim_m = 0.05;    // room for what stands out from a wall under its upper edge
constexpr double kHipShare = 0.42;  // of a gable's height, of a half hip
constexpr float kUnder = 0.55F;     // of the light, under the eaves

glm::dvec2 unit(glm::dvec2 d) { return d / glm::length(d); }

// Each side moved outward by its own distance.
std::vector<glm::dvec2> grown(const Design& design) {
    const std::vector<glm::dvec2>& plan = design.footprint.plan;
    const std::size_t n = plan.size();
    const auto out_of = [&](std::size_t i) {
        const glm::dvec2 d = unit(plan[(i + 1) % n] - plan[i]);
        return glm::dvec2(d.y, -d.x) * (is_gable(design, i) ? design.verge_m : design.eave_m);
    };
    std::vector<glm::dvec2> out;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        const glm::dvec2 a = plan[before] + out_of(before);
        const glm::dvec2 da = plan[i] - plan[before];
        const glm::dvec2 b = plan[i] + out_of(i);
        const glm::dvec2 db = plan[(i + 1) % n] - plan[i];
        const double turn = da.x * db.y - da.y * db.x;
        const double t = ((b.x - a.x) * db.y - (b.y - a.y) * db.x) / turn;
        out.push_back(a + t * da);
    }
    return out;
}

bool is_broken(const Design& design) { return design.form == RoofForm::Mansard || design.form == RoofForm::Gambrel; }

double thick_m(const Design& design) { return design.roof.cladding == scene::Cladding::Thatch ? kThatch_m : kThick_m; }

// Moss and soot begin where water runs off last.
glm::vec3 mossy(const glm::vec3& roof, float wear) {
    return glm::mix(roof, 0.75F * glm::mix(roof, glm::vec3{0.055F, 0.06F, 0.03F}, 0.6F), wear);
}

class RoofOver {
  public:
    RoofOver(scene::Building& to, const Design& design) : to_(to), design_(design) {
        const double pitch = std::tan(glm::radians(design.pitch_deg));
        thick_m_ = thick_m(design);
        // It lies on the walls' upper edges: not they nor what stands out from them come through it.
        base_m_ = design.plinth_m + design.wall_m - design.eave_m * pitch + over_walls_m(design);
        mesh::Plan plan{grown(design), {}};
        mesh::RoofOptions options;
        const std::vector<glm::dvec2>& walls = design.footprint.plan;
        const auto cut = [&](std::size_t i) {
            const double width_m = glm::length(walls[(i + 1) % walls.size()] - walls[i]);
            return rise_m(design, width_m) - hip_cut_m(design, width_m) + design.eave_m * pitch;
        };
        options.profiles = {{{{0, design.pitch_deg}}}, {{{0, 90}}}};
        if (is_broken(design))
            options.profiles[0].courses.push_back({design.break_m + design.eave_m * pitch, design.upper_pitch_deg});
        for (std::size_t i = 0; i < plan.outer.size(); ++i) {
            const bool is_open = is_gable(design, i);
            options.profile_of_edge.push_back(is_open ? 1 : 0);
            if (!is_open || design.form != RoofForm::HalfHipped) continue;
            options.profile_of_edge.back() = static_cast<int>(options.profiles.size());
            options.profiles.push_back({{{0, 90}, {cut(i), design.pitch_deg + 8}}});
        }
        roof_ = mesh::straight_skeleton(plan, options);
    }

    double add() {
        double ridge_m = 0;
        for (const glm::dvec3& v : roof_.vertices) ridge_m = std::max(ridge_m, v.z);
        for (const mesh::RoofFace& face : roof_.faces) {
            if (is_vertical(face))
                add_barge(face);
            else
                add_slope(face);
        }
        return ridge_m + base_m_;
    }

  private:
    glm::vec3 at(std::uint32_t i) const {
        const glm::dvec3& v = roof_.vertices[i];
        return {v.x, v.z + base_m_, -v.y};
    }

    bool is_vertical(const mesh::RoofFace& face) const {
        glm::dvec3 area(0);
        const auto v = [&](std::size_t i) { return roof_.vertices[face.outline[i]]; };
        for (std::size_t i = 2; i < face.outline.size(); ++i) area += glm::cross(v(i - 1) - v(0), v(i) - v(0));
        return std::abs(area.z) < 0.02 * glm::length(area);
    }

    void add_board(glm::vec3 p, glm::vec3 q, std::size_t level) {
        const glm::vec3 down{0, -1.25F * static_cast<float>(thick_m_), 0};
        const bool is_thatch = design_.roof.cladding == scene::Cladding::Thatch;
        const Look look{is_thatch ? design_.roof.colour * 0.7F : design_.wood, scene::Cladding::Plain, 0};
        add_face(to_.levels[level], std::array{p + down, q + down, q, p}, look);
    }

    void add_slope(const mesh::RoofFace& face) {
        const std::vector<std::uint32_t> triangles = mesh::face_triangles(roof_, face);
        const Look above{design_.roof.colour, design_.roof.cladding, 0};
        const Look moss{mossy(design_.roof.colour, design_.wear), design_.roof.cladding, 0};
        const Look below{design_.wood * 0.9F, scene::Cladding::Plain, 0};
        const glm::vec3 down{0, -static_cast<float>(thick_m_), 0};
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
            const std::array corners{at(triangles[i]), at(triangles[i + 1]), at(triangles[i + 2])};
            for (std::size_t level = 0; level < kLevels; ++level) {
                scene::Masses& masses = to_.levels[level];
                const std::size_t first = masses.colours.size();
                add_face(masses, corners, above);
                if (masses.colours.size() == first) continue;
                for (std::size_t c = 0; c < 3; ++c)
                    if (roof_.vertices[triangles[i + c]].z < 0.4) masses.colours[first + c] = moss.colour;
            }
            const std::array<float, 3> dark{kUnder, kUnder, kUnder};
            add_face(to_.levels[0], std::array{corners[2] + down, corners[1] + down, corners[0] + down}, below, dark);
        }
        const std::size_t n = face.outline.size();
        for (std::size_t k = 0; k < n; ++k) {
            const std::uint32_t p = face.outline[k];
            const std::uint32_t q = face.outline[(k + 1) % n];
            if (roof_.vertices[p].z > 1.0e-6 || roof_.vertices[q].z > 1.0e-6) continue;
            add_board(at(p), at(q), 0);
            add_board(at(p), at(q), 1);
        }
    }

    // The edges of the opening under a gable's roof.
    void add_barge(const mesh::RoofFace& face) {
        const std::size_t n = face.outline.size();
        for (std::size_t k = 0; k < n; ++k) {
            const glm::vec3 p = at(face.outline[k]);
            const glm::vec3 q = at(face.outline[(k + 1) % n]);
            const glm::vec2 level{q.x - p.x, q.z - p.z};
            const bool is_base = std::max(p.y, q.y) < base_m_ + 1.0e-4;
            if (is_base || glm::length(level) < 1.0e-3F) continue;
            // Counter-clockwise from outside: upper edges run from right to left.
            add_board(q, p, 0);
            add_board(q, p, 1);
            const glm::vec3 down{0, -1.25F * static_cast<float>(thick_m_), 0};
            const Look inner{design_.wood * kUnder, scene::Cladding::Plain, 0};
            add_face(to_.levels[0], std::array{p + down, q + down, q, p}, inner);
        }
    }

    scene::Building& to_;
    const Design& design_;
    mesh::Roof roof_;
    double base_m_ = 0;
    double thick_m_ = kThick_m;
};

}  // namespace

double rise_m(const Design& design, double width_m) {
    const double steep = std::tan(glm::radians(design.pitch_deg));
    const double below = 0.5 * width_m * steep;
    if (!is_broken(design) || below <= design.break_m) return below;
    return design.break_m + (0.5 * width_m - design.break_m / steep) * std::tan(glm::radians(design.upper_pitch_deg));
}

std::vector<glm::dvec2> gable_of(const Design& design, double width_m) {
    const double rise = rise_m(design, width_m);
    const double cut = hip_cut_m(design, width_m);
    const double steep = std::tan(glm::radians(design.pitch_deg));
    if (cut > 0) return {{0.5 * width_m + cut / steep, rise - cut}, {0.5 * width_m - cut / steep, rise - cut}};
    const glm::dvec2 ridge{0.5 * width_m, rise};
    if (!is_broken(design) || rise <= design.break_m) return {ridge};
    const double run = design.break_m / steep;
    return {{width_m - run, design.break_m}, ridge, {run, design.break_m}};
}

double over_walls_m(const Design& design) { return thick_m(design) + kTrim_m; }

double hip_cut_m(const Design& design, double width_m) {
    return design.form == RoofForm::HalfHipped ? kHipShare * rise_m(design, width_m) : 0;
}

double add_roof(scene::Building& to, const Design& design) { return RoofOver(to, design).add(); }

}  // namespace quadrat::synthesis::houses
