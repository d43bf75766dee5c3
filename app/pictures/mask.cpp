// SPDX-License-Identifier: Apache-2.0
#include "pictures/mask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/error.hpp"
#include "synthesis/land/masks.hpp"

namespace quadrat::pictures {
namespace {

// What GDAL, SRTM and ESRI's tools write where nothing was measured.
constexpr std::array kUsualNodata{-9999.0F, -99999.0F, -32768.0F, -32767.0F};
constexpr float kNoHeight = 1.0e30F;  // beyond it lie the largest floats, which are used the same way

struct Holes {
    MaskRange within;  // a usual value in the range that was asked for is a height
    std::optional<float> nodata;
    bool has_usual = true;

    bool is_one(float value) const {
        if (!std::isfinite(value) || std::abs(value) > kNoHeight || value == nodata) return true;
        const bool is_inside = value >= within.low && value <= within.high;
        return has_usual && !is_inside && std::ranges::find(kUsualNodata, value) != kUsualNodata.end();
    }
};

void require_within(const mesh::Field& share, const std::string& name, std::string_view option) {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    for (const float value : share.samples) {
        if (std::isnan(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low >= 0 && high <= 1) return;
    throw base::InputError(fmt::format(
        "{0}: its heights are from {1:g} to {2:g}, and a picture of such numbers is from 0 to 1; say which are "
        "black and white: {3} {1:g}:{2:g}",
        name, low, high, option));
}

}  // namespace

MaskRange mask_range_from(const std::string& text, std::string_view option) {
    MaskRange range;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%f:%f%c", &range.low, &range.high, &rest) != 2 || !std::isfinite(range.low) ||
        !std::isfinite(range.high) || range.low >= range.high)
        throw base::InputError(
            fmt::format("{} {}: write LOW:HIGH, which of the picture's own numbers are black and white, as 200:1700",
                        option, text));
    return range;
}

Mask mask_from(const GreyPicture& picture, const std::string& name, std::optional<MaskRange> range,
               std::optional<float> nodata, std::string_view option) {
    const MaskRange taken = range.value_or(MaskRange{0, picture.white.value_or(1.0F)});
    const Holes holes{taken, nodata ? nodata : picture.nodata, !picture.white};
    Mask mask{picture.samples, 0, 0};
    for (float& value : mask.share.samples) {
        const bool is_hole = holes.is_one(value);
        mask.holes += is_hole;
        value = is_hole ? std::numeric_limits<float>::quiet_NaN() : (value - taken.low) / (taken.high - taken.low);
    }
    if (mask.holes == mask.share.samples.size())
        throw base::InputError(fmt::format("{}: none of its {} samples is a height", name, mask.holes));
    if (!range) require_within(mask.share, name, option);
    for (float& share : mask.share.samples) {
        mask.cut += share < 0 || share > 1;
        if (!std::isnan(share)) share = std::clamp(share, 0.0F, 1.0F);
    }
    synthesis::land::fill_holes(mask.share);
    return mask;
}

}  // namespace quadrat::pictures
