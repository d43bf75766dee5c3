// SPDX-License-Identifier: Apache-2.0
#include "unit/display/edid_maker.hpp"

#include <algorithm>

namespace quadrat::display::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint8_t low(int value) { return static_cast<std::uint8_t>(value & 0xff); }

void put(Bytes& bytes, std::size_t at, std::initializer_list<int> values) {
    for (const int value : values) bytes[at++] = low(value);
}

void put_text(Bytes& bytes, std::size_t at, int tag, const std::string& text) {
    put(bytes, at, {0, 0, 0, tag, 0});
    for (std::size_t i = 0; i < 13; ++i)
        bytes[at + 5 + i] = i < text.size() ? static_cast<std::uint8_t>(text[i]) : i == text.size() ? '\n' : ' ';
}

void put_timing(Bytes& bytes, std::size_t at, const MadeTiming& t) {
    put(bytes, at, {t.clock_10khz, t.clock_10khz >> 8, t.width, t.blank_x, (t.width >> 8) << 4 | t.blank_x >> 8});
    put(bytes, at + 5, {t.height, t.blank_y, (t.height >> 8) << 4 | t.blank_y >> 8, 88, 44, 0x45, 0});
    put(bytes, at + 12, {t.width_mm, t.height_mm, (t.width_mm >> 8) << 4 | t.height_mm >> 8, 0, 0, 0x1e});
}

Bytes cta_block() {
    Bytes block(128, 0);
    put(block, 0, {0x02, 0x03, 0x0f, 0xf1});
    put(block, 4, {0x43, 0x10, 0x04, 0x03});              // video: 1080p50, 720p60, 480p
    put(block, 8, {0x65, 0x03, 0x0c, 0x00, 0x10, 0x00});  // vendor: HDMI Licensing, address 1.0.0.0
    return block;
}

}  // namespace

void mend_checksum(Bytes& edid, std::size_t block) {
    std::uint8_t sum = 0;
    for (std::size_t i = 0; i < 127; ++i) sum = low(sum + edid[block * 128 + i]);
    edid[block * 128 + 127] = low(-sum);
}

Bytes bytes_of(const MadeEdid& made) {
    Bytes bytes(128, 0);
    put(bytes, 0, {0, 255, 255, 255, 255, 255, 255, 0});
    const int vendor = (made.vendor[0] - 'A' + 1) << 10 | (made.vendor[1] - 'A' + 1) << 5 | (made.vendor[2] - 'A' + 1);
    put(bytes, 8, {vendor >> 8, vendor, made.product, made.product >> 8});
    for (int i = 0; i < 4; ++i) bytes[static_cast<std::size_t>(12 + i)] = low(static_cast<int>(made.serial >> (8 * i)));
    put(bytes, 16,
        {12, made.year - 1990, 1, 4, made.is_digital ? 0xa3 : 0x08, made.width_cm, made.height_cm, 120, 0x0a});
    put_timing(bytes, 54, made.timing);
    put_text(bytes, 72, 0xfc, made.name);
    if (!made.serial_text.empty()) put_text(bytes, 90, 0xff, made.serial_text);
    put(bytes, 108, {0, 0, 0, 0xfd, 0, 48, 62, 15, 80, 17});
    if (made.has_hdmi) {
        bytes[126] = 1;
        const Bytes extension = cta_block();
        bytes.insert(bytes.end(), extension.begin(), extension.end());
        mend_checksum(bytes, 1);
    }
    mend_checksum(bytes, 0);
    return bytes;
}

}  // namespace quadrat::display::testing
