// SPDX-License-Identifier: Apache-2.0
// Which commit a program is of: read from git, from the tarball, or said to be unknown.
#include <gmock/gmock.h>

#include "journeys/quadrat_program.hpp"

namespace {

namespace fs = std::filesystem;
using namespace quadrat::tests;

// A source tree with the two files that say the commit.
class Tree {
  public:
    Tree() {
        for (const char* name : {"commit.cmake", "QuadratVersion.cmake"})
            fs::copy(std::string(QUADRAT_SOURCE_DIR "/cmake/") + name, folder_ / name);
    }
    std::string version() const {
        const std::string at = folder_.path().string();
        EXPECT_TRUE(succeeds(run({"cmake", "-DOUTPUT=" + at + "/version.cpp", "-DVERSION=1.2.3", "-DSOURCE=" + at, "-P",
                                  at + "/QuadratVersion.cmake"},
                                 folder_)));
        const std::string text = contents_of(folder_ / "version.cpp");
        const std::size_t start = text.find("return \"") + 8;
        return text.substr(start, text.find('"', start) - start);
    }
    std::string git(const std::string& words) const {
        const Ended ended = run({"bash", "-c", "git -c user.name=a -c user.email=a@b " + words}, folder_);
        EXPECT_TRUE(succeeds(ended));
        return ended.out.substr(0, ended.out.find('\n'));
    }
    const TemporaryFolder& folder() const { return folder_; }

  private:
    TemporaryFolder folder_;
};

TEST(Version, NamesTheCommitAndWhetherFilesDiffer) {
    const Ended ended = run(program({"--version"}), TemporaryFolder());
    EXPECT_THAT(ended.out, testing::MatchesRegex("quadrat [0-9.]+\\+([0-9a-f]+(-dirty)?|unknown)\n"));
    const Tree tree;
    tree.git("init --quiet && git add commit.cmake && git -c user.name=a -c user.email=a@b commit --quiet -m first");
    const std::string commit = tree.git("rev-parse --short HEAD");
    EXPECT_EQ(tree.version(), "1.2.3+" + commit);
    tree.folder().write("commit.cmake", contents_of(tree.folder() / "commit.cmake") + "# changed\n");
    EXPECT_EQ(tree.version(), "1.2.3+" + commit + "-dirty");
}

TEST(Version, WritesNothingWhereNothingChanged) {
    const Tree tree;
    tree.version();
    const fs::path written = tree.folder() / "version.cpp";
    fs::last_write_time(written, fs::file_time_type::clock::now() - std::chrono::hours(1));
    const auto before = fs::last_write_time(written);
    tree.version();
    EXPECT_EQ(fs::last_write_time(written), before);
}

TEST(Version, ATarballKnowsItsCommitAndAPlainCopySaysThatItDoesNot) {
    const Tree tree;
    EXPECT_EQ(tree.version(), "1.2.3+unknown");
    tree.folder().write(".gitattributes", contents_of(QUADRAT_SOURCE_DIR "/.gitattributes"));
    fs::create_directory(tree.folder() / "cmake");
    fs::copy(tree.folder() / "commit.cmake", tree.folder() / "cmake/commit.cmake");
    tree.git(
        "init --quiet && git add .gitattributes cmake && git -c user.name=a -c user.email=a@b commit --quiet -m a");
    const std::string commit = tree.git("rev-parse --short HEAD");
    tree.git("archive HEAD cmake/commit.cmake | tar -x -O > commit.cmake && rm -rf .git");
    EXPECT_EQ(tree.version(), "1.2.3+" + commit);
}

}  // namespace
