// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

namespace quadrat::kiosk::fleet {

// By what a broker tells connections apart: of two with the same it throws out the older. So it is of this machine and
// this state folder, whatever the machine is called: its machine-id, which images that were copied share, with the
// serial number of its board and the addresses of its network cards, which they do not. 23 letters and digits, as much
// as every broker must take. What cannot be read is left out.
std::string client_id(const std::filesystem::path& state, const std::filesystem::path& etc = "/etc",
                      const std::filesystem::path& sys = "/sys");

// The password in a file: its first line, whatever editor saved it: neither its end of line nor a byte order mark is of
// the password. Throws InputError, which never holds any of it.
std::string password_in(const std::filesystem::path& file);

}  // namespace quadrat::kiosk::fleet
