// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "display/options.hpp"
#include "doctor/diagnosis.hpp"
#include "doctor/diagnosis_access.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;

struct SeenConnector {
    std::string name;  // "HDMI-A-1"
    bool has_screen = false;
    std::vector<std::string> modes;  // "1920x1080"; each size once or more
};

std::vector<std::string> lines_in(const fs::path& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

std::vector<SeenConnector> connectors_in(const fs::path& sysfs_drm) {
    std::vector<SeenConnector> seen;
    for (const fs::path& path : entries_of(sysfs_drm)) {
        const std::string name = path.filename().string();
        const std::size_t dash = name.find('-');
        const bool is_connector = name.starts_with("card") && dash != std::string::npos && fs::exists(path / "status");
        if (!is_connector) continue;
        const auto status = lines_in(path / "status");
        seen.push_back(
            {name.substr(dash + 1), !status.empty() && status.front() == "connected", lines_in(path / "modes")});
    }
    return seen;
}

std::optional<Finding> connector_trouble(const std::string& wanted, const std::vector<SeenConnector>& seen) {
    if (wanted.empty() || seen.empty()) return std::nullopt;
    const auto found = std::ranges::find(seen, wanted, &SeenConnector::name);
    std::vector<std::string> names, lit;
    for (const SeenConnector& connector : seen) names.push_back(connector.name);
    for (const SeenConnector& connector : seen)
        if (connector.has_screen) lit.push_back(connector.name);
    if (found == seen.end())
        return Finding{"screen", Health::Bad,
                       fmt::format("screen.connector is \"{}\": there is no such output here", wanted),
                       fmt::format("there are {}; until then the first with a screen is used", fmt::join(names, ", "))};
    if (found->has_screen || lit.empty()) return std::nullopt;
    return Finding{"screen", Health::Bad,
                   fmt::format("screen.connector is \"{}\": nothing is plugged in there, but a screen is on {}", wanted,
                               fmt::join(lit, ", ")),
                   "plug the screen in there, or name where it is"};
}

std::optional<Finding> mode_trouble(const site::Configuration::Screen& wanted, const std::vector<SeenConnector>& seen) {
    const auto mode = display::mode_from(wanted.mode, "screen.mode");
    if (!mode) return std::nullopt;
    const std::string size = fmt::format("{}x{}", mode->size.width, mode->size.height);
    for (const SeenConnector& connector : seen) {
        const bool is_ours = wanted.connector.empty() || wanted.connector == connector.name;
        const bool is_known = connector.has_screen && !connector.modes.empty();
        if (!is_ours || !is_known || std::ranges::find(connector.modes, size) != connector.modes.end()) continue;
        return Finding{
            "screen", Health::Doubtful,
            fmt::format("screen.mode is \"{}\": the screen on {} does not offer {}", wanted.mode, connector.name, size),
            fmt::format("it offers {}; until then the exhibit chooses one itself", fmt::join(connector.modes, ", "))};
    }
    return std::nullopt;
}

}  // namespace

std::vector<Finding> examine_wanted_screen(const site::Configuration& configuration, const fs::path& sysfs_drm) {
    std::vector<Finding> findings;
    const auto add = [&](std::optional<Finding> finding) {
        if (finding) findings.push_back(std::move(*finding));
    };
    const bool has_desktop = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    if (configuration.screen.display == "window" && !has_desktop)
        add(Finding{"screen", Health::Bad, "screen.display is \"window\", and there is no desktop here to open one on",
                    "write display = \"kms\" or \"auto\"; a service has no desktop"});
    const std::vector<SeenConnector> seen = connectors_in(sysfs_drm);
    add(connector_trouble(configuration.screen.connector, seen));
    add(mode_trouble(configuration.screen, seen));
    return findings;
}

}  // namespace quadrat::doctor
