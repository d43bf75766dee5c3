// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>

#include "display/display.hpp"

namespace quadrat::display {

// The screen itself, without any desktop. It may come, go and change; see kms/screen_state.hpp.
// Throws InputError, naming the remedy, when there is a card and it is not ours to use.
std::unique_ptr<Display> open_kms(const DisplayOptions& options, std::string why);

// The same, but only if it shows a picture right now; nothing otherwise, and `why_not` says why.
std::unique_ptr<Display> open_kms_if_there_is_a_screen(const DisplayOptions& options, std::string& why_not);

}  // namespace quadrat::display
