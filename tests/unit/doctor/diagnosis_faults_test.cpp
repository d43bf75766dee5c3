// SPDX-License-Identifier: Apache-2.0
// Set-ups that are broken, each in one way: the doctor names the cause and what mends it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "doctor/diagnosis.hpp"
#include "firmware-io/merged_buttons.hpp"
#include "site/wall_clock.hpp"
#include "staff/vitals.hpp"
#include "support/process.hpp"
#include "unit/firmware-io/fake_gpio.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Broken {
    std::string name;
    std::vector<Finding> (*examine)(const tests::TemporaryFolder& machine);
    Health health;
    std::string cause, remedy;
};

void add_connector(const tests::TemporaryFolder& machine, const std::string& status, const std::string& edid) {
    fs::create_directories(machine / "sys/card0");
    fs::create_directories(machine / "sys/card0-HDMI-A-1");
    fs::create_directories(machine / "dev");
    machine.write("dev/card0", "");
    machine.write("sys/card0-HDMI-A-1/status", status + "\n");
    machine.write("sys/card0-HDMI-A-1/modes", edid.empty() ? "" : "1920x1080\n");
    machine.write("sys/card0-HDMI-A-1/edid", edid);
}

std::vector<Finding> screen_of(const tests::TemporaryFolder& machine) {
    return examine_screen({}, machine / "sys", machine / "dev");
}

std::vector<Finding> buttons_of(const std::string& input) {
    site::Configuration configuration;
    configuration.inputs = {input};
    return examine_buttons(configuration);
}

// Lines may be looked at, and never taken: a running exhibit's are its own.
class UntouchableGpio final : public tests::FakeGpioHost {
  public:
    using FakeGpioHost::FakeGpioHost;
    std::unique_ptr<firmware_io::gpio::InputLines> request_inputs(const std::string& chip, const std::vector<unsigned>&,
                                                                  firmware_io::gpio::InputOptions) override {
        throw std::logic_error(chip + " was taken");
    }
    std::unique_ptr<firmware_io::gpio::OutputLines> request_outputs(const std::string& chip,
                                                                    const std::vector<unsigned>&) override {
        throw std::logic_error(chip + " was taken");
    }
};

// What is said of a button and a lamp on lines that somebody holds.
std::vector<Finding> lines_held_by(const std::string& holder) {
    const auto open = [&](std::string_view spec) {
        auto machine = std::make_shared<tests::FakeGpioMachine>();
        machine->chips = {tests::chip_of("/dev/gpiochip0", "pinctrl-rp1", {"GPIO17", "GPIO5"})};
        for (auto& line : machine->chips.front().lines) line.holder = holder;
        const auto wiring = std::get<firmware_io::gpio::Wiring>(firmware_io::parse_input_spec(spec));
        return firmware_io::Opened{
            std::make_unique<firmware_io::gpio::GpioButtons>(std::make_unique<UntouchableGpio>(machine), wiring), ""};
    };
    site::Configuration configuration;
    configuration.inputs = {"gpio:A=GPIO17,lampA=GPIO5"};
    return {examine_buttons(configuration, {}, open).front()};
}

std::vector<Finding> service_that_says(const tests::TemporaryFolder& machine, const staff::Vitals& vitals) {
    machine.write("health.json", staff::to_json(vitals));
    return examine_service(machine.path());
}

std::vector<Finding> configured(const tests::TemporaryFolder& machine, const std::string& toml) {
    return examine_configuration(machine.write("quadrat.toml", toml)).findings;
}

// The exhibit's user, to whom nothing of the machine's was given; whoever runs the test may be root.
machine::Account stranger(const tests::TemporaryFolder& machine) {
    fs::permissions(machine.path(), fs::perms{0755});
    return {"quadrat", ::getuid() + 12345, {}};
}

void add_closed_node(const tests::TemporaryFolder& machine, const std::string& name) {
    fs::create_directories((machine / "dev" / name).parent_path());
    fs::permissions(machine.write("dev/" + name, ""), fs::perms{0600});
}

site::Configuration sounding(const std::string& device) {
    site::Configuration configuration;
    configuration.sound.is_on = true;
    configuration.sound.device = device;
    return configuration;
}

std::vector<Finding> sound_of(const tests::TemporaryFolder& machine, const std::optional<machine::Account>& exhibit,
                              const std::string& device, const std::string& handset = "") {
    site::Configuration configuration = sounding(device);
    configuration.sound.private_device = handset;
    return examine_sound(configuration, exhibit, machine / "dev");
}

