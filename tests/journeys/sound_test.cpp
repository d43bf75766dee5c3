// SPDX-License-Identifier: Apache-2.0
// What is heard of a visit. On a simulated clock nobody can listen: the log tells what would be heard.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <utility>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;

constexpr const char* kShort =
    "[picture]\nland_samples = 65\n[visit]\nrounds = 1\ndescribe_every = 1\nfamily = false\n";

std::vector<std::string> play_words(const std::string& speed) {
    std::vector<std::string> words{"run",       "--config", "site.toml",
                                   "--display", "headless", "--size",
                                   "320x180",   "--input",  "script:visit.script",
                                   "--state",   "state",    "--seed",
                                   "7",         "--rounds", "1"};
    if (!speed.empty()) words.insert(words.end(), {"--speed", speed});
    return program(words);
}

Ended play(const TemporaryFolder& folder, const std::string& settings, const std::string& script,
           const std::string& speed = "") {
    folder.write("site.toml", kShort + settings);
    folder.write("visit.script", script);
    return run(play_words(speed), folder);
}

// What was heard, in order: "says (en): …", "sounds: …".
std::vector<std::string> heard(const std::string& log) {
    static const std::regex line(R"( info ((?:says|sounds)[^\n]*))");
    std::vector<std::string> lines;
    for (std::sregex_iterator it(log.begin(), log.end(), line), end; it != end; ++it) lines.push_back((*it)[1]);
    return lines;
}

// A press a second after the words begin that it waits for is what somebody does who sees nothing.
TEST(OneSwitchAndSoundAlone, LeadThroughTheWholeVisit) {
    const TemporaryFolder folder;
    const Ended ended = play(folder,
                             "describe_words = 1\n[play]\nbuttons = \"one\"\npace_s = 1\n"
                             "[sound]\non = true\nspeech = true\n",
                             "at 2s press D\nat 12s press D\nwait 12s\npress D\nwait 20s\npress D\nwait 25s\npress "
                             "D\nwait 20s\npress D\n");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("the visit ends with its finale, after 1 rounds"));
    EXPECT_THAT(ended.err, HasSubstr("it was called"));
    const std::vector<std::string> lines = heard(ended.err);
    ASSERT_GT(lines.size(), 30U) << ended.err;
    EXPECT_THAT(std::vector(lines.begin(), lines.begin() + 5),
                testing::ElementsAre("sounds: press D", "says (en): Which has the best trees?",
                                     "says (en): Press any button when the frame is on yours", "sounds: mark A",
                                     testing::StartsWith("says (en): A: ")));
    for (const char* what : {"says (en): Which has the best land?", "says (en): Which has the best sky?",
                             "says (en): B: ", "says (en): C: ", "sounds: choice", "sounds: finale",
                             "says (en): This is the landscape you bred", "says (en): Which words suit"})
        EXPECT_THAT(lines, testing::Contains(HasSubstr(what)));
    EXPECT_THAT(ended.err, HasSubstr("surrounds: ")) << "the landscape that is marked";
    EXPECT_EQ(count_of(ended.err, "sound card"), 0U) << "nothing is opened where nobody can listen";
}

TEST(Back, HeldWhereTheExhibitSpeaksSaysItAgainAndPressedGoesBack) {
    const TemporaryFolder folder;
    const Ended ended =
        play(folder, "describe_words = 0\nlanguages = [\"en\", \"de\"]\n[sound]\non = true\nspeech = true\n",
             "at 2s press D\nwait 8s\npress B\nwait 30s\nhold Back for 3s\nwait 30s\npress B\nwait 2s\n"
             "press Back\nwait 2s\npress A\nwait 2s\npress A\nwait 2s\npress A\n");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("the visit ends with its finale"));
    const std::vector<std::string> lines = heard(ended.err);
    EXPECT_THAT(lines, testing::IsSupersetOf({"says (en): Which language?", "says (de): B: Deutsch",
                                              "says (de): Zurück gedrückt halten, um es noch einmal zu hören"}));
    EXPECT_EQ(std::ranges::count(lines, "says (de): Wo sind die schönsten Bäume?"), 3)
        << "asked, said again, and gone back to";
    EXPECT_EQ(std::ranges::count(lines, "sounds: louder"), 1);
    EXPECT_EQ(std::ranges::count(lines, "sounds: back"), 1);
    EXPECT_EQ(count_of(ended.err, "still there"), 0U) << "nobody is asked that while they are told something";
}

