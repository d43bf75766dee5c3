// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pictures/png_picture.hpp"
#include "staff/keepsakes.hpp"
#include "staff/service_screen.hpp"
#include "staff/watch.hpp"
#include "support/process.hpp"

namespace quadrat::staff {
namespace {

using namespace std::chrono_literals;
using firmware_io::Button;
using testing::HasSubstr;

Vitals ailing() {
    Vitals vitals;
    vitals.version = "1.2.3";
    vitals.machine.name = "hall-2";
    vitals.machine.addresses = {"192.0.2.7"};
    vitals.machine.temperature_c = 71.4;
    vitals.mode = Mode::Safe;
    vitals.buttons = {firmware_io::Presence::Absent, "a device that calls itself \xff\"\\"};
    vitals.findings = {{firmware_io::Ailment::Chattering, Button::B, 1s}};
    vitals.ailments[2][1] = 4;
    vitals.faults = {"10:00:00 buttons: gone"};
    vitals.free_mb = 512;
    return vitals;
}

TEST(Vitals, AreJsonWhateverADeviceCallsItself) {
    const auto json = nlohmann::json::parse(to_json(ailing()));
    EXPECT_EQ(json["verdict"], "bad");
    EXPECT_EQ(json["mode"], "safe");
    EXPECT_EQ(json["buttons"]["counts"]["chattering"]["B"], 4);
    EXPECT_EQ(json["buttons"]["findings"][0]["is"], "chattering");
    EXPECT_EQ(nlohmann::json::parse(to_json(Vitals{}))["verdict"], "good");
}

TEST(Vitals, TellTheLevelApartFromTheAlphaThatIsDrawnWith) {
    Vitals vitals;
    vitals.level = 0.12;
    vitals.alpha = 0.19;
    const auto json = nlohmann::json::parse(to_json(vitals));
    EXPECT_EQ(json["level"], 0.12);
    EXPECT_EQ(json["alpha"], 0.19);
}

TEST(Vitals, AreMetricsThatPrometheusReads) {
    std::istringstream lines{to_prometheus(ailing())};
    int samples = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("# HELP quadrat_") || line.starts_with("# TYPE quadrat_")) continue;
        EXPECT_THAT(line, testing::MatchesRegex("quadrat_[a-z_]+(\\{[a-zA-Z0-9_=\", ]+\\})? -?[0-9.e+]+"));
        ++samples;
    }
    EXPECT_GT(samples, 40);
    EXPECT_THAT(to_prometheus(ailing()),
                HasSubstr("quadrat_button_ailments_total{button=\"B\",ailment=\"chattering\"} 4"));
}

TEST(Vitals, TellOfSoundThatIsWantedAndNotHeard) {
    Vitals vitals;
    EXPECT_THAT(to_prometheus(vitals), testing::Not(HasSubstr("sound"))) << "it is off";
    vitals.sound = {true, true, 3, 0, ""};
    auto json = nlohmann::json::parse(to_json(vitals));
    EXPECT_EQ(json["verdict"], "good");
    EXPECT_EQ(json["sound"]["underruns"], 3);
    EXPECT_THAT(to_prometheus(vitals), HasSubstr("\nquadrat_sound_underruns_total 3\n"));
    ServiceScreen service;
    service.open(0s);
    EXPECT_THAT(service.board(vitals, 1s).lines, testing::Contains("sound plays · 3 gaps"));
    vitals.sound = {true, false, 3, 0, "the sound card hw:1 is gone"};
    json = nlohmann::json::parse(to_json(vitals));
    EXPECT_EQ(json["verdict"], "doubtful");
    EXPECT_EQ(json["sound"]["trouble"], "the sound card hw:1 is gone");
    EXPECT_THAT(to_prometheus(vitals), HasSubstr("\nquadrat_sound_up 0\n"));
    EXPECT_THAT(service.board(vitals, 1s).lines, testing::Contains("NO SOUND: the sound card hw:1 is gone"));
}

