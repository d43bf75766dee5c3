// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "firmware-io/hid/mapping.hpp"

namespace quadrat::commands {

// Asks on the terminal for one button after the other, and keeps what each is in `file`, with what was learned there of
// other devices. `device` is as after "hid:", "" for any. Returns the exit status. Throws InputError.
int learn_buttons(const std::string& device, const std::filesystem::path& file);

// Whoever writes it, the exhibit's user may read it. Throws InputError.
void keep_mappings(const std::filesystem::path& file, std::span<const firmware_io::hid::HidMapping> mappings);

}  // namespace quadrat::commands
