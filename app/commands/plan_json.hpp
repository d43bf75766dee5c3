// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mesh/straight_skeleton.hpp"

namespace quadrat::commands {

// What quadrat skeleton reads: {"outer": [[x, y], …], "holes": [[[x, y], …], …], "weights": [degrees, …],
// "profiles": {"all" or an edge's number: [{"slope": degrees, "from": metres}, …]}, "height": metres,
// "ambiguity": "least" | "most"}. Only outer is needed. A profile stands before a weight.
struct PlanFile {
    mesh::Plan plan;
    mesh::RoofOptions options;
};

// Throws InputError "SOURCE:LINE: …" or "SOURCE: …".
PlanFile plan_from(std::string_view text, std::string_view source);

// {"outer": …, "holes": …} alone. Throws the same.
mesh::Plan region_from(std::string_view text, std::string_view source);

// {"vertices": [[x, y, z], …], "faces": [{"edge": i, "course": 0, "vertices": [k, …]}, …], "tops": [[k, …], …]}
std::string json_of(const mesh::Roof& roof);

// Seen from above: lines of ridges, hips and valleys, faces shaded by where they look.
std::string svg_of(const mesh::Roof& roof);

}  // namespace quadrat::commands
