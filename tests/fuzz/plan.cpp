// SPDX-License-Identifier: Apache-2.0
// Any text is a plan for a roof or is refused in one line that names it.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "commands/plan_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const quadrat::commands::PlanFile file =
            quadrat::commands::plan_from({reinterpret_cast<const char*>(data), size}, "fuzz");
        if (file.options.profile_of_edge.size() != file.plan.edge_count()) std::abort();
    } catch (const quadrat::base::InputError& error) {
        const std::string_view what = error.what();
        if (what.find("fuzz:") != 0 || what.find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
