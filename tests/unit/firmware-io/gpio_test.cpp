// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "fake_gpio.hpp"
#include "firmware-io/gpio/gpio_buttons.hpp"

namespace quadrat::tests {
namespace {

using namespace std::chrono_literals;
using namespace firmware_io;
using testing::AllOf;
using testing::HasSubstr;

const gpio::ChipFacts kHeader = chip_of("/dev/gpiochip4", "pinctrl-rp1", {"ID_SDA", "GPIO17", "GPIO27"});
const gpio::ChipFacts kExpander = chip_of("/dev/gpiochip0", "mcp2221", {"GPIO17", "GP1"});

TEST(FindLine, PrefersTheHeaderWhateverItsNumber) {
    const std::vector chips{kExpander, kHeader};
    EXPECT_EQ(gpio::find_line(chips, {"GPIO17", {}}), (gpio::LinePlace{"/dev/gpiochip4", 1}));
    EXPECT_EQ(gpio::find_line(chips, {"GP1", {}}), (gpio::LinePlace{"/dev/gpiochip0", 1}));
    EXPECT_EQ(gpio::find_line(chips, {"", {"/dev/gpiochip0", 0}}), (gpio::LinePlace{"/dev/gpiochip0", 0}));
}

std::string refusal(const std::vector<gpio::ChipFacts>& chips, const gpio::LineAddress& address) {
    try {
        gpio::find_line(chips, address);
    } catch (const gpio::GpioError& error) {
        return error.what();
    }
    return "found";
}

TEST(FindLine, RefusesWhatIsAmbiguousMissingOrHeldAndSaysTheRemedy) {
    gpio::ChipFacts twin = kExpander;
    twin.path = "/dev/gpiochip1";
    EXPECT_THAT(refusal({kExpander, twin}, {"GP1", {}}),
                AllOf(HasSubstr("/dev/gpiochip0:1 and /dev/gpiochip1:1"), HasSubstr("write the one you mean")));
    EXPECT_THAT(refusal({kHeader}, {"GPIO99", {}}), AllOf(HasSubstr("GPIO99"), HasSubstr("gpioinfo")));
    EXPECT_THAT(refusal({kHeader}, {"", {"/dev/gpiochip4", 54}}), HasSubstr("/dev/gpiochip4:54"));
    EXPECT_THAT(refusal({}, {"GPIO17", {}}), HasSubstr("no GPIO chip"));
    EXPECT_THAT(refusal({{"/dev/gpiochip0", "", {}, "Permission denied"}}, {"GPIO17", {}}),
                AllOf(HasSubstr("/dev/gpiochip0 cannot be opened (Permission denied)"), HasSubstr("group")));
    gpio::ChipFacts held = kHeader;
    held.lines[1].holder = "spi0 CS1";
    EXPECT_THAT(refusal({held}, {"GPIO17", {}}), HasSubstr("GPIO17 is held by spi0 CS1;"));
}

TEST(FindLine, KnowsAChipByPathLinkNameNumberAndLabel) {
    const auto folder = std::filesystem::temp_directory_path() / ("quadrat-chips-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream{folder / "gpiochip7"};
    std::filesystem::create_symlink("gpiochip7", folder / "panel");
    std::filesystem::create_symlink("panel", folder / "panel-of-old");
    gpio::ChipFacts linked = kExpander;
    linked.path = (std::filesystem::canonical(folder) / "gpiochip7").string();
    const std::vector chips{kExpander, kHeader, linked};
    for (const std::string chip : {"/dev/gpiochip4", "gpiochip4", "4", "pinctrl-rp1"})
        EXPECT_EQ(gpio::find_line(chips, {"", {chip, 1}}), (gpio::LinePlace{"/dev/gpiochip4", 1})) << chip;
    for (const char* link : {"panel", "panel-of-old", "gpiochip7"})
        EXPECT_EQ(gpio::find_line(chips, {"", {(folder / link).string(), 1}}), (gpio::LinePlace{linked.path, 1}))
            << link;
    EXPECT_THAT(refusal(chips, {"", {"mcp2221", 0}}),
                AllOf(HasSubstr("mcp2221:0: both /dev/gpiochip0 and "), HasSubstr("write the path")));
    EXPECT_THAT(refusal(chips, {"", {"gpiochip9", 0}}), HasSubstr("gpiochip9:0 is on no GPIO chip"));
    EXPECT_THAT(refusal(chips, {"", {"gpiochip4", 99}}), HasSubstr("gpiochip4:99 is on no GPIO chip"));
    std::filesystem::remove_all(folder);
}

TEST(FindLine, ALinesNameMayEndLikeAPlace) {
    const std::vector chips{chip_of("/dev/gpiochip0", "soc", {"a", "SPI:0"})};
    EXPECT_EQ(gpio::find_line(chips, {"", {"SPI", 0}}), (gpio::LinePlace{"/dev/gpiochip0", 1}));
}

TEST(GpioButtons, OneLineUnderTwoNamesIsRefusedByBoth) {
    const auto machine = std::make_shared<FakeGpioMachine>();
    machine->chips = {kHeader};
    gpio::Wiring wiring;
    wiring.contacts = {{Button::A, {"GPIO17", {}}}, {Button::B, {"", {"4", 1}}}};
    gpio::GpioButtons buttons{std::make_unique<FakeGpioHost>(machine), wiring};
    EXPECT_THAT(buttons.look().reason, HasSubstr("A=GPIO17 and B=4:1 are the same line; give each"));
    buttons.poll(1s);
    EXPECT_THAT(buttons.status().reason, HasSubstr("are the same line"));
}

TEST(FindLine, TakesWhatWeHoldForFreeWhereItIsOnlyLookedAt) {
    gpio::ChipFacts held = kHeader;
    held.lines[1].holder = gpio::kConsumer;
    EXPECT_THAT(refusal({held}, {"GPIO17", {}}), HasSubstr("GPIO17 is held by quadrat;"));
    EXPECT_EQ(gpio::find_line(std::span{&held, 1}, {"GPIO17", {}}, gpio::kConsumer),
              (gpio::LinePlace{"/dev/gpiochip4", 1}));
}

TEST(KernelClock, IsNeverLaterThanNowAndKeepsTheDistancesOfTheKernel) {
    KernelClock clock;
    clock.saw(100s, 7s);  // waited 3 ms, which nobody knows yet
    EXPECT_EQ(clock.moment_of(100s), 7s);
    clock.saw(100s + 10ms, 7s + 7ms);  // was read at once: now we do
    EXPECT_EQ(clock.moment_of(100s + 10ms), 7s + 7ms);
    clock.saw(101s, 8s + 500ms);
    EXPECT_EQ(clock.moment_of(101s), 8s - 3ms);
    clock.saw(50s, 9s);
    EXPECT_EQ(clock.moment_of(50s), 9s) << "a kernel clock that was set back";
}

struct Panel {
    std::shared_ptr<FakeGpioMachine> machine = std::make_shared<FakeGpioMachine>();
    gpio::LinePlace a{"/dev/gpiochip0", 0}, lamp{"/dev/gpiochip0", 1};
    gpio::GpioButtons buttons;
    Panel() : buttons{host(*this), wiring()} {}
    static std::unique_ptr<gpio::GpioHost> host(const Panel& panel) {
        panel.machine->chips = {chip_of("/dev/gpiochip0", "pinctrl-fake", {"GPIO17", "GPIO5"})};
        return std::make_unique<FakeGpioHost>(panel.machine);
    }
    static gpio::Wiring wiring() {
        gpio::Wiring wiring;
        wiring.contacts = {{Button::A, {"GPIO17", {}}}};
        wiring.lamps = {{Button::A, {"GPIO5", {}}}};
        return wiring;
    }
};

TEST(GpioButtons, EdgesCarryTheKernelsDistancesHoweverLateTheyAreRead) {
    Panel panel;
    panel.buttons.poll(1s);
    panel.machine->move(panel.a, true, 2s);
    panel.machine->move(panel.a, false, 2s + 100ms);
    const auto down = panel.buttons.poll(2s + 500ms), up = panel.buttons.poll(2s + 600ms);
    ASSERT_EQ(down.size(), 1U);
    ASSERT_EQ(up.size(), 1U);
    EXPECT_EQ(up[0].at - down[0].at, 105ms);
}

TEST(GpioButtons, AfterAnOverflowTheLevelsAreReadAgainSoThatNothingIsStuck) {
    Panel panel;
    panel.buttons.poll(1s);
    for (int i = 0; i < 17; ++i) panel.machine->move(panel.a, i % 2 == 0, 1s + 100us * i);
    panel.machine->move(panel.a, false, 1s + 3ms);  // lost: the queue is full
    ASSERT_EQ(panel.machine->queued[panel.a].size(), 16U);
    panel.buttons.poll(1s + 16ms);
    panel.buttons.poll(1s + 32ms);
    EXPECT_FALSE(panel.buttons.contacts()[index_of(Button::A)].is_down);
    EXPECT_FALSE(panel.buttons.contacts()[index_of(Button::A)].is_closed);
}

TEST(GpioButtons, AnEdgeTheKernelNeverReportedKeepsAButtonDownForLittleMoreThanASecond) {
    Panel panel;
    panel.buttons.poll(1s);
    panel.machine->move(panel.a, true, 1500ms);
    EXPECT_EQ(panel.buttons.poll(1500ms).size(), 1U);
    panel.machine->level[panel.a] = false;
    std::vector<ButtonEdge> edges;
    for (Instant now = 1500ms; edges.empty() && now < 10s; now += 16ms) edges = panel.buttons.poll(now);
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].motion, Motion::Up);
    EXPECT_LT(edges[0].at, 2600ms);
}

TEST(GpioButtons, LampsFollowTheirPatternAndAreWrittenOnlyWhenTheyChange) {
    Panel panel;
    Lamps lamps{};
    lamps[index_of(Button::A)] = LampPattern::Blinking;
    panel.buttons.set_lamps(lamps);
    for (Instant now = 0s; now < 4s; now += 16ms) {
        panel.buttons.poll(now);
        EXPECT_EQ(panel.machine->lit[panel.lamp], is_lamp_lit(LampPattern::Blinking, now));
    }
    EXPECT_EQ(panel.machine->writes, 10U);  // five periods of 800 ms
}

TEST(GpioButtons, LampsComeBackAfterReplugging) {
    Panel panel;
    Lamps lamps{};
    lamps[index_of(Button::A)] = LampPattern::Steady;
    panel.buttons.set_lamps(lamps);
    panel.buttons.poll(1s);
    panel.machine->unplug();
    panel.buttons.poll(2s);
    panel.machine->plug();
    panel.machine->lit.clear();
    panel.buttons.poll(4s);
    EXPECT_TRUE(panel.machine->lit[panel.lamp]);
}

TEST(GpioButtons, SearchesForMissingHardwareOnceASecondAndNoMore) {
    Panel panel;
    panel.machine->unplug();
    for (Instant now = 0s; now < 10s; now += 10ms) panel.buttons.poll(now);
    EXPECT_EQ(panel.machine->listings, 10U);
}

TEST(GpioButtons, GoesOnWithTheLinesThatCanBeHadAndTakesTheOthersWhenTheyAreFree) {
    auto machine = std::make_shared<FakeGpioMachine>();
    machine->chips = {chip_of("/dev/gpiochip0", "pinctrl-fake", {"GPIO17", "GPIO27", "GPIO5"})};
    machine->chips[0].lines[1].holder = "spi0 CS1";
    gpio::Wiring wiring;
    wiring.contacts = {{Button::A, {"GPIO17", {}}}, {Button::B, {"GPIO27", {}}}};
    wiring.lamps = {{Button::A, {"GPIO99", {}}}};
    gpio::GpioButtons buttons{std::make_unique<FakeGpioHost>(machine), wiring};
    buttons.poll(1s);
    EXPECT_EQ(buttons.status().presence, Presence::Present);
    EXPECT_THAT(buttons.status().reason, AllOf(HasSubstr("GPIO lines A=GPIO17; without B=GPIO27"),
                                               HasSubstr("without lamp A=GPIO99"), HasSubstr("GPIO99 is on no GPIO")));
    machine->move({"/dev/gpiochip0", 0}, true, 2s);
    EXPECT_EQ(buttons.poll(2s).size(), 1U);
    machine->chips[0].lines[1].holder.clear();
    buttons.poll(12s);
    machine->move({"/dev/gpiochip0", 1}, true, 13s);
    EXPECT_EQ(buttons.poll(13s).size(), 1U);
    EXPECT_THAT(buttons.status().reason, HasSubstr("GPIO lines A=GPIO17, B=GPIO27"));
}

TEST(GpioButtons, WhatIsWrongWithAllLinesIsSaidOnce) {
    auto machine = std::make_shared<FakeGpioMachine>();
    gpio::Wiring wiring;
    wiring.contacts = {{Button::A, {"GPIO17", {}}}, {Button::B, {"GPIO27", {}}}};
    wiring.lamps = {{Button::A, {"GPIO5", {}}}};
    EXPECT_EQ((gpio::GpioButtons{std::make_unique<FakeGpioHost>(machine), wiring}.look().reason),
              "GPIO lines GPIO17, GPIO27, GPIO5: this machine has no GPIO chip; use hid: or load the chip's driver");
    machine->chips = {chip_of("/dev/gpiochip0", "pinctrl-fake", {"GPIO17"})};
    machine->chips[0].lines[0].holder = "spi0 CS1";
    EXPECT_EQ((gpio::GpioButtons{std::make_unique<FakeGpioHost>(machine), wiring}.look().reason),
              "GPIO line GPIO17 is held by spi0 CS1; stop that, or wire the button to another line; "
              "GPIO lines GPIO27, GPIO5 are on no GPIO chip; the command gpioinfo lists the lines");
}

TEST(GpioButtons, ALineThatCannotBeHadAloneIsAbsentWithTheReason) {
    Panel panel;
    panel.machine->chips[0].lines[0].holder = "spi0 CS1";
    panel.buttons.poll(1s);
    EXPECT_EQ(panel.buttons.status().presence, Presence::Absent);
    EXPECT_THAT(panel.buttons.status().reason, HasSubstr("GPIO17 is held by spi0 CS1;"));
}

}  // namespace
}  // namespace quadrat::tests
