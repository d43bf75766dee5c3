// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "display/display.hpp"
#include "kiosk/detail/calibration.hpp"
#include "kiosk/detail/governor.hpp"

// What a governor found out, kept in the state for the next start on the same GPU. Its card may have another number
// then, and the projector another mode.
namespace quadrat::kiosk {

std::string to_text(const DetailGovernor& governor, const display::Display& screen);

// A profile as it is kept, and whether what is kept is of this screen's GPU.
std::string to_text(const GpuProfile& profile, const display::Display& screen);
bool is_profile_of(std::string_view remembered, const display::Display& screen);

// most: alpha, what the site asks for. What was remembered of another GPU, or cannot be read, counts for nothing.
GovernorOptions options_for(float most, std::string_view remembered, const display::Display& screen);

}  // namespace quadrat::kiosk
