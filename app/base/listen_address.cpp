// SPDX-License-Identifier: Apache-2.0
#include "base/listen_address.hpp"

#include <arpa/inet.h>

#include <charconv>
#include <stdexcept>

namespace quadrat::base {

ListenAddress parse_listen_address(std::string_view text) {
    constexpr const char* kRight = "an address in numbers and a port are right, as 127.0.0.1:8080 or [::1]:8080";
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) throw std::invalid_argument(std::string("there is no port; ") + kRight);
    ListenAddress address;
    const std::string_view port = text.substr(colon + 1);
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
    if (error != std::errc{} || end != port.data() + port.size() || address.port < 1 || address.port > 65535)
        throw std::invalid_argument(std::string("the port is not a number from 1 to 65535; ") + kRight);
    std::string_view host = text.substr(0, colon);
    const bool is_bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (is_bracketed) host = host.substr(1, host.size() - 2);
    address.host = std::string(host);
    in_addr four{};
    in6_addr six{};
    if (!is_bracketed && ::inet_pton(AF_INET, address.host.c_str(), &four) == 1) {
        address.is_loopback = address.host.starts_with("127.");
        return address;
    }
    if (is_bracketed && ::inet_pton(AF_INET6, address.host.c_str(), &six) == 1) {
        address.is_loopback = IN6_IS_ADDR_LOOPBACK(&six);
        return address;
    }
    throw std::invalid_argument(std::string("the address is not one in numbers; ") + kRight);
}

std::string to_text(const ListenAddress& address) {
    const bool is_six = address.host.find(':') != std::string::npos;
    return (is_six ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace quadrat::base
