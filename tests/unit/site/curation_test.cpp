// SPDX-License-Identifier: Apache-2.0
// What the curator says over the site's settings, and the way back.
#include "site/curation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/error.hpp"
#include "site/layers.hpp"
#include "site/settings.hpp"
#include "staff/watch.hpp"
#include "support/process.hpp"

namespace quadrat::site {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ACurator : public testing::Test {
  protected:
    ACurator() {
        std::filesystem::create_directory(state_);
        site("[visit]\nrounds = 3\npatience_s = 30\n[hours]\nmonday = \"09:00-17:00\"\n[screen]\nrotation_deg = 90\n");
    }
    void site(const std::string& toml) const { folder_.write("quadrat.toml", toml); }
    Curation curation() const { return {file_, state_}; }
    bool say(std::vector<std::string> place, CuratedValue value) const {
        return curation().change({{std::move(place), std::move(value)}}, {{}, "10.0.0.1", "a test", ""});
    }
    Configuration now() const { return curation().now().configuration; }
    std::string curated() const { return curation().read(); }
    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "quadrat.toml", state_ = folder_ / "state";
};

std::vector<std::string> texts_of(const std::vector<Mistake>& mistakes) {
    std::vector<std::string> texts;
    for (const Mistake& one : mistakes) texts.push_back(to_text(one));
    return texts;
}

TEST_F(ACurator, SaysWhatCountsOverTheSitesFileKeyByKeyAndTheRestStays) {
    const mode_t umask_before = ::umask(0077);  // as the desk's service has it
    EXPECT_TRUE(say({"visit", "rounds"}, std::int64_t{4}));
    ::umask(umask_before);
    EXPECT_FALSE(say({"visit", "rounds"}, std::int64_t{4})) << "nothing would be another";
    EXPECT_EQ(now().visit.rounds, 4);
    EXPECT_EQ(now().visit.patience_s, 30);
    EXPECT_EQ(std::filesystem::status(curated_file(state_)).permissions(), std::filesystem::perms{0644})
        << "the doctor may be anybody";
    EXPECT_EQ(now().screen.rotation_deg, 90);
    EXPECT_EQ(curation().of_the_site().configuration.visit.rounds, 3);
    const Settings settings = settings_for_service(file_, state_);
    EXPECT_EQ(settings.configuration.visit.rounds, 4);
    EXPECT_EQ(settings.from, SettingsFrom::File);
    EXPECT_EQ(settings_for_people(file_, "").configuration.visit.rounds, 3) << "without a state folder";
    EXPECT_EQ(settings_for_people("", state_).configuration.visit.rounds, 4) << "without a file";
    curation().change({{{"visit", "rounds"}, std::nullopt}}, {});
    EXPECT_FALSE(std::filesystem::exists(curated_file(state_))) << "nothing is said any more";
    EXPECT_EQ(now().visit.rounds, 3);
}

TEST_F(ACurator, IsToldEveryMistakeWithItsFileAndChangesNothing) {
    say({"visit", "rounds"}, std::int64_t{4});
    const std::string before = curated();
    try {
        curation().change({{{"visit", "rounds"}, std::int64_t{900}}, {{"hours", "zone"}, std::string("Mars/Base")}},
                          {});
        FAIL() << "taken";
    } catch (const SettingsError& error) {
        ASSERT_THAT(error.mistakes(), SizeIs(2));
        for (const Mistake& mistake : error.mistakes()) EXPECT_EQ(mistake.file, curated_file(state_).string());
        EXPECT_THAT(error.what(), HasSubstr("visit.rounds is 900; it must lie between 1 and 50"));
    }
    EXPECT_THROW(say({"desk", "listen"}, std::string("127.0.0.1:1")), SettingsError) << "not for the desk to say";
    EXPECT_EQ(curated(), before);
    EXPECT_THAT(curation().changes(), SizeIs(1));
}

TEST_F(ACurator, ReplacesOpeningHoursDayByDayAndExceptionsAsAWhole) {
    site("[hours]\nmonday = \"09:00-17:00\"\n[hours.exceptions]\n2026-12-24 = \"closed\"\n");
    say({"hours", "exceptions"}, EmptyTable{});
    EXPECT_THAT(now().hours.exceptions, IsEmpty());
    EXPECT_EQ(now().hours.week[0].size(), 1U);
    say({"hours", "exceptions", "2026-12-26"}, std::string("10:00-12:00"));
    EXPECT_THAT(now().hours.exceptions, SizeIs(1));
    say({"hours", "tuesday"}, std::string("10:00-12:00"));
    EXPECT_EQ(now().hours.week[1].size(), 1U);
}

TEST_F(ACurator, TakesBackThirtyChangesAndNoMore) {
    for (int i = 1; i <= 35; ++i) say({"visit", "rounds"}, std::int64_t{i});
    EXPECT_THAT(curation().changes(), SizeIs(Curation::kMostChanges));
    for (int i = 34; i >= 5; --i) {
        const auto taken_back = curation().undo();
        ASSERT_TRUE(taken_back);
        EXPECT_EQ(taken_back->who, "10.0.0.1");
        EXPECT_EQ(now().visit.rounds, i);
    }
    EXPECT_EQ(curation().undo(), std::nullopt);
    EXPECT_EQ(now().visit.rounds, 5);
}

TEST_F(ACurator, GoesPastAChangeThatAPulledPlugLeftUndone) {
    say({"visit", "rounds"}, std::int64_t{4});
    const std::string first = curated();
    say({"visit", "rounds"}, std::int64_t{5});
    folder_.write("state/desk.toml", first);  // the way back was written, the file itself was not
    EXPECT_TRUE(curation().undo());
    EXPECT_EQ(now().visit.rounds, 3);
}

TEST_F(ACurator, KeepsWhatHoldsWhereTheWayBackIsDamaged) {
    say({"visit", "rounds"}, std::int64_t{4});
    folder_.write("state/desk.changes.json", "{\"version\":1,\"chan");
    EXPECT_THAT(curation().changes(), IsEmpty());
    EXPECT_EQ(curation().undo(), std::nullopt);
    EXPECT_TRUE(say({"visit", "rounds"}, std::int64_t{6}));
    EXPECT_EQ(now().visit.rounds, 6);
}

TEST_F(ACurator, IsPassedOverByAServiceForWhatWorkedLastWhenTheFileIsDamaged) {
    say({"visit", "rounds"}, std::int64_t{4});
    keep_last_good(state_, *settings_for_service(file_, state_).held);
    for (const char* damaged : {"[visit]\nrounds = 400\n", "[visit", "\xff", ""}) {
        folder_.write("state/desk.toml", damaged);
        const Settings settings = settings_for_service(file_, state_);
        EXPECT_EQ(settings.from, SettingsFrom::LastGood) << damaged;
        EXPECT_EQ(settings.configuration.visit.rounds, 4) << damaged;
        ASSERT_FALSE(settings.mistakes.empty()) << damaged;
        EXPECT_EQ(settings.mistakes.front().file, curated_file(state_).string()) << damaged;
        EXPECT_THROW(settings_for_people(file_, state_), SettingsError) << damaged;
    }
    std::filesystem::remove(last_good_file(state_));
    EXPECT_EQ(settings_for_service(file_, state_).configuration.visit.rounds, 3) << "the site's own, then";
}

TEST_F(ACurator, LeavesACutSitesFileToBeKnownAsCut) {
    site("[visit]\nrounds = 12\n");
    say({"visit", "patience_s"}, 20.0);
    keep_last_good(state_, *settings_for_service(file_, state_).held);
    site("[visit]\nrounds = 1");
    EXPECT_EQ(settings_for_service(file_, state_).from, SettingsFrom::LastGood);
    EXPECT_EQ(settings_for_service(file_, state_).configuration.visit.rounds, 12);
}

TEST_F(ACurator, IsHeardByARunningExhibitWithAndWithoutASitesFile) {
    for (const std::filesystem::path& file : {file_, std::filesystem::path()}) {
        std::filesystem::remove(curated_file(state_));
        staff::Watch watch(file, settings_for_service(file, state_).held, folder_ / "run", state_);
        for (int i = 0; i < 3; ++i) EXPECT_FALSE(watch.look().settings);
        Curation(file, state_).change({{{"visit", "rounds"}, std::int64_t{7}}}, {});
        std::optional<staff::Seen::Changed> changed;
        for (int i = 0; i < 3 && !changed; ++i) changed = watch.look().settings;
        ASSERT_TRUE(changed);
        EXPECT_EQ(changed->checked.configuration.visit.rounds, 7);
    }
}

TEST_F(ACurator, NamesThemesAndGivesEachDayToOneOfThem) {
    const std::string themes =
        "[words]\nwet = [-1, 0]\n[themes.\"autumn week\"]\nfrom = \"2026-10-12\"\nuntil = \"2026-10-18\"\n"
        "locked = [\"sky\"]\nwords = { colourful = [0.5, 1] }\ntext.de.attract = \"Herbst!\"\n[themes.night]\n"
        "words = { light = [-1, -0.8] }\n";
    site(themes);
    using namespace std::chrono;
    const auto configuration = now();
    EXPECT_EQ(theme_on(configuration, 2026y / 10 / 11), "");
    EXPECT_EQ(theme_on(configuration, 2026y / 10 / 12), "autumn week");
    EXPECT_EQ(theme_on(configuration, 2026y / 10 / 18), "autumn week");
    EXPECT_EQ(theme_on(configuration, 2026y / 10 / 19), "");
    EXPECT_EQ(theme_on(configuration, std::nullopt), "") << "a clock that is not to be trusted";
    const Configuration autumn = with_theme(configuration, "autumn week");
    EXPECT_EQ(autumn.words.at("colourful"), (std::array<double, 2>{0.5, 1}));
    EXPECT_EQ(autumn.words.at("wet"), (std::array<double, 2>{-1, 0})) << "what the theme does not name stays";
    EXPECT_THAT(autumn.breeding.locked, testing::ElementsAre("sky"));
    EXPECT_EQ(text(autumn, "attract", "de"), "Herbst!");
    EXPECT_NE(text(autumn, "attract", "en"), "Herbst!");
    say({"visit", "theme"}, std::string("night"));
    EXPECT_EQ(theme_on(now(), 2026y / 10 / 12), "night") << "chosen by hand";
    say({"visit", "theme"}, std::string(kNoTheme));
    EXPECT_EQ(theme_on(now(), 2026y / 10 / 12), "");
}

TEST(Themes, SayWhatIsWrongWithThem) {
    struct Wrong {
        const char* toml;
        const char* says;
    };
    for (const Wrong& wrong : {
             Wrong{"[themes.a]\nfrom = \"2026-10-12\"\n", "has no days that could be counted"},
             Wrong{"[themes.a]\nfrom = \"2026-10-12\"\nuntil = \"2026-10-11\"\n", "has no days that could be counted"},
             Wrong{"[themes.a]\nfrom = \"soon\"\nuntil = \"2026-10-11\"\n", "is no date"},
             Wrong{"[themes.a]\nfrom = \"2026-10-12\"\nuntil = \"2026-10-20\"\n"
                   "[themes.b]\nfrom = \"2026-10-20\"\nuntil = \"2026-10-21\"\n",
                   "has days that are of a too"},
             Wrong{"[themes.a]\nwords = { damp = [0, 1] }\n", "themes.a.words.damp is not known"},
             Wrong{"[themes.a]\nwords = { wet = [1, 0] }\n", "themes.a.words.wet is not a range"},
             Wrong{"[themes.a]\nlocked = [\"water\"]\n", "names no aspect"},
             Wrong{"[themes.a]\ntext.tlh.attract = \"nuqneH\"\n", "is no language's table"},
             Wrong{"[themes.a]\ntext.de.atract = \"x\"\n", "themes.a.text.de.atract is not known"},
             Wrong{"[themes.a]\ncolour = 3\n", "themes.a.colour is not known"},
             Wrong{"[themes.none]\n", "is no theme"},
             Wrong{"[visit]\ntheme = \"winter\"\n", "visit.theme is \"winter\"; it must be one of by date, none"},
             Wrong{"[text.de]\natract = \"x\"\n", "text.de.atract is not known"},
             Wrong{"[hours]\nzone = \"../../etc/passwd\"\n", "write one that the machine knows"},
         }) {
        const auto mistakes = texts_of(check_configuration(wrong.toml, "site.toml").mistakes);
        EXPECT_THAT(mistakes, testing::Contains(HasSubstr(wrong.says))) << wrong.toml;
    }
}

TEST(Texts, OfALanguageCountBeforeThoseOfTheSiteInItsOwn) {
    const Configuration configuration = configuration_from(
        "[visit]\nlanguage = \"fr\"\n[text]\nattract = \"Un\"\nback = \"Retour\"\n[text.fr]\nattract = \"Deux\"\n"
        "[text.de]\nattract = \"Drei\"\n",
        "site.toml");
    EXPECT_EQ(text(configuration, "attract"), "Deux");
    EXPECT_EQ(text(configuration, "attract", "fr"), "Deux");
    EXPECT_EQ(text(configuration, "attract", "de"), "Drei");
    EXPECT_EQ(text(configuration, "back"), "Retour");
    EXPECT_NE(text(configuration, "back", "de"), "Retour");
}

TEST(Layers, AreTakenApartAsTheyWerePutTogether) {
    for (const char* below : {"[visit]\nrounds = 1", "[visit]\nrounds = 12\n", "# nothing\n"}) {
        const std::string both = laid_over(below, "[words]\n", "/a file/desk.toml");
        const Layers layers = layers_of(both);
        EXPECT_EQ(layers.below, below);
        EXPECT_EQ(layers.above, "[words]\n");
        EXPECT_EQ(layers.above_source, "/a file/desk.toml");
        EXPECT_EQ(laid_over(below, "", "x"), below);
    }
}

TEST(Edits, AreWrittenSoThatTheyAreReadAgainWhateverTheySay) {
    const std::string text = "\"Ask\" \\ me\n<b>\xc3\xa4\xe2\x80\xae";
    const std::string toml =
        edited("", {{{"text", "ar", "ask.trees"}, text}, {{"words", "wet"}, std::array{0.5, 1.0}}});
    EXPECT_EQ(edited(toml, {}), toml);
    const Configuration read = check_configuration(toml, "x", [](const std::string&) { return ""; }).configuration;
    EXPECT_EQ(read.texts_in.at("ar").at("ask.trees"), text);
    EXPECT_EQ(edited(toml, {{{"text"}, std::nullopt}, {{"words", "wet"}, std::nullopt}}), "");
    EXPECT_THROW(edited("visit = 3\n", {{{"visit", "rounds"}, std::int64_t{1}}}), base::InputError);
    EXPECT_THROW(edited("[visit", {}), base::InputError);
}

}  // namespace
}  // namespace quadrat::site