TEST(Back, IsAnyButtonWhereAnyButtonWillDo) {
    const TemporaryFolder folder;
    const Ended ended = play(folder, "describe_words = 0\n[sound]\non = true\nspeech = true\n",
                             "at 2s press Back\nwait 45s\npress Back\nwait 20s\npress A\nwait 2s\npress A\nwait 2s\n"
                             "press A\n");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("the visit ends with its finale"));
    const std::vector<std::string> lines = heard(ended.err);
    EXPECT_EQ(std::ranges::count(lines, "sounds: still there"), 1);
    EXPECT_EQ(std::ranges::count(lines, "says (en): Which has the best trees?"), 2);
}

TEST(ASoundCardThatIsMissing, CostsNoVisitAndIsSaidOnce) {
    const TemporaryFolder folder;
    const Ended ended = play(folder,
                             "describe_words = 0\nfinale_s = 5\n[sound]\non = true\nspeech = true\ndevice = "
                             "\"hw:CARD=NoSuchCard\"\n",
                             "at 8s press D\nwait 3s\npress A\nwait 3s\npress A\nwait 3s\npress A\n", "2");
    ASSERT_TRUE(succeeds(ended));
    EXPECT_THAT(ended.err, HasSubstr("the visit ends with its finale"));
    EXPECT_EQ(count_of(ended.err, "the sound card hw:CARD=NoSuchCard cannot be opened"), 1U) << ended.err;
    const Ended looked = run(program({"doctor", "--only", "sound", "--config", "site.toml"}), folder);
    EXPECT_EQ(looked.status, 3) << looked.out;
    EXPECT_THAT(looked.out, HasSubstr("the sound card hw:CARD=NoSuchCard cannot be opened"));
}

// The card is a file: what is in it was heard.
TEST(AVisitThatIsHeard, SpeaksAndSoundsUnderItsLevel) {
    const TemporaryFolder folder;
    const std::string card = (folder / "card.wav").string();
    const Ended ended = play(folder,
                             "describe_words = 0\nfinale_s = 5\n[sound]\non = true\nspeech = true\nlevel = 0.4\ndevice "
                             "= 'file:\"" +
                                 card + "\",wav'\n",
                             "at 8s press D\nwait 6s\npress A\nwait 6s\npress A\nwait 6s\npress A\n", "1.5");
    ASSERT_TRUE(succeeds(ended));
    const std::string bytes = contents_of(card);
    ASSERT_GT(bytes.size(), 1'000'000U) << ended.err;
    int loudest = 0;
    std::vector<double> each_tenth;
    double sum = 0;
    std::size_t samples = 0;
    for (std::size_t at = 44; at + 1 < bytes.size(); at += 2) {
        const auto value = static_cast<std::int16_t>(static_cast<unsigned char>(bytes[at]) |
                                                     static_cast<unsigned char>(bytes[at + 1]) << 8U);
        loudest = std::max(loudest, std::abs(static_cast<int>(value)));
        sum += static_cast<double>(value) * value;
        if (++samples % 9'600 == 0) each_tenth.push_back(std::sqrt(std::exchange(sum, 0) / 9'600) / 32'768);
    }
    EXPECT_LE(loudest, 32'768 * 0.401);
    EXPECT_GT(loudest, 32'768 * 0.1);
    const auto spoken = std::ranges::count_if(each_tenth, [](double loud) { return loud > 0.03; });
    EXPECT_GT(spoken, 30) << "three seconds and more of speech, louder than any landscape";
    EXPECT_LT(spoken, std::ssize(each_tenth));
}

TEST(TheSoundOfAScene, IsWrittenTheSameEachTimeAndMeasured) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"sound", "seed:7", "-o", "a.wav", "--seconds", "3"}), folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, testing::ContainsRegex("^(wind|leaves|nothing)[^\n]*\n3.0 s, peak -[0-9.]+ dBFS, mean -"));
    ASSERT_EQ(run(program({"sound", "seed:7", "-o", "b.wav", "--seconds", "3"}), folder).status, 0);
    EXPECT_EQ(contents_of(folder / "a.wav"), contents_of(folder / "b.wav"));
    EXPECT_EQ(std::filesystem::file_size(folder / "a.wav"), 44U + 3 * 48'000 * 4);
    EXPECT_EQ(run(program({"sound", "seed:7", "-o", "a.ogg"}), folder).status, 2);
    EXPECT_EQ(run(program({"sound", "seed:7", "-o", "a.wav", "--seconds", "0"}), folder).status, 2);
}

}  // namespace
