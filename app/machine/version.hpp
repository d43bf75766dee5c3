// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

namespace quadrat::machine {

// "0.1.0+1a875e5": the version, and the commit that this binary was built of; "-dirty" follows where files differed
// from it, and "unknown" stands where neither git nor the tarball said. The build writes it
// (cmake/QuadratVersion.cmake).
std::string_view version();

}  // namespace quadrat::machine
