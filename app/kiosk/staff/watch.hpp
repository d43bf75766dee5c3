// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/configuration.hpp"
#include "kiosk/staff/machine.hpp"

namespace quadrat::kiosk::staff {

// What lies outside of the program and may change while it runs. Looking can wait for a disk: done by an errand.
struct Seen {
    MachineFacts machine;
    WallClock wall;
    std::optional<double> free_mb;
    bool is_picture_asked = false;
    std::vector<std::string> earlier_faults;     // of the runs before this one, oldest first
    std::optional<Configuration> configuration;  // if its file has changed, and can be used
    std::string configuration_trouble;           // if it has changed, and cannot
};

class Watch {
  public:
    // `configuration_file` may be empty.
    Watch(std::filesystem::path configuration_file, std::filesystem::path runtime, std::filesystem::path state);

    Seen look();

  private:
    std::filesystem::path configuration_file_, runtime_, state_;
    std::filesystem::file_time_type configured_at_{};
};

// Who asks for a picture makes this file in the runtime folder, and finds it gone when the picture lies beside it.
inline constexpr const char* kPictureAsked = "picture.asked";
inline constexpr const char* kPicture = "picture.png";
// What the machine should do, in one word: reboot or poweroff. A unit with the right to it watches this file.
inline constexpr const char* kPowerAsked = "power.asked";

// What a running exhibit may change at once. The keys of what it may not, "screen.mode, buttons.inputs", or "".
std::string apply(const Configuration& changed, Configuration& running);

}  // namespace quadrat::kiosk::staff