const std::vector<Broken>& broken_machines() {
    static const std::vector<Broken> all{
        {"NoGraphicsCard", screen_of, Health::Doubtful, "no graphics card", "vc4-kms-v3d"},
        {"NoCardNode",
         [](const tests::TemporaryFolder& m) {
             add_connector(m, "connected", "edid");
             fs::remove(m / "dev/card0");
             return screen_of(m);
         },
         Health::Bad, "card0 is missing", "systemctl status systemd-udevd"},
        {"NothingPluggedIn",
         [](const tests::TemporaryFolder& m) {
             add_connector(m, "disconnected", "");
             return screen_of(m);
         },
         Health::Doubtful, "HDMI-A-1: nothing is plugged in", "check both ends of the cable"},
        {"NoEdid",
         [](const tests::TemporaryFolder& m) {
             add_connector(m, "connected", "");
             return screen_of(m);
         },
         Health::Doubtful, "no EDID", "screen.mode"},
        {"NoSuchLine", [](const tests::TemporaryFolder&) { return buttons_of("gpio:A=NO_SUCH_LINE"); }, Health::Bad,
         "gpio:A=NO_SUCH_LINE", "plug it in"},
        {"MisspeltInput", [](const tests::TemporaryFolder&) { return buttons_of("telepathy:"); }, Health::Bad,
         "telepathy", "buttons.inputs"},
        {"CardOfAnotherGroup",
         [](const tests::TemporaryFolder& m) {
             add_connector(m, "connected", "edid");
             add_closed_node(m, "card0");
             return examine_screen(stranger(m), m / "sys", m / "dev");
         },
         Health::Bad, "card0: no permission", "usermod -aG video quadrat"},
        {"GpuOfAnotherGroup",
         [](const tests::TemporaryFolder& m) {
             add_closed_node(m, "renderD128");
             return examine_screen(stranger(m), m / "sys", m / "dev");
         },
         Health::Bad, "renderD128", "usermod -aG render quadrat"},
        {"NoSoundCard", [](const tests::TemporaryFolder& m) { return sound_of(m, {}, "hw:CARD=NoSuchCard"); },
         Health::Doubtful, "the sound card hw:CARD=NoSuchCard cannot be opened", "aplay -L"},
        {"NoHandset", [](const tests::TemporaryFolder& m) { return sound_of(m, {}, "null", "hw:CARD=NoHandset"); },
         Health::Doubtful, "the sound card hw:CARD=NoHandset cannot be opened", "aplay -L"},
        {"SoundCardOfAnotherGroup",
         [](const tests::TemporaryFolder& m) {
             add_closed_node(m, "pcmC0D0p");
             return sound_of(m, stranger(m), "null");
         },
         Health::Bad, "sound cards' nodes: may not be used by the user quadrat", "usermod -aG audio quadrat"},
        {"LanguageWithoutAVoice",
         [](const tests::TemporaryFolder& m) {
             site::Configuration configuration = sounding("null");
             configuration.sound.speaks = true;
             configuration.visit.languages = {"en", "xh"};
             return examine_sound(configuration, {}, m / "dev");
         },
         Health::Doubtful, "espeak-ng has no voice for the language xh", "sound.speech_folder"},
        {"NoVoiceAtAll",
         [](const tests::TemporaryFolder& m) {
             site::Configuration configuration = sounding("null");
             configuration.sound.speaks = true;
             return examine_sound(configuration, {}, m / "dev", "no-such-voice");
         },
         Health::Doubtful, "no-such-voice: No such file or directory; apt install espeak-ng", "sound.speech_folder"},
        {"ServiceWithoutSound",
         [](const tests::TemporaryFolder& m) {
             staff::Vitals vitals;
             vitals.sound = {true, false, 0, 0, "the sound card default is gone"};
             return service_that_says(m, vitals);
         },
         Health::Doubtful, "its sound: the sound card default is gone", "quadrat doctor --only sound"},
        {"LinesOfAnotherGroup",
         [](const tests::TemporaryFolder& m) {
             add_closed_node(m, "gpiochip0");
             return examine_buttons({}, stranger(m), firmware_io::open_buttons, m / "dev");
         },
         Health::Bad, "GPIO chips: may not be used by the user quadrat", "usermod -aG gpio quadrat"},
        {"HidOfAnotherGroup",
         [](const tests::TemporaryFolder& m) {
             add_closed_node(m, "hidraw3");
             return examine_buttons({}, stranger(m), firmware_io::open_buttons, m / "dev");
         },
         Health::Bad, "hidraw3", "usermod -aG input quadrat"},
        {"InputDeviceOfAnotherGroup",
         [](const tests::TemporaryFolder& m) {
             add_closed_node(m, "input/event3");
             return examine_buttons({}, stranger(m), firmware_io::open_buttons, m / "dev");
         },
         Health::Bad, "event3", "usermod -aG input quadrat"},
        {"MapInSomebodysHome",
         [](const tests::TemporaryFolder& m) {
             site::Configuration configuration;
             configuration.inputs = {"hid:map=/root/.local/state/quadrat/buttons.map"};
             const auto open = [](std::string_view) {
                 return firmware_io::Opened{std::make_unique<firmware_io::MergedButtons>(
                                                std::vector<std::unique_ptr<firmware_io::ButtonSource>>{}),
                                            ""};
             };
             return examine_buttons(configuration, stranger(m), open, m / "dev");
         },
         Health::Doubtful, "the user quadrat cannot read this map", "move it to /var/lib/quadrat"},
        {"StateOfAnotherUser", [](const tests::TemporaryFolder& m) { return examine_state(m.path(), stranger(m)); },
         Health::Bad, "cannot be written", "give the exhibit's user this folder"},
        {"StateFileOfAnotherUser",
         [](const tests::TemporaryFolder& m) {
             m.write("quadrat.db", "SQLite format 3 and more");
             const machine::Account exhibit = stranger(m);
             fs::permissions(m.path(), fs::perms{0777});
             return examine_state(m.path(), exhibit);
         },
         Health::Bad, "somebody else's", "systemd-tmpfiles --create quadrat.conf"},
        {"FailedUnit",
         [](const tests::TemporaryFolder&) {
             return examine_unit(machine::UnitState{"loaded", "enabled", "failed", "exit-code"});
         },
         Health::Bad, "has failed (exit-code)", "journalctl -u quadrat"},
        {"StoppedUnit",
         [](const tests::TemporaryFolder&) {
             return examine_unit(machine::UnitState{"loaded", "enabled", "inactive", "success"});
         },
         Health::Bad, "is stopped", "systemctl start quadrat"},
        {"DisabledUnit",
         [](const tests::TemporaryFolder&) {
             return examine_unit(machine::UnitState{"loaded", "disabled", "active", "success"});
         },
         Health::Doubtful, "does not start with the machine", "systemctl enable --now quadrat"},
        {"MaskedUnit",
         [](const tests::TemporaryFolder&) {
             return examine_unit(machine::UnitState{"masked", "masked", "inactive", "success"});
         },
         Health::Bad, "is masked", "systemctl unmask quadrat"},
        {"UnitThatStartsAgainAndAgain",
         [](const tests::TemporaryFolder&) {
             return examine_unit(machine::UnitState{"loaded", "enabled", "activating", "watchdog"});
         },
         Health::Doubtful, "its last end was: watchdog", "journalctl -u quadrat"},
        {"HeldLine", [](const tests::TemporaryFolder&) { return lines_held_by("spi0 CS1"); }, Health::Bad,
         "GPIO lines GPIO17, GPIO5 are held by spi0 CS1", "stop that"},
        {"HeldByUs", [](const tests::TemporaryFolder&) { return lines_held_by("quadrat"); }, Health::Good,
         "GPIO lines A=GPIO17, lamp A=GPIO5", ""},
        {"DamagedMapOfButtons",
         [](const tests::TemporaryFolder& m) {
             const auto findings = buttons_of("hid:map=" + m.write("buttons.map", "A is the red one\n").string());
             return std::vector{findings.front()};
         },
         Health::Doubtful, "buttons.map:1", "doctor --learn-buttons"},
        {"DamagedState",
         [](const tests::TemporaryFolder& m) {
             m.write("quadrat.db", "no database any more");
             return examine_state(m.path());
         },
         Health::Doubtful, "is not a database any more", "sets it aside"},
        {"FullDisk", [](const tests::TemporaryFolder& m) { return examine_state(m.path(), 3.0); }, Health::Doubtful,
         "3 MB left", "make room"},
        {"StateBehindAFile", [](const tests::TemporaryFolder&) { return examine_state("/proc/version/state", 1000.0); },
         Health::Bad, "cannot be written", "--state"},
        {"UntrustedClock",
         [](const tests::TemporaryFolder&) {
             site::Hours hours;
             hours.is_always_open = false;
             return examine_clock(site::judge_clock(41, false, {}, "/nowhere"), hours);
         },
         Health::Doubtful, "shows the year 1970", "timedatectl set-ntp true"},
        {"BrokenSettings", [](const tests::TemporaryFolder& m) { return configured(m, "[visit]\nrounds = 900\n"); },
         Health::Bad, "quadrat.toml:2: visit.rounds is 900", "between 1 and 50"},
        {"StoppedService",
         [](const tests::TemporaryFolder& m) {
             m.write("health.json", "{}");
             fs::last_write_time(m / "health.json", fs::file_time_type::clock::now() - std::chrono::hours{1});
             return examine_service(m.path());
         },
         Health::Bad, "the exhibit has stopped", "journalctl -u quadrat"},
        {"SafeMode",
         [](const tests::TemporaryFolder& m) {
             staff::Vitals vitals;
             vitals.mode = staff::Mode::Safe;
             return service_that_says(m, vitals);
         },
         Health::Doubtful, "safe mode", "journalctl -u quadrat -p err"},
        {"SafeModeThatStaffWishFor",
         [](const tests::TemporaryFolder& m) {
             staff::Vitals vitals;
             vitals.mode = staff::Mode::Safe;
             vitals.is_safe_as_wished = true;
             return service_that_says(m, vitals);
         },
         Health::Doubtful, "safe mode, as staff wish", "rm /run/quadrat/safe-mode"},
        {"StuckButton",
         [](const tests::TemporaryFolder& m) {
             staff::Vitals vitals;
             vitals.findings = {{firmware_io::Ailment::Stuck, firmware_io::Button::C, firmware_io::Instant{0}}};
             return service_that_says(m, vitals);
         },
         Health::Doubtful, "button C is stuck", "look at the button and its cable"},
        {"UnpluggedPanel",
         [](const tests::TemporaryFolder& m) {
             staff::Vitals vitals;
             vitals.buttons = {firmware_io::Presence::Absent, "HID device was unplugged"};
             return service_that_says(m, vitals);
         },
         Health::Bad, "HID device was unplugged", "plug them in"},
        {"ThrottledMachine",
         [](const tests::TemporaryFolder& m) {
             staff::Vitals vitals;
             vitals.machine.is_throttled = true;
             return service_that_says(m, vitals);
         },
         Health::Doubtful, "heat or low voltage", "power supply"},
    };
    return all;
}

