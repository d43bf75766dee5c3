// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

// What pages and plots of `quadrat bench` are written with.
namespace quadrat::benches {

// A bar as inline SVG, solid up to one share of its width and pale on to another; shares are from 0 to 1.
std::string bar_of(double solid_share, double pale_share);

}  // namespace quadrat::benches
