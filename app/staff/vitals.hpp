// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware-io/button_health.hpp"
#include "hearing/health.hpp"
#include "machine/machine.hpp"
#include "projector/keeper.hpp"
#include "site/hours.hpp"
#include "staff/ladder.hpp"
#include "staff/settings_in_use.hpp"
#include "tempo/frame_record.hpp"

// How the exhibit is: what staff see on the screen, and what a fleet collects.
namespace quadrat::staff {

// Frames of the running program, by their records: a frame is late as tempo::is_late says.
class FrameCount {
  public:
    void frame(const tempo::FrameRecord& record);  // was shown

    std::uint64_t frames = 0;
    std::uint64_t late = 0;
    double longest_ms = 0;
    double per_second = 0;  // over about the last second

  private:
    tempo::DisplayTime second_began_{};
    int in_second_ = 0;
};

struct Vitals {
    std::string version;
    Mode mode = Mode::Usual;
    bool is_safe_as_wished = false;  // by staff, not for failures
    int failures = 0;                // of the last ten minutes
    std::chrono::seconds running{0};
    machine::MachineFacts machine;
    std::string display;         // GPU, driver and mode
    std::string screen_trouble;  // "" while it shows
    site::Curtain curtain = site::Curtain::Open;
    site::WallClock wall;
    bool has_hours = false;  // it closes by the clock
    bool is_open = true;     // by its hours
    bool stands_by = false;  // staff keep it closed
    std::string opening;     // "open until 18:00"
    FrameCount frames;
    double level = 1;  // of detail, the governor's
    double alpha = 1;  // that is drawn with at this level
    double scale = 1;  // of a side of the views, as they are drawn
    int samples = 1;   // a pixel
    std::size_t triangles = 0;
    std::size_t draws = 0;
    std::size_t gpu_objects = 0;  // buffers, textures, programs; constant over visits
    firmware_io::SourceStatus buttons;
    std::uint64_t presses = 0;
    std::vector<firmware_io::Finding> findings;
    firmware_io::AilmentCounts ailments{};
    std::array<bool, firmware_io::kButtons.size()> is_closed{};
    std::array<std::uint64_t, firmware_io::kButtons.size()> presses_of{};
    bool tests_lamps = false;
    int visits = 0;
    std::string state_trouble;  // "" while everything is kept
    hearing::Health sound;
    std::string postcard_trouble;  // "" while the last one was printed
    std::optional<double> free_mb;
    std::vector<std::string> faults;           // the last warnings, oldest first
    std::vector<std::string> earlier_faults;   // those of the runs before this one, with their dates
    std::optional<projector::Told> projector;  // where somebody keeps one
    SettingsNews settings;
    std::string theme;  // of the site's, that is shown; "" for none
};

// A screen that is dark because the house is closed has not failed.
enum class ScreenState { Shows, Card, Dark, Failed };
ScreenState screen_state(const Vitals& vitals);

enum class Verdict { Good, Doubtful, Bad };
Verdict verdict_of(const Vitals& vitals);

// One JSON object; and Prometheus' text format, for its node exporter's folder of text files.
std::string to_json(const Vitals& vitals);
std::string to_prometheus(const Vitals& vitals);

}  // namespace quadrat::staff
