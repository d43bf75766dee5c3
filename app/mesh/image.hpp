// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

namespace quadrat::mesh {

// Eight bits a channel, rows from the top, channels interleaved. Colours are sRGB-encoded where a user of the image
// says "colour", plain numbers elsewhere.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 4;  // 1, 2 or 4
    std::vector<std::uint8_t> bytes;

    Image() = default;
    Image(int width_, int height_, int channels_)
        : width(width_),
          height(height_),
          channels(channels_),
          bytes(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                static_cast<std::size_t>(channels_)) {}
    std::uint8_t* pixel(int x, int y) {
        return bytes.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels);
    }
    const std::uint8_t* pixel(int x, int y) const { return const_cast<Image*>(this)->pixel(x, y); }
    friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace quadrat::mesh
