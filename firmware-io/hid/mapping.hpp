// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <string_view>

#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/hid_host.hpp"

namespace quadrat::firmware_io::hid {

// What was taught about one device. Serial and port are one word each, "" where the device has none.
struct HidMapping {
    std::uint16_t vendor = 0, product = 0;
    std::string serial, port;
    Bindings bindings;
    friend bool operator==(const HidMapping&, const HidMapping&) = default;
};

// The mapping of a device: the one of its serial number, else of its port, else the only one of its kind (a board that
// was moved to another port keeps its mapping; of two equal boards each keeps its own). Null if there is none.
const HidMapping* mapping_of(std::span<const HidMapping> mappings, const HidIdentity& device);

// Puts a mapping among the others, in place of an earlier one of the same device.
void remember(std::vector<HidMapping>& mappings, HidMapping mapping);

// As text, to be kept and edited by hand:
//
//     device 0079:0006
//     serial 4711                                  # only if it has one
//     port usb-0000:00:14.0-1.2/input0             # only if it has one
//     A = 0009:0001 pressed, collection 0          # usage page and usage, the part, the top-level collection
//     Back = 0001:0039 left, collection 0
//
// Parsing is pure, for any bytes, and throws std::invalid_argument: "SOURCE:LINE: what is wrong; what would be right".
std::string to_text(std::span<const HidMapping> mappings);
std::vector<HidMapping> parse_mappings(std::string_view text, std::string_view source_name);

// Reads and parses. Throws std::invalid_argument, naming the file.
std::vector<HidMapping> read_mappings(const std::filesystem::path& file);

}  // namespace quadrat::firmware_io::hid
