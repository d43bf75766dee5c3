// SPDX-License-Identifier: Apache-2.0
// Whoever reads settings comes to the same verdict, mistake for mistake: the doctor, the exhibit as people start it,
// the exhibit as the service starts it, the publisher, and the exhibit that follows them while it runs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/error.hpp"
#include "doctor/diagnosis.hpp"
#include "fleet/publisher.hpp"
#include "site/screen.hpp"
#include "site/settings.hpp"
#include "staff/watch.hpp"
#include "support/process.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::IsEmpty;

// A site's folder: the file of settings, a state folder, and what settings may name.
class Site {
  public:
    Site() {
        fs::create_directory(folder_ / "state");
        fs::create_directory(folder_ / "folder");
        folder_.write("right.script", "at 2s press A\n");
        folder_.write("wrong.script", "at 2s prod A\n");
        folder_.write("secret", "password\n");
        ::mkfifo((folder_ / "pipe").c_str(), 0600);
    }
    // "HERE" stands for the folder.
    fs::path write(std::string toml) const {
        for (std::size_t at = toml.find("HERE"); at != std::string::npos; at = toml.find("HERE", at))
            toml.replace(at, 4, folder_.path().string());
        return folder_.write("site.toml", toml);
    }
    fs::path state() const { return folder_ / "state"; }
    fs::path runtime() const { return folder_.path(); }
    fs::path file() const { return folder_ / "site.toml"; }

  private:
    tests::TemporaryFolder folder_;
};

using Verdict = std::vector<std::string>;  // a line a mistake; none: the settings can be used

Verdict lines_of(const std::vector<site::Mistake>& mistakes) {
    Verdict lines;
    for (const site::Mistake& mistake : mistakes)
        lines.push_back(fmt::format("{}:{}: {}", mistake.file, mistake.line, mistake.what));
    return lines;
}

Verdict doctors(const Site& site) {
    Verdict lines;
    for (const Finding& finding : examine_configuration(site.file()).findings)
        if (finding.health != Health::Good) {
            const auto what = finding.what.find(": ");
            lines.push_back(fmt::format("{}:{}: {}", finding.file, finding.line,
                                        what == std::string::npos ? finding.what : finding.what.substr(what + 2)));
        }
    return lines;
}

Verdict peoples(const Site& site) {
    try {
        site::settings_for_people(site.file(), site.state());
        return {};
    } catch (const site::SettingsError& error) {
        return lines_of(error.mistakes());
    }
}

Verdict services(const Site& site) { return lines_of(site::settings_for_service(site.file(), site.state()).mistakes); }

Verdict publishers(const Site& site) {
    try {
        site::read_configuration(site.file());
        return {};
    } catch (const site::SettingsError& error) {
        return lines_of(error.mistakes());
    }
}

// Right settings when it starts; then the file is written.
Verdict followers(const Site& site, const std::string& toml) {
    site.write("[visit]\nrounds = 3\n");
    std::optional<std::string> held;
    site::check_configuration_file(site.file(), &held);
    staff::Watch watch(site.file(), held, site.runtime(), site.state());
    watch.look();
    watch.look();
    site.write(toml);
    for (int look = 0; look < 3; ++look)
        if (const auto seen = watch.look(); seen.settings) return lines_of(seen.settings->checked.mistakes);
    return {"nothing was noticed"};
}

// A file of settings, and for each of its mistakes where and about what it is said.
struct Wrong {
    std::string name, toml;
    std::vector<std::pair<int, std::string>> said;
};
void PrintTo(const Wrong& wrong, std::ostream* os) { *os << wrong.name; }

Wrong text_of(const std::string& name, const std::string& line, const std::string& said) {
    const std::size_t dot = said.find('.');
    return {name, fmt::format("[{}]\n{}\n", said.substr(0, dot), line), {{2, said}}};
}

