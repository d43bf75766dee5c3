// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "fake_evdev.hpp"
#include "fake_hid.hpp"
#include "firmware-io/evdev/control_reader.hpp"
#include "firmware-io/evdev/evdev_buttons.hpp"
#include "firmware-io/evdev/libevdev_host.hpp"
#include "firmware-io/hid/hid_buttons.hpp"
#include "firmware-io/merged_buttons.hpp"
#include "stand_in_kernel.hpp"

namespace quadrat::tests {
namespace {

using namespace std::chrono_literals;
using namespace firmware_io;
using namespace firmware_io::evdev;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

EvdevButtons buttons_on(FakeEvdevDevices devices, EvdevOptions options = {},
                        std::shared_ptr<const HeardBoards> boards = {}) {
    return EvdevButtons{std::make_unique<FakeEvdevHost>(std::move(devices)), std::move(options), std::move(boards)};
}

std::string presses(ButtonSource& source, Instant from, Instant until) {
    std::string text;
    for (Instant now = from; now < until; now += 1ms)
        for (const ButtonEdge& edge : source.poll(now))
            if (edge.motion == Motion::Down) text.append(text.empty() ? "" : " ").append(name_of(edge.button));
    return text;
}

std::string press_of_key(ButtonSource& source, FakeEvdevDevice& device, Code code, Instant at) {
    device.key(code, true, at);
    std::string text = presses(source, at, at + 50ms);
    device.key(code, false, at + 50ms);
    presses(source, at + 50ms, at + 100ms);
    return text;
}

TEST(Evdev, APadInXInputModeHasItsButtonsHatAndLeftStick) {
    const auto pad = x_input_pad();
    EvdevButtons buttons = buttons_on({pad});
    presses(buttons, 0s, 1s);
    EXPECT_THAT(buttons.status().reason, HasSubstr("/dev/input/event5 (Microsoft X-Box 360 pad 045e:028e)"));
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_SOUTH, 1s), "A");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_EAST, 2s), "B");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_NORTH, 3s), "C");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_WEST, 4s), "D");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_TL, 5s), "Back");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_SELECT, 6s), "Back");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_START, 7s), "");
    const auto moved = [&](Code code, std::int32_t value, Instant at) {
        pad->axis(code, value, at);
        const std::string text = presses(buttons, at, at + 50ms);
        pad->axis(code, 0, at + 50ms);
        presses(buttons, at + 50ms, at + 100ms);
        return text;
    };
    EXPECT_EQ(moved(ABS_HAT0Y, -1, 8s), "A");
    EXPECT_EQ(moved(ABS_HAT0X, 1, 9s), "B");
    EXPECT_EQ(moved(ABS_Y, 32767, 10s), "C");
    EXPECT_EQ(moved(ABS_X, -32768, 11s), "D");
    EXPECT_EQ(moved(ABS_Z, 255, 12s), "") << "a trigger is nobody's button until it is named";
    EXPECT_EQ(moved(ABS_RX, 32767, 13s), "");
}

TEST(Evdev, NamedControlsReplaceTheUsualOnes) {
    const auto pad = x_input_pad();
    EvdevOptions options;
    options.bindings = {{*signal_named("ABS_Z+"), Button::A}, {*signal_named("BTN_START"), Button::Back}};
    EvdevButtons buttons = buttons_on({pad}, options);
    presses(buttons, 0s, 1s);
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_SOUTH, 1s), "");
    EXPECT_EQ(press_of_key(buttons, *pad, BTN_START, 2s), "Back");
    pad->axis(ABS_Z, 255, 3s);
    EXPECT_EQ(presses(buttons, 3s, 4s), "A");
}

TEST(Evdev, KeyboardsAreHeardByLettersDigitsAndMamesKeysAndARepeatIsNoPress) {
    const auto keyboard = evdev_device("/dev/input/event2", {KEY_ESC, KEY_1, KEY_A, KEY_LEFTCTRL, KEY_B, KEY_SPACE});
    EvdevButtons buttons = buttons_on({keyboard});
    presses(buttons, 0s, 1s);
    EXPECT_EQ(press_of_key(buttons, *keyboard, KEY_1, 1s), "A");
    EXPECT_EQ(press_of_key(buttons, *keyboard, KEY_LEFTCTRL, 2s), "A");
    EXPECT_EQ(press_of_key(buttons, *keyboard, KEY_SPACE, 3s), "C");
    EXPECT_EQ(press_of_key(buttons, *keyboard, KEY_ESC, 4s), "Back");
    keyboard->key(KEY_B, true, 5s);
    for (int i = 0; i < 20; ++i)
        keyboard->send({ControlKind::Key, KEY_B, 2, FakeEvdevDevice::kKernelZero + 5s + 250ms + 30ms * i});
    EXPECT_EQ(presses(buttons, 5s, 7s), "B");
}

