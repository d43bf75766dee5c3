// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace quadrat::synthesis::trees {

enum class LeafKind { Ovate, Lance, Round, Lobed, Palmate, Needles, Heart, Feather, Frond, Spines };
inline constexpr int kLeafKinds = 10;

// An outline folded along its midrib, of length 1 and width 1: x along, y across. The vertices run from the foot along
// one side to the tip and back along the other; the foot and the tip are the ends of the fold.
struct LeafShape {
    std::vector<glm::vec2> outline;
    std::vector<float> lightness;  // a vertex: veins and rims
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> plain;  // the same in two triangles, or in a few
    std::size_t tip = 0;
    float width = 0.5F;  // what is usual, to the length
    float arch = 0.1F;   // how far the tip bends down, to the length
};
const LeafShape& leaf_shape(LeafKind kind);

}  // namespace quadrat::synthesis::trees
