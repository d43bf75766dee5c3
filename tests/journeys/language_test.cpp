// SPDX-License-Identifier: Apache-2.0
// Visitors who choose their language, and translators' files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;

TEST(AVisitorsLanguage, IsAskedFirstAndSpokenUntilTheirVisitEnds) {
    const TemporaryFolder folder;
    folder.write("site.toml",
                 "[picture]\nland_samples = 65\n[visit]\nrounds = 1\ndescribe_words = 0\n"
                 "languages = [\"en\", \"de\", \"fr\", \"zh\", \"he\"]\n");
    // German stands on the first page, Chinese on the next.
    folder.write("visit.script",
                 "at 2s press A\nafter 1s press B\nafter 1s press A\nafter 1s press A\nafter 1s press A\nwait 40s\n"
                 "press A\nafter 1s press D\nafter 1s press A\nafter 1s press B\nafter 1s press B\nafter 1s press B\n"
                 "wait 40s\n");
    const Ended ended = run(program({"run", "--config", "site.toml", "--display", "headless", "--size", "320x180",
                                     "--input", "script:visit.script", "--state", "state", "--seed", "7"}),
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale"), 2U) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("a visitor chose the language de"));
    EXPECT_THAT(ended.err, HasSubstr("a visitor chose the language zh"));
    EXPECT_THAT(ended.err, HasSubstr("Himmel")) << "the landscape they bred, in their words";
    EXPECT_THAT(ended.err, HasSubstr("的天空"));
}

TEST(ALanguageOfTheSite, IsExportedTranslatedCheckedAndSpoken) {
    const TemporaryFolder folder;
    ASSERT_EQ(run(program({"languages", "export", "de", "-o", "wae.po"}), folder).status, 0);
    std::string po = contents_of(folder / "wae.po");
    const std::string was = "msgstr \"Deutsch\"";
    ASSERT_NE(po.find(was), std::string::npos);
    po.replace(po.find(was), was.size(), "msgstr \"Walserdeutsch\"");
    std::filesystem::create_directory(folder / "own");
    folder.write("own/wae.po", po);
    const Ended checked = run(program({"languages", "check", "own/wae.po", "-o", "wae.json"}), folder);
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("Walserdeutsch, "));
    EXPECT_THAT(contents_of(folder / "wae.json"), HasSubstr("\"Walserdeutsch\""));
    folder.write("site.toml", "[visit]\nlanguage = \"wae\"\nlanguage_folder = \"own\"\n");
    const Ended spoken = run(program({"doctor", "--only", "settings", "--config", "site.toml"}), folder);
    EXPECT_EQ(spoken.status, 0) << spoken.out << spoken.err;
    folder.write("own/wae.po", "msgctxt \"prompts/sea\"\nmsgstr \"x\"\n");
    const Ended refused = run(program({"doctor", "--only", "settings", "--config", "site.toml"}), folder);
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.out + refused.err, HasSubstr("own/wae.po:1: there is no text"));
}

TEST(Languages, AreListedWithWhatTheyHave) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"languages"}), folder);
    EXPECT_EQ(ended.status, 0);
    EXPECT_THAT(ended.out, HasSubstr("עברית  (from right to left)"));
    EXPECT_GE(count_of(ended.out, "\n"), 16U);
    EXPECT_EQ(run(program({"languages", "export", "fi", "-o", "fi.json"}), folder).status, 2);
}

}  // namespace
