// SPDX-License-Identifier: Apache-2.0
// The part of RFC 3986 that an address of a broker needs; zones of IPv6 as in RFC 6874.
#include "site/broker_address.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace quadrat::site {
namespace {

constexpr std::size_t kLongestHost = 253;
constexpr std::size_t kLongestLabel = 63;
constexpr int kPlainPort = 1883;
constexpr int kEncryptedPort = 8883;

[[noreturn]] void refuse(std::string_view what) {
    throw std::invalid_argument(fmt::format("{}; write mqtts://HOST:PORT, or mqtt://HOST:PORT", what));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_of_a_name(char c) { return is_digit(c) || is_letter(c) || c == '-' || c == '_'; }

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

Broker of_scheme(std::string_view address) {
    const std::size_t end = address.find("://");
    const std::string scheme = end == std::string_view::npos ? "" : lower(address.substr(0, end));
    if (scheme == "mqtts") return {"", kEncryptedPort, true};
    if (scheme == "mqtt") return {"", kPlainPort, false};
    refuse("begins with neither mqtts:// nor mqtt://");
}

int parse_port(std::string_view text) {
    int port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    constexpr int kHighest = 65535;
    const bool is_number = !text.empty() && std::all_of(text.begin(), text.end(), is_digit) && error == std::errc{} &&
                           end == text.data() + text.size();
    if (!is_number || port < 1 || port > kHighest) refuse("has a port that is no number from 1 to 65535");
    return port;
}

bool is_zone(std::string_view zone) {
    constexpr std::size_t kLongest = 15;  // of an interface's name
    return !zone.empty() && zone.size() <= kLongest &&
           std::all_of(zone.begin(), zone.end(), [](char c) { return is_of_a_name(c) || c == '.'; });
}

std::string parse_ipv6(std::string_view text) {
    const std::size_t percent = text.find('%');
    std::string address(text.substr(0, percent));
    std::array<unsigned char, 16> bytes{};
    if (address.find('\0') != std::string::npos || ::inet_pton(AF_INET6, address.c_str(), bytes.data()) != 1)
        refuse("has no IPv6 address between its brackets");
    if (percent == std::string_view::npos) return address;
    std::string_view zone = text.substr(percent + 1);
    if (zone.starts_with("25") && zone.size() > 2) zone.remove_prefix(2);
    if (!is_zone(zone)) refuse("names no interface after the % of its IPv6 address: [fe80::1%eth0]");
    return address + "%" + std::string(zone);
}

bool is_name(std::string_view host) {
    if (host.ends_with('.')) host.remove_suffix(1);
    if (host.size() > kLongestHost) return false;
    for (std::size_t start = 0; start <= host.size();) {
        const std::size_t dot = std::min(host.find('.', start), host.size());
        const std::string_view label = host.substr(start, dot - start);
        const bool is_label = !label.empty() && label.size() <= kLongestLabel && label.front() != '-' &&
                              label.back() != '-' && std::all_of(label.begin(), label.end(), is_of_a_name);
        if (!is_label) return false;
        start = dot + 1;
    }
    return true;
}

std::string parse_name(std::string_view host) {
    if (host.empty()) refuse("names no host");
    if (!is_name(host)) refuse("has a host that is no name of letters, digits, - and dots, and no IPv4 address");
    const bool is_numeric = std::all_of(host.begin(), host.end(), [](char c) { return is_digit(c) || c == '.'; });
    std::array<unsigned char, 4> bytes{};
    if (is_numeric && ::inet_pton(AF_INET, std::string(host).c_str(), bytes.data()) != 1)
        refuse("has a host that is no IPv4 address: four numbers up to 255");
    return std::string(host);
}

// What follows the host in brackets: "", or ":PORT".
std::optional<int> port_after_brackets(std::string_view rest) {
    if (rest.empty()) return std::nullopt;
    if (!rest.starts_with(':')) refuse("has something other than :PORT after its brackets");
    return parse_port(rest.substr(1));
}

}  // namespace

Broker parse_broker(std::string_view address) {
    if (address.find('@') != std::string_view::npos)
        throw std::invalid_argument(
            "has a user or a password in it; write those as fleet.user and fleet.password_file, and here only "
            "mqtts://HOST:PORT");
    Broker broker = of_scheme(address);
    std::string_view rest = address.substr(address.find("://") + 3);
    if (rest.ends_with('/')) rest.remove_suffix(1);
    if (rest.find_first_of("/?#") != std::string_view::npos) refuse("has a path after the host, and a broker has none");
    if (rest.starts_with('[')) {
        const std::size_t end = rest.find(']');
        if (end == std::string_view::npos) refuse("has a [ without its ]");
        broker.host = parse_ipv6(rest.substr(1, end - 1));
        broker.port = port_after_brackets(rest.substr(end + 1)).value_or(broker.port);
        return broker;
    }
    if (std::count(rest.begin(), rest.end(), ':') > 1)
        refuse("has several colons after its host: an IPv6 address has brackets, as mqtt://[2001:db8::1]:1883");
    const std::size_t colon = rest.find(':');
    broker.host = parse_name(rest.substr(0, colon));
    if (colon != std::string_view::npos) broker.port = parse_port(rest.substr(colon + 1));
    return broker;
}

std::string to_text(const Broker& broker) {
    if (broker.host.find(':') == std::string::npos) return fmt::format("{}:{}", broker.host, broker.port);
    std::string host = broker.host;
    if (const std::size_t percent = host.find('%'); percent != std::string::npos) host.insert(percent + 1, "25");
    return fmt::format("[{}]:{}", host, broker.port);
}

}  // namespace quadrat::site
