// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "machine/machine.hpp"
#include "projector/keeper.hpp"
#include "site/configuration.hpp"
#include "site/wall_clock.hpp"
#include "staff/preview_wish.hpp"

namespace quadrat::staff {

// What lies outside of the program and may change while it runs. Looking can wait for a disk: done by an errand.
struct Seen {
    // A file of settings that is another than it was, can be used or not.
    struct Changed {
        site::CheckedConfiguration checked;
        std::string toml;
    };
    machine::MachineFacts machine;
    site::WallClock wall;
    std::optional<double> free_mb;
    bool is_picture_asked = false;
    bool is_glance_asked = false;
    bool stands_by = false;
    bool is_restart_asked = false;
    bool is_health_asked = false;
    bool is_lamp_test_asked = false;
    std::optional<projector::Told> projector;  // where somebody keeps one
    std::optional<PreviewWish> preview;
    std::optional<Changed> settings;
    std::optional<std::vector<std::string>> guests;  // of other exhibits, by their codes, where they have changed
    std::vector<std::string> earlier_faults;         // of the runs before this one, oldest first
};

class Watch {
  public:
    // `configuration_file` may be empty: what the curator says at the desk is followed all the same. `held` is what
    // both held when they were read last, nothing where that could not be.
    Watch(std::filesystem::path configuration_file, std::optional<std::string> held, std::filesystem::path runtime,
          std::filesystem::path state);

    // Settings are read once their file has been the same for two looks: who saves one may not be through.
    Seen look();

  private:
    // Which file lies there, and since when. All zero: none.
    struct Stamp {
        std::uint64_t node = 0, size = 0;
        std::int64_t written_ns = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    static Stamp stamp_of(const std::filesystem::path& file);
    std::optional<Seen::Changed> changed_settings();
    std::optional<std::vector<std::string>> changed_guests();

    std::filesystem::path configuration_file_, runtime_, state_;
    site::LastTimeSeen last_time_;
    site::ZoneWatch zone_;
    std::optional<std::string> held_;
    std::string worked_;                  // what it held last that could be used
    using Stamps = std::array<Stamp, 2>;  // of the site's file and the curator's
    std::optional<Stamps> seen_, read_;
    Stamp guests_seen_;
    std::vector<std::string> guests_;
};

// Who asks for a picture makes this file in the runtime folder, and finds it gone when the picture lies beside it.
inline constexpr const char* kPictureAsked = "picture.asked";
inline constexpr const char* kPicture = "picture.png";
// Or this lies beside it, and says why there is none.
inline constexpr const char* kNoPicture = "picture.refused";
// The same of a small picture, for who looks again and again; none lies there while the screen is dark.
inline constexpr const char* kGlanceAsked = "glance.asked";
inline constexpr const char* kGlance = "glance.png";
inline constexpr int kGlanceWidth = 854;
// While this file is there, the exhibit is closed to visitors, whatever its hours say.
inline constexpr const char* kStandBy = "standby";
// The exhibit takes this file away, ends, and is started anew by whoever started it.
inline constexpr const char* kRestartAsked = "restart.asked";
// Who looks at the exhibit from afar makes this file, and finds health.json of that moment when it is gone.
inline constexpr const char* kHealthAsked = "health.asked";
// The lamps are tested for a while, whatever the visit does.
inline constexpr const char* kLampTestAsked = "lamps.asked";
// While this file is there, each start is in safe mode, as staff wish.
inline constexpr const char* kSafeMode = "safe-mode";
// The next start forgets the failures before it, and takes this file away.
inline constexpr const char* kUsualAsked = "usual.asked";
// What the machine should do, in one word: reboot or poweroff. A unit with the right to it watches this file.
inline constexpr const char* kPowerAsked = "power.asked";

// What a running exhibit may change at once. The keys of what it may not, "screen.mode, buttons.inputs", or "".
std::string apply(const site::Configuration& changed, site::Configuration& running);

}  // namespace quadrat::staff