std::vector<Wrong> wrong_screens() {
    return {
        text_of("Display", "display = \"tv\"", "screen.display"),
        text_of("DisplayNumber", "display = 1", "screen.display"),
        text_of("SizeStar", "size = \"1920*1080\"", "screen.size"),
        text_of("SizeWord", "size = \"huge\"", "screen.size"),
        text_of("SizeHalf", "size = \"12x\"", "screen.size"),
        text_of("SizeTooLarge", "size = \"8000x8000\"", "screen.size"),
        text_of("SizeNegative", "size = \"-640x480\"", "screen.size"),
        text_of("SizeList", "size = [1280, 720]", "screen.size"),
        text_of("ModeProgressive", "mode = \"1080p\"", "screen.mode"),
        text_of("ModeHertz", "mode = \"1920x1080@60Hz\"", "screen.mode"),
        text_of("ModeTooFast", "mode = \"1920x1080@6000\"", "screen.mode"),
        text_of("ModeSpace", "mode = \"1920x1080 @60\"", "screen.mode"),
        text_of("ConnectorPort", "connector = \"HDMI1\"", "screen.connector"),
        text_of("ConnectorCard", "connector = \"card0\"", "screen.connector"),
        text_of("Rotation", "rotation_deg = 45", "screen.rotation_deg"),
        text_of("RotationText", "rotation_deg = \"90\"", "screen.rotation_deg"),
        text_of("Mirrored", "mirrored = \"yes\"", "screen.mirrored"),
        text_of("MirroredNumber", "mirrored = 1", "screen.mirrored"),
    };
}

std::vector<Wrong> wrong_inputs() {
    return {
        text_of("InputKind", "inputs = [\"telepathy:\"]", "buttons.inputs"),
        text_of("InputUsb", "inputs = [\"usb:\"]", "buttons.inputs"),
        text_of("InputNoList", "inputs = \"hid:\"", "buttons.inputs"),
        text_of("InputNumber", "inputs = [17]", "buttons.inputs"),
        text_of("InputDevice", "inputs = [\"hid:79:zz\"]", "buttons.inputs"),
        text_of("InputButton", "inputs = [\"gpio:E=GPIO17\"]", "buttons.inputs"),
        text_of("InputLineTwice", "inputs = [\"gpio:A=GPIO17,B=GPIO17\"]", "buttons.inputs"),
        {"InputLineInTwo",
         "[buttons]\ninputs = [\"gpio:A=GPIO17\",\n\"gpio:B=GPIO27,C=GPIO17\"]\n",
         {{3, "buttons.inputs: line GPIO17 is in two inputs"}}},
        text_of("InputNoLine", "inputs = [\"gpio:\"]", "buttons.inputs"),
        text_of("InputPull", "inputs = [\"gpio:A=GPIO17,pull=left\"]", "buttons.inputs"),
        text_of("InputDebounce", "inputs = [\"gpio:A=GPIO17,debounce=5\"]", "buttons.inputs"),
        text_of("InputTwice", "inputs = [\"hid:\", \"hid:\"]", "buttons.inputs"),
        text_of("InputEmpty", "inputs = [\"\"]", "buttons.inputs"),
        text_of("InputScriptMissing", "inputs = [\"script:HERE/none.script\"]", "buttons.inputs"),
        text_of("InputScriptWrong", "inputs = [\"script:HERE/wrong.script\"]", "buttons.inputs"),
        text_of("InputScriptFolder", "inputs = [\"script:HERE/folder\"]", "buttons.inputs"),
        text_of("InputScriptPipe", "inputs = [\"script:HERE/pipe\"]", "buttons.inputs"),
    };
}

