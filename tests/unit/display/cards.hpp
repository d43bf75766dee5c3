// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "display/kms/card.hpp"

namespace quadrat::display::testing {

inline ScreenMode mode(int width, int height, double hz) { return {{width, height}, hz, false, false}; }
inline ScreenMode preferred(int width, int height, double hz) { return {{width, height}, hz, true, false}; }
inline ScreenMode interlaced(int width, int height, double hz) { return {{width, height}, hz, false, true}; }

inline Connector connector(std::uint32_t id, std::string name, Plug plug) {
    Connector made;
    made.id = id;
    made.name = std::move(name);
    made.plug = plug;
    if (plug != Plug::Disconnected) made.modes = {preferred(1920, 1080, 60.0), mode(1280, 720, 60.0)};
    return made;
}
inline Connector as(ConnectorUse use, Connector made) {
    made.use = use;
    return made;
}

// The cards of a Raspberry Pi: one that draws and has no connectors, one that shows.
inline Card v3d(std::string path) { return {std::move(path), "v3d", true, "", {}}; }
inline Card vc4(std::string path, Plug first, Plug second) {
    return {std::move(path),
            "vc4",
            true,
            "",
            {connector(32, "HDMI-A-1", first), connector(42, "HDMI-A-2", second),
             as(ConnectorUse::Writeback, connector(50, "Writeback-1", Plug::Connected))}};
}

}  // namespace quadrat::display::testing
