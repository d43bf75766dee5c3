// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::tests {

// A report and the buttons that our default bindings find pressed in it ("" for none, "A Back" for two).
struct SpecimenReport {
    std::string_view bytes;
    std::string_view pressed;
};

// A kind of HID device: how its report descriptor is built, what is to be found in it, and reports one after the other.
// Bytes in hexadecimal. Written after the layouts that such devices have; shortened where they repeat themselves.
struct HidSpecimen {
    std::string_view name;
    std::string_view descriptor;
    std::size_t applications, buttons, keys, hats, axes, arrays;
    std::vector<SpecimenReport> reports;
};
const std::vector<HidSpecimen>& hid_specimens();

std::vector<std::uint8_t> bytes_of(std::string_view hexadecimal);

}  // namespace quadrat::tests
