// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/input_spec.hpp"

#include <gmock/gmock.h>

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string error_of(std::string_view spec) {
    try {
        parse_input_spec(spec);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

TEST(InputSpec, ReadsLinesByNameAndByPlace) {
    const auto wiring = std::get<gpio::Wiring>(
        parse_input_spec("gpio:A=GPIO17,b=/dev/gpiochip0:27,lampA=GPIO5,pull=none,active=high,debounce=8ms"));
    EXPECT_EQ(wiring.contacts,
              (std::vector<gpio::Wire>{{Button::A, {"GPIO17", {}}}, {Button::B, {"", {"/dev/gpiochip0", 27}}}}));
    EXPECT_EQ(wiring.lamps, (std::vector<gpio::Wire>{{Button::A, {"GPIO5", {}}}}));
    EXPECT_EQ(wiring.inputs.pull, gpio::Pull::None);
    EXPECT_EQ(wiring.inputs.active, gpio::Active::High);
    EXPECT_EQ(wiring.debounce.period, 8ms);
}

TEST(InputSpec, ContactsCloseToGroundUnlessSaidOtherwise) {
    const auto wiring = std::get<gpio::Wiring>(parse_input_spec("gpio:A=GPIO17"));
    EXPECT_EQ(wiring.inputs.pull, gpio::Pull::Up);
    EXPECT_EQ(wiring.inputs.active, gpio::Active::Low);
    EXPECT_EQ(wiring.debounce.period, 5ms);
    EXPECT_EQ(wiring.debounce.form, DebounceForm::FirstEdge);
}

TEST(InputSpec, ReadsEveryWayToNameAHidDevice) {
    EXPECT_EQ(std::get<HidSpec>(parse_input_spec("hid:")).selector, hid::HidSelector{});
    EXPECT_EQ(std::get<HidSpec>(parse_input_spec("hid:0079:0006")).selector, (hid::HidSelector{0x79, 6, "", ""}));
    EXPECT_EQ(std::get<HidSpec>(parse_input_spec("hid:path=/dev/hidraw3")).selector.path, "/dev/hidraw3");
    const auto spec = std::get<HidSpec>(parse_input_spec("hid:16C0:05e1,port=usb-0000:00:14.0-1,form=integrator"));
    EXPECT_EQ(spec.selector, (hid::HidSelector{0x16c0, 0x05e1, "", "usb-0000:00:14.0-1"}));
    EXPECT_EQ(spec.debounce.form, DebounceForm::Integrator);
}

TEST(InputSpec, ReadsEveryWayToNameAGpioChip) {
    const auto wiring = std::get<gpio::Wiring>(
        parse_input_spec("gpio:A=/dev/panel:1,B=gpiochip4:2,C=4:3,D=pinctrl-rp1:4,Back=0-0020:5"));
    std::vector<gpio::LinePlace> places;
    for (const gpio::Wire& wire : wiring.contacts) places.push_back(wire.line.place);
    EXPECT_EQ(places, (std::vector<gpio::LinePlace>{
                          {"/dev/panel", 1}, {"gpiochip4", 2}, {"4", 3}, {"pinctrl-rp1", 4}, {"0-0020", 5}}));
}

TEST(InputSpec, TellsEqualBoardsApartBySerialAndByPort) {
    const auto hid = std::get<HidSpec>(parse_input_spec("hid:0079:0006,serial=4711")).selector;
    EXPECT_EQ(hid.serial, "4711");
    const auto evdev = std::get<EvdevSpec>(parse_input_spec("evdev:045e:028e,serial=7,port=usb-1,name=X-Box 360"));
    EXPECT_EQ(evdev.selector, (DeviceSelector{0x45e, 0x28e, "", "usb-1", "7", "X-Box 360"}));
}

TEST(InputSpec, ReadsWhatIsHeardThroughTheKernelsDrivers) {
    const auto any = std::get<EvdevSpec>(parse_input_spec("evdev:"));
    EXPECT_EQ(any.selector, DeviceSelector{});
    EXPECT_TRUE(any.grabs);
    const auto spec = std::get<EvdevSpec>(
        parse_input_spec("evdev:path=/dev/input/event3,A=BTN_SOUTH,b=ABS_Z+,Back=ABS_HAT0X-,grab=no,debounce=8ms"));
    EXPECT_EQ(spec.selector.path, "/dev/input/event3");
    EXPECT_FALSE(spec.grabs);
    EXPECT_EQ(spec.debounce.period, 8ms);
    EXPECT_EQ(spec.controls, (std::vector<NamedControl>{
                                 {Button::A, "BTN_SOUTH"}, {Button::B, "ABS_Z+"}, {Button::Back, "ABS_HAT0X-"}}));
    EXPECT_THAT(error_of("evdev:45e"), HasSubstr("evdev:0079:0006"));
    EXPECT_THAT(error_of("evdev:A=SOUTH"), HasSubstr("BTN_SOUTH, KEY_A"));
    EXPECT_THAT(error_of("evdev:A=ABS_Z"), HasSubstr("ABS_Z+"));
    EXPECT_THAT(error_of("evdev:grab=maybe"), HasSubstr("yes or no"));
    EXPECT_THAT(error_of("evdev:map=x"), HasSubstr("\"map\" is not a setting"));
}

TEST(InputSpec, ErrorsNameTheSpecTheTroubleAndTheRemedy) {
    EXPECT_THAT(error_of("mouse"), AllOf(StartsWith("input \"mouse\": no such input;"), HasSubstr("script:FILE")));
    EXPECT_THAT(error_of("gpio"), HasSubstr("no such input"));
    EXPECT_THAT(error_of("gpio:"), HasSubstr("gpio:A=GPIO17"));
    EXPECT_THAT(error_of("gpio:E=GPIO17"), HasSubstr("\"E\" is not a setting"));
    EXPECT_THAT(error_of("gpio:A=GPIO17,B=GPIO17"), HasSubstr("named twice"));
    EXPECT_THAT(error_of("gpio:lampA=GPIO17"), HasSubstr("no button has a line"));
    EXPECT_THAT(error_of("gpio:A=/dev/gpiochip0"), HasSubstr("/dev/gpiochip0:17"));
    EXPECT_THAT(error_of("gpio:A=GPIO17,debounce=2s"), HasSubstr("0ms to 1s"));
    EXPECT_THAT(error_of("gpio:A=GPIO17,pull=sideways"), HasSubstr("up, down or none"));
    EXPECT_THAT(error_of("hid:79"), HasSubstr("hid:0079:0006"));
    EXPECT_THAT(error_of("hid:12345:1"), HasSubstr("hid:0079:0006"));
    EXPECT_THAT(error_of("hid:0079:0006,speed=3"), HasSubstr("path, port, serial, name, map, debounce or form"));
    EXPECT_THAT(error_of("script:"), HasSubstr("script:FILE"));
    EXPECT_EQ(error_of("gpio:A=X\nY,B=X\nY").find('\n'), std::string::npos);
}

TEST(OpenButtons, MissingHardwareIsASourceThatIsAbsent) {
    for (const char* spec : {"gpio:A=NO_SUCH_LINE", "hid:ffff:fffe", "hid:path=/dev/hidraw9999", "evdev:ffff:fffe"}) {
        const auto source = open_buttons(spec).source;
        EXPECT_TRUE(source->poll(1s).empty());
        EXPECT_EQ(source->status().presence, Presence::Absent) << spec;
        EXPECT_THAT(source->status().reason, HasSubstr(";")) << spec;
    }
}

TEST(OpenButtons, AControlThatNoKernelKnowsIsSaidAndTheUsualOnesApply) {
    EXPECT_THAT(open_buttons("evdev:A=BTN_SUOTH").map_trouble, HasSubstr("\"BTN_SUOTH\""));
    EXPECT_EQ(open_buttons("evdev:A=BTN_SOUTH,B=ABS_RZ+").map_trouble, "");
}

TEST(OpenButtons, AMissingScriptIsAnError) { EXPECT_THROW(open_buttons("script:/nowhere"), std::invalid_argument); }

}  // namespace
}  // namespace quadrat::firmware_io
