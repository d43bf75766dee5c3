// SPDX-License-Identifier: Apache-2.0
// VESA Enhanced EDID Standard, release A revision 2 (EDID 1.4), section 3; CTA-861-H, section 7.5 (data blocks).
#include "display/kms/edid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace quadrat::display {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::size_t kBlock = 128;
constexpr std::array<std::uint8_t, 8> kHeader{0x00, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x00};
constexpr std::array<std::size_t, 4> kDescriptors{54, 72, 90, 108};
constexpr std::size_t kDescriptorLength = 18;
constexpr std::uint8_t kNameTag = 0xfc;
constexpr std::uint8_t kSerialTag = 0xff;
constexpr std::uint8_t kCtaTag = 0x02;
constexpr unsigned kVendorBlock = 3;
constexpr std::uint32_t kHdmiVendor = 0x000c03;

bool sums_to_zero(Bytes block) { return (std::accumulate(block.begin(), block.end(), 0U) & 0xffU) == 0U; }

std::string vendor_of(Bytes block, std::vector<std::string>& faults) {
    const unsigned packed = static_cast<unsigned>(block[8]) << 8U | block[9];
    std::string letters;
    for (const unsigned shift : {10U, 5U, 0U}) {
        const unsigned number = packed >> shift & 0x1fU;
        const bool is_letter = number >= 1 && number <= 26;
        letters += is_letter ? static_cast<char>('A' + static_cast<char>(number) - 1) : '?';
    }
    if (letters.find('?') != std::string::npos) faults.push_back("the vendor is not three letters");
    return letters;
}

// Ended by a line feed, padded by spaces; screens in the field put anything else there, so only what prints is kept.
std::string text_of(Bytes descriptor) {
    std::string text;
    for (const std::uint8_t byte : descriptor.subspan(5, 13)) {
        if (byte == '\n' || byte == '\0') break;
        text += byte >= 0x20 && byte < 0x7f ? static_cast<char>(byte) : '?';
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

void read_timing(Bytes timing, Edid& edid) {
    if (edid.native) return;
    const double clock_hz = (timing[0] | timing[1] << 8) * 10'000.0;
    const int width = timing[2] | (timing[4] & 0xf0) << 4;
    const int blank_x = timing[3] | (timing[4] & 0x0f) << 8;
    const int height = timing[5] | (timing[7] & 0xf0) << 4;
    const int blank_y = timing[6] | (timing[7] & 0x0f) << 8;
    const double total = static_cast<double>(width + blank_x) * (height + blank_y);
    if (width == 0 || height == 0 || total <= 0.0) {
        edid.faults.push_back("its first detailed timing has no pixels");
        return;
    }
    edid.native = Size{width, height};
    edid.native_hz = clock_hz / total;
    const Size size_mm{timing[12] | (timing[14] & 0xf0) << 4, timing[13] | (timing[14] & 0x0f) << 8};
    // Some fill in the aspect ratio, 16 by 9 "millimetres".
    if (size_mm.width > 32 && size_mm.height > 18) edid.size_mm = size_mm;
}

void read_descriptor(Bytes descriptor, Edid& edid) {
    if (descriptor[0] != 0 || descriptor[1] != 0) return read_timing(descriptor, edid);
    if (descriptor[3] == kNameTag) edid.name = text_of(descriptor);
    if (descriptor[3] == kSerialTag) edid.serial_text = text_of(descriptor);
}

// Data blocks lie from byte 4 to where the detailed timings start; each begins with its tag and length.
void read_cta(Bytes block, Edid& edid) {
    const std::size_t end = std::min<std::size_t>(block[2], kBlock - 1);
    for (std::size_t at = 4; at < end;) {
        const unsigned tag = block[at] >> 5U;
        const std::size_t length = block[at] & 0x1fU;
        if (at + 1 + length > end) {
            edid.faults.push_back("a data block is longer than its extension");
            return;
        }
        if (tag == kVendorBlock && length >= 3) {
            const std::uint32_t vendor = block[at + 1] | block[at + 2] << 8 | block[at + 3] << 16;
            edid.is_hdmi = edid.is_hdmi || vendor == kHdmiVendor;
        }
        at += 1 + length;
    }
}

void read_extensions(Bytes bytes, Edid& edid) {
    const std::size_t promised = bytes[126];
    const std::size_t present = bytes.size() / kBlock - 1;
    if (promised > present)
        edid.faults.push_back(fmt::format("{} of {} extensions are missing", promised - present, promised));
    for (std::size_t i = 1; i <= std::min(promised, present); ++i) {
        const Bytes block = bytes.subspan(i * kBlock, kBlock);
        if (!sums_to_zero(block))
            edid.faults.push_back(fmt::format("the checksum of extension {} is wrong", i));
        else if (block[0] == kCtaTag)
            read_cta(block, edid);
    }
}

}  // namespace

std::optional<Edid> read_edid(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kBlock || !std::equal(kHeader.begin(), kHeader.end(), bytes.begin())) return std::nullopt;
    Edid edid;
    if (!sums_to_zero(bytes.first(kBlock))) edid.faults.push_back("its checksum is wrong");
    edid.vendor = vendor_of(bytes, edid.faults);
    edid.product = static_cast<std::uint16_t>(bytes[10] | bytes[11] << 8);
    edid.serial = bytes[12] | bytes[13] << 8 | bytes[14] << 16 | static_cast<std::uint32_t>(bytes[15]) << 24U;
    edid.year = bytes[17] == 0 ? 0 : 1990 + bytes[17];
    edid.is_digital = (bytes[20] & 0x80U) != 0;
    edid.size_mm = {bytes[21] * 10, bytes[22] * 10};
    // One of the two alone is an aspect ratio, and both zero is a projector: neither is a size.
    if (bytes[21] == 0 || bytes[22] == 0) edid.size_mm = {};
    for (const std::size_t at : kDescriptors) read_descriptor(bytes.subspan(at, kDescriptorLength), edid);
    read_extensions(bytes, edid);
    return edid;
}

std::string identity_of(const std::optional<Edid>& edid) {
    if (!edid) return "no EDID";
    std::string line = fmt::format("{} 0x{:04x}", edid->vendor, edid->product);
    if (!edid->name.empty()) line += fmt::format(" '{}'", edid->name);
    if (!edid->serial_text.empty()) return line + fmt::format(" serial {}", edid->serial_text);
    return edid->serial == 0 ? line : line + fmt::format(" serial {}", edid->serial);
}

// FNV-1a, 64 bits.
std::uint64_t fingerprint_of(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return 0;
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3ULL;
    return hash == 0 ? 1 : hash;
}

}  // namespace quadrat::display
