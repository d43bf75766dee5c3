// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/input_spec.hpp"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "firmware-io/hid/hidraw.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        quadrat::firmware_io::parse_input_spec({reinterpret_cast<const char*>(bytes), size});
    } catch (const std::invalid_argument& error) {
        if (std::string_view{error.what()}.find('\n') != std::string_view::npos) std::abort();
    }
    const std::string text{reinterpret_cast<const char*>(bytes), size};
    quadrat::firmware_io::hid::parse_uevent(text);
    try {
        using namespace quadrat::firmware_io::hid;
        const auto mappings = parse_mappings(text, "fuzz");
        if (parse_mappings(to_text(mappings), "again").size() != mappings.size()) std::abort();
    } catch (const std::invalid_argument& error) {
        if (std::string_view{error.what()}.find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
