// SPDX-License-Identifier: Apache-2.0
// Any bytes are text, which reads the same a second time, or are refused in one line that names the file.
#include "base/text_file.hpp"

#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "base/markup.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::base;
    const std::string given(reinterpret_cast<const char*>(bytes), size);
    constexpr TextLimits kLimits{1U << 16U, 1U << 10U};
    const std::string safe = escaped(given);
    if (safe.find_first_of("<>\"'") != std::string::npos) std::abort();
    try {
        const std::string text = text_from(given, "fuzz", kLimits);
        if (text.find('\0') != std::string::npos || text.find("\r\n") != std::string::npos) std::abort();
        if (text_from(text, "fuzz", kLimits) != text) std::abort();
    } catch (const InputError& error) {
        const std::string_view what = error.what();
        if (!what.starts_with("fuzz:") || what.find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
