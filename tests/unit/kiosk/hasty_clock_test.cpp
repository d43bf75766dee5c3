// SPDX-License-Identifier: Apache-2.0
// --speed N: the program's clock runs ahead of the display's, and frames are still judged by the display's alone.
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "firmware-io/merged_buttons.hpp"
#include "kiosk/run_loop.hpp"
#include "support/process.hpp"
#include "tempo/flight_log.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kPeriod{16'666'667};

// Without a GPU; everything before present() takes 2 ms, and each frame is shown at the next refresh.
class PromptScreen final : public display::Display {
  public:
    // Counts frames from when nothing grows any more: how long that takes is the machine's affair.
    PromptScreen(int frames, std::atomic<bool>& stop, std::function<bool()> is_growing)
        : Display("prompt"), left_(frames), stop_(stop), is_growing_(std::move(is_growing)) {}
    std::string_view kind() const override { return "prompt"; }
    std::string description() const override { return "prompt"; }
    std::string renderer() const override { return "prompt"; }
    display::Canvas canvas() const override { return {}; }
    display::Canvas begin_frame() override {
        now_ += 2ms;
        return {};
    }
    display::Presented present(const tempo::HandOver& how) override {
        flights_.handed_over(++frame_, how, now());
        now_ = (now_ / kPeriod + 1) * kPeriod;
        flights_.shown(now(), kPeriod);
        if (!is_growing_()) stop_ = --left_ <= 0;
        return {display::Outcome::Shown, frame_, now(), kPeriod, "", flights_.take_finished(), {}};
    }
    base::DisplayTime now() const override { return base::DisplayTime{now_}; }
    void set_power(display::Power) override {}

  private:
    std::chrono::nanoseconds now_{0};
    tempo::FlightLog flights_;
    std::uint64_t frame_ = 0;
    int left_;
    std::atomic<bool>& stop_;
    std::function<bool()> is_growing_;
};

class FastClock final : public base::Clock {
  public:
    explicit FastClock(const display::Display& screen) : screen_(screen) {}
    base::Instant now() override { return 60 * screen_.now().time_since_epoch(); }

  private:
    const display::Display& screen_;
};

TEST(HastyClock, FramesThatLeaveRoomAreSeenToLeaveIt) {
    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    configuration.picture.land_samples = 65;
    const auto no_time = [] { return archive::WallTime{}; };
    Show show(configuration, {base::Seed{1}, {1, {65, 64, 128}}, no_time, no_time, ""},
              archive::Archive::open(folder.path(), {}).archive);
    firmware_io::MergedButtons buttons{{}};
    staff::Panel panel(buttons);
    std::atomic<bool> stop{false};
    PromptScreen screen(4000, stop, [&] { return show.programme().is_growing(); });
    FastClock clock(screen);
    tempo::GovernorOptions options;
    options.start = 0.2F;
    tempo::Tempo tempo({tempo::Governing::ByFrames, options});
    RunLoopParts parts{configuration, clock, screen, panel, buttons, show, tempo};
    parts.stop = &stop;
    run_loop(parts);
    EXPECT_GT(tempo.governor().settled(), 0.5F) << "an eighth of each frame's time is used";
}

}  // namespace
}  // namespace quadrat::kiosk
