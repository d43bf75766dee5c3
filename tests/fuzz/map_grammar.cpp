// SPDX-License-Identifier: Apache-2.0
// Any text is a grammar of cells or is refused with its line and column; its cells stay whole however they divide.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "unit/synthesis/map_faults.hpp"

namespace lsystem = quadrat::synthesis::lsystem;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const lsystem::MapGrammar grammar =
            lsystem::read_map_grammar({reinterpret_cast<const char*>(data), size}, "fuzz");
        const std::vector<glm::vec2> outline = lsystem::regular_outline(grammar.start.size());
        const lsystem::Map whole = lsystem::derive_map(grammar, outline, {.steps = 0}, quadrat::base::Seed{1});
        const lsystem::Map map = lsystem::derive_map(
            grammar, outline, {.chance = 0.5F, .pull = static_cast<int>(size % 3), .most_cells = 200},
            quadrat::base::Seed{size});
        if (!quadrat::tests::map_faults(map, whole.area(0)).empty()) std::abort();
    } catch (const quadrat::base::InputError& error) {
        if (std::string_view(error.what()).find("fuzz:") != 0) std::abort();
    }
    return 0;
}
