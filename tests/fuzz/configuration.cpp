// SPDX-License-Identifier: Apache-2.0
#include "site/configuration.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

// Any bytes are a configuration, or have mistakes: each in one line, with what is wrong, what would be right, and
// where.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::site;
    const std::string_view toml{reinterpret_cast<const char*>(bytes), size};
    const auto any_font = [](const std::string&) { return std::string{}; };
    const auto last_line = 1 + std::count(toml.begin(), toml.end(), '\n');
    int line = 0;
    for (const Mistake& mistake : check_configuration(toml, "fuzz.toml", any_font).mistakes) {
        const bool is_told =
            !mistake.what.empty() && !mistake.remedy.empty() && to_text(mistake).find('\n') == std::string::npos;
        // Of a text that is cut the end is the place, which TOML takes to be a line further.
        if (!is_told || mistake.line < line || mistake.line > last_line + 1) std::abort();
        line = mistake.line;
    }
    return 0;
}