std::vector<Wrong> wrong_visits() {
    return {
        text_of("Rounds", "rounds = 900", "visit.rounds"),
        text_of("RoundsText", "rounds = \"six\"", "visit.rounds"),
        text_of("RoundsFraction", "rounds = 2.5", "visit.rounds"),
        text_of("Patience", "patience_s = nan", "visit.patience_s"),
        text_of("PatienceUnit", "patience_s = \"25s\"", "visit.patience_s"),
        text_of("Language", "language = \"tlh\"", "visit.language"),
        text_of("LanguageName", "language = \"German\"", "visit.language"),
        text_of("VisitKey", "turns = 6", "visit.turns"),
        text_of("Genome", "genome = \"mouse\"", "breeding.genome"),
        text_of("Breeder", "breeder = \"Belief\"", "breeding.breeder"),
        text_of("LearningRate", "learning_rate = 2", "breeding.learning_rate"),
        text_of("Locked", "locked = [\"sea\"]", "breeding.locked"),
        text_of("LockedTwice", "locked = [\"sky\", \"sky\"]", "breeding.locked"),
        text_of("WordRange", "wet = [0.5, 0]", "words.wet"),
        text_of("WordBeyond", "wet = [-2, 0]", "words.wet"),
        text_of("WordOne", "wet = 0.5", "words.wet"),
        text_of("WordUnknown", "nice = [0, 1]", "words.nice"),
        text_of("Alpha", "alpha = 0", "picture.alpha"),
        text_of("Samples", "samples = 2", "picture.samples"),
        text_of("LandSamples", "land_samples = 300", "picture.land_samples"),
        text_of("Ground", "ground = \"mole\"", "picture.ground"),
    };
}

std::vector<Wrong> wrong_hours() {
    return {
        text_of("Hours", "monday = \"nine to five\"", "hours.monday"),
        text_of("HoursDay", "moonday = \"closed\"", "hours.moonday"),
        text_of("HoursPast", "monday = \"09:00-25:00\"", "hours.monday"),
        text_of("HoursNumber", "monday = 9", "hours.monday"),
        text_of("HoursCard", "card_s = -1", "hours.card_s"),
        {"ExceptionDate", "[hours.exceptions]\n2026-02-30 = \"closed\"\n", {{2, "hours.exceptions.2026-02-30"}}},
        {"ExceptionSpan", "[hours.exceptions]\n2026-12-24 = \"noon\"\n", {{2, "hours.exceptions.2026-12-24"}}},
        {"ExceptionsNoTable", "[hours]\nexceptions = \"closed\"\n", {{2, "hours.exceptions"}}},
    };
}

std::vector<Wrong> wrong_fleets() {
    return {
        text_of("BrokerScheme", "broker = \"http://broker\"", "fleet.broker"),
        text_of("BrokerBare", "broker = \"broker.example\"", "fleet.broker"),
        text_of("BrokerPort", "broker = \"mqtt://broker:port\"", "fleet.broker"),
        text_of("BrokerPortBeyond", "broker = \"mqtt://broker:70000\"", "fleet.broker"),
        text_of("BrokerNoHost", "broker = \"mqtts://\"", "fleet.broker"),
        {"NameSlash", "[fleet]\nbroker = \"mqtt://broker\"\nname = \"hall/2\"\n", {{3, "fleet.name"}}},
        text_of("NamePlus", "name = \"hall+2\"", "fleet.name"),
        text_of("NameNumber", "name = 2", "fleet.name"),
        text_of("PasswordFile", "password_file = \"HERE/none\"", "fleet.password_file"),
        text_of("PasswordFolder", "password_file = \"HERE/folder\"", "fleet.password_file"),
        text_of("AuthorityFile", "ca_file = \"HERE/none.pem\"", "fleet.ca_file"),
    };
}

std::vector<Wrong> wrong_texts() {
    return {
        {"TextKey", "[text]\nhello = \"x\"\n", {{2, "text.hello"}}},
        {"TextNumber", "[text]\nattract = 3\n", {{2, "text.attract"}}},
        {"TextWithoutQuotes", "[text]\nask.trees = \"Which?\"\n", {{2, "text.ask.trees stands without quotation"}}},
        {"TextWithoutQuotesUnknown", "[text]\nask.sea = \"Which?\"\n", {{2, "text.ask.sea"}}},
        {"TextWithoutFont", "[text]\nattract = \"\\U000f0000\"\n", {{2, "text.attract: no installed font"}}},
        {"TextWithControls", "[text]\nattract = \"a\\u0007b\"\n", {{2, "text.attract"}}},
        {"TextTooLong", fmt::format("[text]\nattract = \"{}\"\n", std::string(900, 'm')), {{2, "text.attract"}}},
    };
}

std::string in_utf16(std::string_view ascii) {
    std::string bytes = "\xff\xfe";
    for (const char c : ascii) bytes += std::string{c, '\0'};
    return bytes;
}

