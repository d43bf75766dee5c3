// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "display/display.hpp"

// What a graphics card says about itself, as plain values: the choices below are made over these, so that they can be
// tested with cards nobody here has.
namespace quadrat::display {

struct ScreenMode {
    Size size;
    double refresh_hz = 0.0;
    bool is_preferred = false;  // the screen's own wish
    bool is_interlaced = false;
    friend bool operator==(const ScreenMode&, const ScreenMode&) = default;
};

enum class Plug { Connected, Disconnected, Unknown };
enum class ConnectorUse {
    Screen,
    Virtual,   // of a virtual machine or a remote desktop: taken when there is no real one
    Writeback  // a recorder inside the card; nobody sees it
};

struct Connector {
    std::uint32_t id = 0;
    std::string name;  // as the kernel has it: "HDMI-A-1"
    ConnectorUse use = ConnectorUse::Screen;
    Plug plug = Plug::Unknown;
    bool is_link_bad = false;  // the kernel's link-status: pixels do not arrive, a new modeset is wanted
    std::vector<ScreenMode> modes;
    std::vector<std::uint8_t> edid;  // empty when the screen or its cable gives none
};

struct Card {
    std::string path;    // "/dev/dri/card1": differs from start to start, never kept
    std::string driver;  // "vc4"
    bool is_atomic = true;
    std::string problem;  // why it cannot be used at all: "permission denied…"; empty when it can
    std::vector<Connector> connectors;
};

}  // namespace quadrat::display
