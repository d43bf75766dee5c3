// SPDX-License-Identifier: Apache-2.0
// Scenes from outside: an error of one line, or a recipe that comes back exactly.
#include "genome/recipe.hpp"

#include <cstdlib>
#include <string_view>

#include "base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    try {
        const genome::Recipe recipe = genome::from_json({reinterpret_cast<const char*>(bytes), size}, "fuzz");
        if (genome::from_json(genome::to_json(recipe), "again") != recipe) std::abort();
    } catch (const base::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
