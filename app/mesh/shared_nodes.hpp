// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/straight_skeleton.hpp"

namespace quadrat::mesh {

// Where a face runs along a line on which those beyond it have nodes of their own, it gets them too: afterwards every
// line between two faces is walked once each way, from node to node.
void share_nodes(Roof& roof);

}  // namespace quadrat::mesh
