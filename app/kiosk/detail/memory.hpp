// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "kiosk/detail/governor.hpp"

// What a governor found out, kept in the state for the next start on the same GPU and screen.
namespace quadrat::kiosk {

std::string to_text(const DetailGovernor& governor, std::string_view gpu);

// most: alpha, what the site asks for. What was remembered of another GPU, or cannot be read, counts for nothing.
GovernorOptions options_for(float most, std::string_view remembered, std::string_view gpu);

}  // namespace quadrat::kiosk
