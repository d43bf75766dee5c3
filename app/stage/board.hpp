// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace quadrat::stage {

// Text over everything else.
struct Board {
    std::string title;
    std::vector<std::string> lines;
    // All: nothing else is seen. Tint: the picture is seen behind it. Strip: lines only, in a corner of the picture.
    enum class Cover { All, Tint, Strip } cover = Cover::All;
    bool has_wires = false;   // the picture shows the edges of its triangles
    std::string prompt = {};  // a key of genome::kPrompts, where the title is one
};

}  // namespace quadrat::stage