TEST(Vitals, TellAScreenThatIsDarkByPlanFromOneThatFailed) {
    Vitals vitals;
    EXPECT_THAT(to_prometheus(vitals), HasSubstr("\nquadrat_screen_up 1\n"));
    vitals.has_hours = true;
    vitals.curtain = site::Curtain::Dark;
    vitals.is_open = false;
    vitals.opening = "closed until 09:00";
    vitals.wall.is_trusted = true;
    vitals.wall.source = "rtc0";
    auto json = nlohmann::json::parse(to_json(vitals));
    EXPECT_EQ(json["verdict"], "good");
    EXPECT_EQ(json["screen"], "dark");
    EXPECT_EQ(json["open"], false);
    EXPECT_EQ(json["opening"], "closed until 09:00");
    EXPECT_EQ(json["clock"]["trusted"], true);
    EXPECT_EQ(json["clock"]["source"], "rtc0");
    for (const char* line : {"quadrat_screen_up 0", "quadrat_screen_failed 0", "quadrat_screen_state{state=\"dark\"} 1",
                             "quadrat_open 0", "quadrat_clock_trusted 1", "quadrat_clock_source{source=\"rtc0\"} 1"})
        EXPECT_THAT(to_prometheus(vitals), HasSubstr(std::string("\n") + line + "\n"));
    vitals.screen_trouble = "nothing is plugged in";
    json = nlohmann::json::parse(to_json(vitals));
    EXPECT_EQ(json["screen"], "failed");
    EXPECT_EQ(json["verdict"], "bad");
    EXPECT_THAT(to_prometheus(vitals), HasSubstr("\nquadrat_screen_failed 1\n"));
}

TEST(Vitals, AreDoubtfulWhereHoursWaitForAClock) {
    Vitals vitals;
    vitals.has_hours = true;
    EXPECT_EQ(verdict_of(vitals), Verdict::Doubtful);
    vitals.wall.is_trusted = true;
    EXPECT_EQ(verdict_of(vitals), Verdict::Good);
}

TEST(Vitals, AreDoubtfulAndSayWhyWhereTheSettingsCannotBeUsed) {
    Vitals vitals;
    ASSERT_EQ(verdict_of(vitals), Verdict::Good);
    vitals.settings.from = site::SettingsFrom::LastGood;
    vitals.settings.mistakes = {{"/etc/q.toml", 7, "screen.mode: \"1080p\" is not a mode", "write 1920x1080"}};
    EXPECT_EQ(verdict_of(vitals), Verdict::Doubtful);
    const auto told = nlohmann::json::parse(to_json(vitals))["settings"];
    EXPECT_EQ(told["from"], "last good");
    EXPECT_EQ(told["mistakes"][0]["line"], 7);
    EXPECT_EQ(told["mistakes"][0]["remedy"], "write 1920x1080");
    EXPECT_THAT(to_prometheus(vitals), HasSubstr("quadrat_settings_up 0\n"));
    EXPECT_THAT(to_prometheus(vitals), HasSubstr("quadrat_settings_from 1\n"));
    ServiceScreen service;
    service.open(0s);
    EXPECT_THAT(service.board(vitals, 0s).lines,
                testing::IsSupersetOf({std::string("SETTINGS: the last settings that worked are used"),
                                       std::string("/etc/q.toml, line 7: screen.mode: \"1080p\" is not a mode"),
                                       std::string("  → write 1920x1080")}));
}

// Frames that reach a screen of 16 ms at these moments, each meant to take so many periods.
FrameCount count_of(const std::vector<std::chrono::milliseconds>& shown, int meant_periods = 1) {
    FrameCount count;
    std::optional<tempo::DisplayTime> before;
    for (const auto at : shown) {
        tempo::FrameRecord record;
        record.shown = tempo::DisplayTime{at};
        record.shown_before = std::exchange(before, record.shown);
        record.period = 16ms;
        record.meant_periods = meant_periods;
        count.frame(record);
    }
    return count;
}

TEST(Vitals, CountLateFrames) {
    std::vector<std::chrono::milliseconds> shown;
    for (int i = 0; i < 120; ++i) shown.push_back(i * 16ms + (i >= 60 ? 40ms : 0ms));
    const FrameCount count = count_of(shown);
    EXPECT_EQ(count.frames, 120U);
    EXPECT_EQ(count.late, 1U);
    EXPECT_NEAR(count.longest_ms, 56, 1);
    EXPECT_NEAR(count.per_second, 60, 3);
}

TEST(Vitals, CountAFrameLateByWhatItWasMeantToTake) {
    std::vector<std::chrono::milliseconds> shown;
    for (int i = 0; i < 100; ++i) shown.push_back(i * 32ms);
    EXPECT_EQ(count_of(shown, 2).late, 0U);
    shown.push_back(99 * 32ms + 48ms);
    EXPECT_EQ(count_of(shown, 2).late, 1U) << "one refresh period more";
}

