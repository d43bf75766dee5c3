// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/parameters.hpp"
#include "synthesis/trees/lsystem.hpp"

namespace quadrat::synthesis::trees {

// The constants of ABOP figure 2.6 (Honda's monopodial trees, pp. 55-57), angles in degrees.
struct HondaTree {
    float r1;                   // contraction of the trunk
    float r2;                   // contraction of the branches
    float a0;                   // branching angle from the trunk
    float a2;                   // branching angle of the lateral axes
    float d;                    // divergence
    float wr;                   // decrease of width
    bool is_less_flat = false;  // laterals turn about their bearer instead of lying level
};

HondaTree book_tree(int type);  // 0 to 3: a to d as printed

// The book's type, or for 4 to 7 its changed relative, with the genes' angles and contractions in place: at the genes'
// defaults a to d are as printed.
HondaTree gene_tree(const scene::TreeParameters& parameters);

// A(1, 10) and the productions p1 to p3 of figure 2.6.
Grammar honda_grammar(const HondaTree& tree);

}  // namespace quadrat::synthesis::trees