TEST(Evdev, WithoutASelectorAPadGoesBeforeAKeyboardAndAPowerButtonIsNone) {
    const auto power = evdev_device("/dev/input/event0", {KEY_POWER, KEY_BACK});
    const auto keyboard = evdev_device("/dev/input/event1", {KEY_A, KEY_B});
    const auto pad = x_input_pad();
    keyboard->facts.identity.product = 2;
    EvdevButtons all = buttons_on({power, keyboard, pad});
    all.poll(0s);
    EXPECT_EQ(power->opened + keyboard->opened, 0U);
    EXPECT_EQ(pad->opened, 1U);
    EvdevButtons none = buttons_on({power});
    none.poll(0s);
    EXPECT_EQ(none.status().presence, Presence::Absent);
    EXPECT_THAT(none.status().reason, HasSubstr("input device with buttons is not plugged in; plug it in"));
}

TEST(Evdev, AllInterfacesOfABoardAreHeardAndGrabbed) {
    const auto pad = evdev_device("/dev/input/event3", kFiveKeys), keys = evdev_device("/dev/input/event4", {KEY_C});
    keys->facts.identity.port = "usb-0000:00:14.0-1/input1";
    for (const DeviceSelector& selector :
         {DeviceSelector{}, DeviceSelector{0x1209, 1}, DeviceSelector{{}, {}, "/dev/input/event3"}}) {
        EvdevButtons buttons = buttons_on({pad, keys}, {selector, {}, Grab::Yes, {}});
        presses(buttons, 0s, 1s);
        EXPECT_EQ(press_of_key(buttons, *keys, KEY_C, 1s), "C");
        EXPECT_EQ(press_of_key(buttons, *pad, BTN_THUMB, 2s), "B");
        EXPECT_EQ(keys->grab, Grab::Yes);
    }
    EvdevButtons polite = buttons_on({pad}, {{}, {}, Grab::No, {}});
    polite.poll(0s);
    EXPECT_EQ(pad->grab, Grab::No);
}

TEST(Evdev, TwoEqualBoardsAreBothHeardAndToldApartBySerialAndPort) {
    const auto left = evdev_device("/dev/input/event3", kFiveKeys),
               right = evdev_device("/dev/input/event4", kFiveKeys);
    right->facts.identity.port = "usb-0000:00:14.0-2/input0";
    right->facts.identity.serial = "R";
    EvdevButtons both = buttons_on({left, right});
    presses(both, 0s, 1s);
    EXPECT_EQ(press_of_key(both, *left, BTN_TRIGGER, 1s), "A");
    EXPECT_EQ(press_of_key(both, *right, BTN_TOP, 2s), "D");
    for (const DeviceSelector& selector :
         {DeviceSelector{{}, {}, "", "usb-0000:00:14.0-2"}, DeviceSelector{{}, {}, "", "", "R"}}) {
        EvdevButtons one = buttons_on({left, right}, {selector, {}, Grab::Yes, {}});
        presses(one, 0s, 1s);
        EXPECT_EQ(press_of_key(one, *left, BTN_TRIGGER, 1s), "");
        EXPECT_EQ(press_of_key(one, *right, BTN_TRIGGER, 2s), "A");
    }
}

TEST(Evdev, PressesAreAtTheKernelsTimesHoweverLongAFrameTook) {
    const auto board = evdev_device("/dev/input/event3", kFiveKeys);
    EvdevButtons buttons = buttons_on({board});
    buttons.poll(1s);
    board->key(BTN_TRIGGER, true, 2s);
    board->key(BTN_TRIGGER, false, 2s + 20ms);
    board->key(BTN_TRIGGER, true, 2s + 60ms);
    board->key(BTN_TRIGGER, false, 2s + 80ms);
    auto edges = buttons.poll(2s + 90ms);
    const auto last = buttons.poll(2s + 100ms);
    edges.insert(edges.end(), last.begin(), last.end());
    ASSERT_EQ(edges.size(), 4U) << "two presses within one frame are two";
    EXPECT_EQ(edges[2].at - edges[0].at, 60ms);
}