TEST(Vitals, AFrameThatIsComparedWithNoneIsNotLate) {
    FrameCount count;
    tempo::FrameRecord record;
    record.period = 16ms;
    for (int i = 0; i < 200; ++i) {
        const tempo::DisplayTime at{i * 16ms + (i >= 100 ? 24h : 0h)};
        record.shown_before = i == 0 || i == 100 ? std::nullopt : std::optional(record.shown);  // the screen was away
        record.shown = at;
        count.frame(record);
    }
    EXPECT_EQ(count.late, 0U);
    EXPECT_EQ(count.frames, 200U);
    EXPECT_NEAR(count.longest_ms, 16, 1);
}

TEST(ServiceScreen, ShowsWhatStaffAskOnTheTelephone) {
    ServiceScreen service;
    service.open(0s);
    const stage::Board board = service.board(ailing(), 1s);
    EXPECT_THAT(board.title, HasSubstr("Quadrat 1.2.3 · hall-2 · SAFE MODE"));
    std::string all;
    for (const std::string& line : board.lines) all += line + "\n";
    for (const char* what : {"address 192.0.2.7", "71 °C", "disk 512 MB", "BUTTONS MISSING", "button B is chattering",
                             "buttons: gone", "A: lamp test", "late"})
        EXPECT_THAT(all, HasSubstr(what));
}

TEST(ServiceScreen, ShowsTheTimeItsZoneWhoVouchesForItAndUntilWhenItIsOpen) {
    Vitals vitals = ailing();
    vitals.wall = {std::chrono::year_month_day{std::chrono::year{2026}, std::chrono::month{11}, std::chrono::day{26}},
                   755,
                   true,
                   "Europe/Berlin (CET, UTC+01:00)",
                   "rtc0",
                   {},
                   {}};
    vitals.opening = "open until 18:00";
    ServiceScreen service;
    EXPECT_THAT(service.board(vitals, 1s).lines,
                testing::IsSupersetOf({"2026-11-26 12:35 Europe/Berlin (CET, UTC+01:00) · rtc0", "open until 18:00"}));
    vitals.wall.is_trusted = false;
    vitals.wall.doubt = "rtc0 shows 1970";
    EXPECT_THAT(service.board(vitals, 1s).lines,
                testing::IsSupersetOf({"2026-11-26 12:35 Europe/Berlin (CET, UTC+01:00) · clock NOT TRUSTED",
                                       "open until 18:00 · rtc0 shows 1970"}));
}

TEST(ServiceScreen, ItsFiguresLieInACornerOfThePicture) {
    Vitals vitals = ailing();
    vitals.triangles = 123'456;
    vitals.level = 0.12;
    vitals.alpha = 0.19;
    vitals.scale = 0.75;
    vitals.draws = 210;
    const stage::Board board = figures_board(vitals, false);
    EXPECT_EQ(board.cover, stage::Board::Cover::Strip);
    EXPECT_FALSE(board.has_wires);
    EXPECT_TRUE(figures_board(vitals, true).has_wires);
    ASSERT_FALSE(board.lines.empty());
    EXPECT_THAT(board.lines.front(), HasSubstr("detail 0.12 (α 0.19) · "));
    EXPECT_THAT(board.lines.front(), HasSubstr("123 thousand triangles in 210 draws · views at 75 %"));
}

TEST(ServiceScreen, RestartsAndShutsDownOnlyWhenAskedTwice) {
    ServiceScreen service;
    service.open(0s);
    EXPECT_EQ(service.press(Button::D, 1s), std::nullopt);
    EXPECT_EQ(service.press(Button::B, 2s), std::nullopt) << "another button is no confirmation";
    EXPECT_EQ(service.press(Button::B, 8s), std::nullopt) << "too late";
    EXPECT_EQ(service.press(Button::B, 9s), StaffWish::Restart);
    EXPECT_EQ(service.press(Button::D, 10s), std::nullopt);
    EXPECT_EQ(service.press(Button::D, 11s), StaffWish::ShutDown);
    EXPECT_EQ(service.press(Button::C, 12s), StaffWish::Picture);
}

TEST(ServiceScreen, TestsEachLampAndLeavesByBackOrByItself) {
    ServiceScreen service;
    EXPECT_FALSE(service.is_open(0s));
    service.open(0s);
    service.press(Button::A, 1s);
    std::set<std::size_t> lit;
    for (std::chrono::milliseconds now = 1s; now < 10s; now += 300ms)
        for (std::size_t i = 0; i < 5; ++i)
            if (service.lamps(now + 100ms)[i] != firmware_io::LampPattern::Off) lit.insert(i);
    EXPECT_EQ(lit.size(), 5U);
    service.press(Button::Back, 11s);
    EXPECT_FALSE(service.is_open(11s));
    service.open(20s);
    EXPECT_TRUE(service.is_open(139s));
    EXPECT_FALSE(service.is_open(140s));
}

