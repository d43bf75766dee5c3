// SPDX-License-Identifier: Apache-2.0
// Boards as they are sold: several interfaces, several of a kind, numbered from 0.
#include <gmock/gmock.h>

#include "fake_hid.hpp"
#include "firmware-io/hid/hid_buttons.hpp"
#include "firmware-io/hid/report_reader.hpp"
#include "hid_specimens.hpp"

namespace quadrat::tests {
namespace {

using namespace std::chrono_literals;
using namespace firmware_io;
using namespace firmware_io::hid;
using testing::AllOf;
using testing::HasSubstr;

// Six keys at most, after a byte of modifiers and an empty one: what a BIOS understands.
const Bytes kBootKeyboard = bytes_of(
    "05 01 09 06 a1 01 05 07 19 e0 29 e7 15 00 25 01 75 01 95 08 81 02 95 01 75 08 81 01 "
    "95 06 75 08 15 00 25 65 05 07 19 00 29 65 81 00 c0");
// A bit for each key, in a report with the number 2.
const Bytes kBitmapKeyboard = bytes_of(
    "05 01 09 06 a1 01 85 02 05 07 19 e0 29 e7 15 00 25 01 75 01 95 08 81 02 "
    "19 00 29 77 15 00 25 01 75 01 95 78 81 02 c0");
const Bytes kNobodyPresses(8, 0);

Bytes boot_key(std::uint8_t key) { return {0, 0, key, 0, 0, 0, 0, 0}; }
Bytes bitmap_key(unsigned key) {
    Bytes report(17, 0);
    report[0] = 2;
    report[2 + key / 8] = static_cast<std::uint8_t>(1u << key % 8);
    return report;
}

std::shared_ptr<FakeHidDevice> interface_of(std::string path, std::string port, Bytes descriptor) {
    auto device = std::make_shared<FakeHidDevice>();
    device->facts = {std::move(path), {0xd209, 0x0420, "Encoder", "9", std::move(port)}, std::move(descriptor)};
    return device;
}

// A board that shows a game controller, a keyboard and a keyboard with a bit for each key, as encoders do.
struct Board {
    std::shared_ptr<FakeHidDevice> pad = interface_of("/dev/hidraw0", "usb-0000:01:00.0-1.2/input0", kFiveButtons);
    std::shared_ptr<FakeHidDevice> keys = interface_of("/dev/hidraw1", "usb-0000:01:00.0-1.2/input1", kBootKeyboard);
    std::shared_ptr<FakeHidDevice> bits = interface_of("/dev/hidraw9", "usb-0000:01:00.0-1.2/input2", kBitmapKeyboard);

