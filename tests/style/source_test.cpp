// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>

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

// The first line of each function, and how many lines it has. By the shape that clang-format gives the code: what
// begins in the first column, and closes there, or one step in within a class, is a function.
std::vector<std::pair<std::string, std::size_t>> functions_of(const std::string& text) {
    std::vector<std::pair<std::string, std::size_t>> found;
    std::istringstream lines(text);
    std::string outer, member;
    std::size_t outer_at = 0, member_at = 0, number = 0;
    bool is_in_class = false;
    for (std::string line; std::getline(lines, line); ++number) {
        const bool is_outer = !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0;
        if (is_outer) outer = line, outer_at = number;
        if (is_outer && (line.starts_with("class ") || line.starts_with("struct ")) && line.ends_with("{"))
            is_in_class = true;
        if (line.starts_with("};")) is_in_class = false;
        const bool is_member = line.size() > 4 && line.starts_with("    ") && line[4] != ' ' && line[4] != '}';
        if (is_in_class && is_member) member = line, member_at = number;
        if (line == "}") found.emplace_back(outer, number - outer_at + 1);
        if (is_in_class && line == "    }") found.emplace_back(member, number - member_at + 1);
    }
    return found;
}

TEST(Source, NoFunctionIsLongerThanSixtyLines) {
    std::size_t functions = 0;
    for (const auto& file : source_files({"app", "firmware-io"}, {".hpp", ".cpp"}))
        for (const auto& [first, lines] : functions_of(file.text)) {
            EXPECT_LE(lines, 60U) << file.path << ": " << first;
            ++functions;
        }
    EXPECT_GT(functions, 1000U);
}

// A class that goes on in a second file is two classes. Those that do so still are listed, and may only become fewer.
TEST(Source, NoClassIsContinuedInASecondFile) {
    const std::set<std::string> still{"mesh::CollapsingMesh", "render::Renderer", "archive::Archive", "mesh::Wavefront",
                                      "stage::Stage"};
    static const std::regex member(R"(^[\w:<>,&*~ \[\]]*?\b([A-Z]\w+)::~?\w+\()");
    std::map<std::string, std::set<std::string>> files;
    for (const auto& file : source_files({"app"}, {".cpp"})) {
        const std::string room = file.path.substr(4, file.path.find('/', 4) - 4);
        std::istringstream lines(file.text);
        std::smatch match;
        for (std::string line; std::getline(lines, line);)
            if (!line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0 && !line.ends_with(";") &&
                std::regex_search(line, match, member))
                files[room + "::" + match[1].str()].insert(file.path);
    }
    EXPECT_GT(files.size(), 100U);
    std::set<std::string> continued;
    for (const auto& [name, where] : files)
        if (where.size() > 1) continued.insert(name);
    EXPECT_EQ(continued, still);
}

TEST(Source, TheBridgeStaysThin) {
    std::ptrdiff_t lines = 0;
    for (const auto& file : source_files({"app/kiosk"}, {".hpp", ".cpp"})) lines += std::ranges::count(file.text, '\n');
    EXPECT_GT(lines, 500);
    EXPECT_LE(lines, 2500) << "what can be said without the loop has a room below";
}

// How much is drawn of what follows from alpha in the allowance's table, and nowhere else.
TEST(Source, TheAllowanceAloneHasCurvesOfAlpha) {
    static const std::regex curve(R"(\b(pow|sqrt|exp2|log2|clamp|min|max|lerp|mix|smoothstep)\([^;]*\balpha\b)");
    std::set<std::string> with_curves;
    for (const auto& file : source_files({"app/render"}, {".hpp", ".cpp"}))
        if (std::regex_search(file.text, curve)) with_curves.insert(file.path);
    EXPECT_EQ(with_curves, std::set<std::string>{"app/render/choose/allowance.cpp"});
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
