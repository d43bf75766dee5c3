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
    EXPECT_THAT(error_of("hid:0079:0006,speed=3"), HasSubstr("path, port, map, debounce or form"));
    EXPECT_THAT(error_of("script:"), HasSubstr("script:FILE"));
    EXPECT_EQ(error_of("gpio:A=X\nY,B=X\nY").find('\n'), std::string::npos);
}

TEST(OpenButtons, MissingHardwareIsASourceThatIsAbsent) {
    for (const char* spec : {"gpio:A=NO_SUCH_LINE", "hid:ffff:fffe", "hid:path=/dev/hidraw9999"}) {
        const auto source = open_buttons(spec).source;
        EXPECT_TRUE(source->poll(1s).empty());
        EXPECT_EQ(source->status().presence, Presence::Absent) << spec;
        EXPECT_THAT(source->status().reason, HasSubstr(";")) << spec;
    }
}

TEST(OpenButtons, AMissingScriptIsAnError) { EXPECT_THROW(open_buttons("script:/nowhere"), std::invalid_argument); }

}  // namespace
}  // namespace quadrat::firmware_io
