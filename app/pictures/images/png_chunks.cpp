// SPDX-License-Identifier: Apache-2.0
#include "pictures/images/png_chunks.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

namespace quadrat::pictures {
namespace {

constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::size_t kAroundData = 12;  // length and kind before it, checksum after it

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    return number;
}

struct Chunk {
    std::string_view kind;
    std::string_view whole;

    bool has_right_checksum() const {
        const std::string_view summed = whole.substr(4, whole.size() - 8);
        return ::crc32_z(0, reinterpret_cast<const Bytef*>(summed.data()), summed.size()) ==
               number_at(whole, whole.size() - 4);
    }
    bool is_text() const { return kind == "tEXt" || kind == "zTXt" || kind == "iTXt"; }
};

// Up to and with IEND; fewer where the bytes end before it.
std::vector<Chunk> chunks_of(std::string_view png) {
    std::vector<Chunk> chunks;
    std::string_view rest = png.substr(kSignature.size());
    while (rest.size() >= kAroundData) {
        const std::size_t size = std::size_t{number_at(rest, 0)} + kAroundData;
        if (size > rest.size()) break;
        chunks.push_back({rest.substr(4, 4), rest.substr(0, size)});
        if (chunks.back().kind == "IEND") break;
        rest.remove_prefix(size);
    }
    return chunks;
}

}  // namespace

std::string damage_of_png(std::string_view png) {
    if (!png.starts_with(kSignature)) return "it does not begin as a PNG does";
    const std::vector<Chunk> chunks = chunks_of(png);
    bool has_pixels = false;
    for (const Chunk& chunk : chunks) {
        if (!chunk.has_right_checksum()) return fmt::format("the checksum of its part {} is wrong", chunk.kind);
        has_pixels = has_pixels || chunk.kind == "IDAT";
    }
    if (chunks.empty() || chunks.front().kind != "IHDR") return "it has no size";
    if (chunks.back().kind != "IEND") return fmt::format("it is cut off after {} bytes", png.size());
    return has_pixels ? "" : "it has no pixels";
}

std::string with_texts_first(std::string png) {
    if (!damage_of_png(png).empty()) return png;
    std::string before;
    std::string texts;
    std::string after;
    for (const Chunk& chunk : chunks_of(png)) {
        const bool is_behind = !after.empty() || chunk.kind == "IDAT";
        (chunk.is_text() && is_behind ? texts : is_behind ? after : before) += chunk.whole;
    }
    return std::string(kSignature) + before + texts + after;
}

}  // namespace quadrat::pictures
