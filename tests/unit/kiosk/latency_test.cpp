// SPDX-License-Identifier: Apache-2.0
// From a contact that closes to the frame and the lamp that show it, on a clock and a screen of 60 Hz that are
// emulated.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "display/kms/screen_keeper.hpp"
#include "firmware-io/gpio/gpio_buttons.hpp"
#include "firmware-io/hid/hid_buttons.hpp"
#include "kiosk/run_loop.hpp"
#include "support/process.hpp"
#include "unit/display/scripted_screen.hpp"
#include "unit/firmware-io/fake_gpio.hpp"
#include "unit/firmware-io/fake_hid.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;
using tests::FakeGpioMachine;

constexpr base::Instant kPeriod = display::testing::ScriptedScreen::kPeriod;
constexpr std::size_t kPresses = 3000;

// The screen's clock is the only one.
class EmulatedClock : public base::Clock {
  public:
    explicit EmulatedClock(display::testing::ScriptedScreen& screen) : screen_(screen) {}
    base::Instant now() override { return screen_.now(); }

  private:
    display::testing::ScriptedScreen& screen_;
};

// Where a finger is: closed for 80 ms, some 350 ms apart, at moments that have nothing to do with frames.
struct Finger {
    std::mt19937 random{1848};
    std::vector<base::Instant> presses;
    Finger() {
        for (base::Instant at = 3s; presses.size() < kPresses; at += 350ms + base::Instant{random() % 100'000'000})
            presses.push_back(at);
    }
};

// What drives a real screen, on a scripted one without a GPU; drawing takes a while.
class EmulatedScreen : public display::Display {
  public:
    EmulatedScreen(display::testing::ScriptedScreen& screen, std::function<void(base::Instant)> world,
                   std::function<void(base::Instant, base::Instant)> seen)
        : Display("emulated"), screen_(screen), keeper_(screen), world_(std::move(world)), seen_(std::move(seen)) {}
    std::string_view kind() const override { return "emulated"; }
    std::string description() const override { return "emulated"; }
    std::string renderer() const override { return ""; }
    display::Canvas canvas() const override { return {}; }
    display::Canvas begin_frame() override {
        keeper_.attend();
        begun_ = screen_.now();
        world_(begun_);
        return {};
    }
    display::Presented present(const tempo::HandOver& how) override {
        screen_.spend(2ms + base::Instant{random_() % 12'000'000});
        const display::Presented presented = keeper_.present(how);
        if (presented.outcome == display::Outcome::Shown) seen_(begun_, presented.shown_at.time_since_epoch());
        return presented;
    }
    base::DisplayTime now() const override { return base::DisplayTime{screen_.now()}; }
    void set_power(display::Power) override {}

  private:
    display::testing::ScriptedScreen& screen_;
    display::ScreenKeeper keeper_;
    std::function<void(base::Instant)> world_;
    std::function<void(base::Instant, base::Instant)> seen_;
    std::mt19937 random_{7};
    base::Instant begun_{0};
};

struct Latencies {
    std::vector<base::Instant> frame, lamp;
    static double at_ms(std::vector<base::Instant> all, double share) {
        std::sort(all.begin(), all.end());
        const auto index = static_cast<std::size_t>(share * static_cast<double>(all.size() - 1));
        return std::chrono::duration<double, std::milli>(all.at(index)).count();
    }
};

// Plays all presses. `move` opens or closes the contact at a moment; `is_lit` tells its lamp, if it has one.
Latencies measure(firmware_io::ButtonSource& buttons, const std::function<void(bool, base::Instant)>& move,
                  const std::function<bool()>& is_lit) {
    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    configuration.picture.land_samples = 65;
    Show show(
        configuration,
        {base::Seed{1}, {1, {65, 64, 128}}, [] { return archive::WallTime{}; }, [] { return archive::WallTime{}; }, ""},
        archive::Archive::open(folder.path(), {}).archive);
    const Finger finger;
    display::testing::ScriptedScreen hardware;
    EmulatedClock clock(hardware);
    staff::Panel panel(buttons);
    Latencies latencies;
    std::atomic<bool> stop{false};
    std::size_t closed = 0, opened = 0;
    std::optional<base::Instant> waiting;
    bool lamp_before = false;
    const auto world = [&](base::Instant now) {
        while (opened < closed && finger.presses[opened] + 80ms <= now) move(false, finger.presses[opened++] + 80ms);
        while (closed < kPresses && finger.presses[closed] <= now) {
            lamp_before = is_lit();
            waiting = finger.presses[closed];
            move(true, finger.presses[closed++]);
        }
        stop = closed == kPresses && opened == kPresses;
    };
    const auto seen = [&](base::Instant polled, base::Instant shown) {
        if (!waiting || !show.last_press() || show.last_press()->at < *waiting - kPeriod) return;
        latencies.frame.push_back(shown - *waiting);
        if (is_lit() != lamp_before) latencies.lamp.push_back(polled - *waiting);
        waiting.reset();
    };
    EmulatedScreen screen(hardware, world, seen);
    tempo::Tempo tempo({tempo::Governing::Fixed, {}});
    RunLoopParts parts{configuration, clock, screen, panel, buttons, show, tempo};
    parts.stop = &stop;
    run_loop(parts);
    return latencies;
}

void expect_prompt(const Latencies& latencies) {
    ASSERT_EQ(latencies.frame.size(), kPresses) << "every press is shown";
    const double frame_ms = Latencies::at_ms(latencies.frame, 0.999);
    testing::Test::RecordProperty("press_to_frame_p999_us", static_cast<int>(1000 * frame_ms));
    EXPECT_LE(frame_ms, 2 * 16.667 + 5);
}

TEST(Latency, FromAGpioEdgeToTheFrameAndToTheLamp) {
    auto machine = std::make_shared<FakeGpioMachine>();
    machine->chips = {tests::chip_of("/dev/gpiochip0", "pinctrl-rp1", {"B", "LAMP"})};
    firmware_io::gpio::Wiring wiring;
    wiring.contacts = {{firmware_io::Button::B, {"B", {}}}};
    wiring.lamps = {{firmware_io::Button::B, {"LAMP", {}}}};
    firmware_io::gpio::GpioButtons buttons{std::make_unique<tests::FakeGpioHost>(machine), wiring};
    const firmware_io::gpio::LinePlace contact{"/dev/gpiochip0", 0}, lamp{"/dev/gpiochip0", 1};
    const Latencies latencies = measure(
        buttons, [&](bool is_closed, base::Instant at) { machine->move(contact, is_closed, at); },
        [&] { return machine->lit[lamp]; });
    expect_prompt(latencies);
    // A lamp that breathes may be dark just then: most presses are seen in it, and all of those at once.
    ASSERT_GT(latencies.lamp.size(), kPresses / 2);
    testing::Test::RecordProperty("press_to_lamp_max_us", static_cast<int>(1000 * Latencies::at_ms(latencies.lamp, 1)));
    EXPECT_LE(Latencies::at_ms(latencies.lamp, 1), 20);
}

TEST(Latency, FromAHidReportToTheFrame) {
    const auto device = tests::five_button_device();
    firmware_io::hid::HidButtons buttons{std::make_unique<tests::FakeHidHost>(tests::FakeHidDevices{device}), {}};
    const Latencies latencies = measure(
        buttons, [&](bool is_closed, base::Instant) { device->send({static_cast<std::uint8_t>(is_closed ? 2 : 0)}); },
        [] { return false; });
    expect_prompt(latencies);
}

}  // namespace
}  // namespace quadrat::kiosk
