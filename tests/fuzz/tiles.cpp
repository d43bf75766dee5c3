// SPDX-License-Identifier: Apache-2.0
// Any bytes as an example of tiles: either they are refused with their line, or they are read again from what is
// written of them, and a small box is filled in which nothing stands that the example does not show.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "synthesis/noise/model_synthesis.hpp"

namespace noise = quadrat::synthesis::noise;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const noise::Tiles example = noise::tiles_from({reinterpret_cast<const char*>(data), size}, "fuzz");
        if (!(noise::tiles_from(noise::text_of(example), "again") == example)) std::abort();
        if (example.cells.size() > 4096) return 0;  // slow, and says no more
        const noise::Tiles made = noise::synthesise(example, {5, 4, 3}, {}, quadrat::base::Seed{1});
        if (noise::forbidden_neighbours(example, made) != 0) std::abort();
    } catch (const quadrat::base::InputError& error) {
        if (std::string_view(error.what()).find("fuzz:") != 0) std::abort();
    }
    return 0;
}
