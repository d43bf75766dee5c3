// SPDX-License-Identifier: Apache-2.0
// What staff are told of frames, by the whole frame loop on a screen and a clock of ours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "firmware-io/merged_buttons.hpp"
#include "kiosk/run_loop.hpp"
#include "staff/caretaker.hpp"
#include "support/process.hpp"
#include "tempo/flight_log.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr base::Instant kPeriod{16'666'667};

class HandMovedClock final : public base::Clock {
  public:
    base::Instant now() override { return now_; }
    void move(base::Instant by) { now_ += by; }

  private:
    base::Instant now_{0};
};

// Without a GPU; each of its frames takes two periods, and after so many it is over.
class SlowScreen final : public display::Display {
  public:
    SlowScreen(HandMovedClock& clock, int frames, std::atomic<bool>& stop)
        : Display("slow"), clock_(clock), left_(frames), stop_(stop) {}

    std::string_view kind() const override { return "slow"; }
    std::string description() const override { return "slow"; }
    std::string renderer() const override { return "slow"; }
    display::Canvas canvas() const override { return {}; }
    display::Canvas begin_frame() override { return {}; }
    display::Presented present(const tempo::HandOver& how) override {
        flights_.handed_over(++presented_, how, now());
        clock_.move(2 * kPeriod);
        stop_ = --left_ == 0;
        flights_.shown(now(), kPeriod);
        return {display::Outcome::Shown, presented_, now(), kPeriod, "", flights_.take_finished(), {}};
    }
    base::DisplayTime now() const override { return base::DisplayTime{clock_.now()}; }
    void set_power(display::Power) override {}

  private:
    HandMovedClock& clock_;
    int left_;
    std::uint64_t presented_ = 0;
    tempo::FlightLog flights_;
    std::atomic<bool>& stop_;
};

// The line of figures after a hundred frames of two periods each.
std::string figures_with(const tempo::GovernorOptions& governing) {
    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    configuration.picture.land_samples = 65;
    Show show(
        configuration,
        {base::Seed{1}, {1, {65, 64, 128}}, [] { return archive::WallTime{}; }, [] { return archive::WallTime{}; }, ""},
        archive::Archive::open(folder.path(), {}).archive);
    firmware_io::MergedButtons buttons{{}};
    staff::Panel panel(buttons);
    staff::Ladder ladder("", folder.path(), 0s);
    tempo::Tempo tempo({tempo::Governing::ByFrames, governing});
    HandMovedClock clock;
    std::atomic<bool> stop{false};
    SlowScreen screen(clock, 100, stop);
    staff::Caretaker caretaker({configuration, {}, folder.path(), folder.path(), ladder, screen});
    RunLoopParts parts{configuration, clock, screen, panel, buttons, show, tempo};
    parts.attendant = &caretaker;
    parts.stop = &stop;
    run_loop(parts);
    caretaker.step_figures();
    std::ignore = caretaker.look(panel, {}, clock.now());
    return caretaker.board() == nullptr ? "" : caretaker.board()->lines.front();
}

TEST(Caretaker, CountsNoFrameLateThatIsMeantToTakeTwoPeriods) {
    tempo::GovernorOptions governing;
    governing.periods = 2;
    EXPECT_THAT(figures_with(governing), HasSubstr(" 0 late of 100 "));
}

TEST(Caretaker, TellsTheAlphaThatBelongsToTheLevel) {
    tempo::GovernorOptions governing;
    governing.periods = 2;
    governing.start = 0.12F;
    const std::string figures = figures_with(governing);
    float level = 0;
    float alpha = 0;
    const std::size_t at = figures.find("detail ");
    ASSERT_NE(at, std::string::npos) << figures;
    ASSERT_EQ(std::sscanf(figures.c_str() + at, "detail %f (α %f)", &level, &alpha), 2) << figures;
    EXPECT_LT(level, 0.13F);
    EXPECT_NEAR(alpha, tempo::alpha_for(level), 0.015F) << figures << ": both are rounded";
}

}  // namespace
}  // namespace quadrat::kiosk
