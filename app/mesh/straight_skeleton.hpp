// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrat::mesh {

// A polygon with holes, metres. Edges are numbered through all loops, the outer one first, edge i from a point to the
// next. Loops may turn either way.
struct Plan {
    std::vector<glm::dvec2> outer;
    std::vector<std::vector<glm::dvec2>> holes;

    std::size_t edge_count() const;
};

// What stands on an edge: courses one above the other, each from its height on. A slope of 90 degrees is a wall, of
// less leans inward as a roof does, of more outward as eaves do. In (0, 180); rounded to a cotangent of 2^-28.
struct Profile {
    struct Course {
        double from_m = 0;  // the first course's is 0; rising
        double slope_deg = 45;
    };
    std::vector<Course> courses{{}};
};

// Two planes of one direction and different slopes meet: which of them goes on? The paper's figures 65 and 66.
enum class Ambiguity : std::uint8_t { LeastVolume, MostVolume };

struct RoofOptions {
    std::vector<Profile> profiles{{}};
    std::vector<int> profile_of_edge;  // empty: the first for all
    std::optional<double> height_m;    // where it ends; needed where nothing closes it
    Ambiguity ambiguity = Ambiguity::LeastVolume;
};

struct RoofFace {
    int edge = 0;
    int course = 0;
    std::vector<std::uint32_t> outline;             // counter-clockwise from above; of an overhang, clockwise
    std::vector<std::vector<std::uint32_t>> holes;  // of weighted roofs, seldom
};

struct Roof {
    std::vector<glm::dvec3> vertices;              // x, y of the plan, z up
    std::vector<RoofFace> faces;                   // by edge, then by course; an edge that gave way at once has none,
                                                   // nor one whose neighbour in line shares a holed face with it
    std::vector<std::vector<std::uint32_t>> tops;  // where it was ended: counter-clockwise, holes clockwise
};

// Why there is no roof: what is wrong with the plan, in its own numbering.
class PlanError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The weighted straight skeleton of a plan, as the roof over it. A pure function; the same on every processor.
// What decides which planes meet is exact: of the plan's points to fifteen decimal places of its extent, of normals
// rounded to 2^-50 (those within 1e-8 rad of each other taken as one), of cotangents rounded to 2^-28. Nodes nearer to
// each other than 1e-9 of the extent are one in what is returned. Throws PlanError for fewer than three points, numbers
// that are none, edges that cross, touch or come within 1e-7 of the extent, holes outside, slopes out of range, and for
// a roof that never closes and has no height. Weights positive: at most one face an edge and course. The method: see
// straight_skeleton.cpp.
Roof straight_skeleton(const Plan& plan, const RoofOptions& options = {});

}  // namespace quadrat::mesh
