// SPDX-License-Identifier: Apache-2.0
// The room `doctor`: what is wrong with this machine and what mends it. It looks and touches nothing.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "firmware-io/input_spec.hpp"
#include "machine/account.hpp"
#include "machine/unit_state.hpp"
#include "site/configuration.hpp"
#include "site/hours.hpp"

namespace quadrat::doctor {

enum class Health { Good, Doubtful, Bad };

// One thing that was looked at.
struct Finding {
    std::string subject;  // "screen"
    Health health = Health::Good;
    std::string what;    // one line
    std::string remedy;  // one line; empty when there is nothing to do
    std::string file = {};
    int line = 0;  // of that file; 0: none
};

// Looks and touches nothing: safe beside a running exhibit. `exhibit` is whose
// rights count, whoever looks; nothing: those of whoever looks.
std::vector<Finding> examine_gpu();
std::vector<Finding> examine_screen(const std::optional<machine::Account>& exhibit = {},
                                    const std::filesystem::path& sysfs_drm = "/sys/class/drm",
                                    const std::filesystem::path& dev_dri = "/dev/dri");
// Whether this machine has the screen that the settings ask for.
std::vector<Finding> examine_wanted_screen(const site::Configuration& configuration,
                                           const std::filesystem::path& sysfs_drm = "/sys/class/drm");
// Whether the projector that the settings name is as the exhibit wants it, as who keeps it says in the runtime folder;
// where nobody keeps it, how it answers. `ask` throws projector::Trouble.
using AskProjector = std::function<std::string(const site::Configuration::Screen& screen)>;
std::vector<Finding> examine_projector(const site::Configuration& configuration, const std::filesystem::path& runtime,
                                       const AskProjector& ask);
using OpenButtons = std::function<firmware_io::Opened(std::string_view spec)>;
std::vector<Finding> examine_buttons(const site::Configuration& configuration,
                                     const std::optional<machine::Account>& exhibit = {},
                                     const OpenButtons& open = firmware_io::open_buttons,
                                     const std::filesystem::path& dev = "/dev");
// What is plugged in that no input names, so that nobody has to guess what to write.
std::vector<Finding> examine_boards(const site::Configuration& configuration,
                                    const OpenButtons& open = firmware_io::open_buttons);
// Whether the cards that the settings name are there, and every language has a voice. Makes no sound.
std::vector<Finding> examine_sound(const site::Configuration& configuration,
                                   const std::optional<machine::Account>& exhibit = {},
                                   const std::filesystem::path& dev_snd = "/dev/snd",
                                   const std::string& voice = "espeak-ng");
std::vector<Finding> examine_state(const std::filesystem::path& directory,
                                   const std::optional<machine::Account>& exhibit = {});
// The same on a disk with so much room.
std::vector<Finding> examine_state(const std::filesystem::path& directory, std::optional<double> free_mb,
                                   const std::optional<machine::Account>& exhibit = {});
std::vector<Finding> examine_clock(const site::WallClock& wall, const site::Hours& hours);
// What systemd says of the exhibit's unit; nothing to say where it knows none.
std::vector<Finding> examine_unit(const std::optional<machine::UnitState>& unit);
// What a running exhibit last said of itself in its runtime folder.
std::vector<Finding> examine_service(const std::filesystem::path& runtime);

// The configuration, as far as it is right, with a finding for each mistake. `state`: where the exhibit keeps the
// settings that worked last.
struct Examined {
    site::Configuration configuration;
    std::vector<Finding> findings;
};
Examined examine_configuration(const std::filesystem::path& file, const std::filesystem::path& state = {});

Health worst_of(const std::vector<Finding>& findings);
std::string report_of(const std::vector<Finding>& findings);
// {"verdict": "bad", "findings": [{"part", "verdict", "what", "remedy", "file", "line"}, …]}
std::string json_of(const std::vector<Finding>& findings);

}  // namespace quadrat::doctor
