// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "mesh/image.hpp"

namespace quadrat::tests {

// Against golden/NAME.png; what was drawn is left in the build folder when they differ.
void expect_golden(const std::string& name, const mesh::Image& picture);

}  // namespace quadrat::tests
