// SPDX-License-Identifier: Apache-2.0
// Languages as translators read and write them, and as a site brings its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/language_po.hpp"
#include "genome/speech.hpp"
#include "support/process.hpp"

namespace quadrat::genome {
namespace {

std::string refusal(std::string_view po) {
    try {
        json_of_po(po, "xx.po");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(LanguagePo, OfEveryLanguageComesBackAsItWas) {
    for (const std::string_view code : language_codes()) {
        const std::string po = po_of(code);
        EXPECT_EQ(parse_json(json_of_po(po, "again"), "again"), parse_json(language_json(code), code)) << code;
    }
}

TEST(LanguagePo, OfALanguageThatIsNotSpokenIsWhatThereIsToTranslate) {
    const std::string po = po_of("fi");
    EXPECT_THAT(po, testing::HasSubstr("\"Language: fi\\n\""));
    EXPECT_THAT(po, testing::HasSubstr("msgctxt \"prompts/attract\"\nmsgid \"Press any button\"\nmsgstr \"\"\n"));
    EXPECT_EQ(json_of_po(po, "fi.po"), "{}\n");
}

TEST(LanguagePo, TakesWhatGettextsToolsWrite) {
    const std::string json = json_of_po(
        "msgid \"\"\nmsgstr \"\"\n\"Language: fi\\n\"\n\n"
        "#. A remark\n#: app/genome/languages/en.json\n#, fuzzy\n#| msgid \"before\"\n"
        "msgctxt \"prompts/attract\"\nmsgid \"\"\n\"Press \"\n\"any button\"\nmsgstr \"\"\n\"Paina \\\"mitä\\\" \"\n"
        "\"nappia\"\n"
        "msgctxt \"words/wet/0\"\nmsgid \"dry\"\nmsgstr \"kuiva\"\n"
        "#~ msgctxt \"prompts/gone\"\n#~ msgstr \"poissa\"\n",
        "fi.po");
    EXPECT_EQ(parse_json(json, "fi"),
              parse_json(R"({"prompts": {"attract": "Paina \"mitä\" nappia"}, "words": {}})", "like"))
        << "of a word both ends are needed";
}

TEST(LanguagePo, RefusesByLine) {
    EXPECT_THAT(refusal("msgctxt \"prompts/attract\"\nmsgid \"a\nmsgstr \"b\"\n"), testing::HasSubstr("xx.po:2: "));
    EXPECT_THAT(refusal("msgctxt \"and\"\nmsgid \"a\"\nmsgstr \"\xE4\"\n"), testing::HasSubstr("is not UTF-8"));
    EXPECT_THAT(refusal("\n\nhello\n"), testing::HasSubstr("xx.po:3: is no line of a PO file"));
    EXPECT_THAT(refusal("msgctxt \"prompts/sea\"\nmsgid \"a\"\nmsgstr \"b\"\n"),
                testing::HasSubstr("xx.po:1: there is no text \"prompts/sea\""));
    EXPECT_THAT(refusal("msgctxt \"and\"\nmsgid \"a\"\nmsgstr \"b\"\n\nmsgctxt \"and\"\nmsgid \"a\"\nmsgstr \"c\"\n"),
                testing::HasSubstr("xx.po:5: \"and\" comes a second time"));
    EXPECT_THAT(refusal("msgid \"a\"\nmsgid_plural \"as\"\n"), testing::HasSubstr("plural"));
    EXPECT_THAT(refusal("msgctxt \"and\"\nmsgid \"a\"\nmsgstr \"b\\q\"\n"), testing::HasSubstr("there is no \\q"));
}

// No text has a number that a noun would have to agree with: a language with other plurals than English is right.
TEST(LanguagePo, HoldsNoNumbers) {
    for (const std::string_view code : language_codes())
        for (const std::string_view key : kPrompts)
            EXPECT_EQ(prompt(code, key).find_first_of("0123456789%"), std::string_view::npos) << code << " " << key;
}

TEST(Languages, AreSixteenAtLeastOfSeveralScripts) {
    EXPECT_GE(language_codes().size(), 16U);
    std::vector<std::string_view> mirrored;
    for (const std::string_view code : language_codes())
        if (language(code).reads_right_to_left()) mirrored.push_back(code);
    EXPECT_THAT(mirrored, testing::ElementsAre("ar", "he"));
}

TEST(Languages, OfASiteAreSpokenBesideThoseThatComeAlong) {
    const tests::TemporaryFolder folder;
    const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder.path() / name) << text; };
    std::string po = po_of("de");
    const std::string was = "msgstr \"Deutsch\"";
    po.replace(po.find(was), was.size(), "msgstr \"Walserdeutsch\"");
    write("wae.po", po);
    write("notes.txt", "for nobody");
    speak_from_folder(folder.path());
    EXPECT_EQ(language("wae").name(), "Walserdeutsch");
    EXPECT_EQ(prompt("wae_CH", "ask.sky"), prompt("de", "ask.sky"));
    EXPECT_THAT(language_codes(), testing::Contains("wae"));
    write("gsw.json", R"({"language": "Mundart"})");
    EXPECT_THROW(speak_from_folder(folder.path()), base::InputError) << "it lacks what joins texts";
    std::filesystem::remove(folder.path() / "gsw.json");
    write("De-1.po", po);
    EXPECT_THROW(speak_from_folder(folder.path()), base::InputError) << "no code";
    EXPECT_THROW(speak_from_folder(folder.path() / "nowhere"), base::InputError);
    EXPECT_THAT(language_codes(), testing::Not(testing::Contains("gsw")));
}

}  // namespace
}  // namespace quadrat::genome
