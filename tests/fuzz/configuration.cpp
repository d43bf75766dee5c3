// SPDX-License-Identifier: Apache-2.0
#include "kiosk/configuration.hpp"

#include <cstddef>
#include <cstdint>

#include "base/error.hpp"

// Any bytes are a configuration or are refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        quadrat::kiosk::configuration_from({reinterpret_cast<const char*>(bytes), size}, "fuzz.toml");
    } catch (const quadrat::base::InputError&) {
    }
    return 0;
}
