// SPDX-License-Identifier: Apache-2.0
#include "commands/curator_forms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/process.hpp"

namespace quadrat::commands {
namespace {

using desk::Entry;
using desk::Fields;
using Deed = desk::Curator::Deed;

// A form as a browser sends it, untouched.
Fields as_it_came(const desk::Form& form) {
    Fields fields = form.kept;
    for (const desk::Group& group : form.groups)
        for (const Entry& entry : group.entries) {
            const std::size_t space = std::min(entry.value.find(' '), entry.value.size());
            if (entry.kind == Entry::Kind::Range) {
                fields[entry.name + ".low"] = entry.value.substr(0, space);
                fields[entry.name + ".high"] = entry.value.substr(std::min(space + 1, entry.value.size()));
            } else if (entry.kind != Entry::Kind::Tick || entry.value == "on") {
                fields[entry.name] = entry.value;
            }
        }
    return fields;
}

class AForm : public testing::Test {
  protected:
    void site(const std::string& toml) const { folder_.write("quadrat.toml", toml); }
    void curated(const std::string& toml) const { folder_.write("desk.toml", toml); }
    site::Curation curation() const { return {folder_ / "quadrat.toml", folder_.path()}; }
    desk::Form form(const std::string& part, const Fields& query = {}) const {
        return curator_form(part, query, say_, curation().now().configuration).value();
    }
    bool send(const std::string& part, const Fields& fields, Deed deed = Deed::Save) const {
        const site::Configuration now = curation().now().configuration;
        return curation().change(curator_edits(part, fields, deed, now, curation().of_the_site().configuration), {});
    }
    site::Configuration now() const { return curation().now().configuration; }
    tests::TemporaryFolder folder_;
    const desk::Texts& say_ = *desk::language_of("en");
};

constexpr const char* kBusySite =
    "[visit]\nlanguage = \"fr\"\nlanguages = [\"zh\", \"en\"]\nrounds = 4\npatience_s = 12.5\ntheme = \"night\"\n"
    "[hours]\nmonday = \"09:00-12:30, 13:30-18:00\"\nfriday = \"18:00-02:00\"\nzone = \"Europe/Berlin\"\n"
    "[hours.exceptions]\n2026-12-24 = \"closed\"\n[breeding]\nlocked = [\"sky\"]\n[words]\nwet = [-0.5, 0.25]\n"
    "[text]\nattract = \"Venez\"\n[text.de]\nback = \"Weg\"\n[themes.night]\nwords = { light = [-1, -0.8] }\n"
    "text.fr.attract = \"Nuit\"\n[themes.\"autumn week\"]\nfrom = \"2026-10-12\"\nuntil = \"2026-10-18\"\n";

TEST_F(AForm, ThatIsSentAsItCameSaysNothing) {
    for (const std::string toml : {"# nothing\n", kBusySite}) {
        site(toml);
        for (const std::string& part : curator_parts()) {
            EXPECT_FALSE(send(part, as_it_came(form(part)))) << part << ": " << curation().read();
            EXPECT_EQ(curation().read(), "") << part;
        }
    }
    EXPECT_FALSE(send("texts", as_it_came(form("texts", {{"in", "de"}}))));
}

TEST_F(AForm, OfAThemeThatIsSentAsItCameLeavesAllThemesAsTheyWere) {
    site(kBusySite);
    const auto before = now().themes;
    for (const auto& [name, theme] : before) {
        send("theme", as_it_came(form("theme", {{"name", name}})));
        EXPECT_EQ(now().themes, before) << name << ": " << curation().read();
    }
}

TEST_F(AForm, SaysWhatWasWrittenAndLeavesTheRestToTheSite) {
    site(kBusySite);
    Fields visit = as_it_came(form("visit"));
    visit["rounds"] = "9";
    visit["offers.de"] = "on";
    visit.erase("offers.en");
    EXPECT_TRUE(send("visit", visit));
    EXPECT_EQ(now().visit.rounds, 9);
    EXPECT_THAT(now().visit.languages, testing::ElementsAre("zh", "de")) << "the order of the buttons stays";
    EXPECT_THAT(curation().read(), testing::Not(testing::HasSubstr("patience_s")));
    site("[visit]\npatience_s = 99\n");
    EXPECT_EQ(now().visit.patience_s, 99) << "the site may change what the curator has not said";
    visit["rounds"] = "";
    EXPECT_TRUE(send("visit", visit));
    EXPECT_EQ(now().visit.rounds, site::Configuration{}.visit.rounds) << "nothing: as the site says";
}

TEST_F(AForm, TakesOutWhatTheSiteLimits) {
    site(kBusySite);
    Fields words = as_it_came(form("words"));
    words["word.wet.low"] = words["word.wet.high"] = "";
    words["word.tall.low"] = "0.5";
    words.erase("locked.sky");
    EXPECT_TRUE(send("words", words));
    EXPECT_EQ(now().words.at("wet"), (std::array<double, 2>{-1, 1}));
    EXPECT_EQ(now().words.at("tall"), (std::array<double, 2>{0.5, 1})) << "one end alone limits that end";
    EXPECT_TRUE(now().breeding.locked.empty());
    Fields texts = as_it_came(form("texts"));
    texts["text.attract"] = "";
    EXPECT_TRUE(send("texts", texts));
    EXPECT_EQ(site::text(now(), "attract"),
              site::text(site::configuration_from("[visit]\nlanguage=\"fr\"\n", "x"), "attract"));
}

TEST_F(AForm, OpensEveryDayAndAlwaysAgain) {
    site("# nothing\n");
    Fields hours = as_it_came(form("hours"));
    EXPECT_EQ(hours.at("monday"), "00:00-24:00");
    hours["monday"] = " 10:00-12:00 ";
    hours["exceptions"] = "\r\n2026-12-24 10:00-13:00\r\n2026-12-25 closed\r\n";
    EXPECT_TRUE(send("hours", hours));
    EXPECT_EQ(now().hours.week[0].size(), 1U);
    EXPECT_EQ(now().hours.exceptions.size(), 2U);
    EXPECT_FALSE(send("hours", as_it_came(form("hours"))));
    hours["monday"] = "00:00-24:00";
    hours["exceptions"] = "";
    EXPECT_TRUE(send("hours", hours));
    EXPECT_TRUE(now().hours.is_always_open);
    site("[hours]\nmonday = \"closed\"\n");
    hours["tuesday"] = "";
    EXPECT_TRUE(send("hours", hours));
    EXPECT_FALSE(now().hours.is_always_open);
    EXPECT_EQ(now().hours.week[1].size(), 0U);
    EXPECT_EQ(now().hours.week[0].front().until_min, 24 * 60) << "over what the site says";
}

TEST_F(AForm, MakesRenamesAndTakesOutAThemeThatIsShown) {
    site("# nothing\n");
    EXPECT_TRUE(send("theme", {{"called", "autumn"},
                               {"from", "2026-10-12"},
                               {"until", "2026-10-18"},
                               {"locked.sky", "on"},
                               {"word.wet.high", "0"},
                               {"in", "de"},
                               {"text.attract", "Herbst"}}));
    EXPECT_TRUE(send("themes", {{"theme", "autumn"}}));
    Fields theme = as_it_came(form("theme", {{"name", "autumn"}, {"in", "fr"}}));
    EXPECT_EQ(theme.count("text.attract"), 1U);
    theme["text.attract"] = "Automne";
    theme["called"] = "harvest";
    EXPECT_TRUE(send("theme", theme));
    ASSERT_TRUE(now().themes.contains("harvest"));
    EXPECT_FALSE(now().themes.contains("autumn"));
    EXPECT_EQ(now().visit.theme, "harvest");
    EXPECT_EQ(now().themes.at("harvest").texts.at("de").at("attract"), "Herbst") << "the other languages' stay";
    EXPECT_THROW(send("theme", {{"called", "harvest"}}), base::InputError) << "it is another's name";
    EXPECT_TRUE(send("theme", {{"name", "harvest"}, {"called", "harvest"}}, Deed::Remove));
    EXPECT_TRUE(now().themes.empty());
    EXPECT_EQ(now().visit.theme, site::kThemeByDate);
    site(kBusySite);
    EXPECT_THROW(send("theme", {{"name", "night"}, {"called", "night"}}, Deed::Remove), base::InputError);
}

TEST_F(AForm, IsThereInEveryLanguageOfTheDesk) {
    site(kBusySite);
    for (const desk::Texts& say : desk::languages())
        for (const char* part : {"hours", "visit", "texts", "words", "themes", "theme"}) {
            const auto made = curator_form(part, {}, say, now());
            ASSERT_TRUE(made) << part;
            EXPECT_FALSE(say(std::string("curator.") + part).empty()) << part;
            for (const desk::Group& group : made->groups) {
                EXPECT_FALSE(group.title.empty()) << part;
                for (const Entry& entry : group.entries) EXPECT_FALSE(entry.label.empty()) << part << " " << entry.name;
            }
        }
    EXPECT_FALSE(curator_form("nowhere", {}, say_, now()));
}

}  // namespace
}  // namespace quadrat::commands
