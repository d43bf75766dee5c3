// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "display/display.hpp"

namespace quadrat::display {

// What a screen says of itself (VESA E-EDID 1.4; the extension is CTA-861). The kernel takes the modes from it; we read
// who the screen is, to know it again and to tell staff when it was exchanged.
struct Edid {
    std::string vendor;  // three letters, "DEL"
    std::uint16_t product = 0;
    std::uint32_t serial = 0;
    int year = 0;             // made, or model year; 0: not said
    std::string name;         // "DELL U2412M"; empty: not said
    std::string serial_text;  // empty: not said
    bool is_digital = false;
    bool is_hdmi = false;        // has HDMI's own data block: a television or projector rather than a DVI monitor
    Size size_mm;                // of the picture; 0x0: not said, as projectors do
    std::optional<Size> native;  // the first detailed timing
    double native_hz = 0.0;
    std::vector<std::string> faults;  // what is wrong with it, for the log; the rest is as read
};

// Never throws, whatever the bytes. Nothing: not an EDID (empty, short, wrong header).
std::optional<Edid> read_edid(std::span<const std::uint8_t> bytes);

// "DEL 0xa0b3 'DELL U2412M' serial 1234"; "no EDID" for nothing. The same screen gives the same line.
std::string identity_of(const std::optional<Edid>& edid);

// 64 bits that differ when the bytes do; 0 only for no bytes.
std::uint64_t fingerprint_of(std::span<const std::uint8_t> bytes);

}  // namespace quadrat::display
