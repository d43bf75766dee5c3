// SPDX-License-Identifier: Apache-2.0
// Tables of ratios to what others need: what is read can be shown.
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "benches/peer_table.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::benches;
    try {
        const std::string_view text(reinterpret_cast<const char*>(bytes), size);
        if (section_of(peer_table_from(text, "input")).find("</section>") == std::string::npos) std::abort();
    } catch (const quadrat::base::InputError&) {
    }
    return 0;
}
