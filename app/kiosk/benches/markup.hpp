// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

// What pages and plots of `quadrat bench` are written with.
namespace quadrat::kiosk::benches {

// As it may stand between the tags of HTML and SVG, and in their attributes.
std::string escaped(std::string_view text);

// A bar as inline SVG, solid up to one share of its width and pale on to another; shares are from 0 to 1.
std::string bar_of(double solid_share, double pale_share);

}  // namespace quadrat::kiosk::benches
