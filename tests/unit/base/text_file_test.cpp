// SPDX-License-Identifier: Apache-2.0
#include "base/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/markup.hpp"
#include "base/utf8.hpp"

namespace quadrat::base {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string in_utf16(std::string_view ascii, bool is_little_endian) {
    std::string bytes;
    for (const char c : ascii) bytes += is_little_endian ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
}

TEST(TextFile, TakesWhatEditorsDoToLineEndsAndBeginnings) {
    for (const char* bytes : {"one\ntwo\n", "\xEF\xBB\xBFone\ntwo\n", "one\r\ntwo\r\n", "\xEF\xBB\xBFone\r\ntwo\r\n",
                              "one\rtwo\r", "one\r\ntwo\n"})
        EXPECT_EQ(text_from(bytes, "a.txt"), "one\ntwo\n");
    EXPECT_EQ(text_from("", "a.txt"), "");
    EXPECT_EQ(text_from("\xEF\xBB\xBF", "a.txt"), "");
}

TEST(TextFile, KeepsEveryOtherByteOfUtf8) {
    const std::string text = "Größe \xE9\xAB\x98\xF0\x9F\x8C\xB3\t\x01\n a\rb\n";
    EXPECT_EQ(text_from(text, "a.txt"), text);
}

TEST(TextFile, RefusesUtf16AndUtf32ByName) {
    for (const bool is_little_endian : {true, false}) {
        const std::string marked = in_utf16("size = 3\n", is_little_endian);
        const std::string mark = is_little_endian ? "\xFF\xFE" : "\xFE\xFF";
        for (const std::string& bytes : {mark + marked, marked})
            EXPECT_THAT([&] { text_from(bytes, "a.txt"); },
                        ThrowsMessage<InputError>(AllOf(HasSubstr("a.txt: is UTF-16"), HasSubstr("as UTF-8"))));
    }
    EXPECT_THAT([&] { text_from(std::string("\xFF\xFE\0\0a\0\0\0", 8), "a.txt"); },
                ThrowsMessage<InputError>(HasSubstr("is UTF-32")));
}

TEST(TextFile, RefusesWhatIsNoTextWithLineAndByte) {
    EXPECT_THAT([&] { text_from(std::string("one\ntw\0o\n", 9), "a.txt"); },
                ThrowsMessage<InputError>(HasSubstr("a.txt:2: byte 3 is NUL")));
    EXPECT_THAT(
        [&] {
            text_from(
                "one\nGr\xF6\xDF"
                "e\n",
                "a.txt");
        },
        ThrowsMessage<InputError>(AllOf(HasSubstr("a.txt:2: byte 3 is not UTF-8 (0xF6)"), HasSubstr("ANSI"))));
}

TEST(TextFile, RefusesALineAndAWholeThatAreTooLong) {
    EXPECT_THAT(
        [&] {
            text_from("one\n" + std::string(11, 'x'), "a.txt", {100, 10});
        },
        ThrowsMessage<InputError>(HasSubstr("a.txt:2: this line has 11 bytes; a line has 10 at most")));
    EXPECT_THAT(
        [&] {
            text_from(std::string(101, '\n'), "a.txt", {100, 10});
        },
        ThrowsMessage<InputError>(HasSubstr("a.txt: has 101 bytes")));
    EXPECT_EQ(text_from(std::string(10, 'x'), "a.txt", {10, 10}).size(), 10U);
}

TEST(Utf8, HasNoOverlongFormsNoSurrogatesAndEndsAtPlaneSixteen) {
    const std::pair<const char*, std::size_t> cases[] = {
        {"a", 1},        {"\xC3\xA4", 2},     {"\xE2\x82\xAC", 3}, {"\xF4\x8F\xBF\xBF", 4},
        {"\xC0\x80", 0}, {"\xE0\x80\x80", 0}, {"\xED\xA0\x80", 0}, {"\xF4\x90\x80\x80", 0},
        {"\x80", 0},     {"\xE2\x82", 0}};
    for (const auto& [bytes, length] : cases) EXPECT_EQ(utf8_length(bytes), length) << testing::PrintToString(bytes);
    EXPECT_EQ(utf8_length(""), 0U);
}

TEST(Markup, LetsNothingStandThatXmlWouldReadOrForbids) {
    EXPECT_EQ(escaped("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
    EXPECT_EQ(escaped("Größe\n\t"), "Größe\n\t");
    EXPECT_EQ(escaped(std::string("a\0b\x1B\xFF", 5)),
              "a\xEF\xBF\xBD"
              "b\xEF\xBF\xBD\xEF\xBF\xBD");
}

}  // namespace
}  // namespace quadrat::base
