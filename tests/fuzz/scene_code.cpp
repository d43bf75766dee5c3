// SPDX-License-Identifier: Apache-2.0
// Codes from outside: an error of one line, or a scene whose code comes back.
#include "genome/scene_code.hpp"

#include <cstdlib>

#include "base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    try {
        const genome::Recipe recipe = genome::recipe_of_code({reinterpret_cast<const char*>(bytes), size}, "fuzz");
        if (genome::recipe_of_code(genome::code_of(recipe), "again") != recipe) std::abort();
    } catch (const base::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
