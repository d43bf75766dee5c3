// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "support/source_tree.hpp"

namespace {

using quadrat::tests::source_files;

const std::vector<std::string> kCode{".hpp", ".cpp", ".inc", ".glsl", ".vert", ".frag", ".comp", ".cmake"};
const std::vector<std::string> kFolders{"app", "firmware-io", "shaders", "tests", "cmake"};

TEST(Source, EveryFileSaysItsLicence) {
    for (const auto& file : source_files(kFolders, kCode))
        EXPECT_LT(file.text.find("SPDX-License-Identifier: Apache-2.0"), 120U) << file.path;
}

TEST(Source, NoFileIsLongerThanARoomMayBe) {
    for (const auto& file : source_files(kFolders, {".hpp", ".cpp"}))
        EXPECT_LE(std::ranges::count(file.text, '\n'), 450) << file.path << " has more than one purpose by now";
}

TEST(Source, TheBridgeStaysThin) {
    std::ptrdiff_t lines = 0;
    for (const auto& file : source_files({"app/kiosk"}, {".hpp", ".cpp"})) lines += std::ranges::count(file.text, '\n');
    EXPECT_GT(lines, 500);
    EXPECT_LE(lines, 2500) << "what can be said without the loop has a room below";
}

TEST(Source, TheMainFunctionStaysSmall) {
    for (const auto& file : source_files({"app"}, {".cpp"})) {
        if (file.path == "app/main.cpp") {
            EXPECT_LT(std::ranges::count(file.text, '\n'), 60);
        }
    }
}

TEST(Source, NamesNothingAfterItsBeingACatchAll) {
    static const std::regex vague(R"(\b(class|struct)\s+\w*(Manager|Helper|Utils?|Info)\b)");
    for (const auto& file : source_files(kFolders, {".hpp", ".cpp"}))
        EXPECT_FALSE(std::regex_search(file.text, vague)) << file.path;
}

}  // namespace