std::vector<Wrong> wrong_files() {
    return {
        {"Nothing", "", {{0, "is empty"}}},
        {"BlankLines", "\n  \n\t\n", {{0, "is empty"}}},
        {"Table", "[vist]\nrounds = 3\n", {{1, "vist is not known"}}},
        {"NoTable", "visit = 3\n", {{1, "visit must be a table"}}},
        {"Bracket", "[visit\nrounds = 6\n", {{1, "table"}}},
        {"CutInAString", "[screen]\nsize = \"1280x", {{2, "string"}}},
        {"CutInAList", "[buttons]\ninputs = [\"hid:\",\n", {{3, "array"}}},
        {"CutBehindAMistake", "ch?\"\n[visit]\nrounds = \xff\n", {{1, ""}, {3, ""}}},
        {"CutBehindAKey", "[visit]\nrounds =", {{2, "value"}}},
        {"CutInAWord", "[screen]\nmirrored = tru\n", {{2, "saw 'tru\\n'"}}},
        {"TwoLinesInAText", "[screen]\nsize = \"a\\nb\"\n", {{2, "\"a\\nb\""}}},
        {"ColoursInAText", "[screen]\nmode = \"\\u001b[31m\"\n", {{2, "\"\\x1b[31m\""}}},
        {"KeyTwice", "[visit]\nrounds = 3\nrounds = 4\n", {{3, "rounds"}}},
        {"NoQuotes", "[visit]\nlanguage = de\n", {{2, ""}}},
        {"NoUtf8", "[text]\nattract = \"\xff\xfe\"\n", {{2, ""}}},
        {"Utf16", in_utf16("[visit]\nrounds = 3\n"), {{0, "UTF-16"}}},
        {"Utf16WithoutItsMark", in_utf16("[visit]\nrounds = 3\n").substr(2), {{0, "UTF-16"}}},
        {"Zeros", std::string("[visit]\nrounds = 3\n\0\0\0\0\0\0", 25), {{3, ""}}},
        {"ManyMistakes",
         "[screen]\nmode = \"1080p\"\nsize = \"huge\"\n[buttons]\ninputs = [\"usb:\", \"gpio:\"]\n[visit]\n"
         "rounds = 900\nlanguage = de\nturns = 6\n[fleet]\nbroker = \"broker\"\nname = \"a/b\"\n[text]\n"
         "ask.sky = \"?\"\n[vist]\nrounds = 3\n",
         {{2, "screen.mode"},
          {3, "screen.size"},
          {5, "buttons.inputs"},
          {5, "buttons.inputs"},
          {7, "visit.rounds"},
          {8, ""},
          {9, "visit.turns"},
          {11, "fleet.broker"},
          {12, "fleet.name"},
          {14, "text.ask.sky"},
          {15, "vist"}}},
    };
}

