// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace quadrat::base {

// Where a server listens: an address of this machine, in numbers. Throws std::invalid_argument: what is wrong and what
// would be right.
struct ListenAddress {
    std::string host;  // "127.0.0.1", "::1"
    int port = 0;
    bool is_loopback = false;  // nobody but this machine reaches it
    friend bool operator==(const ListenAddress&, const ListenAddress&) = default;
};
ListenAddress parse_listen_address(std::string_view text);  // "127.0.0.1:8080", "[::1]:8080"
std::string to_text(const ListenAddress& address);

}  // namespace quadrat::base
