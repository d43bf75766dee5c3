// SPDX-License-Identifier: Apache-2.0
#include "sound/speaker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "sound/wav.hpp"
#include "support/process.hpp"

namespace quadrat::sound {
namespace {

using testing::HasSubstr;

std::vector<Frame> tone(int frames, float gain) {
    std::vector<Frame> made(static_cast<std::size_t>(frames));
    for (std::size_t i = 0; i < made.size(); ++i) {
        const float value = gain * std::sin(0.05F * static_cast<float>(i));
        made[i] = {value, value};
    }
    return made;
}

std::string little_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
    return text;
}

std::string wav(std::uint32_t kind, std::uint32_t channels, std::uint32_t rate, std::uint32_t bits,
                const std::string& data) {
    return "RIFF" + little_endian(0, 4) + "WAVEfmt " + little_endian(16, 4) + little_endian(kind, 2) +
           little_endian(channels, 2) + little_endian(rate, 4) + little_endian(rate * channels * bits / 8, 4) +
           little_endian(channels * bits / 8, 2) + little_endian(bits, 2) + "data" +
           little_endian(static_cast<std::uint32_t>(data.size()), 4) + data;
}

std::string refusal_of(const std::string& bytes) {
    try {
        speech_from_wav(bytes, "ask.wav");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

std::filesystem::path program_in(const tests::TemporaryFolder& folder, const std::string& does) {
    const auto file = folder.write("voice", "#!/bin/sh\n" + does + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
}

TEST(Wav, ComesBackAsItWasWritten) {
    std::vector<Frame> frames = tone(2'400, 0.8F);
    const std::vector<float> read = speech_from_wav(wav_of(frames), "tone.wav");
    ASSERT_EQ(read.size(), frames.size());
    for (std::size_t i = 0; i < read.size(); ++i) ASSERT_NEAR(read[i], frames[i].left, 1e-4F);
}

TEST(Wav, IsReadInEveryFormThatIsNamed) {
    EXPECT_THAT(speech_from_wav(wav(1, 1, 48'000, 8, "\x80\xFF"), "a"), testing::ElementsAre(0, 127.0F / 128));
    EXPECT_THAT(speech_from_wav(wav(1, 2, 48'000, 16, std::string("\x00\x40\x00\x20", 4)), "a"),
                testing::ElementsAre(0.375F))
        << "channels are mixed";
    EXPECT_THAT(speech_from_wav(wav(3, 1, 48'000, 32, little_endian(0x3F000000U, 4)), "a"), testing::ElementsAre(0.5F));
    EXPECT_EQ(speech_from_wav(wav(1, 1, 22'050, 16, std::string(44'100, '\0')), "a").size(), 48'000U);
    std::string piped = wav(1, 1, 48'000, 16, std::string(20, '\0'));
    piped.replace(40, 4, "\xFF\xFF\xFF\x7F", 4);
    EXPECT_EQ(speech_from_wav(piped, "a").size(), 10U) << "of a length that nobody knew";
}

TEST(Wav, IsRefusedWithWhatIsWrongAndWhatWouldBeRight) {
    EXPECT_THAT(refusal_of("ID3"), HasSubstr("ask.wav: it is no WAV; save it as WAV of 16 bits"));
    EXPECT_THAT(refusal_of(wav(1, 1, 48'000, 24, std::string(30, '\0'))), HasSubstr("form 1 with 24 bits"));
    EXPECT_THAT(refusal_of(wav(1, 0, 48'000, 16, "ab")), HasSubstr("0 channels"));
    EXPECT_THAT(refusal_of(wav(1, 1, 400, 16, "ab")), HasSubstr("400 samples per second"));
    EXPECT_THAT(refusal_of(wav(1, 1, 48'000, 16, "")), HasSubstr("holds no sound"));
    EXPECT_THAT(refusal_of(wav(1, 1, 8'000, 8, std::string(8'000 * 61, '\x80'))), HasSubstr("too long"));
    EXPECT_THAT(refusal_of(wav(1, 1, 48'000, 16, "ab").substr(0, 22)), HasSubstr("its form is cut off"));
}

TEST(Resampling, KeepsATone) {
    std::vector<float> low(2'205);
    for (std::size_t i = 0; i < low.size(); ++i) low[i] = std::sin(6.2831853F * 440 * static_cast<float>(i) / 22'050);
    const std::vector<float> high = resampled(low, 22'050, 48'000);
    ASSERT_EQ(high.size(), 4'800U);
    for (std::size_t i = 10; i + 30 < high.size(); ++i)
        ASSERT_NEAR(high[i], std::sin(6.2831853F * 440 * static_cast<float>(i) / 48'000), 0.005F) << i;
}

TEST(ASpeaker, TakesARecordingBeforeTheMachinesVoice) {
    const tests::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "en");
    std::vector<Frame> frames = tone(1'000, 0.4F);
    folder.write("en/ask.trees.wav", wav_of(frames));
    folder.write("en/ask.sky.wav", "no sound");
    Speaker speaker(folder.path(), "no-such-program");
    EXPECT_EQ(speaker.say({"en", "ask.trees", "Which?"}).size(), 1'000U);
    EXPECT_EQ(speaker.trouble(), "");
    EXPECT_TRUE(speaker.say({"en", "ask.land", "Which?"}).empty());
    EXPECT_THAT(speaker.trouble(), HasSubstr("no-such-program: No such file or directory; apt install espeak-ng"));
    EXPECT_TRUE(speaker.say({"en", "ask.sky", "Which?"}).empty());
    EXPECT_THAT(speaker.trouble(), HasSubstr("ask.sky.wav: it is no WAV"));
    EXPECT_TRUE(speaker.say({"en", "", "← …"}).empty());
    EXPECT_EQ(speaker.trouble(), "") << "there is nothing to say";
}

TEST(ASpeaker, HandsItsTextToTheVoiceAndOutlivesWhatItDoes) {
    const tests::TemporaryFolder folder;
    std::vector<Frame> frames = tone(500, 0.4F);
    folder.write("said.wav", wav_of(frames));
    const std::string at = folder.path().string();
    const auto say = [&](const std::string& does) {
        Speaker speaker("", program_in(folder, does).string());
        const std::size_t said = speaker.say({"zh", "", "A: ← quiet; $(reboot)"}).size();
        return std::to_string(said) + " " + speaker.trouble();
    };
    EXPECT_EQ(say("echo \"$@\" > " + at + "/words; cat > " + at + "/text; cat " + at + "/said.wav"), "500 ");
    EXPECT_EQ(tests::contents_of(folder / "words"), "-v cmn-latn-pinyin -s 150 --stdin --stdout\n");
    EXPECT_EQ(tests::contents_of(folder / "text"), "A:   quiet; $(reboot)\n");
    EXPECT_THAT(say("exit 1"), HasSubstr("has no voice for the language zh"));
    EXPECT_THAT(say("cat " + at + "/said.wav; kill -9 $$"), HasSubstr("has no voice"));
    EXPECT_THAT(say("echo rubbish"), HasSubstr("it is no WAV"));
    EXPECT_THAT(say("exec sleep 60"), HasSubstr("does not answer"));
}

TEST(ASpeaker, SpeaksWithTheVoiceThatComesAlong) {
    Speaker speaker("");
    for (const char* language : {"ar", "de", "el", "en", "es", "fr", "he", "hi", "it", "nl", "pl", "pt", "tr", "uk",
                                 "zh", "de-AT", "fr_CA.UTF-8"}) {
        const std::vector<float> said = speaker.say({language, "", "A: 1"});
        EXPECT_EQ(speaker.trouble(), "") << language;
        EXPECT_GT(said.size(), 4'800U) << language;
        EXPECT_GT(std::ranges::max(said), 0.05F) << language;
    }
    for (const char* language : {"ja", "xh", "tlh"}) {
        EXPECT_TRUE(speaker.say({language, "", "A"}).empty());
        EXPECT_THAT(speaker.trouble(), HasSubstr("it wants recordings")) << language;
    }
}

TEST(Readable, LeavesOutWhatIsForEyesAndPausesBetweenThings) {
    EXPECT_EQ(readable("→ taller, wider crowns · wetter · warmer light"), "taller, wider crowns; wetter; warmer light");
    EXPECT_EQ(readable("← Back"), "Back");
    EXPECT_EQ(readable("· a"), "a");
    EXPECT_EQ(readable("→"), "");
}

// The mark waits as long as this says: too short, and it runs away from what is being said.
TEST(SpeakingTime, IsAboutWhatTheVoiceTakes) {
    Speaker speaker("");
    for (const auto& [language, text] :
         {std::pair{"en", "Which has the best trees?"}, std::pair{"de", "A: sehr hohe und belaubte Bäume"},
          std::pair{"fr", "Appuyez sur un bouton pour commencer"}, std::pair{"zh", "哪幅的树木最美？"},
          std::pair{"ar", "استمر في الضغط: سيكفيك زر واحد"}, std::pair{"hi", "शुरू करने के लिए कोई भी बटन दबाएँ"}}) {
        const Utterance utterance{language, "", text};
        const double took = static_cast<double>(speaker.say(utterance).size()) / kRate;
        EXPECT_GT(speaking_time_s(utterance), 0.75 * took) << text;
        EXPECT_LT(speaking_time_s(utterance), 1.8 * took) << text;
    }
}

}  // namespace
}  // namespace quadrat::sound
