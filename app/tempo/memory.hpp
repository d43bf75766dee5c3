// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "tempo/calibration.hpp"
#include "tempo/governor.hpp"

// What a governor found out, kept in the state for the next start on the same GPU. Its card may have another number
// then, and the projector another mode.
namespace quadrat::tempo {

std::string to_text(const DetailGovernor& governor, std::string_view gpu);

// A profile as it is kept, and whether what is kept is of this screen's GPU.
std::string to_text(const GpuProfile& profile, std::string_view gpu);
bool is_profile_of(std::string_view remembered, std::string_view gpu);

// most: alpha, what the site asks for. What was remembered of another GPU, or cannot be read, counts for nothing.
GovernorOptions options_for(float most, std::string_view remembered, std::string_view gpu);

}  // namespace quadrat::tempo
