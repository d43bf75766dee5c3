// SPDX-License-Identifier: Apache-2.0
#include "projector/projector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "projector/cec.hpp"
#include "projector/pjlink.hpp"

namespace quadrat::projector {
namespace {

constexpr std::string_view kPjLink = "pjlink://";
constexpr std::string_view kCec = "cec:";

[[noreturn]] void refuse(const std::string& text, const char* why) {
    throw std::invalid_argument(
        fmt::format("is \"{}\": {}; write cec, cec:/dev/cec1, pjlink://192.168.0.30 or pjlink://NAME:4352", text, why));
}

bool is_host(std::string_view host) {
    constexpr std::size_t kLongest = 253;
    const bool is_plain = std::ranges::all_of(host, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
               c == ':' || c == '%' || c == '_';
    });
    return !host.empty() && host.size() <= kLongest && is_plain && host.front() != '-';
}

int port_from(const std::string& text, std::string_view digits) {
    constexpr int kLast = 65535;
    int port = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
    if (error != std::errc{} || end != digits.data() + digits.size() || port < 1 || port > kLast)
        refuse(text, "its port is no number from 1 to 65535");
    return port;
}

PjLink pjlink_from(const std::string& text) {
    std::string_view rest = std::string_view(text).substr(kPjLink.size());
    PjLink to;
    if (rest.starts_with('[')) {
        const std::size_t end = rest.find(']');
        if (end == std::string_view::npos) refuse(text, "its [ has no ]");
        to.host = rest.substr(1, end - 1);
        rest = rest.substr(end + 1);
    } else {
        const std::size_t colon = std::min(rest.find(':'), rest.size());
        to.host = rest.substr(0, colon);
        rest = rest.substr(colon);
    }
    if (!is_host(to.host)) refuse(text, "there is no name or number of a projector in it");
    if (rest.starts_with(':'))
        to.port = port_from(text, rest.substr(1));
    else if (!rest.empty())
        refuse(text, "there is something behind the address");
    return to;
}

}  // namespace

Address parse_address(const std::string& text) {
    if (text == "cec") return Cec{};
    if (text.starts_with(kPjLink)) return pjlink_from(text);
    if (!text.starts_with(kCec)) refuse(text, "it is neither CEC nor PJLink");
    const std::string device = text.substr(kCec.size());
    const bool is_device = device.starts_with("/dev/cec") && device.find("..") == std::string::npos &&
                           std::ranges::all_of(device, [](char c) { return c > ' ' && c < 127; });
    if (!is_device) refuse(text, "it names no device /dev/cec…");
    return Cec{device};
}

std::string to_text(const Address& address) {
    if (const auto* cec = std::get_if<Cec>(&address)) return "cec:" + cec->device;
    const auto& to = std::get<PjLink>(address);
    const bool is_number = to.host.find(':') != std::string::npos;
    return fmt::format("pjlink://{}{}{}:{}", is_number ? "[" : "", to.host, is_number ? "]" : "", to.port);
}

const char* name_of(Power power) {
    constexpr const char* kNames[] = {"off", "on", "cooling", "warming", "unknown"};
    return kNames[static_cast<std::size_t>(power)];
}

std::unique_ptr<Projector> open_projector(const Address& address, const std::string& password,
                                          std::chrono::milliseconds patience) {
    if (const auto* cec = std::get_if<Cec>(&address)) return open_cec(*cec, patience);
    return open_pjlink(std::get<PjLink>(address), password, patience);
}

}  // namespace quadrat::projector
