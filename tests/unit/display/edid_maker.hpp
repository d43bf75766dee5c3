// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace quadrat::display::testing {

struct MadeTiming {
    int clock_10khz = 14850;
    int width = 1920, blank_x = 280, height = 1080, blank_y = 45;
    int width_mm = 0, height_mm = 0;
};

struct MadeEdid {
    std::string vendor = "EPS";
    std::uint16_t product = 0x1234;
    std::uint32_t serial = 0;
    int year = 2019;
    int width_cm = 0, height_cm = 0;
    bool is_digital = true;
    std::string name = "EPSON PJ";
    std::string serial_text;
    MadeTiming timing;
    bool has_hdmi = true;  // a CTA-861 extension with HDMI's data block
};

// Byte for byte as the standard lays it out, checksums included.
std::vector<std::uint8_t> bytes_of(const MadeEdid& edid);
void mend_checksum(std::vector<std::uint8_t>& edid, std::size_t block);

}  // namespace quadrat::display::testing
