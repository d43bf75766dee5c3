// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::desk {

// A line of a log as it may be shown: instead of each of these secrets, of what follows "password=", "token: " and the
// like, and of a user's password in an address, stands "•••". Secrets of fewer than four bytes would take words apart,
// and are left alone. Takes any bytes.
std::string without_secrets(std::string_view line, const std::vector<std::string>& secrets);

}  // namespace quadrat::desk
