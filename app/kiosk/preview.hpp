// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kiosk/show.hpp"
#include "staff/preview_wish.hpp"
#include "stage/theatre.hpp"

namespace quadrat::kiosk {

// The words that were wished for where they would stand, over the landscapes of now. Drawn over the canvas, before the
// frame itself is; empty where nothing can be drawn, or there is no such prompt.
mesh::Image preview_of(const staff::PreviewWish& wish, const Show& show, stage::Theatre& theatre,
                       const site::Configuration& configuration, const display::Canvas& canvas, base::Instant now);

}  // namespace quadrat::kiosk