TEST(Evdev, WhatIsHeldWhenItIsOpenedIsNoPressAndAPressRightAfterwardsIs) {
    const auto board = evdev_device("/dev/input/event3", kFiveKeys);
    board->held = {BTN_TRIGGER};
    EvdevButtons buttons = buttons_on({board});
    EXPECT_THAT(buttons.poll(1s), IsEmpty());
    board->key(BTN_THUMB, true, 1s + 1ms);
    EXPECT_EQ(presses(buttons, 1s + 1ms, 1s + 50ms), "B");
    board->key(BTN_TRIGGER, false, 2s);
    presses(buttons, 2s, 3s);
    board->key(BTN_TRIGGER, true, 3s);
    EXPECT_EQ(presses(buttons, 3s, 4s), "A");
}

TEST(Evdev, AfterAnOverflowTheContactsAreTrueAgain) {
    const auto board = evdev_device("/dev/input/event3", kFiveKeys);
    EvdevButtons buttons = buttons_on({board});
    buttons.poll(1s);
    board->key(BTN_TRIGGER, true, 2s);
    buttons.poll(2s);
    for (int i = 0; i < 50; ++i) board->key(BTN_THUMB, i % 2 == 0, 2s + 100us * i);
    board->key(BTN_TRIGGER, false, 2s + 10ms);
    board->key(BTN_THUMB2, true, 2s + 11ms);
    ASSERT_TRUE(board->has_overflowed);
    presses(buttons, 2s + 20ms, 3s);
    EXPECT_FALSE(buttons.contacts()[0].is_down);
    EXPECT_FALSE(buttons.contacts()[1].is_down);
    EXPECT_TRUE(buttons.contacts()[2].is_down);
}

TEST(Evdev, OneThatAnotherProgramHasIsNamedWithTheRemedy) {
    const auto board = evdev_device("/dev/input/event3", kFiveKeys);
    board->refusal = "another program has grabbed it";
    EvdevButtons buttons = buttons_on({board});
    buttons.poll(0s);
    EXPECT_EQ(buttons.status().presence, Presence::Absent);
    EXPECT_THAT(buttons.status().reason, HasSubstr("another program has grabbed it); install the udev rule, or stop"));
    board->refusal.clear();
    buttons.poll(1s);
    EXPECT_EQ(buttons.status().presence, Presence::Present);
}

// One board, heard through both of the kernel's ways.
struct BothWays {
    std::shared_ptr<FakeHidDevice> raw = five_button_device();
    std::shared_ptr<FakeEvdevDevice> cooked = evdev_device("/dev/input/event3", kFiveKeys);
    std::shared_ptr<HeardBoards> boards = std::make_shared<HeardBoards>();

    MergedButtons merged(bool is_hid_first) const {
        std::vector<std::unique_ptr<ButtonSource>> sources;
        sources.push_back(std::make_unique<hid::HidButtons>(std::make_unique<FakeHidHost>(FakeHidDevices{raw}),
                                                            hid::HidSelector{}, DebounceOptions{},
                                                            std::vector<hid::HidMapping>{}, boards));
        sources.push_back(std::make_unique<EvdevButtons>(std::make_unique<FakeEvdevHost>(FakeEvdevDevices{cooked}),
                                                         EvdevOptions{}, boards));
        if (!is_hid_first) std::swap(sources[0], sources[1]);
        return MergedButtons{std::move(sources)};
    }
    // A tap that is over before the frame is: the two ways tell it at moments that do not overlap.
    void tap(Instant at) const {
        cooked->key(BTN_TRIGGER, true, at);
        cooked->key(BTN_TRIGGER, false, at + 4ms);
        raw->send({0x01});
        raw->send({0x00});
    }
};

TEST(Evdev, ABoardThatHidHearsIsLeftAloneSoThatOnePressIsOne) {
    for (const bool is_hid_first : {true, false}) {
        const BothWays board;
        MergedButtons buttons = board.merged(is_hid_first);
        std::size_t downs = 0;
        for (int frame = 0; frame < 500; ++frame) {
            const Instant now = 16ms * frame;
            if (frame >= 100 && frame % 10 == 0) board.tap(now - 14ms);
            for (const ButtonEdge& edge : buttons.poll(now)) downs += edge.motion == Motion::Down ? 1 : 0;
        }
        EXPECT_EQ(downs, 40U);
        EXPECT_THAT(buttons.status().reason, HasSubstr("is heard by hid: already; name another one"));
    }
}

