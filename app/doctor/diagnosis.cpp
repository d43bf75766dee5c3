// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "base/error.hpp"
#include "display/display.hpp"
#include "doctor/diagnosis_access.hpp"
#include "doctor/diagnosis_state.hpp"
#include "machine/machine.hpp"
#include "site/wall_clock.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

// card0, card1 …: nodes that can set a mode. card0-HDMI-A-1 …: their connectors.
bool is_card(const std::string& name) { return name.starts_with("card") && name.find('-') == std::string::npos; }

Finding connector_finding(const fs::path& connector) {
    const std::string name = connector.filename().string();
    const std::string plain = name.substr(name.find('-') + 1);
    if (first_line(connector / "status") != "connected")
        return {"screen", Health::Doubtful, fmt::format("{}: nothing is plugged in", plain),
                "if a projector is: switch it on, check both ends of the cable, then try another"};
    const std::string mode = first_line(connector / "modes");
    std::error_code error;
    if (fs::file_size(connector / "edid", error) == 0 || error || mode.empty())
        return {"screen", Health::Doubtful,
                fmt::format("{}: plugged in, but it does not say what it is (no EDID)", plain),
                "a bad cable or adapter; pin the projector's mode in the configuration, screen.mode"};
    return {"screen", Health::Good, fmt::format("{}: plugged in, prefers {}", plain, mode), ""};
}

}  // namespace

std::vector<Finding> examine_gpu() {
    try {
        display::DisplayOptions options;
        options.kind = display::Kind::Headless;
        options.size = {64, 64};
        const auto screen = display::open_display(options);
        screen->begin_frame();
        const std::string what = screen->description();
        if (what.find("llvmpipe") != std::string::npos || what.find("softpipe") != std::string::npos)
            return {{"gpu", Health::Doubtful, what,
                     "pictures are computed by the processor: install the GPU's driver (Debian: libgl1-mesa-dri), and "
                     "add the exhibit's user to the group render"}};
        return {{"gpu", Health::Good, what, ""}};
    } catch (const base::InputError& error) {
        return {{"gpu", Health::Bad, error.what(), "install libegl-mesa0 and libgl1-mesa-dri"}};
    }
}

std::vector<Finding> examine_screen(const std::optional<machine::Account>& exhibit, const fs::path& sysfs_drm,
                                    const fs::path& dev_dri) {
    std::vector<Finding> findings;
    for (const fs::path& path : entries_of(sysfs_drm)) {
        const std::string name = path.filename().string();
        if (is_card(name)) {
            const fs::path node = dev_dri / name;
            std::error_code error;
            if (!fs::exists(node, error))
                findings.push_back({"screen", Health::Bad, fmt::format("{} is missing", node.string()),
                                    "is udev running? systemctl status systemd-udevd"});
            else if (!is_usable(node, exhibit))
                findings.push_back({"screen", Health::Bad, fmt::format("{}: no permission", node.string()),
                                    "add the exhibit's user to the group video: " + joining("video", exhibit)});
        } else if (name.starts_with("card") && fs::exists(path / "status")) {
            findings.push_back(connector_finding(path));
        }
    }
    const Finding drawing = access_finding({"gpu", "GPU's nodes to draw with", "renderD", "render"}, dev_dri, exhibit);
    if (drawing.health != Health::Good) findings.push_back(drawing);
    if (findings.empty())
        findings.push_back({"screen", Health::Doubtful, "no graphics card with outputs was found",
                            "with Raspberry Pi OS: dtoverlay=vc4-kms-v3d in config.txt; elsewhere: is the GPU's kernel "
                            "driver loaded? Headless runs need none"});
    return findings;
}

std::vector<Finding> examine_state(const fs::path& directory, const std::optional<machine::Account>& exhibit) {
    std::error_code error;
    fs::path existing = fs::absolute(directory);
    while (!fs::exists(existing, error) && existing.has_relative_path()) existing = existing.parent_path();
    return examine_state(directory, machine::free_mb(existing), exhibit);
}

std::vector<Finding> examine_state(const fs::path& directory, std::optional<double> free_mb,
                                   const std::optional<machine::Account>& exhibit) {
    std::error_code error;
    fs::path existing = fs::absolute(directory);
    while (!fs::exists(existing, error) && existing.has_relative_path()) existing = existing.parent_path();
    if (!fs::is_directory(existing, error) || !is_usable(existing, exhibit))
        return {{"state", Health::Bad, fmt::format("{}: cannot be written", existing.string()),
                 "visits are kept in memory only; give the exhibit's user this folder, or name another with --state"}};
    std::vector<Finding> findings;
    constexpr double kEnough_mb = 100;
    if (free_mb && *free_mb < kEnough_mb)
        findings.push_back({"state", Health::Doubtful, fmt::format("{}: {:.0f} MB left", existing.string(), *free_mb),
                            "make room: the exhibit goes on, but keeps nothing once the disk is full; what is large: "
                            "du -xh " +
                                existing.string() + " | sort -h | tail"});
    const std::vector<Finding> files = examine_state_files(directory, exhibit);
    findings.insert(findings.end(), files.begin(), files.end());
    return findings;
}

std::vector<Finding> examine_clock(const site::WallClock& wall, const site::Hours& hours) {
    const bool closes = !hours.is_always_open;
    const std::string now = site::time_text(wall);
    if (wall.is_trusted) {
        const bool may_be_unset = closes && (wall.zone.starts_with("UTC") || wall.zone.starts_with("Etc/UTC"));
        return {{"clock", Health::Good,
                 fmt::format("{}: it can be trusted ({}); {}", now, wall.source, site::opening_text(hours, wall)),
                 may_be_unset ? "the opening hours follow UTC: where the site's time is another, timedatectl "
                                "set-timezone Europe/Berlin"
                              : ""}};
    }
    return {{"clock", closes ? Health::Doubtful : Health::Good,
             fmt::format("{}: nothing keeps it right: {}; {}", now, wall.doubt, site::opening_text(hours, wall)),
             closes ? "the opening hours are not followed until it is right: " + wall.remedy
                    : "nothing on the screen depends on it; for right dates: " + wall.remedy}};
}

Health worst_of(const std::vector<Finding>& findings) {
    Health worst = Health::Good;
    for (const Finding& finding : findings) worst = std::max(worst, finding.health);
    return worst;
}

std::string report_of(const std::vector<Finding>& findings) {
    std::string out;
    constexpr const char* kMarks[] = {"good    ", "doubtful", "BAD     "};
    for (const Finding& finding : findings) {
        out += fmt::format("{}  {:<9} {}\n", kMarks[static_cast<std::size_t>(finding.health)], finding.subject,
                           finding.what);
        if (!finding.remedy.empty()) out += fmt::format("{:21}-> {}\n", "", finding.remedy);
    }
    return out;
}

}  // namespace quadrat::doctor
