// SPDX-License-Identifier: Apache-2.0
// What the pages for developers name is there: folders, files, commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = QUADRAT_SOURCE_DIR;
constexpr const char* kPages[] = {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "GLOSSARY.md"};

std::string contents_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

// `app/tempo/governor`, `app/tempo/`, `tests/style/layers.txt`: within backquotes, with a folder of ours before it.
TEST(Pages, NameNoPathThatIsNotThere) {
    static const std::regex path(R"(`((?:app|firmware-io|shaders|tests|deploy|cmake)/[\w./*-]*)`)");
    std::size_t checked = 0;
    for (const char* page : kPages) {
        const std::string text = contents_of(kRoot / page);
        ASSERT_FALSE(text.empty()) << page;
        for (std::sregex_iterator it(text.begin(), text.end(), path), end; it != end; ++it) {
            const std::string name = (*it)[1].str();
            if (name.find('*') != std::string::npos) continue;
            const bool is_there =
                fs::exists(kRoot / name) || fs::exists(kRoot / (name + ".hpp")) || fs::exists(kRoot / (name + ".cpp"));
            EXPECT_TRUE(is_there) << page << " names " << name;
            ++checked;
        }
    }
    EXPECT_GT(checked, 40U);
}

TEST(Pages, LinkToWhatIsThere) {
    static const std::regex link(R"(\]\(([\w./-]+)(?:#[\w-]*)?\))");
    for (const char* page : kPages) {
        const std::string text = contents_of(kRoot / page);
        for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it)
            EXPECT_TRUE(fs::exists(kRoot / (*it)[1].str())) << page << " links to " << (*it)[1];
    }
}

// `quadrat run` has a file commands/run.cpp that adds "run".
TEST(Pages, NameNoCommandThatTheProgramHasNot) {
    static const std::regex command(R"(quadrat ([a-z]+)\b)");
    static const std::regex added(R"re(add_subcommand\(\s*"([a-z]+)")re");
    std::set<std::string> known;
    for (const auto& entry : fs::directory_iterator(kRoot / "app/commands")) {
        const std::string text = contents_of(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), added), end; it != end; ++it) known.insert((*it)[1]);
    }
    ASSERT_GT(known.size(), 10U);
    for (const char* page : kPages) {
        const std::string text = contents_of(kRoot / page);
        for (std::sregex_iterator it(text.begin(), text.end(), command), end; it != end; ++it) {
            if (it->prefix().length() > 0 && *(it->prefix().second - 1) != '`' && *(it->prefix().second - 1) != '/')
                continue;
            EXPECT_TRUE(known.contains((*it)[1])) << page << ": " << it->str();
        }
    }
}

TEST(Pages, TheFirstOneIsShort) {
    const std::string text = contents_of(kRoot / "README.md");
    EXPECT_LT(std::ranges::count(text, '\n'), 200);
}

}  // namespace