TEST(Evdev, ABoardThatHidMayNotOpenIsHeardByEvdevUntilHidMay) {
    const BothWays board;
    board.raw->refusal = "Permission denied";
    MergedButtons buttons = board.merged(true);
    presses(buttons, 0s, 1s);
    board.cooked->key(BTN_TRIGGER, true, 1s);
    EXPECT_EQ(presses(buttons, 1s, 1s + 100ms), "A");
    board.raw->refusal.clear();
    EXPECT_EQ(presses(buttons, 1s + 100ms, 4s), "");
    EXPECT_FALSE(buttons.contacts()[0].is_down);
    board.tap(4s);
    EXPECT_EQ(presses(buttons, 4s, 5s), "A");
}

Controls pad_controls() {
    return {{}, {{ABS_HAT0X, -1, 1, 0}, {ABS_HAT0Y, -1, 1, 0}, {ABS_X, -100, 100, 0}, {ABS_Y, -100, 100, 0}}};
}

void move(ControlReader& reader, Code code, std::int32_t value) { reader.take({ControlKind::Axis, code, value, 0s}); }

TEST(ControlReader, ADiagonalKeepsTheDirectionItCameFromAndIsUprightFromTheCentre) {
    ControlReader reader{pad_controls()};
    const Signal up{evdev::SignalPart::Low, ABS_HAT0Y}, right{evdev::SignalPart::High, ABS_HAT0X};
    move(reader, ABS_HAT0X, 1);
    move(reader, ABS_HAT0Y, -1);
    reader.take({});
    EXPECT_TRUE(reader.is_pressed(up));
    EXPECT_FALSE(reader.is_pressed(right));
    move(reader, ABS_HAT0Y, 0);
    reader.take({});
    EXPECT_TRUE(reader.is_pressed(right));
    move(reader, ABS_HAT0Y, -1);
    reader.take({});
    EXPECT_TRUE(reader.is_pressed(right));
    EXPECT_FALSE(reader.is_pressed(up));
}

TEST(ControlReader, AStickIsPressedFromHalfWayAndLetGoBelowAQuarter) {
    ControlReader reader{pad_controls()};
    const Signal right{evdev::SignalPart::High, ABS_X};
    for (const auto& [value, is_pressed] :
         std::vector<std::pair<int, bool>>{{49, false}, {50, true}, {40, true}, {25, true}, {24, false}, {49, false}}) {
        move(reader, ABS_X, value);
        reader.take({});
        EXPECT_EQ(reader.is_pressed(right), is_pressed) << value;
    }
}

TEST(ControlReader, AxesThatRestAnywhereOrHaveNoRangeAreNeverPressed) {
    ControlReader reader{{{}, {{ABS_X, 0, 255, 0}, {ABS_HAT0X, 0, 0, 0}, {ABS_RZ, 5, -5, 0}}}};
    for (const Code code : std::vector<Code>{ABS_X, ABS_HAT0X, ABS_RZ, ABS_Y}) {
        move(reader, code, 0);
        reader.take({});
        EXPECT_FALSE(reader.is_pressed({evdev::SignalPart::Low, code}));
        EXPECT_FALSE(reader.is_pressed({evdev::SignalPart::High, code}));
    }
}

TEST(Libevdev, ReadsCapabilitiesAsTheKernelWritesThem) {
    EXPECT_THAT(parse_capabilities("3"), ElementsAre(0, 1));
    if (sizeof(unsigned long) == 8) {
        EXPECT_THAT(parse_capabilities("7cdb000000000000 0 0 0 0"),
                    ElementsAre(BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR, BTN_SELECT, BTN_START,
                                BTN_MODE, BTN_THUMBL, BTN_THUMBR));
    }
    EXPECT_THAT(parse_capabilities(""), IsEmpty());
    EXPECT_THAT(parse_capabilities("no bits"), IsEmpty());
}

TEST(Libevdev, KnowsControlsByTheirNames) {
    EXPECT_EQ(signal_named("BTN_SOUTH"), (Signal{evdev::SignalPart::Key, BTN_SOUTH}));
    EXPECT_EQ(signal_named("ABS_HAT0X-"), (Signal{evdev::SignalPart::Low, ABS_HAT0X}));
    EXPECT_EQ(signal_named("ABS_RZ+"), (Signal{evdev::SignalPart::High, ABS_RZ}));
    for (const char* name : {"", "+", "BTN_SUOTH", "ABS_X", "REL_X+"})
        EXPECT_EQ(signal_named(name), std::nullopt) << name;
}

