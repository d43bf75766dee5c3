// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "projector/projector.hpp"

namespace quadrat::projector {

// What cec-ctl (v4l-utils) printed of a screen's power. Takes any text.
Power power_in(std::string_view printed);
// Where the cable ends, "1.0.0.0", in what it printed of the device; "" where nothing is plugged in that knows CEC.
std::string physical_address_in(std::string_view printed);

std::unique_ptr<Projector> open_cec(const Cec& at, std::chrono::milliseconds patience);

}  // namespace quadrat::projector