std::vector<Wrong> all_wrong() {
    std::vector<Wrong> all;
    for (const auto& some :
         {wrong_screens(), wrong_inputs(), wrong_visits(), wrong_hours(), wrong_fleets(), wrong_texts(), wrong_files()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

class EveryMistake : public testing::TestWithParam<Wrong> {};

TEST_P(EveryMistake, IsTheSameForAllWhoReadSettings) {
    const Site site;
    site.write(GetParam().toml);
    const std::vector<site::Mistake> mistakes = site::check_configuration_file(site.file()).mistakes;
    const Verdict verdict = lines_of(mistakes);
    EXPECT_THAT(doctors(site), ElementsAreArray(verdict));
    EXPECT_THAT(peoples(site), ElementsAreArray(verdict));
    EXPECT_THAT(services(site), ElementsAreArray(verdict));
    EXPECT_THAT(publishers(site), ElementsAreArray(verdict));
    EXPECT_THAT(followers(site, GetParam().toml), ElementsAreArray(verdict));

    ASSERT_EQ(mistakes.size(), GetParam().said.size()) << testing::PrintToString(verdict);
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        EXPECT_EQ(mistakes[i].file, site.file().string());
        EXPECT_EQ(mistakes[i].line, GetParam().said[i].first) << mistakes[i].what;
        EXPECT_THAT(mistakes[i].what, HasSubstr(GetParam().said[i].second));
        EXPECT_FALSE(mistakes[i].remedy.empty()) << mistakes[i].what;
        EXPECT_EQ(to_text(mistakes[i]).find('\n'), std::string::npos) << "a line each";
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, EveryMistake, testing::ValuesIn(all_wrong()),
                         [](const auto& wrong) { return wrong.param.name; });

TEST(Mistakes, AreMoreThanSixty) { EXPECT_GE(all_wrong().size(), 60U); }

TEST(Mistakes, AMissingFileIsOneToo) {
    const Site site;
    site.write("[visit]\nrounds = 3\n");
    std::optional<std::string> held;
    site::check_configuration_file(site.file(), &held);
    staff::Watch watch(site.file(), held, site.runtime(), site.state());
    watch.look();
    watch.look();
    fs::remove(site.file());
    std::optional<staff::Seen::Changed> seen;
    for (int look = 0; look < 3 && !seen; ++look) seen = watch.look().settings;
    ASSERT_TRUE(seen.has_value());
    const std::vector<site::Mistake> mistakes = site::check_configuration_file(site.file()).mistakes;
    ASSERT_EQ(mistakes.size(), 1U);
    EXPECT_FALSE(mistakes.front().remedy.empty());
    const Verdict verdict = lines_of(mistakes);
    EXPECT_THAT(verdict.front(), HasSubstr("site.toml"));
    EXPECT_THAT(lines_of(seen->checked.mistakes), ElementsAreArray(verdict));
    EXPECT_THAT(doctors(site), ElementsAreArray(verdict));
    EXPECT_THAT(peoples(site), ElementsAreArray(verdict));
    EXPECT_THAT(services(site), ElementsAreArray(verdict));
    EXPECT_THAT(publishers(site), ElementsAreArray(verdict));
}

class EveryRightFile : public testing::TestWithParam<const char*> {};

TEST_P(EveryRightFile, CanBeUsedByAllAndWhatItNamesCanBeMade) {
    const Site site;
    site.write(GetParam());
    EXPECT_THAT(doctors(site), IsEmpty());
    EXPECT_THAT(peoples(site), IsEmpty());
    EXPECT_THAT(services(site), IsEmpty());
    EXPECT_THAT(publishers(site), IsEmpty());
    EXPECT_THAT(followers(site, GetParam()), IsEmpty());
    const site::Configuration configuration = site::read_configuration(site.file());
    EXPECT_NO_THROW(site::display_options(configuration));
    for (const std::string& spec : configuration.inputs) EXPECT_NO_THROW(firmware_io::open_buttons(spec)) << spec;
    if (configuration.fleet.broker.empty()) return;
    EXPECT_NO_THROW(fleet::Publisher(configuration.fleet, site.state(), site.runtime()));
}

INSTANTIATE_TEST_SUITE_P(
    Settings, EveryRightFile,
    testing::Values("# nothing but a remark: the defaults are wished for\n", "[screen]\n",
                    "[screen]\nsize = \"1280x720\"\nmode = \"1920x1080@59.94\"\nconnector = \"HDMI-A-1\"\n",
                    "[screen]\nsize = \"\"\nmode = \"\"\nconnector = \"\"\n", "[screen]\nmode = \"1280X720\"\n",
                    "[buttons]\ninputs = [\"gpio:A=GPIO17,B=GPIO27,lampA=GPIO5\", \"hid:0079:0006\", \"keyboard\"]\n",
                    "[buttons]\ninputs = [\"hid:map=/nowhere/yet.map\", \"script:HERE/right.script\"]\n",
                    "[fleet]\nbroker = \"mqtt://broker.example:1884\"\nname = \"hall 2\"\nuser = \"quadrat\"\n"
                    "password_file = \"HERE/secret\"\n",
                    "[text]\nattract = \"Drück einen Knopf\"\n\"ask.trees\" = \"Wo?\"\n",
                    "[visit]\nlanguage = \"xh\"\n", "\xef\xbb\xbf[visit]\r\nrounds = 3\r\n"));

}  // namespace
}  // namespace quadrat::doctor
