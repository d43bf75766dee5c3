// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "fake_hid.hpp"
#include "firmware-io/hid/hid_buttons.hpp"
#include "firmware-io/hid/hidraw.hpp"
#include "firmware-io/hid/learner.hpp"
#include "hid_specimens.hpp"

namespace quadrat::tests {
namespace {

using namespace std::chrono_literals;
using namespace firmware_io;
using namespace firmware_io::hid;
using testing::HasSubstr;
using testing::StartsWith;

HidSignal button_signal(unsigned number, std::uint16_t collection = 0) {
    return {collection, usage(page::kButton, number), SignalPart::Pressed};
}

HidDeviceFacts dragon_rise(std::string port) {
    for (const HidSpecimen& specimen : hid_specimens())
        if (specimen.name == "DragonRiseZeroDelayEncoder")
            return {
                "/dev/hidraw0", {0x79, 6, "Generic USB Joystick", "", std::move(port)}, bytes_of(specimen.descriptor)};
    return {};
}

TEST(HidMapping, WhatIsWrittenIsReadAgain) {
    std::mt19937 random{5};
    std::vector<HidMapping> mappings;
    for (int i = 0; i < 50; ++i) {
        HidMapping mapping{static_cast<std::uint16_t>(random()),
                           static_cast<std::uint16_t>(random()),
                           i % 3 == 0 ? std::to_string(i) : std::string{},
                           i % 2 == 0 ? std::string{"usb-1."}.append(std::to_string(i)) : std::string{},
                           {}};
        for (int b = 0; b < i % 7; ++b)
            mapping.bindings.push_back({{static_cast<std::uint16_t>(random() % 3), static_cast<Usage>(random()),
                                         static_cast<SignalPart>(random() % 7)},
                                        kButtons[random() % 5]});
        mappings.push_back(mapping);
    }
    EXPECT_EQ(parse_mappings(to_text(mappings), "again"), mappings);
}

TEST(HidMapping, ErrorsNameTheFileTheLineTheTroubleAndTheRemedy) {
    const auto error_of = [](std::string_view text) -> std::string {
        try {
            parse_mappings(text, "buttons.map");
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(error_of("A = 0009:0001 pressed, collection 0"),
                StartsWith("buttons.map:1: this belongs to no device;"));
    EXPECT_THAT(error_of("# x\ndevice 79"), StartsWith("buttons.map:2: \"79\" is not two hexadecimal numbers;"));
    EXPECT_THAT(error_of("device 0079:0006\nE = 0009:0001 pressed, collection 0"), HasSubstr("A, B, C, D or Back"));
    EXPECT_THAT(error_of("device 0079:0006\nA = 0009:0001 pushed, collection 0"), HasSubstr("left, low or high"));
    EXPECT_THAT(error_of("device 0079:0006\nA 1"), HasSubstr("write A = 0009:0001 pressed, collection 0"));
}

TEST(HidMapping, EqualBoardsAreToldApartByTheirPortAndALoneOneMayMove) {
    const HidMapping left{0x79, 6, "", "usb-1/input0", {{button_signal(1), Button::A}}};
    const HidMapping right{0x79, 6, "", "usb-2/input0", {{button_signal(1), Button::B}}};
    const std::vector both{left, right};
    EXPECT_EQ(mapping_of(both, {0x79, 6, "", "", "usb-2/input0"}), &both[1]);
    EXPECT_EQ(mapping_of(both, {0x79, 6, "", "", "usb-3/input0"}), nullptr);
    EXPECT_EQ(mapping_of(std::span{both}.first(1), {0x79, 6, "", "", "usb-3/input0"}), &both[0]);
    EXPECT_EQ(mapping_of(both, {0x79, 7, "", "", "usb-1/input0"}), nullptr);
    const std::vector numbered{HidMapping{1, 2, "X1", "usb-1", {}}, HidMapping{1, 2, "X2", "usb-2", {}}};
    EXPECT_EQ(mapping_of(numbered, {1, 2, "", "X1", "usb-2"}), &numbered[0]) << "a serial number goes before the port";
}

TEST(HidMapping, LearningAgainReplacesWhatWasKnownOfTheSameDevice) {
    std::vector<HidMapping> mappings{{0x79, 6, "", "usb-1", {{button_signal(1), Button::A}}},
                                     {0x79, 6, "", "usb-2", {}}};
    remember(mappings, {0x79, 6, "", "usb-1", {{button_signal(9), Button::A}}});
    ASSERT_EQ(mappings.size(), 2U);
    EXPECT_EQ(mapping_of(mappings, {0x79, 6, "", "", "usb-1"})->bindings[0].signal, button_signal(9));
}

TEST(Learner, TakesWhatCameAndWentAndIgnoresAnAxisThatRestsOffCentre) {
    Learner learner{dragon_rise("usb-1/input0")};
    // The unused axes of this board lie at their low end; it reports nothing until something is pressed.
    for (const char* held : {"00 00 00 00 00 4f 00 00", "00 00 00 00 00 0f 08 00", "00 00 00 00 00 06 00 00",
                             "00 00 00 00 ff 0f 00 00", "00 00 00 00 00 0f 80 00"}) {
        ASSERT_TRUE(learner.asked());
        learner.report(bytes_of(held));
        learner.report(bytes_of("00 00 00 00 00 0f 00 00"));
        EXPECT_EQ(learner.trouble(), "");
    }
    EXPECT_FALSE(learner.asked());
    const HidMapping mapping = learner.mapping();
    EXPECT_EQ(mapping.port, "usb-1/input0");
    const Usage y = usage(page::kDesktop, 0x31);
    EXPECT_EQ(mapping.bindings, (Bindings{{button_signal(3), Button::A},
                                          {button_signal(8), Button::B},
                                          {{0, kHatSwitch, SignalPart::Left}, Button::C},
                                          {{0, y, SignalPart::High}, Button::D},
                                          {button_signal(12), Button::Back}}));
}

TEST(Learner, RefusesTwoAtOnceAndTheSameTwiceAndSaysSo) {
    Learner learner{dragon_rise("usb-1/input0")};
    const char* rest = "7f 7f 7f 7f 7f 0f 00 00";
    learner.report(bytes_of("7f 7f 7f 7f 7f 3f 00 00"));
    learner.report(bytes_of(rest));
    EXPECT_THAT(learner.trouble(), HasSubstr("several controls"));
    EXPECT_EQ(learner.asked(), Button::A);
    for (int i = 0; i < 2; ++i) {
        learner.report(bytes_of("7f 7f 7f 7f 7f 1f 00 00"));
        learner.report(bytes_of(rest));
    }
    EXPECT_THAT(learner.trouble(), HasSubstr("button A already"));
    EXPECT_EQ(learner.asked(), Button::B);
    learner.skip();
    EXPECT_EQ(learner.asked(), Button::C);
}

TEST(Learner, SurvivesAnyReportsAndLearnsOnlyWhatTheDeviceCanSend) {
    std::mt19937 random{11};
    for (const HidSpecimen& specimen : hid_specimens()) {
        const HidDeviceFacts device{"", {1, 2, "", "a b#\n", ""}, bytes_of(specimen.descriptor)};
        Learner learner{device};
        for (int i = 0; i < 500; ++i) {
            Bytes report(random() % 12);
            for (auto& byte : report) byte = static_cast<std::uint8_t>(random() & random());
            learner.report(report);
        }
        const HidLayout layout = parse_descriptor(device.descriptor);
        for (const Binding& binding : learner.mapping().bindings) EXPECT_TRUE(can_send(layout, binding.signal));
        EXPECT_EQ(parse_mappings(to_text(std::vector{learner.mapping()}), "again"), std::vector{learner.mapping()});
    }
}

struct TwoEqualBoards {
    std::shared_ptr<FakeHidDevice> left = std::make_shared<FakeHidDevice>(), right = std::make_shared<FakeHidDevice>();
    TwoEqualBoards() {
        left->facts = dragon_rise("usb-0000:00:14.0-1.1/input0");
        right->facts = dragon_rise("usb-0000:00:14.0-1.2/input0");
        right->facts.path = "/dev/hidraw1";
    }
    HidButtons at(std::string port) const {
        return {std::make_unique<FakeHidHost>(FakeHidDevices{left, right}), {0x79, 6, "", std::move(port)}};
    }
};
const Bytes kFirstButton{0x7f, 0x7f, 0x7f, 0x7f, 0x7f, 0x1f, 0, 0};

TEST(HidButtons, EachOfTwoEqualBoardsKeepsItsPortWhateverPathItGets) {
    TwoEqualBoards boards;
    HidButtons buttons = boards.at("usb-0000:00:14.0-1.2");
    buttons.poll(1s);
    EXPECT_EQ(boards.right->opened, 1U);
    boards.right->unplug();
    buttons.poll(2s);
    EXPECT_EQ(buttons.status().presence, Presence::Absent);
    std::swap(boards.left->facts.path, boards.right->facts.path);
    boards.right->is_plugged = true;
    ++boards.right->plugging;
    buttons.poll(4s);
    EXPECT_EQ(buttons.status().presence, Presence::Present);
    boards.left->send(kFirstButton);
    EXPECT_TRUE(buttons.poll(5s).empty()) << "that is the other one's button";
    boards.right->send(kFirstButton);
    EXPECT_EQ(buttons.poll(6s).size(), 1U);
    EXPECT_EQ(boards.left->opened, 0U);
}

TEST(HidButtons, APortIsNotTheBeginningOfAnother) {
    TwoEqualBoards boards;
    HidButtons buttons = boards.at("usb-0000:00:14.0-1");
    buttons.poll(1s);
    EXPECT_EQ(buttons.status().presence, Presence::Absent);
}

TEST(HidButtons, AMappingGoesBeforeTheDefault) {
    TwoEqualBoards boards;
    const HidMapping mapping{0x79, 6, "", "usb-0000:00:14.0-1.2/input0", {{button_signal(1), Button::D}}};
    HidButtons buttons{
        std::make_unique<FakeHidHost>(FakeHidDevices{five_button_device(), boards.right}), {}, {}, {mapping}};
    buttons.poll(1s);
    ASSERT_EQ(boards.right->opened, 1U) << "the device that was taught is the likeliest";
    boards.right->send(kFirstButton);
    const auto edges = buttons.poll(2s);
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].button, Button::D);
}

TEST(HidButtons, ADeviceThatMayNotBeOpenedIsNamedWithTheRemedyAndTriedAgain) {
    auto device = five_button_device();
    device->refusal = "Permission denied";
    HidButtons buttons{std::make_unique<FakeHidHost>(FakeHidDevices{device}), {}};
    buttons.poll(1s);
    EXPECT_THAT(
        buttons.status().reason,
        HasSubstr("/dev/hidraw0 (Five buttons 1209:0001) cannot be opened (Permission denied); install the udev rule"));
    device->refusal.clear();
    buttons.poll(2s);
    EXPECT_EQ(buttons.status().presence, Presence::Present);
}

TEST(HidButtons, PassesOverDevicesWithoutButtonsAndMiceWhenThereIsAGamepad) {
    const auto device_of = [](std::string_view name, const char* path) {
        auto device = std::make_shared<FakeHidDevice>();
        for (const HidSpecimen& specimen : hid_specimens())
            if (specimen.name == name) device->facts = {path, {1, 2, "x", "", ""}, bytes_of(specimen.descriptor)};
        return device;
    };
    const auto mouse = device_of("OneSwitchAsAMouse", "/dev/hidraw0"), pad = device_of("DualShock4", "/dev/hidraw1");
    HidButtons buttons{std::make_unique<FakeHidHost>(FakeHidDevices{device_of("", "/dev/hidraw9"), mouse, pad}), {}};
    buttons.poll(1s);
    EXPECT_EQ(mouse->opened, 0U);
    EXPECT_EQ(pad->opened, 1U);
}

TEST(HidButtons, AFloodOfReportsIsReadInPortionsAndEndsInTheTrueState) {
    struct Flood : HidStream {
        int left = 100'000;
        std::ptrdiff_t read(std::span<std::uint8_t> report) override {
            report[0] = static_cast<std::uint8_t>(~left & 1);
            return left-- > 0 ? 1 : kNothing;
        }
    };
    struct Host : HidHost {
        std::vector<HidDeviceFacts> devices() override { return {five_button_device()->facts}; }
        std::unique_ptr<HidStream> open(const std::string&, std::string&) override { return std::make_unique<Flood>(); }
    };
    HidButtons buttons{std::make_unique<Host>(), {}};
    for (Instant now = 0s; now < 10s; now += 16ms) buttons.poll(now);
    EXPECT_FALSE(buttons.contacts()[0].is_closed);
    EXPECT_GT(buttons.contacts()[0].raw_edges, 90'000U);
}

class HidrawListing : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::remove_all(root); }
    void TearDown() override { std::filesystem::remove_all(root); }
    void add(const std::string& name, const std::string& uevent, const Bytes& descriptor) const {
        std::filesystem::create_directories(root / name / "device");
        std::ofstream{root / name / "device" / "uevent"} << uevent;
        std::ofstream{root / name / "device" / "report_descriptor", std::ios::binary}.write(
            reinterpret_cast<const char*>(descriptor.data()), static_cast<std::streamsize>(descriptor.size()));
    }
    std::filesystem::path root =
        std::filesystem::temp_directory_path() / std::string{"quadrat-hidraw-"}.append(std::to_string(::getpid()));
};

TEST_F(HidrawListing, GivesEachDeviceOnceWithItsIdentityItsPortAndItsDescriptor) {
    add("hidraw10",
        "DRIVER=hid-generic\nHID_ID=0003:0000D209:00000420\nHID_NAME=Ultimarc "
        "I-PAC\nHID_PHYS=usb-1/input0\nHID_UNIQ=4\n",
        kFiveButtons);
    add("hidraw2",
        "HID_ID=0003:00000079:00000006\nHID_NAME=Generic   USB  "
        "Joystick\nHID_PHYS=usb-0000:00:14.0-1.2/input0\nHID_UNIQ=\n",
        {});
    add("hidraw3", "", {});
    const auto devices = Hidraw{root}.devices();
    ASSERT_EQ(devices.size(), 3U);
    EXPECT_EQ(devices[0].path, "/dev/hidraw2");
    EXPECT_EQ(devices[0].identity.vendor, 0x79);
    EXPECT_EQ(devices[0].identity.port, "usb-0000:00:14.0-1.2/input0");
    EXPECT_EQ(devices[1].identity.vendor, 0) << "a device that says nothing is listed as nobody";
    EXPECT_EQ(devices[2].path, "/dev/hidraw10");
    EXPECT_EQ(devices[2].identity.product, 0x420);
    EXPECT_EQ(devices[2].identity.serial, "4");
    EXPECT_EQ(devices[2].descriptor, kFiveButtons);
}

TEST_F(HidrawListing, AMachineWithoutHidrawHasNoDevices) { EXPECT_TRUE(Hidraw{root}.devices().empty()); }

TEST_F(HidrawListing, ANodeThatIsNotThereCannotBeOpenedAndSaysWhy) {
    std::string trouble;
    EXPECT_EQ(Hidraw{}.open((root / "hidraw0").string(), trouble), nullptr);
    EXPECT_NE(trouble, "");
}

}  // namespace
}  // namespace quadrat::tests
