// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "pictures/image_file.hpp"

namespace quadrat::pictures {

// Which of a picture's own numbers are black and white: metres of a digital elevation model, say.
struct MaskRange {
    float low = 0;
    float high = 1;
};
// "LOW:HIGH"; throws InputError naming the option that it was given with.
MaskRange mask_range_from(const std::string& text, std::string_view option = "--mask-range");

struct Mask {
    mesh::Field share;  // 0 black to 1 white
    // Samples that know nothing and have what is around them: no numbers, or a value that elevation models use for it.
    std::size_t holes = 0;
    std::size_t cut = 0;  // beyond the range
};

// Without a range, whole numbers without a sign mean what they do in a picture, and the others must be 0 to 1. Holes
// are told by nodata, and by what is usual (-9999, -32768 …). Throws InputError naming the file, and the range to
// write with the option.
Mask mask_from(const GreyPicture& picture, const std::string& name, std::optional<MaskRange> range,
               std::optional<float> nodata, std::string_view option = "--mask-range");

}  // namespace quadrat::pictures
