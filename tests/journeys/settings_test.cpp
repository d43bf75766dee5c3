// SPDX-License-Identifier: Apache-2.0
// The site's settings, right and wrong, as the commands take them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
using testing::Each;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> start_of(const std::string& command) {
    if (command == "publish") return program({command, "--config", "site.toml", "--state", "state", "--runtime", "."});
    return program({command, "--config", "site.toml", "--state", "state", "--display", "headless", "--size", "160x90",
                    "--rounds", "1"});
}

Ended examined(const TemporaryFolder& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"doctor", "--config", "site.toml", "--state", "state", "--only", "settings"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(program(arguments), folder);
}

// Settings with one mistake that no command may pass over.
struct Wrong {
    const char* name;
    std::string toml;
    const char* said;
};
void PrintTo(const Wrong& wrong, std::ostream* os) { *os << wrong.name; }

class WrongSettings : public testing::TestWithParam<Wrong> {};

TEST_P(WrongSettings, AreBadForTheDoctorAndRefusedByWhoeverStartsWithThem) {
    const TemporaryFolder folder;
    folder.write("site.toml", GetParam().toml);
    const Ended doctor = examined(folder);
    EXPECT_EQ(doctor.status, 4) << doctor.out;
    EXPECT_THAT(doctor.out, HasSubstr(GetParam().said));
    for (const char* command : {"run", "publish"}) {
        const Ended ended = run(start_of(command), folder);
        EXPECT_EQ(ended.status, 2) << command << ended.err;
        EXPECT_THAT(lines_of(ended.err), Each(StartsWith("quadrat: site.toml"))) << command;
        EXPECT_THAT(ended.err, HasSubstr(GetParam().said)) << command;
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, WrongSettings,
                         testing::Values(Wrong{"Empty", "", "is empty"}, Wrong{"Blank", "\n \n", "is empty"},
                                         Wrong{"Size", "[screen]\nsize = \"1920*1080\"\n", "screen.size"},
                                         Wrong{"Mode", "[screen]\nmode = \"1080p\"\n", "screen.mode"},
                                         Wrong{"Input", "[buttons]\ninputs = [\"usb:\"]\n", "buttons.inputs"},
                                         Wrong{"Broker", "[fleet]\nbroker = \"broker.example\"\n", "fleet.broker"},
                                         Wrong{"Name", "[fleet]\nbroker = \"mqtt://broker\"\nname = \"hall/2\"\n",
                                               "fleet.name"},
                                         Wrong{"Pace", "[play]\npace_s = 20\n", "play.pace_s"},
                                         Wrong{"Hold", "[play]\nhold_s = 0.2\n", "play.hold_s"},
                                         Wrong{"TakeHome", "[take_home]\nurl = \"museum.example\"\n", "take_home.url"},
                                         Wrong{"Text", "[text]\nsize = \"huge\"\n", "text.size"},
                                         Wrong{"Letters", "[text]\nattract = \"\\U000F0000\"\n", "text.attract"},
                                         Wrong{"Quotes", "[text]\nask.trees = \"Which?\"\n", "\"ask.trees\""}),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

TEST(Settings, AllMistakesAreListedAtOnceByEveryCommand) {
    const TemporaryFolder folder;
    folder.write("site.toml",
                 "[screen]\nmode = \"1080p\"\n[visit]\nrounds = 900\nlanguage = de\n[fleet]\nname = \"a/b\"\n");
    const std::vector<std::string> expected{"site.toml:2: screen.mode", "site.toml:4: visit.rounds",
                                            "site.toml:5: ", "site.toml:7: fleet.name"};
    const Ended doctor = examined(folder);
    EXPECT_EQ(count_of(doctor.out, "BAD "), expected.size()) << doctor.out;
    for (const std::string& mistake : expected) EXPECT_THAT(doctor.out, HasSubstr(mistake));
    for (const char* command : {"run", "publish"}) {
        const Ended ended = run(start_of(command), folder);
        EXPECT_EQ(ended.status, 2) << command;
        const auto lines = lines_of(ended.err);
        ASSERT_EQ(lines.size(), expected.size()) << command << ended.err;
        for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_THAT(lines[i], StartsWith("quadrat: " + expected[i]));
    }
}

TEST(Settings, TheDoctorTellsOtherProgramsWhatItFinds) {
    const TemporaryFolder folder;
    folder.write("site.toml", "[visit]\nrounds = 900\nturns = 6\n");
    const Ended bad = examined(folder, {"--json"});
    EXPECT_EQ(bad.status, 4);
    const auto told = nlohmann::json::parse(bad.out);
    EXPECT_EQ(told["verdict"], "bad");
    ASSERT_EQ(told["findings"].size(), 2U) << bad.out;
    const auto& first = told["findings"][0];
    EXPECT_EQ(first["part"], "settings");
    EXPECT_EQ(first["verdict"], "bad");
    EXPECT_EQ(first["file"], "site.toml");
    EXPECT_EQ(first["line"], 2);
    EXPECT_THAT(first["what"].get<std::string>(), HasSubstr("visit.rounds is 900"));
    EXPECT_THAT(first["remedy"].get<std::string>(), HasSubstr("between 1 and 50"));
    EXPECT_EQ(told["findings"][1]["line"], 3);

    folder.write("site.toml", "# the defaults\n");
    const Ended good = examined(folder, {"--json", "--only", "state"});
    EXPECT_EQ(good.status, 0) << good.out;
    EXPECT_EQ(nlohmann::json::parse(good.out)["verdict"], "good");
    const Ended all = run(program({"doctor", "--json", "--state", "state"}), folder);
    for (const auto& finding : nlohmann::json::parse(all.out)["findings"])
        for (const char* key : {"part", "verdict", "what", "remedy", "file", "line"})
            EXPECT_TRUE(finding.contains(key)) << key << finding;
}

TEST(Settings, WhatIsWrongWithEveryLineIsSaidOnce) {
    const TemporaryFolder folder;
    folder.write("site.toml", "[buttons]\ninputs = [\"gpio:A=NO_LINE_1,B=NO_LINE_2,lampA=NO_LINE_3\"]\n");
    const Ended doctor =
        run(program({"doctor", "--config", "site.toml", "--state", "state", "--only", "buttons"}), folder);
    EXPECT_EQ(doctor.status, 4);
    EXPECT_THAT(doctor.out, HasSubstr("GPIO lines NO_LINE_1, NO_LINE_2, NO_LINE_3"));
}

}  // namespace
