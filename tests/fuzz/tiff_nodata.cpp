// SPDX-License-Identifier: Apache-2.0
// Any bytes as a TIFF: what it says of holes is a number, or nothing.
#include "pictures/images/tiff_nodata.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto nodata = quadrat::pictures::nodata_of_tiff({reinterpret_cast<const char*>(bytes), size});
    if (nodata && !std::isfinite(*nodata)) std::abort();
    return 0;
}
