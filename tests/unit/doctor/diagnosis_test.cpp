// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware-io/evdev/evdev_buttons.hpp"
#include "support/process.hpp"
#include "unit/firmware-io/fake_evdev.hpp"

namespace quadrat::doctor {
namespace {

using testing::HasSubstr;

// A machine's /sys/class/drm and /dev/dri, as folders.
class Machine {
  public:
    Machine() {
        std::filesystem::create_directories(sys());
        std::filesystem::create_directories(dev());
    }
    std::filesystem::path sys() const { return folder_.path() / "sys"; }
    std::filesystem::path dev() const { return folder_.path() / "dev"; }
    Machine& card(const std::string& name) {
        std::filesystem::create_directory(sys() / name);
        folder_.write("dev/" + name, "");
        return *this;
    }
    Machine& connector(const std::string& name, const std::string& status, const std::string& modes,
                       const std::string& edid) {
        std::filesystem::create_directory(sys() / name);
        folder_.write("sys/" + name + "/status", status + "\n");
        folder_.write("sys/" + name + "/modes", modes);
        folder_.write("sys/" + name + "/edid", edid);
        return *this;
    }
    std::string report() const { return report_of(examine_screen({}, sys(), dev())); }

  private:
    tests::TemporaryFolder folder_;
};

TEST(Doctor, NamesTheScreenThatIsPluggedIn) {
    Machine machine;
    machine.card("card1").connector("card1-HDMI-A-1", "connected", "1920x1080\n1280x720\n", "edid");
    EXPECT_THAT(machine.report(), HasSubstr("HDMI-A-1: plugged in, prefers 1920x1080"));
    EXPECT_THAT(machine.report(), testing::Not(HasSubstr("->")));
}

TEST(Doctor, TellsAnUnpluggedScreenFromOneWithoutEdid) {
    Machine machine;
    machine.card("card0")
        .connector("card0-HDMI-A-1", "disconnected", "", "")
        .connector("card0-HDMI-A-2", "connected", "1024x768\n", "");
    EXPECT_THAT(machine.report(), HasSubstr("HDMI-A-1: nothing is plugged in"));
    EXPECT_THAT(machine.report(), HasSubstr("HDMI-A-2: plugged in, but it does not say what it is (no EDID)"));
}

TEST(Doctor, MissesTheNodeOfACard) {
    Machine machine;
    machine.card("card0").connector("card0-HDMI-A-1", "connected", "1024x768\n", "edid");
    std::filesystem::remove(machine.dev() / "card0");
    EXPECT_THAT(machine.report(), HasSubstr("card0 is missing"));
    EXPECT_THAT(report_of(examine_screen({}, "/nowhere", "/nowhere")), HasSubstr("no graphics card"));
}

TEST(Doctor, FindsNothingWrongWithSoundThatIsOffOrThere) {
    site::Configuration configuration;
    configuration.sound.device = "hw:CARD=NoSuchCard";
    EXPECT_THAT(report_of(examine_sound(configuration)), HasSubstr("sound is off, as the settings say"));
    configuration.sound.is_on = configuration.sound.speaks = true;
    configuration.sound.device = "null";
    configuration.visit.languages = {"de", "zh"};
    const auto findings = examine_sound(configuration, {}, "/nowhere");
    EXPECT_EQ(worst_of(findings), Health::Good) << report_of(findings);
    EXPECT_THAT(report_of(findings), HasSubstr("every language of the site has a voice"));
}

TEST(Doctor, KnowsADamagedStateFileWithoutTouchingIt) {
    const tests::TemporaryFolder folder;
    EXPECT_THAT(report_of(examine_state(folder.path())), HasSubstr("no visit has been kept yet"));
    folder.write("quadrat.db", "not a database at all");
    EXPECT_THAT(report_of(examine_state(folder.path())), HasSubstr("is not a database any more"));
    EXPECT_EQ(tests::contents_of(folder / "quadrat.db"), "not a database at all");
}

TEST(Doctor, SaysWhichButtonsAreMissingAndWhichAreMisspelt) {
    site::Configuration configuration;
    configuration.inputs = {"gpio:A=NO_SUCH_LINE", "telepathy:"};
    const auto findings = examine_buttons(configuration);
    EXPECT_EQ(findings.at(0).health, Health::Bad);
    EXPECT_EQ(findings.at(1).health, Health::Bad);
    EXPECT_THAT(findings.at(1).what, HasSubstr("telepathy"));
    EXPECT_THAT(report_of(examine_buttons({})), HasSubstr("none are named"));
}

TEST(Doctor, NamesTheBoardsThatNoInputNames) {
    const auto open = [](std::string_view spec) {
        tests::FakeEvdevDevices devices;
        if (spec == "evdev:") devices.push_back(tests::x_input_pad());
        return firmware_io::Opened{
            std::make_unique<firmware_io::evdev::EvdevButtons>(std::make_unique<tests::FakeEvdevHost>(devices),
                                                               firmware_io::evdev::EvdevOptions{}),
            ""};
    };
    site::Configuration configuration;
    configuration.inputs = {"gpio:A=GPIO17"};
    EXPECT_THAT(report_of(examine_boards(configuration, open)),
                HasSubstr("evdev: would hear /dev/input/event5 (Microsoft X-Box 360 pad 045e:028e)"));
    EXPECT_EQ(examine_boards(configuration, open).size(), 1U) << "no HID board is there";
    configuration.inputs = {"evdev:045e:028e"};
    EXPECT_TRUE(examine_boards(configuration, open).empty());
}

}  // namespace
}  // namespace quadrat::doctor
