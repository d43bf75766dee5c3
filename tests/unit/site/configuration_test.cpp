// SPDX-License-Identifier: Apache-2.0
#include "site/configuration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "base/error.hpp"
#include "base/file.hpp"
#include "genome/speech.hpp"
#include "support/process.hpp"

namespace quadrat::site {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::string& toml) {
    try {
        configuration_from(toml, "site.toml");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Configuration, TheFileThatIsDeliveredSaysTheDefaults) {
    const Configuration delivered = read_configuration(QUADRAT_SOURCE_DIR "/deploy/quadrat.toml");
    const Configuration standard;
    EXPECT_EQ(delivered.screen.display, standard.screen.display);
    EXPECT_EQ(delivered.inputs, standard.inputs);
    EXPECT_EQ(delivered.visit.rounds, standard.visit.rounds);
    EXPECT_EQ(delivered.visit.patience_s, standard.visit.patience_s);
    EXPECT_EQ(delivered.visit.countdown_s, standard.visit.countdown_s);
    EXPECT_EQ(delivered.visit.finale_s, standard.visit.finale_s);
    EXPECT_EQ(delivered.visit.long_press_s, standard.visit.long_press_s);
    EXPECT_EQ(delivered.visit.language, standard.visit.language);
    EXPECT_EQ(delivered.breeding.genome, standard.breeding.genome);
    EXPECT_EQ(delivered.breeding.breeder, standard.breeding.breeder);
    EXPECT_EQ(delivered.words, standard.words);
    EXPECT_EQ(delivered.breeding.learning_rate, standard.breeding.learning_rate);
    EXPECT_EQ(delivered.breeding.mutation, standard.breeding.mutation);
    EXPECT_EQ(delivered.picture.alpha, standard.picture.alpha);
    EXPECT_EQ(delivered.picture.land_samples, standard.picture.land_samples);
    EXPECT_EQ(delivered.picture.ground, standard.picture.ground);
    EXPECT_EQ(delivered.visit.describe_words, standard.visit.describe_words);
    EXPECT_EQ(delivered.visit.describe_every, standard.visit.describe_every);
    EXPECT_EQ(delivered.visit.describe_others, standard.visit.describe_others);
    EXPECT_EQ(delivered.visit.describe_s, standard.visit.describe_s);
    EXPECT_EQ(delivered.play.buttons, standard.play.buttons);
    EXPECT_EQ(delivered.play.held, standard.play.held);
    EXPECT_EQ(delivered.play.hold_s, standard.play.hold_s);
    EXPECT_EQ(delivered.play.pace_s, standard.play.pace_s);
    EXPECT_EQ(delivered.play.times_round, standard.play.times_round);
    EXPECT_EQ(delivered.play.begins_by_itself, standard.play.begins_by_itself);
    EXPECT_EQ(delivered.play.dwell_s, standard.play.dwell_s);
    EXPECT_EQ(delivered.play.quiet_s, standard.play.quiet_s);
    EXPECT_EQ(delivered.play.patience, standard.play.patience);
    EXPECT_EQ(delivered.play.shows_how, standard.play.shows_how);
    EXPECT_EQ(delivered.sound, standard.sound);
    EXPECT_EQ(delivered.look, standard.look);
    EXPECT_EQ(delivered.take_home, standard.take_home);
    EXPECT_EQ(delivered.hours, standard.hours);
    EXPECT_EQ(delivered.closing.card, standard.closing.card);
    EXPECT_EQ(delivered.closing.overtime, standard.closing.overtime);
    EXPECT_EQ(delivered.closing.awake, standard.closing.awake);
    EXPECT_EQ(delivered.closing.wakes_by_button, standard.closing.wakes_by_button);
    EXPECT_TRUE(delivered.texts.empty()) << "they would hide what the screen says in the site's language";
}

TEST(Configuration, TheFileThatIsDeliveredShowsEveryPromptInEnglish) {
    std::string shown = base::read_file(QUADRAT_SOURCE_DIR "/deploy/quadrat.toml");
    shown = std::regex_replace(shown.substr(shown.find("[text]")), std::regex("\n# "), "\n");
    const Configuration uncommented = configuration_from(shown, "quadrat.toml");
    EXPECT_EQ(uncommented.texts.size(), genome::kPrompts.size());
    for (const auto& [key, words] : uncommented.texts) EXPECT_EQ(words, text(Configuration{}, key)) << key;
}

TEST(Configuration, TheScreenSpeaksTheSitesLanguageAndItsOwnWordsFirst) {
    const Configuration c =
        configuration_from("[visit]\nlanguage = \"es\"\n[text]\n\"ask.sky\" = \"¿Qué cielo?\"\n", "site.toml");
    EXPECT_EQ(text(c, "ask.sky"), "¿Qué cielo?");
    EXPECT_EQ(text(c, "ask.trees"), "¿Dónde están los mejores árboles?");
}

TEST(Configuration, ReadsWhatTheSiteDecides) {
    const Configuration c = configuration_from(
        "[screen]\nrotation_deg = 90\nmirrored = true\n[buttons]\ninputs = [\"hid:\", \"keyboard\"]\n"
        "[visit]\nrounds = 3\npatience_s = 12.5\n[breeding]\nmutation_form = \"random\"\nlocked = [\"sky\"]\n"
        "[text]\n\"ask.trees\" = \"Welche Bäume?\"\n",
        "site.toml");
    EXPECT_EQ(c.screen.rotation_deg, 90);
    EXPECT_TRUE(c.screen.is_mirrored);
    EXPECT_THAT(c.inputs, testing::ElementsAre("hid:", "keyboard"));
    EXPECT_EQ(c.visit.rounds, 3);
    EXPECT_EQ(c.visit.patience_s, 12.5);
    EXPECT_EQ(c.breeding.mutation_form, "random");
    EXPECT_EQ(text(c, "ask.trees"), "Welche Bäume?");
    EXPECT_EQ(text(c, "ask.sky"), "Which has the best sky?");
}

TEST(Configuration, NamesWhatIsWrongWithWordsAndLanguages) {
    EXPECT_EQ(configuration_from("[visit]\nlanguage = \"de\"\n", "site.toml").visit.language, "de");
    EXPECT_THAT(refusal_of("[words]\nwet = [0.5, 0]\n"), HasSubstr("site.toml:2: words.wet is not a range"));
    EXPECT_THAT(refusal_of("[words]\nnice = [0, 1]\n"), HasSubstr("words.nice is not known"));
    EXPECT_THAT(refusal_of("[visit]\nlanguage = \"tlh\"\n"), HasSubstr("visit.language is \"tlh\""));
}

TEST(Configuration, ReadsHowItIsPlayedByWhoHasNotFourButtons) {
    const Configuration c = configuration_from(
        "[play]\nbuttons = \"two\"\nheld = \"two\"\nhold_s = 0\npace_s = 1.5\ntimes_round = 0\nbegins_by_itself = "
        "false\n"
        "dwell_s = 2\nquiet_s = 1\npatience = 5\n",
        "site.toml");
    EXPECT_EQ(c.play.buttons, "two");
    EXPECT_EQ(c.play.hold_s, 0);
    EXPECT_EQ(c.play.dwell_s, 2);
    EXPECT_EQ(c.play.patience, 5);
    EXPECT_FALSE(c.play.begins_by_itself);
    EXPECT_THAT(refusal_of("[play]\nbuttons = \"three\"\n"), HasSubstr("site.toml:2: play.buttons is \"three\""));
    EXPECT_THAT(refusal_of("[play]\nhold_s = 0.5\n"), HasSubstr("it must be 0, or lie between 1 and 9"));
    EXPECT_THAT(refusal_of("[play]\ndwell_s = 0.1\n"), HasSubstr("play.dwell_s is 0.1"));
    EXPECT_THAT(refusal_of("[play]\npatience = 0\n"), HasSubstr("play.patience is 0"));
    // 5.5 times 9 s are more than three times 15 s.
    EXPECT_THAT(refusal_of("[play]\npace_s = 9\n"),
                HasSubstr("site.toml:2: play.pace_s is 9, so the mark takes 49.5 s"));
    EXPECT_EQ(configuration_from("[play]\npace_s = 9\npatience = 4\n", "site.toml").play.pace_s, 9);
}

TEST(Configuration, ReadsHowItIsLookedAtAndWhereItsLandscapesGo) {
    const Configuration c = configuration_from(
        "[text]\nsize = \"largest\"\ncontrast = \"high\"\n\"ask.sky\" = \"Sky?\"\n[picture]\nmotion = \"calm\"\n"
        "[take_home]\nurl = \"https://museum.example/q?c=\"\n",
        "site.toml");
    EXPECT_EQ(c.look.size, "largest");
    EXPECT_EQ(c.look.contrast, "high");
    EXPECT_EQ(c.look.motion, "calm");
    EXPECT_EQ(c.texts.size(), 1U);
    EXPECT_EQ(c.take_home.url, "https://museum.example/q?c=");
    EXPECT_THAT(refusal_of("[text]\nsize = \"big\"\n"),
                HasSubstr("site.toml:2: text.size is \"big\"; it must be one of normal, large, largest"));
    EXPECT_THAT(refusal_of("[picture]\nmotion = \"none\"\n"), HasSubstr("full, calm"));
    for (const char* wrong : {"museum.example", "ftp://museum.example/", "https:///q", "https://muséum.example/",
                              "https://museum.example/ q", "https://museum.example/<q>"})
        EXPECT_THAT(refusal_of(("[take_home]\nurl = \"" + std::string(wrong) + "\"\n").c_str()),
                    HasSubstr("write an address such as https://museum.example/quadrat/"));
    EXPECT_THAT(refusal_of(("[take_home]\nurl = \"https://" + std::string(200, 'a') + "\"\n").c_str()),
                HasSubstr("take_home.url has 208 letters"));
}

TEST(Configuration, ReadsWhatIsHeard) {
    EXPECT_FALSE(Configuration{}.sound.is_on) << "a room of exhibits is loud enough";
    const tests::TemporaryFolder folder;
    const Configuration c = configuration_from(
        "[sound]\non = true\nlevel = 0.3\nsoundscape = 0\nsignals = 0.5\nspeech = true\nspeech_folder = \"" +
            folder.path().string() +
            "\"\ndevice = \"plughw:CARD=PCH,DEV=0\"\nprivate_device = \"hw:1\"\nprivate_level = 1\n",
        "site.toml");
    EXPECT_TRUE(c.sound.is_on && c.sound.speaks);
    EXPECT_EQ(c.sound.level, 0.3);
    EXPECT_EQ(c.sound.soundscape, 0);
    EXPECT_EQ(c.sound.signals, 0.5);
    EXPECT_EQ(c.sound.speech_folder, folder.path().string());
    EXPECT_EQ(c.sound.device, "plughw:CARD=PCH,DEV=0");
    EXPECT_EQ(c.sound.private_device, "hw:1");
    EXPECT_EQ(c.sound.private_level, 1);
    EXPECT_THAT(refusal_of("[sound]\nlevel = 1.5\n"),
                HasSubstr("site.toml:2: sound.level is 1.5; it must lie between"));
    EXPECT_THAT(refusal_of("[sound]\ndevice = \"my card\"\n"), HasSubstr("is no name of a sound card"));
    EXPECT_THAT(refusal_of("[sound]\nspeech_folder = \"/no/such\"\n"),
                HasSubstr("names no folder that is there: /no/such"));
    EXPECT_THAT(
        refusal_of("[sound]\nspeech = true\nprivate_device = \"default\"\n"),
        HasSubstr("site.toml:3: sound.private_device is the same card as sound.device; name another: aplay -L"));
    EXPECT_THAT(refusal_of("[sound]\nprivate_device = \"hw:1\"\n"),
                HasSubstr("is there, and nobody speaks on it; add speech = true"));
    EXPECT_THAT(refusal_of("[sound]\nvolume = 1\n"), HasSubstr("sound.volume is not known"));
}

TEST(Configuration, ReadsOpeningHours) {
    const Configuration c = configuration_from(
        "[hours]\ntuesday = \"09:00-17:00\"\ncard_s = 5\nwakes_by_button = false\n"
        "[hours.exceptions]\n2026-12-24 = \"closed\"\n",
        "site.toml");
    EXPECT_FALSE(c.hours.is_always_open);
    EXPECT_EQ(c.hours.week[1], (std::vector<OpenSpan>{{540, 1020}}));
    EXPECT_TRUE(c.hours.week[0].empty());
    EXPECT_EQ(c.hours.exceptions.size(), 1U);
    EXPECT_EQ(c.closing.card, std::chrono::seconds{5});
    EXPECT_FALSE(c.closing.wakes_by_button);
    const Configuration only = configuration_from("[hours.exceptions]\n2026-12-24 = \"closed\"\n", "site.toml");
    EXPECT_EQ(only.hours.week[3], (std::vector<OpenSpan>{{0, 1440}})) << "open but for the exceptions";
    EXPECT_THAT(refusal_of("[hours]\nmonday = \"nine to five\"\n"), HasSubstr("site.toml:2: hours.monday"));
    EXPECT_THAT(refusal_of("[hours]\nmoonday = \"closed\"\n"), HasSubstr("hours.moonday is not known"));
    EXPECT_THAT(refusal_of("[hours.exceptions]\n2026-02-30 = \"closed\"\n"), HasSubstr("is no date"));
}

TEST(Configuration, RefusesInOneLineWithTheLineTheKeyAndWhatWouldBeRight) {
    EXPECT_THAT(refusal_of("[visit]\nrounds = 900\n"), HasSubstr("site.toml:2: visit.rounds is 900; it must lie"));
    EXPECT_THAT(refusal_of("[visit]\n\npatience_s = true\n"),
                HasSubstr("site.toml:3: visit.patience_s is not a number"));
    EXPECT_THAT(refusal_of("[screen]\ndisplay = \"tv\"\n"), HasSubstr("one of auto, kms, window, headless"));
    EXPECT_THAT(refusal_of("[picture]\nland_samples = 300\n"), HasSubstr("65, 129, 257, 513 or 1025"));
    EXPECT_THAT(refusal_of("[screen]\nrotation_deg = 45\n"), HasSubstr("0, 90, 180 or 270"));
    EXPECT_THAT(refusal_of("[buttons]\ninputs = \"hid:\"\n"), HasSubstr("is not a list"));
    EXPECT_THAT(refusal_of("[vist]\nrounds = 3\n"), HasSubstr("vist is not known; there are"));
    EXPECT_THAT(refusal_of("[text]\nhello = \"x\"\n"), HasSubstr("text.hello is not known"));
    EXPECT_THAT(refusal_of("visit = 3\n"), HasSubstr("write [visit]"));
    EXPECT_THAT(refusal_of("[visit]\nrounds = nan\n"), HasSubstr("visit.rounds"));
    EXPECT_THAT(refusal_of("[visit]\npatience_s = nan\n"), HasSubstr("must lie between"));
    EXPECT_THAT(refusal_of("[visit\n"), HasSubstr("site.toml:1:"));
}

// What is said of a text, one line a mistake, on a machine whose fonts have the letters of Latin alone.
std::string mistakes_in(const std::string& toml) {
    const auto latin_alone = [](const std::string& text) {
        const bool is_latin = std::ranges::all_of(
            text, [](char c) { return static_cast<unsigned char>(c) < 0xd0 || c == static_cast<char>(0xe2); });
        return is_latin ? std::string{} : "some";
    };
    std::string lines;
    for (const Mistake& mistake : check_configuration(toml, "site.toml", latin_alone).mistakes)
        lines += to_text(mistake) + "\n";
    return lines;
}

TEST(Configuration, AllMistakesAreListedAndWhatIsRightIsKept) {
    const std::string toml =
        "[visit]\nrounds = six\npatience_s = 5\n[screen]\nmode = \"1080p\"\n[fleet]\nname = \"a/b\"\n[vist]\n";
    const CheckedConfiguration checked = check_configuration(toml, "site.toml");
    std::vector<int> lines;
    for (const Mistake& mistake : checked.mistakes) lines.push_back(mistake.line);
    EXPECT_THAT(lines, testing::ElementsAre(2, 5, 7, 8));
    EXPECT_EQ(checked.configuration.visit.patience_s, 5);
    EXPECT_EQ(checked.configuration.screen.mode, "");
}

TEST(Configuration, AfterALineThatIsNoTomlNothingIsMadeUp) {
    EXPECT_THAT(mistakes_in("[buttons]\ninputs = [ \"hid:\"\n[visit]\nrounds = 3\n"),
                testing::MatchesRegex("site.toml:3: [^\n]*\n"))
        << "the list that does not end, and nothing of what follows it";
    EXPECT_THAT(mistakes_in("[visit\nrounds = 3\n[picture]\nalpha = 900\n"),
                testing::AllOf(HasSubstr("site.toml:1: "), HasSubstr("site.toml:4: picture.alpha is 900")));
    EXPECT_THAT(mistakes_in("[visit\nrounds = 3\n"), testing::Not(HasSubstr("rounds")));
}

TEST(Configuration, AFileOfNoBytesIsAMistakeAndOneOfCommentsIsNot) {
    EXPECT_THAT(mistakes_in(""), HasSubstr("site.toml: the file is empty"));
    EXPECT_THAT(mistakes_in(" \n\n"), HasSubstr("empty"));
    EXPECT_EQ(mistakes_in("# as it comes\n"), "");
}

TEST(Configuration, AKeyWithADotWithoutQuotationMarksIsToldHowToBeWritten) {
    const std::string said = mistakes_in("[text]\nask.trees = \"Welche?\"\ndescribe.tree = \"x\"\n");
    EXPECT_THAT(said, HasSubstr("site.toml:2: text.ask.trees stands without quotation marks"));
    EXPECT_THAT(said, HasSubstr("\"ask.trees\" = "));
    EXPECT_THAT(said, HasSubstr("site.toml:3: text.describe.tree is not known"));
    EXPECT_EQ(std::ranges::count(said, '\n'), 2);
}

TEST(Configuration, WordsThatNoFontCanShowAreAMistakeWhereTheyAreWrittenOrChosen) {
    EXPECT_THAT(mistakes_in("[text]\nattract = \"欢迎\"\n"), HasSubstr("site.toml:2: text.attract: no installed font"));
    EXPECT_THAT(mistakes_in("[visit]\nlanguage = \"ar\"\n"), HasSubstr("site.toml:2: visit.language is \"ar\"; no"));
    EXPECT_EQ(mistakes_in("[text]\nattract = \"Drückt einen Knopf\"\n[visit]\nlanguage = \"de\"\n"), "");
}

TEST(Configuration, AScriptThatIsNotThereOrWrongIsAMistakeOfTheInputs) {
    const tests::TemporaryFolder folder;
    const std::string file = folder.write("visit.script", "prod B\n").string();
    EXPECT_THAT(mistakes_in("[buttons]\ninputs = [\"script:" + file + "\"]\n"), HasSubstr("visit.script:1: "));
    EXPECT_THAT(mistakes_in("[buttons]\ninputs = [\"script:/nowhere\"]\n"), HasSubstr("no such file"));
}

}  // namespace
}  // namespace quadrat::site
