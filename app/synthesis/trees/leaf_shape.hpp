// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace quadrat::synthesis::trees {

enum class LeafKind { Ovate, Lance, Round, Lobed, Palmate, Needles, Heart, Feather, Frond, Spines };
inline constexpr int kLeafKinds = 10;

// An outline folded along its midrib, of length 1 and width 1: x along, y across. A single leaf's vertices run from its
// foot along one side to its tip and back along the other.
struct LeafShape {
    std::vector<glm::vec2> outline;
    std::vector<glm::vec2> on_blade;  // per vertex: midrib 0 to rim 1; foot 0 to tip 1, of the leaf that it belongs to
    std::vector<glm::vec2> disc;      // per vertex: where it lies when the shape is rounded to a disc of radius 1
    std::vector<glm::vec2> cluster;   // per vertex: where it lies when its leaves are flowers; may be empty: a disc
    std::vector<float> lightness;     // per vertex: veins and rims
    std::vector<float> lift;          // per vertex: toward the upper side, to the length; may be empty: flat
    std::vector<std::uint32_t> twig_foot;  // vertices where the twig begins that bears it; none: it has no twig
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> plain;  // the same in two triangles, or in a few
    float width = 0.5F;                // what is usual, to the length
    float arch = 0.1F;                 // how far the tip bends down, to the length
};
const LeafShape& leaf_shape(LeafKind kind);

// A twig with several leaves of this kind, as trees and shrubs bear them: of the size of one large leaf, but with the
// outline and the texture of many small ones. A feather has its leaflets; fronds and spines are sprays already.
const LeafShape& spray_shape(LeafKind kind);

// The same with its leaves where they come on a shoot of such an inhibition (synthesis/trees/inhibition.hpp); of as
// many triangles. Kinds that are no twigs of single leaves are as they always are.
LeafShape spray_shape(LeafKind kind, float inhibition);

// A sliver of one triangle that tapers to its tip: of a bough, a twig.
const LeafShape& sliver_shape();

}  // namespace quadrat::synthesis::trees
