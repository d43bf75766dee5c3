// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "firmware-io/button_press.hpp"

namespace quadrat::firmware_io {

// What the lamp in a button does. A lamp that breathes or blinks belongs to a button that can be pressed now.
enum class LampPattern { Off, Steady, Breathing, Blinking };

// One pattern for each button, in the order of kButtons.
using Lamps = std::array<LampPattern, kButtons.size()>;

// How bright a lamp is at a moment, 0 to 1. Breathing: a raised cosine of 3 s that never goes quite dark.
// Blinking: 1.25 Hz, well below the three flashes a second that WCAG 2.3.1 allows.
float lamp_brightness(LampPattern pattern, Instant at);

// The same for a lamp that can only be switched: Breathing becomes a slow wink, 2.4 s lit and 0.6 s dark.
bool is_lamp_lit(LampPattern pattern, Instant at);

}  // namespace quadrat::firmware_io
