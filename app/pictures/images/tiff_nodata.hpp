// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string_view>

namespace quadrat::pictures {

// The number that stands for "nothing was measured here" in the first picture of a TIFF, as GDAL and its kin write it.
// Nothing where the file says none, where it says "nan", and in any other bytes.
std::optional<float> nodata_of_tiff(std::string_view tiff);

}  // namespace quadrat::pictures
