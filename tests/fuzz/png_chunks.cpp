// SPDX-License-Identifier: Apache-2.0
// Any bytes: where they are a whole PNG, the one with its texts first is whole too, and stays as it is.
#include "pictures/images/png_chunks.hpp"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::pictures;
    const std::string png(reinterpret_cast<const char*>(bytes), size);
    const std::string moved = with_texts_first(png);
    if (damage_of_png(png).empty() != damage_of_png(moved).empty()) std::abort();
    if (!damage_of_png(png).empty() && moved != png) std::abort();
    if (with_texts_first(moved) != moved) std::abort();
    return 0;
}
