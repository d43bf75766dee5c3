// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/device.hpp"

#include <filesystem>
#include <string_view>

namespace quadrat::firmware_io {
namespace {

// "0079:0006"
std::string to_string(std::uint16_t vendor, std::uint16_t product) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text(9, ':');
    for (std::size_t i = 0; i < 4; ++i) {
        text[i] = kDigits[vendor >> (12 - 4 * i) & 0xfu];
        text[5 + i] = kDigits[product >> (12 - 4 * i) & 0xfu];
    }
    return text;
}

bool is_port(const std::string& beginning, const std::string& port) {
    return beginning.empty() ||
           (port.starts_with(beginning) && (port.size() == beginning.size() || port[beginning.size()] == '/'));
}

}  // namespace

std::string without_links(const std::string& path) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    return error ? path : real.string();
}

bool is_meant(const DeviceSelector& selector, const DeviceIdentity& device, const std::string& path) {
    const bool is_path = selector.path.empty() || selector.path == path || without_links(selector.path) == path;
    return is_path && is_port(selector.port, device.port) &&
           (selector.serial.empty() || selector.serial == device.serial) &&
           device.name.find(selector.name) != std::string::npos &&
           selector.vendor.value_or(device.vendor) == device.vendor &&
           selector.product.value_or(device.product) == device.product;
}

std::string in_words(std::string text, const DeviceSelector& selector) {
    if (selector.vendor && selector.product) text.append(" ").append(to_string(*selector.vendor, *selector.product));
    if (!selector.name.empty()) text.append(" \"").append(selector.name).append("\"");
    if (!selector.serial.empty()) text.append(" of serial ").append(selector.serial);
    if (!selector.path.empty()) text.append(" ").append(selector.path);
    if (!selector.port.empty()) text.append(" at ").append(selector.port);
    return text;
}

std::string describe(const std::string& path, const DeviceIdentity& device) {
    std::string text{path};
    return text.append(" (")
        .append(device.name)
        .append(" ")
        .append(to_string(device.vendor, device.product))
        .append(")");
}

std::string board_of(const DeviceIdentity& device) {
    const std::size_t interface = device.port.rfind("/input");
    std::string text = to_string(device.vendor, device.product);
    return text.append(" ").append(device.port.substr(0, interface)).append(" ").append(device.serial);
}

}  // namespace quadrat::firmware_io
