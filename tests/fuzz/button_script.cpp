// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "firmware-io/scripted/scripted_buttons.hpp"

using namespace quadrat::firmware_io;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) try {
    scripted::ScriptedButtons buttons{scripted::parse_script({reinterpret_cast<const char*>(bytes), size}, "fuzz")};
    std::array<bool, kButtons.size()> is_down{};
    for (const ButtonEdge& edge : buttons.poll(Instant::max() / 2)) {
        bool& down = is_down[index_of(edge.button)];
        if (down == (edge.motion == Motion::Down)) std::abort();
        down = !down;
    }
    if (!buttons.is_finished()) std::abort();
    return 0;
} catch (const scripted::ScriptError& error) {
    return std::string_view{error.what()}.find('\n') == std::string_view::npos ? 0 : (std::abort(), 0);
}