// A file of settings that others write, and who watches it.
class AWatchedFile : public testing::Test {
  protected:
    static constexpr const char* kHeld = "[visit]\nrounds = 3\n";
    // The second look after a change, as nobody is still writing then.
    Seen look_twice() {
        watch_.look();
        return watch_.look();
    }
    std::string mistake_of(const Seen& seen) {
        if (!seen.settings || seen.settings->checked.is_usable()) return "";
        return to_text(seen.settings->checked.mistakes.front());
    }
    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.write("quadrat.toml", kHeld);
    Watch watch_{file_, kHeld, folder_.path(), folder_.path()};
};

TEST_F(AWatchedFile, IsToldOfOnceWhenItChangesAndWhenItCannotBeUsed) {
    EXPECT_FALSE(look_twice().settings.has_value()) << "as it was";
    folder_.write("quadrat.toml", "[visit]\nrounds = 4\n");
    EXPECT_FALSE(watch_.look().settings.has_value()) << "who saves it may not be through";
    Seen seen = watch_.look();
    ASSERT_TRUE(seen.settings.has_value());
    EXPECT_EQ(seen.settings->checked.configuration.visit.rounds, 4);
    EXPECT_EQ(seen.settings->toml, "[visit]\nrounds = 4\n");
    EXPECT_FALSE(look_twice().settings.has_value());
    folder_.write("quadrat.toml", "[visit]\nrounds = 400\n");
    EXPECT_THAT(mistake_of(look_twice()), HasSubstr("quadrat.toml:2: visit.rounds is 400"));
    EXPECT_FALSE(look_twice().settings.has_value()) << "once";
}

TEST_F(AWatchedFile, ThatIsEmptiedOrGoneIsAMistakeAndIsFineWhenItIsBack) {
    folder_.write("quadrat.toml", "");
    EXPECT_THAT(mistake_of(look_twice()), HasSubstr("empty"));
    folder_.write("quadrat.toml", "[visit]\nround");
    EXPECT_THAT(mistake_of(look_twice()), HasSubstr("quadrat.toml:2: "));
    std::filesystem::remove(file_);
    EXPECT_THAT(mistake_of(look_twice()), HasSubstr("quadrat.toml: cannot read"));
    EXPECT_FALSE(look_twice().settings.has_value()) << "once";
    folder_.write("quadrat.toml", kHeld);
    const Seen seen = look_twice();
    ASSERT_TRUE(seen.settings.has_value());
    EXPECT_TRUE(seen.settings->checked.is_usable());
}

TEST_F(AWatchedFile, BesideIsWatchedForRequestsAndRoom) {
    folder_.write(kPictureAsked, "");
    EXPECT_TRUE(watch_.look().is_picture_asked);
    EXPECT_GT(watch_.look().machine.memory_mb, 1);
    EXPECT_GT(watch_.look().free_mb.value_or(0), 1);
}

TEST(Watch, AppliesAtOnceWhatARunningExhibitMayChangeAndNamesTheRest) {
    site::Configuration running, changed;
    changed.visit.patience_s = 60;
    changed.texts["attract"] = "Los!";
    changed.picture.samples = 1;
    changed.hours.is_always_open = false;
    EXPECT_EQ(apply(changed, running), "");
    EXPECT_EQ(running.visit.patience_s, 60);
    EXPECT_EQ(site::text(running, "attract"), "Los!");
    EXPECT_EQ(running.picture.samples, 1);
    EXPECT_FALSE(running.hours.is_always_open);
    changed.sound.level = 0.2;
    EXPECT_EQ(apply(changed, running), "");
    EXPECT_EQ(running.sound.level, 0.2);
    changed.sound.device = "hw:1";
    EXPECT_EQ(apply(changed, running), "sound");
    EXPECT_EQ(running.sound.device, "default") << "until it is started anew";
    changed.sound.device = "default";
    changed.screen.mode = "1280x720";
    changed.inputs = {"hid:"};
    EXPECT_EQ(apply(changed, running), "screen, buttons.inputs");
    changed.fleet.broker = "mqtts://broker.example:8883";
    EXPECT_EQ(apply(changed, running), "screen, buttons.inputs, fleet (systemctl restart quadrat-fleet)");
    EXPECT_EQ(running.screen.mode, "");
}