Controls controls_after(EvdevStream& stream, const Controls& before) {
    ControlReader reader{before};
    ControlEvent event;
    while (stream.take(event) == EvdevStream::Took::Event) reader.take(event);
    Controls after;
    for (const Code code : kFiveKeys)
        if (reader.is_pressed({evdev::SignalPart::Key, code})) after.held.push_back(code);
    return after;
}

TEST(Libevdev, CatchesUpWithWhatAnOverflowLost) {
    StandInFolder folder;
    StandInEvdev device{folder, {kFiveKeys.begin(), kFiveKeys.end()}};
    LibevdevHost host{folder.sys(), folder.dev()};
    std::string trouble;
    const auto stream = host.open(device.path(), Grab::Yes, trouble);
    ASSERT_NE(stream, nullptr) << trouble;
    device.key(BTN_TRIGGER, true, 1000);
    Controls controls = controls_after(*stream, stream->at_opening());
    EXPECT_THAT(controls.held, ElementsAre(BTN_TRIGGER));
    device.key(BTN_TRIGGER, false, 2000);
    device.key(BTN_TOP, true, 3000);
    device.overflow(4000);
    controls = controls_after(*stream, controls);
    EXPECT_THAT(controls.held, ElementsAre(BTN_TOP));
    device.key(BTN_THUMB, true, 5000);
    EXPECT_THAT(controls_after(*stream, controls).held, ElementsAre(BTN_THUMB, BTN_TOP));
}

TEST(Libevdev, TellsWhatIsHeldAndWhereTheAxesAreAtOpeningAndGrabsForAsLongAsItIsOpen) {
    StandInFolder folder;
    StandInEvdev device{folder, {BTN_SOUTH, BTN_EAST}, {{ABS_X, {-7, -32768, 32767, 0, 0, 0}}}};
    device.key(BTN_EAST, true, 0);
    LibevdevHost host{folder.sys(), folder.dev()};
    ASSERT_EQ(host.devices().size(), 1U);
    const EvdevDeviceFacts facts = host.devices().front();
    EXPECT_EQ(facts.path, device.path());
    EXPECT_EQ(facts.identity.port, "usb-0000:00:14.0-1/input0");
    EXPECT_THAT(facts.keys, ElementsAre(BTN_SOUTH, BTN_EAST));
    EXPECT_THAT(facts.axes, ElementsAre(ABS_X));
    std::string trouble;
    const auto stream = host.open(facts.path, Grab::Yes, trouble);
    ASSERT_NE(stream, nullptr) << trouble;
    EXPECT_TRUE(device.is_grabbed());
    EXPECT_THAT(stream->at_opening().held, ElementsAre(BTN_EAST));
    ASSERT_EQ(stream->at_opening().axes.size(), 1U);
    EXPECT_EQ(stream->at_opening().axes[0].minimum, -32768);
    EXPECT_EQ(stream->at_opening().axes[0].value, -7);
}

TEST(Libevdev, OneThatAnotherProgramHasGrabbedIsNotOpened) {
    StandInFolder folder;
    StandInEvdev device{folder, {BTN_SOUTH}};
    device.is_grabbed_by_another = true;
    LibevdevHost host{folder.sys(), folder.dev()};
    std::string trouble;
    EXPECT_EQ(host.open(device.path(), Grab::Yes, trouble), nullptr);
    EXPECT_EQ(trouble, "another program has grabbed it");
    EXPECT_NE(host.open(device.path(), Grab::No, trouble), nullptr);
    EXPECT_EQ(host.open((folder.dev() / "event9").string(), Grab::No, trouble), nullptr);
    EXPECT_EQ(trouble, "No such file or directory");
}

TEST(Libevdev, TellsAtOnceWhatIsPluggedInAndOut) {
    StandInFolder folder;
    LibevdevHost host{folder.sys(), folder.dev()};
    EXPECT_FALSE(host.take_news());
    StandInEvdev device{folder, {BTN_SOUTH}};
    EXPECT_TRUE(host.take_news());
    EXPECT_FALSE(host.take_news());
    device.unplug();
    EXPECT_TRUE(host.take_news());
}

}  // namespace
}  // namespace quadrat::tests
