// SPDX-License-Identifier: Apache-2.0
// Any text is a façade's grammar or is refused with its line and column; what it derives is finite and bounded.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "synthesis/houses/facade.hpp"

namespace houses = quadrat::synthesis::houses;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 20'000) return 0;
    try {
        const houses::FacadeGrammar grammar = houses::read_facade({reinterpret_cast<const char*>(data), size}, "fuzz");
        for (const houses::FacadePanel& panel : houses::derive_facade(grammar, {7, 5, 3, {}}, quadrat::base::Seed{1}))
            if (!std::isfinite(panel.depth_m) || !(panel.low_m.x < panel.high_m.x)) std::abort();
    } catch (const quadrat::base::InputError& error) {
        if (std::string_view(error.what()).find("fuzz:") != 0) std::abort();
    }
    return 0;
}