TEST(Machine, TellsAPiThatIsThrottledAndTheWarmestSensor) {
    const tests::TemporaryFolder sys;
    std::filesystem::create_directories(sys / "devices/platform/soc/soc:firmware");
    std::filesystem::create_directories(sys / "class/thermal/thermal_zone0");
    std::filesystem::create_directories(sys / "class/thermal/thermal_zone1");
    sys.write("devices/platform/soc/soc:firmware/get_throttled", "50005\n");
    sys.write("class/thermal/thermal_zone0/temp", "48000\n");
    sys.write("class/thermal/thermal_zone1/temp", "61500\n");
    machine::MachineFacts facts = machine::read_machine(sys.path());
    EXPECT_EQ(facts.is_throttled, true);
    EXPECT_EQ(facts.temperature_c, 61.5);
    sys.write("devices/platform/soc/soc:firmware/get_throttled", "50000\n");
    EXPECT_EQ(machine::read_machine(sys.path()).is_throttled, false) << "it was once, and is not now";
    EXPECT_FALSE(machine::read_machine("/nowhere", "/nowhere").temperature_c.has_value());
}

TEST(Machine, FindsTheFirmwareOfAPi5AndElseItsVoltage) {
    const tests::TemporaryFolder sys;
    EXPECT_EQ(machine::read_machine(sys.path()).is_throttled, std::nullopt) << "nobody answered";
    std::filesystem::create_directories(sys / "class/hwmon/hwmon0");
    std::filesystem::create_directories(sys / "class/hwmon/hwmon1");
    sys.write("class/hwmon/hwmon0/name", "cpu_thermal\n");
    sys.write("class/hwmon/hwmon0/in0_lcrit_alarm", "1\n");
    EXPECT_EQ(machine::read_machine(sys.path()).is_throttled, std::nullopt) << "another sensor's alarm";
    sys.write("class/hwmon/hwmon1/name", "rpi_volt\n");
    sys.write("class/hwmon/hwmon1/in0_lcrit_alarm", "1\n");
    EXPECT_EQ(machine::read_machine(sys.path()).is_throttled, true);
    sys.write("class/hwmon/hwmon1/in0_lcrit_alarm", "0\n");
    EXPECT_EQ(machine::read_machine(sys.path()).is_throttled, false);
    const std::string firmware = "devices/platform/soc@107c000000/soc@107c000000:firmware";
    std::filesystem::create_directories(sys / firmware);
    sys.write(firmware + "/get_throttled", "4\n");
    EXPECT_EQ(machine::read_machine(sys.path()).is_throttled, true) << "the firmware knows more than the voltage";
}

TEST(ServiceScreen, SaysWhetherThrottlingIsKnown) {
    const auto lines_of = [](std::optional<bool> is_throttled) {
        Vitals vitals;
        vitals.machine.is_throttled = is_throttled;
        ServiceScreen service;
        service.open(0s);
        return service.board(vitals, 1s).lines;
    };
    EXPECT_THAT(lines_of(std::nullopt), testing::Contains(HasSubstr("throttling not known")));
    EXPECT_THAT(lines_of(false), testing::Contains(HasSubstr("not throttled")));
    EXPECT_THAT(lines_of(true), testing::Contains(HasSubstr("THROTTLED")));
    EXPECT_FALSE(nlohmann::json::parse(to_json(Vitals{})).contains("throttled"));
    EXPECT_THAT(to_prometheus(Vitals{}), testing::Not(HasSubstr("quadrat_throttled")));
}

TEST(Keepsakes, AreFewAndSeldomAndTheOldestGoes) {
    const tests::TemporaryFolder state;
    mesh::Image picture(8, 6, 4);
    std::fill(picture.bytes.begin(), picture.bytes.end(), std::uint8_t{100});
    EXPECT_EQ(Keepsakes(state.path()).at(0s), nullptr);
    std::filesystem::create_directory(state / "earlier");
    for (int i = 0; i < 5; ++i) {
        Keepsakes keepsakes(state.path());
        EXPECT_TRUE(keepsakes.wants_another(1s));
        const auto file = keepsakes.keep(1s);
        EXPECT_FALSE(keepsakes.wants_another(2h));
        EXPECT_TRUE(keepsakes.wants_another(4h));
        pictures::write_png_quickly(file, halved(picture));
        std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds{i});
    }
    const Keepsakes keepsakes(state.path());
    ASSERT_NE(keepsakes.at(0s), nullptr);
    EXPECT_EQ(keepsakes.at(0s)->width, 4);
    EXPECT_EQ(keepsakes.at(0s)->pixel(0, 0)[0], 100);
    EXPECT_NE(keepsakes.at(0s), keepsakes.at(30s));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(state / "earlier"), {}), 3);
}

}  // namespace
}  // namespace quadrat::staff
