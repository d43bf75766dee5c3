// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/configuration.hpp"
#include "kiosk/staff/hours.hpp"

namespace quadrat::kiosk {

enum class Health { Good, Doubtful, Bad };

// One thing that was looked at.
struct Finding {
    std::string subject;  // "screen"
    Health health = Health::Good;
    std::string what;    // one line
    std::string remedy;  // one line; empty when there is nothing to do
};

// Looks and touches nothing: safe beside a running exhibit. Each finds at least one thing to say.
std::vector<Finding> examine_gpu();
std::vector<Finding> examine_screen(const std::filesystem::path& sysfs_drm = "/sys/class/drm",
                                    const std::filesystem::path& dev_dri = "/dev/dri");
std::vector<Finding> examine_buttons(const Configuration& configuration);
std::vector<Finding> examine_state(const std::filesystem::path& directory);
// The same on a disk with so much room.
std::vector<Finding> examine_state(const std::filesystem::path& directory, std::optional<double> free_mb);
std::vector<Finding> examine_clock();
std::vector<Finding> examine_clock(const staff::WallClock& wall, bool closes_by_the_clock);
// What a running exhibit last said of itself in its runtime folder.
std::vector<Finding> examine_service(const std::filesystem::path& runtime);

// The configuration, or the usual one with the reason why not.
struct Examined {
    Configuration configuration;
    std::vector<Finding> findings;
};
Examined examine_configuration(const std::filesystem::path& file);

Health worst_of(const std::vector<Finding>& findings);
std::string report_of(const std::vector<Finding>& findings);

}  // namespace quadrat::kiosk