    HidButtons buttons(HidSelector selector = {}) const {
        return HidButtons{std::make_unique<FakeHidHost>(FakeHidDevices{pad, keys, bits}), std::move(selector)};
    }
};

// The presses of what was sent just now, "A B".
std::string presses(ButtonSource& source, Instant from, Instant until) {
    std::string text;
    for (Instant now = from; now < until; now += 1ms)
        for (const ButtonEdge& edge : source.poll(now))
            if (edge.motion == Motion::Down) text.append(text.empty() ? "" : " ").append(name_of(edge.button));
    return text;
}

class EveryInterface : public testing::TestWithParam<HidSelector> {};

TEST_P(EveryInterface, OfABoardIsHeard) {
    const Board board;
    HidButtons buttons = board.buttons(GetParam());
    presses(buttons, 0s, 1s);
    EXPECT_THAT(buttons.status().reason, AllOf(HasSubstr("/dev/hidraw0"), HasSubstr("/dev/hidraw1")));
    board.keys->send({1, 0, 0, 0, 0, 0, 0, 0});  // left Ctrl
    board.keys->send(kNobodyPresses);
    EXPECT_EQ(presses(buttons, 1s, 2s), "A");
    board.bits->send(bitmap_key(0x05));
    board.bits->send(bitmap_key(0x01));
    EXPECT_EQ(presses(buttons, 2s, 3s), "B");
    board.pad->send({0x04});
    board.pad->send({0});
    EXPECT_EQ(presses(buttons, 3s, 4s), "C");
}

INSTANTIATE_TEST_SUITE_P(Chosen, EveryInterface,
                         testing::Values(HidSelector{}, HidSelector{0xd209, 0x0420},
                                         HidSelector{{}, {}, "/dev/hidraw0"}, HidSelector{{}, {}, "/dev/hidraw1"},
                                         HidSelector{{}, {}, "", "usb-0000:01:00.0-1.2"},
                                         HidSelector{{}, {}, "", "", "9"}, HidSelector{{}, {}, "", "", "", "Enco"}));

TEST(HidBoards, AnInterfaceThatIsNamedIsHeardAlone) {
    const Board board;
    HidButtons buttons = board.buttons({{}, {}, "", "usb-0000:01:00.0-1.2/input1"});
    buttons.poll(0s);
    EXPECT_EQ(board.pad->opened, 0U);
    EXPECT_EQ(board.keys->opened, 1U);
}

TEST(HidBoards, TheMouseOfABoardIsNotHeardBesideItsKeyboard) {
    const Board board;
    const auto mouse = interface_of(
        "/dev/hidraw3", "usb-0000:01:00.0-1.2/input3",
        bytes_of("05 01 09 02 a1 01 05 09 19 01 29 03 15 00 25 01 75 01 95 03 81 02 75 05 95 01 81 01 c0"));
    HidButtons buttons{std::make_unique<FakeHidHost>(FakeHidDevices{mouse, board.keys}), {}};
    buttons.poll(0s);
    EXPECT_EQ(mouse->opened, 0U);
    HidButtons alone{std::make_unique<FakeHidHost>(FakeHidDevices{mouse}), {}};
    alone.poll(0s);
    EXPECT_EQ(mouse->opened, 1U) << "a switch that clicks is a button where there is no better";
}

TEST(HidBoards, OnePressThatTwoInterfacesTellOfIsOne) {
    const Board board;
    HidButtons buttons = board.buttons();
    presses(buttons, 0s, 1s);
    board.keys->send(boot_key(0x04));
    board.bits->send(bitmap_key(0x04));
    EXPECT_EQ(presses(buttons, 1s, 1s + 3ms), "A");
    board.keys->send(kNobodyPresses);
    EXPECT_EQ(presses(buttons, 1s + 3ms, 1s + 6ms), "");
    EXPECT_TRUE(buttons.contacts()[0].is_down);
    board.bits->send(bitmap_key(0x01));
    EXPECT_EQ(presses(buttons, 1s + 6ms, 2s), "");
    EXPECT_FALSE(buttons.contacts()[0].is_down);
}

TEST(HidBoards, WhatOneInterfaceHoldsFromTheStartSwallowsNoPressOnAnother) {
    const Board board;
    HidButtons buttons = board.buttons();
    buttons.poll(0s);
    board.pad->send({0x01});
    EXPECT_EQ(presses(buttons, 10ms, 1s), "") << "held when it was opened";
    board.keys->send(boot_key(0x04));
    board.keys->send(kNobodyPresses);
    EXPECT_EQ(presses(buttons, 1s, 2s), "A");
}

TEST(HidBoards, AnInterfaceThatComesLaterOrGoesLeavesTheOthersAsTheyAre) {
    const Board board;
    board.keys->unplug();
    HidButtons buttons = board.buttons();
    presses(buttons, 0s, 1s);
    board.pad->send({0x01});
    EXPECT_EQ(presses(buttons, 1s, 2s), "A");
    board.keys->plug();
    presses(buttons, 2s, 4s);
    board.keys->send(boot_key(0x05));
    EXPECT_EQ(presses(buttons, 4s, 5s), "B");
    const auto raw_edges = buttons.contacts()[1].raw_edges;
    board.keys->unplug();
    EXPECT_EQ(presses(buttons, 5s, 7s), "");
    EXPECT_TRUE(buttons.contacts()[0].is_down) << "is still held";
    EXPECT_FALSE(buttons.contacts()[1].is_down) << "went with its keyboard";
    EXPECT_GE(buttons.contacts()[1].raw_edges, raw_edges) << "what was counted stays counted";
    EXPECT_EQ(buttons.status().presence, Presence::Present);
    EXPECT_THAT(buttons.status().reason, HasSubstr("which was unplugged"));
    board.keys->plug();
    presses(buttons, 7s, 9s);
    EXPECT_EQ(buttons.status().reason.find("unplugged"), std::string::npos);
}

TEST(HidBoards, AnInterfaceThatMayNotBeOpenedIsNamedBesideThoseThatAre) {
    const Board board;
    board.keys->refusal = "Permission denied";
    HidButtons buttons = board.buttons();
    buttons.poll(0s);
    EXPECT_EQ(buttons.status().presence, Presence::Present);
    EXPECT_THAT(buttons.status().reason,
                AllOf(HasSubstr("/dev/hidraw0"), HasSubstr("/dev/hidraw1 (Encoder d209:0420) cannot be opened")));
}

TEST(HidBoards, AKeyboardThatWasThereFirstGivesWayToTheGamepadThatComes) {
    const auto keyboard = interface_of("/dev/hidraw0", "usb-1/input0", kBootKeyboard);
    const auto pad = five_button_device();
    pad->facts.path = "/dev/hidraw1";
    pad->is_plugged = false;
    HidButtons buttons{std::make_unique<FakeHidHost>(FakeHidDevices{keyboard, pad}), {}};
    presses(buttons, 0s, 1s);
    keyboard->send(boot_key(0x04));
    EXPECT_EQ(presses(buttons, 1s, 2s), "A");
    pad->is_plugged = true;
    presses(buttons, 2s, 4s);
    EXPECT_FALSE(buttons.contacts()[0].is_down) << "an Up for what the keyboard held";
    pad->send({0x02});
    EXPECT_EQ(presses(buttons, 4s, 5s), "B");
    keyboard->send(boot_key(0x06));
    EXPECT_EQ(presses(buttons, 5s, 6s), "");
}

struct EqualBoards {
    std::shared_ptr<FakeHidDevice> left = five_button_device(), right = five_button_device();
    EqualBoards() {
        left->facts.identity.serial = "L";
        right->facts.path = "/dev/hidraw1";
        right->facts.identity.serial = "R";
        right->facts.identity.port = "usb-0000:00:14.0-2/input0";
    }
    HidButtons buttons(HidSelector selector, std::vector<HidMapping> mappings = {}) const {
        return HidButtons{
            std::make_unique<FakeHidHost>(FakeHidDevices{left, right}), std::move(selector), {}, std::move(mappings)};
    }
};

TEST(HidBoards, TwoEqualOnesAreBothHeard) {
    const EqualBoards boards;
    for (const HidSelector& selector : {HidSelector{}, HidSelector{0x1209, 1}}) {
        HidButtons buttons = boards.buttons(selector);
        presses(buttons, 0s, 1s);
        boards.left->send({0x01});
        boards.left->send({0x00});
        EXPECT_EQ(presses(buttons, 1s, 2s), "A");
        boards.right->send({0x08});
        boards.right->send({0x00});
        EXPECT_EQ(presses(buttons, 2s, 3s), "D");
    }
}

TEST(HidBoards, TwoEqualOnesAreToldApartBySerialAndByPort) {
    const EqualBoards boards;
    for (const HidSelector& selector :
         {HidSelector{{}, {}, "", "", "R"}, HidSelector{0x1209, 1, "", "usb-0000:00:14.0-2"}}) {
        HidButtons buttons = boards.buttons(selector);
        presses(buttons, 0s, 1s);
        boards.left->send({0x01});
        EXPECT_EQ(presses(buttons, 1s, 2s), "");
        boards.right->send({0x01});
        boards.right->send({0x00});
        EXPECT_EQ(presses(buttons, 2s, 3s), "A");
    }
}

TEST(HidBoards, TwoEqualOnesThatWereTaughtEachMeanTheirOwn) {
    const EqualBoards boards;
    const HidSignal first{0, usage(page::kButton, 1), SignalPart::Pressed};
    const std::vector<HidMapping> mappings{{0x1209, 1, "L", "usb-0000:00:14.0-1/input0", {{first, Button::B}}},
                                           {0x1209, 1, "R", "usb-0000:00:14.0-2/input0", {{first, Button::D}}}};
    HidButtons buttons = boards.buttons({}, mappings);
    presses(buttons, 0s, 1s);
    boards.left->send({0x01});
    EXPECT_EQ(presses(buttons, 1s, 2s), "B");
    boards.right->send({0x01});
    EXPECT_EQ(presses(buttons, 2s, 3s), "D");
}

TEST(HidBoards, ALostOneOfTwoIsNamedAndComesBack) {
    const EqualBoards boards;
    HidButtons buttons = boards.buttons({});
    presses(buttons, 0s, 1s);
    boards.right->unplug();
    presses(buttons, 1s, 3s);
    EXPECT_THAT(buttons.status().reason,
                HasSubstr("usb-0000:00:14.0-2/input0 (Five buttons 1209:0001), which was unpl"));
    boards.right->plug();
    presses(buttons, 3s, 5s);
    boards.right->send({0x04});
    EXPECT_EQ(presses(buttons, 5s, 6s), "C");
}

std::string default_presses(const Bytes& descriptor, const Bytes& report) {
    ReportReader reader{parse_descriptor(descriptor)};
    reader.read(report);
    const auto pressed = reader.pressed();
    std::string text;
    for (const Binding& binding : default_bindings(reader.layout()))
        if (std::find(pressed.begin(), pressed.end(), binding.signal) != pressed.end()) text += name_of(binding.button);
    return text;
}

TEST(HidNumbering, ABoxThatCountsFrom0HasAFirstButton) {
    const Bytes range = bytes_of("05 01 09 04 a1 01 05 09 19 00 29 10 15 00 25 01 75 01 95 10 81 02 c0");
    EXPECT_EQ(default_presses(range, {0x01, 0}), "A");
    EXPECT_EQ(default_presses(range, {0x02, 0}), "B");
    EXPECT_EQ(default_presses(range, {0x10, 0}), "Back");
    const Bytes one_by_one =
        bytes_of("05 01 09 04 a1 01 05 09 09 00 09 01 09 02 09 03 15 00 25 01 75 01 95 04 81 02 95 04 81 03 c0");
    EXPECT_EQ(default_presses(one_by_one, {0x01}), "A");
    EXPECT_EQ(default_presses(one_by_one, {0x08}), "D");
}

TEST(HidNumbering, AnArrayThatCountsFrom0MeansItsFirstWhereNothingIsAnotherValue) {
    const Bytes from_one = bytes_of("05 01 09 04 a1 01 05 09 19 00 29 07 15 01 25 08 75 08 95 02 81 00 c0");
    EXPECT_EQ(default_presses(from_one, {0, 0}), "");
    EXPECT_EQ(default_presses(from_one, {1, 0}), "A");
    EXPECT_EQ(default_presses(from_one, {0, 2}), "B");
    const Bytes from_zero = bytes_of("05 01 09 04 a1 01 05 09 19 00 29 08 15 00 25 08 75 08 95 02 81 00 c0");
    EXPECT_EQ(default_presses(from_zero, {0, 0}), "") << "0 is nothing";
    EXPECT_EQ(default_presses(from_zero, {1, 0}), "A");
}

TEST(HidNumbering, PaddingOfUsage0IsNoButton) {
    const Bytes padded =
        bytes_of("05 01 09 04 a1 01 05 09 19 01 29 04 15 00 25 01 75 01 95 04 81 02 09 00 95 04 81 02 c0");
    EXPECT_EQ(default_presses(padded, {0x01}), "A");
    EXPECT_EQ(default_presses(padded, {0x08}), "D");
    EXPECT_EQ(default_presses(padded, {0xf0}), "");
}

}  // namespace
}  // namespace quadrat::tests
