// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace quadrat::kiosk::commands {

// Asks on the terminal for one button after the other, and keeps what each is in `file`, with what was learned there of
// other devices. `device` is as after "hid:", "" for any. Returns the exit status. Throws InputError.
int learn_buttons(const std::string& device, const std::string& file);

}  // namespace quadrat::kiosk::commands
