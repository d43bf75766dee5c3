// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "display/display.hpp"
#include "display/egl/egl_context.hpp"

namespace quadrat::display {

// A picture without a screen: a framebuffer in a context without a surface. Presents at once.
// The platforms are tried in order. Throws InputError, naming what each said and the packages that mend it.
std::unique_ptr<Display> open_headless(const DisplayOptions& options, std::string why,
                                       const std::vector<HeadlessPlatform>& platforms = kHeadlessPlatforms);

}  // namespace quadrat::display
