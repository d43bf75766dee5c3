// SPDX-License-Identifier: Apache-2.0
#include "desk/texts.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <set>

#include "base/error.hpp"
#include "desk/secrets.hpp"

namespace quadrat::desk {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t holes_in(const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at + 2)) ++count;
    return count;
}

TEST(DeskTexts, EachIsThereInEachLanguageWithTheSameHoles) {
    std::set<std::string> codes;
    const Texts& english = *language_of("en");
    for (const Texts& language : languages()) {
        codes.insert(language.code());
        EXPECT_EQ(language.direction(), language.code() == "ar" ? "rtl" : "ltr");
        EXPECT_EQ(language.all().size(), english.all().size()) << language.code();
        for (const auto& [key, text] : english.all()) {
            const auto own = language.all().find(key);
            ASSERT_NE(own, language.all().end()) << language.code() << " has no " << key;
            EXPECT_FALSE(own->second.empty()) << language.code() << ": " << key;
            EXPECT_EQ(holes_in(own->second), holes_in(text)) << language.code() << ": " << key;
        }
    }
    EXPECT_EQ(codes, (std::set<std::string>{"ar", "de", "en", "es", "fr", "xh"})) << "as the exhibit speaks";
}

// A text that is not translated is the English one; that may be so of a short word, not of a sentence.
TEST(DeskTexts, NoSentenceIsLeftInEnglish) {
    const Texts& english = *language_of("en");
    for (const Texts& language : languages()) {
        if (language.code() == "en") continue;
        for (const auto& [key, text] : english.all()) {
            const bool is_sentence = std::ranges::count(text, ' ') >= 2 && !key.starts_with("time.");
            EXPECT_TRUE(!is_sentence || language(key) != text) << language.code() << ": " << key;
        }
    }
}

TEST(DeskTexts, APreferenceIsReadAsBrowsersSendIt) {
    for (const auto& [accepted, code] :
         std::vector<std::pair<const char*, const char*>>{{"", "en"},
                                                          {"de", "de"},
                                                          {"DE-at", "de"},
                                                          {"tlh", "en"},
                                                          {"tlh, fr;q=0.5, es;q=0.7", "es"},
                                                          {"fr;q=0, de;q=0.001", "de"},
                                                          {"xh ; q=0.9 , en;q=0.8", "xh"},
                                                          {"ar;q=2", "en"},
                                                          {"ar;q=abc,es;q=1.000", "es"},
                                                          {";;;,,,q=1,;q=", "en"}})
        EXPECT_EQ(preferred_language(accepted).code(), code) << accepted;
    std::mt19937 chance(5);
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes;
        for (auto n = chance() % 30; n > 0; --n) bytes += "de,;q=0.1- \xff\t*"[chance() % 15];
        EXPECT_FALSE(preferred_language(bytes).code().empty());
    }
}

TEST(DeskTexts, AFileThatIsNoneIsRefused) {
    for (const char* wrong : {"", "[]", "{}", R"({"language": "x", "direction": "up", "texts": {}})",
                              R"({"language": "x", "direction": "ltr", "texts": {"a": 1}})"})
        EXPECT_THROW(Texts::from_json(wrong, "xx", "xx.json"), base::InputError) << wrong;
}

TEST(DeskTexts, HolesAreFilledInTheirOrder) {
    const Texts& english = *language_of("en");
    EXPECT_EQ(english("fact.late.of", {"2", "100"}), "2 of 100");
    EXPECT_EQ(english("fact.late.of", {"{}", "{}"}), "{} of {}") << "what fills a hole has none";
    EXPECT_EQ(english("no such key"), "");
}

TEST(Secrets, AreNeverInALineThatIsShown) {
    const std::vector<std::string> secrets{"hunter22", "abc"};
    const auto shown = [&](const char* line) { return without_secrets(line, secrets); };
    for (const char* line : {"the broker refuses hunter22", "password=hunter22", "Password: \"hunter22\"",
                             "mqtt://staff:hunter22@host", "token = hunter22, then", "mqtt://staff:hunter@22@host/x"})
        EXPECT_THAT(shown(line), Not(HasSubstr("hunter"))) << line;
    EXPECT_THAT(without_secrets("passphrase: open-sesame and more", {}), Not(HasSubstr("sesame")));
    EXPECT_THAT(without_secrets("password=a secret=b passwd:c", {}),
                testing::StrEq("password=••• secret=••• passwd:•••"));
    EXPECT_EQ(shown("the password is read from a file: abc"), "the password is read from a file: abc");
    EXPECT_EQ(shown("12:30:01 listens on http://127.0.0.1:8080"), "12:30:01 listens on http://127.0.0.1:8080");
    std::mt19937 chance(9);
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes;
        for (auto n = chance() % 40; n > 0; --n)
            bytes += std::vector<std::string>{
                "password", "=", ":", "//", "@", " ", "\"", "x", "\xff", "token"}[chance() % 10];
        without_secrets(bytes, secrets);
    }
}

}  // namespace
}  // namespace quadrat::desk
