// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace quadrat::fleet {

// By what a broker tells connections apart: of two with the same it throws out the older. So it is of this machine and
// this state folder, whatever the machine is called: its machine-id, which images that were copied share, with the
// serial number of its board and the addresses of its network cards, which they do not. 23 letters and digits, as much
// as every broker must take. What cannot be read is left out; where nothing can, it is another at each start.
std::string client_id(const std::filesystem::path& state, const std::filesystem::path& etc = "/etc",
                      const std::filesystem::path& sys = "/sys");

// The whole of a small file that the setting `key` names. Throws InputError naming both, and what mends it.
std::string read_named(std::string_view key, const std::filesystem::path& file, std::size_t limit_bytes);

// The password in a file: its first line, whatever editor saved it: neither its end of line nor a byte order mark is of
// the password. Throws InputError, which never holds any of it.
std::string password_in(const std::filesystem::path& file);

}  // namespace quadrat::fleet