class EveryBrokenMachine : public testing::TestWithParam<Broken> {};

TEST_P(EveryBrokenMachine, HasItsCauseNamedAndItsRemedy) {
    const tests::TemporaryFolder machine;
    const auto findings = GetParam().examine(machine);
    EXPECT_EQ(worst_of(findings), GetParam().health) << report_of(findings);
    EXPECT_THAT(report_of(findings), HasSubstr(GetParam().cause));
    EXPECT_THAT(report_of(findings), HasSubstr(GetParam().remedy));
}

INSTANTIATE_TEST_SUITE_P(Doctor, EveryBrokenMachine, testing::ValuesIn(broken_machines()),
                         [](const auto& broken) { return broken.param.name; });

TEST(Doctor, HasNothingAgainstAUnitThatRunsNorAgainstAMachineWithoutOne) {
    EXPECT_EQ(worst_of(examine_unit(machine::UnitState{"loaded", "enabled", "active", "success"})), Health::Good);
    EXPECT_THAT(examine_unit(machine::UnitState{"not-found", "", "inactive", "success"}), testing::IsEmpty());
    EXPECT_THAT(examine_unit(std::nullopt), testing::IsEmpty());
}

TEST(Doctor, FindsNothingWrongWithAnExhibitThatRuns) {
    const tests::TemporaryFolder machine;
    const auto findings = service_that_says(machine, {});
    EXPECT_EQ(worst_of(findings), Health::Good) << report_of(findings);
    machine.write("health.json", "[1, 2");
    EXPECT_EQ(worst_of(examine_service(machine.path())), Health::Doubtful);
    machine.write("health.json", R"({"buttons": [], "mode": 3, "throttled": false})");
    EXPECT_EQ(worst_of(examine_service(machine.path())), Health::Good) << "another program's file harms nobody";
}

}  // namespace
}  // namespace quadrat::doctor
