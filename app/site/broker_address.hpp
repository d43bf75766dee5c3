// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace quadrat::site {

struct Broker {
    std::string host;  // a name, or an address of IPv4 or IPv6, without brackets
    int port = 0;
    bool is_encrypted = false;
    friend bool operator==(const Broker&, const Broker&) = default;
};

// "mqtts://broker.example:8883", "mqtt://10.0.0.1", "mqtts://[2001:db8::1]:8883", "mqtt://[fe80::1%eth0]". Without a
// port, that of the scheme. Throws std::invalid_argument: what is wrong and what would be right. A user and a password
// are refused: they have keys of their own, and an address is shown and logged. No message repeats the text, which may
// hold a password wherever that was put.
Broker parse_broker(std::string_view address);

// "broker.example:8883", "[2001:db8::1]:8883".
std::string to_text(const Broker& broker);

}  // namespace quadrat::site
