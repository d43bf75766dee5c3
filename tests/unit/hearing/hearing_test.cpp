// SPDX-License-Identifier: Apache-2.0
#include "hearing/hearing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "support/process.hpp"

namespace quadrat::hearing {
namespace {

using namespace std::chrono_literals;
using exhibit::Choice;
using exhibit::Screen;
using sound::Signal;
using testing::HasSubstr;
using Passes = Hearing::Passes;

template <typename IsThere>
bool comes(const IsThere& is_there) {
    const auto until = std::chrono::steady_clock::now() + 20s;
    while (!is_there() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(2ms);
    return is_there();
}

site::Configuration speaking() {
    site::Configuration configuration;
    configuration.sound.is_on = true;
    configuration.sound.speaks = true;
    configuration.sound.device = "null";
    return configuration;
}

TEST(AHearing, ThatIsOffOpensNothingAndLeavesBackAsItIs) {
    site::Configuration configuration;
    configuration.sound.speaks = true;
    configuration.sound.device = "hw:CARD=NoSuchCard";
    Hearing hearing(configuration, base::Seed{1}, Aloud::Played);
    EXPECT_FALSE(hearing.is_on() || hearing.speaks());
    EXPECT_EQ(hearing.health(), Health{});
    EXPECT_EQ(hearing.hear_back(true, 1s), Passes::AsItIs);
    EXPECT_FALSE(hearing.next_deadline(1s));
    hearing.be_silent(1s);
}

TEST(AHearing, KeepsBackUntilItKnowsWhatItMeans) {
    const site::Configuration configuration = speaking();
    Hearing hearing(configuration, base::Seed{1}, Aloud::Told);
    exhibit::State visit;
    visit.screen = Screen::Ask;
    visit.since = 10s;
    const auto look = [&](base::Instant now) {
        hearing.look({visit, now, "en", "ask.trees"}, {}, 1);
        return hearing.is_speaking(now);
    };
    EXPECT_TRUE(look(10s));
    EXPECT_EQ(hearing.hear_back(true, 11s), Passes::Nothing);
    EXPECT_EQ(hearing.hear_back(false, 11'300ms), Passes::WholePress);
    EXPECT_EQ(hearing.hear_back(true, 12s), Passes::Nothing);
    EXPECT_EQ(hearing.next_deadline(12s), base::Instant(13s));
    EXPECT_FALSE(look(13s)) << "held while it speaks: it is silent";
    EXPECT_EQ(hearing.hear_back(false, 13'200ms), Passes::Nothing);
    EXPECT_EQ(hearing.hear_back(true, 20s), Passes::Nothing);
    EXPECT_TRUE(look(21s)) << "held while it is silent: it says everything again";
    EXPECT_EQ(hearing.hear_back(false, 21'200ms), Passes::Nothing);
    EXPECT_EQ(hearing.hear_back(false, 21'300ms), Passes::AsItIs) << "of a press that was never kept back";
    hearing.be_silent(22s);
    EXPECT_FALSE(hearing.is_speaking(22s));
}

TEST(AHearing, SaysNothingWhereOnlySignalsAreWanted) {
    site::Configuration configuration = speaking();
    configuration.sound.speaks = false;
    Hearing hearing(configuration, base::Seed{1}, Aloud::Told);
    exhibit::State visit;
    visit.screen = Screen::Ask;
    visit.since = 10s;
    hearing.look({visit, 10s, "en", "ask.trees"}, {}, 1);
    EXPECT_FALSE(hearing.is_speaking(10s));
    EXPECT_EQ(hearing.hear_back(true, 11s), Passes::AsItIs);
}

TEST(AConcert, TellsHowItIsOnEveryCardThatTheSiteNames) {
    site::Configuration configuration = speaking();
    {
        const Concert concert(configuration.sound, base::Seed{1});
        EXPECT_TRUE(comes([&] { return concert.health().is_playing; }));
        EXPECT_EQ(concert.health().trouble, "");
        EXPECT_TRUE(concert.health().is_wanted);
    }
    configuration.sound.private_device = "hw:CARD=NoHandset";
    const Concert concert(configuration.sound, base::Seed{1});
    EXPECT_TRUE(comes([&] { return !concert.health().trouble.empty(); }));
    EXPECT_THAT(concert.health().trouble, HasSubstr("hw:CARD=NoHandset cannot be opened"));
    EXPECT_FALSE(concert.health().is_playing);
}

// What its card was given until the concert ended: the loudest of each.
struct Heard {
    float room = 0, handset = 0;
};
float loudest_in(const std::filesystem::path& file) {
    const std::string bytes = tests::contents_of(file);
    float loudest = 0;
    for (std::size_t at = 44; at + 1 < bytes.size(); at += 2) {
        const auto value = static_cast<std::int16_t>(static_cast<unsigned char>(bytes[at]) |
                                                     static_cast<unsigned char>(bytes[at + 1]) << 8U);
        loudest = std::max(loudest, std::abs(static_cast<float>(value)) / 32'768.0F);
    }
    return loudest;
}
template <typename Play>
Heard heard(const site::Configuration::Sound& settings, const tests::TemporaryFolder& folder, const Play& play) {
    site::Configuration::Sound own = settings;
    const auto card = [&](const std::string& name) { return "file:\"" + (folder / name).string() + "\",wav"; };
    own.device = card("room.wav");
    if (!own.private_device.empty()) own.private_device = card("handset.wav");
    {
        Concert concert(own, base::Seed{1});
        EXPECT_TRUE(comes([&] { return concert.health().is_playing; }));
        play(concert);
    }
    return {loudest_in(folder / "room.wav"), own.private_device.empty() ? 0 : loudest_in(folder / "handset.wav")};
}

// A recording of two seconds of a loud tone, so that nothing hangs on a voice.
void record(const tests::TemporaryFolder& folder, site::Configuration::Sound& sound) {
    std::filesystem::create_directories(folder / "en");
    std::string data;
    for (int i = 0; i < 96'000; ++i) data += (i / 50) % 2 == 0 ? std::string("\xFF\x7F") : std::string("\x01\x80");
    std::string wav("RIFF\0\0\0\0WAVEfmt \x10\0\0\0\x01\0\x01\0\x80\xBB\0\0\0\x77\x01\0\x02\0\x10\0data", 40);
    const auto bytes = static_cast<std::uint32_t>(data.size());
    for (int i = 0; i < 4; ++i) wav += static_cast<char>(bytes >> (8 * i) & 0xFFU);
    folder.write("en/ask.trees.wav", wav + data);
    sound.speech_folder = folder.path().string();
}

TEST(AConcert, SpeaksOnTheHandsetAloneWhereThereIsOne) {
    const tests::TemporaryFolder folder;
    site::Configuration::Sound sound = speaking().sound;
    record(folder, sound);
    const Says question{{"en", "ask.trees", "Which?"}, std::nullopt};
    const auto ask = [&](Concert& concert) {
        concert.play({question});
        const std::filesystem::path file = folder / (sound.private_device.empty() ? "room.wav" : "handset.wav");
        EXPECT_TRUE(comes([&] { return std::filesystem::file_size(file) > 200'000; }));
    };
    const Heard alone = heard(sound, folder, ask);
    EXPECT_GT(alone.room, 0.35F);
    EXPECT_LE(alone.room, 0.51F) << "its level is the most that is ever heard";
    sound.private_device = "yes";
    sound.private_level = 0.8;
    const Heard both = heard(sound, folder, ask);
    EXPECT_EQ(both.room, 0);
    EXPECT_GT(both.handset, 0.6F);
    EXPECT_LE(both.handset, 0.81F);
}

TEST(AConcert, IsLouderForOneVisitAndGoesRoundFromTheLoudest) {
    const tests::TemporaryFolder folder;
    site::Configuration::Sound sound = speaking().sound;
    record(folder, sound);
    const Says question{{"en", "ask.trees", "Which?"}, std::nullopt};
    const auto after = [&](int times, bool ends) {
        return heard(sound, folder, [&](Concert& concert) {
            for (int i = 0; i < times; ++i) concert.louder();
            if (ends) concert.end_visit();
            // What was loud before has gone down by then.
            EXPECT_TRUE(comes([&] { return std::filesystem::file_size(folder / "room.wav") > 100'000; }));
            concert.play({question});
            EXPECT_TRUE(comes([&] { return std::filesystem::file_size(folder / "room.wav") > 400'000; }));
        });
    };
    EXPECT_NEAR(after(1, false).room, 0.75F * 0.9F, 0.1F);
    EXPECT_NEAR(after(3, false).room, 0.25F * 0.9F, 0.1F);
    EXPECT_NEAR(after(1, true).room, 0.5F * 0.9F, 0.1F);
}

TEST(AConcert, SaysNothingThatWasHushedAndNamesWhatCannotBeSaid) {
    const tests::TemporaryFolder folder;
    site::Configuration::Sound sound = speaking().sound;
    record(folder, sound);
    const Heard hushed = heard(sound, folder, [&](Concert& concert) {
        concert.play({Says{{"en", "ask.trees", "Which?"}, std::nullopt}, Hushes{}});
        concert.play({Says{{"tlh", "ask.sky", "nuq"}, std::nullopt}});
        EXPECT_TRUE(comes([&] { return !concert.health().trouble.empty(); }));
        EXPECT_THAT(concert.health().trouble, HasSubstr("for the language tlh"));
        EXPECT_TRUE(concert.health().is_playing);
    });
    EXPECT_EQ(hushed.room, 0);
}

}  // namespace
}  // namespace quadrat::hearing
