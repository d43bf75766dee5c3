// SPDX-License-Identifier: Apache-2.0
#include "site/screen.hpp"

namespace quadrat::site {

display::DisplayOptions display_options(const Configuration& configuration) {
    display::DisplayOptions options;
    options.kind = display::kind_from(configuration.screen.display, "display");
    if (!configuration.screen.size.empty()) options.size = display::size_from(configuration.screen.size, "size");
    options.connector = configuration.screen.connector;
    options.mode = configuration.screen.mode;
    options.rotation = static_cast<display::Rotation>(configuration.screen.rotation_deg / 90);
    options.mirroring = configuration.screen.is_mirrored ? display::Mirroring::Mirrored : display::Mirroring::None;
    return options;
}

std::vector<std::string> default_inputs(std::string_view display_kind) {
    if (display_kind == "window") return {"keyboard", "hid:"};
    return {"hid:"};
}

}  // namespace quadrat::site
