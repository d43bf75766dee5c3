// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Who a device on a cable is, and how a site names the one it means: the same for hidraw and evdev.
namespace quadrat::firmware_io {

// Cheap boards share vendor and product and have no serial, so equal ones differ only by the port.
struct DeviceIdentity {
    std::uint16_t vendor = 0, product = 0;
    std::string name;    // as the device calls itself, for people
    std::string serial;  // usually ""
    std::string port;    // where it is plugged in, and which interface: "usb-0000:00:14.0-1.2/input0"
};

// Which device is meant. What is not given is any.
struct DeviceSelector {
    std::optional<std::uint16_t> vendor, product;
    std::string path = {};    // "/dev/hidraw3", or a link to it
    std::string port = {};    // the beginning of DeviceIdentity::port, up to a '/' or its end
    std::string serial = {};  // all of it
    std::string name = {};    // a part of it
    friend bool operator==(const DeviceSelector&, const DeviceSelector&) = default;
};

// Whether the device answers to all that is given. A path that is a link stands for what it leads to.
bool is_meant(const DeviceSelector& selector, const DeviceIdentity& device, const std::string& path);

// "HID device 0079:0006 at usb-1"; `kind` alone for any.
std::string in_words(std::string kind, const DeviceSelector& selector);

// "/dev/hidraw0 (Generic USB Joystick 0079:0006)"
std::string describe(const std::string& path, const DeviceIdentity& device);

// The same for all interfaces of one board, whichever of the kernel's ways leads to them. A device that tells neither
// its port nor its serial cannot be told from its equals.
std::string board_of(const DeviceIdentity& device);

// Of these, those that are meant; a path stands for the whole board.
template <typename Facts>
std::vector<Facts> those_meant(const DeviceSelector& selector, std::vector<Facts> all) {
    std::vector<Facts> found;
    std::vector<std::string> boards;
    for (const Facts& device : all)
        if (is_meant(selector, device.identity, device.path)) boards.push_back(board_of(device.identity));
    for (Facts& device : all) {
        const bool is_of_board = !selector.path.empty() && !device.identity.port.empty() &&
                                 std::find(boards.begin(), boards.end(), board_of(device.identity)) != boards.end();
        if (is_of_board || is_meant(selector, device.identity, device.path)) found.push_back(std::move(device));
    }
    return found;
}

// Where a link leads to; the path itself where there is none.
std::string without_links(const std::string& path);

}  // namespace quadrat::firmware_io
