// SPDX-License-Identifier: Apache-2.0
// firmware-io includes nothing of app/ and reads its small texts itself: not otherwise than all others are read.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/text_file.hpp"
#include "firmware-io/text_file.hpp"
#include "support/process.hpp"

namespace quadrat {
namespace {

using namespace std::string_view_literals;

template <typename Error, typename Read>
std::string outcome(const Read& read) {
    try {
        return "text: " + read();
    } catch (const Error& error) {
        return std::string("refused: ") + error.what();
    }
}

void expect_one_reading(const tests::TemporaryFolder& folder, std::string_view bytes) {
    const auto file = folder.write("a.txt", std::string(bytes));
    const std::string ours = outcome<base::InputError>([&] { return base::read_text(file); });
    EXPECT_EQ(outcome<firmware_io::TextError>([&] { return firmware_io::read_text(file, 1U << 20U); }), ours);
}

TEST(BothReadersOfText, SayTheSameOfWhatEditorsAndDamageMakeOfAFile) {
    const tests::TemporaryFolder folder;
    for (const std::string_view bytes : {""sv,
                                         "a\nb"sv,
                                         "a\r\nb\r\n"sv,
                                         "a\rb\r"sv,
                                         "a\rb\n"sv,
                                         "\xef\xbb\xbf"sv,
                                         "\xef\xbb\xbf"
                                         "at 1s\r\n"sv,
                                         "\xff\xfe"
                                         "a\0"sv,
                                         "\xfe\xff\0a"sv,
                                         "a\0b\0"sv,
                                         "\0a\0b"sv,
                                         "\xff\xfe\0\0"
                                         "a\0\0\0"sv,
                                         "\0\0\xfe\xff"sv,
                                         "abcdefghi\n\0"sv,
                                         "Gr\xf6sse"sv,
                                         "Gr\xc3\xb6sse"sv,
                                         "\xc0\xaf"sv,
                                         "\xe0\x9f\xbf"sv,
                                         "\xe2\x82\xac"sv,
                                         "\xed\xa0\x80"sv,
                                         "\xf0\x9f\x8c\xb2"sv,
                                         "\xf0\x8f\xbf\xbf"sv,
                                         "\xf4\x90\x80\x80"sv,
                                         "\xf5\x80\x80\x80"sv,
                                         "one\ntwo\xe2\x82"sv,
                                         "a\n\n\x80"sv})
        expect_one_reading(folder, bytes);
    for (const std::size_t length : {std::size_t{65536}, std::size_t{65537}})
        expect_one_reading(folder, "short\n" + std::string(length, 'x') + "\n");
}

TEST(BothReadersOfText, SayTheSameOfAnyBytes) {
    const tests::TemporaryFolder folder;
    constexpr std::array kTelling{'\n',   '\r',   '\0',   'a',    '\x7f', '\x80', '\x8f', '\x90',
                                  '\x9f', '\xa0', '\xbb', '\xbf', '\xc1', '\xc2', '\xdf', '\xe0',
                                  '\xe1', '\xed', '\xef', '\xf0', '\xf4', '\xf5', '\xfe', '\xff'};
    std::mt19937 chance(1);
    for (int i = 0; i < 3000; ++i) {
        std::string bytes(chance() % 7, ' ');
        for (char& byte : bytes) byte = kTelling[chance() % kTelling.size()];
        expect_one_reading(folder, bytes);
        if (testing::Test::HasFailure()) return;
    }
}

}  // namespace
}  // namespace quadrat
