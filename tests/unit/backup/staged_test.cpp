// SPDX-License-Identifier: Apache-2.0
#include "backup/staged.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "base/seed.hpp"
#include "support/process.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kNew{"quadrat.db", "words.json", "earlier/landscape-1.png"};

// A site's files as they were, and one that no backup has.
void write_old(const tests::TemporaryFolder& state) {
    fs::create_directory(state / "earlier");
    for (const std::string& name : site_files()) state.write(name, "old " + name);
    state.write("quadrat.db-wal", "old log");
    state.write("reboots", "2\n");
}

void stage_new(const Staging& staging) {
    for (const std::string& name : kNew) std::ofstream(staging.place(name)) << "new " + name;
}

void expect_old(const tests::TemporaryFolder& state) {
    for (const std::string& name : site_files()) EXPECT_EQ(tests::contents_of(state / name), "old " + name);
    EXPECT_EQ(tests::contents_of(state / "quadrat.db-wal"), "old log");
    EXPECT_FALSE(fs::exists(state / "restoring"));
}

void expect_new(const tests::TemporaryFolder& state) {
    for (const std::string& name : site_files()) {
        const bool is_new = std::ranges::find(kNew, name) != kNew.end();
        EXPECT_EQ(tests::contents_of(state / name), is_new ? "new " + name : "") << name;
        EXPECT_EQ(tests::contents_of(state / "before" / name), "old " + name) << name;
    }
    EXPECT_FALSE(fs::exists(state / "quadrat.db-wal")) << "the log of another file";
    EXPECT_EQ(tests::contents_of(state / "before/quadrat.db-wal"), "old log");
    EXPECT_EQ(tests::contents_of(state / "reboots"), "2\n") << "the machine's own";
    EXPECT_FALSE(fs::exists(state / "restoring"));
}

TEST(Staging, ThatIsNotCommittedLeavesEverythingAsItWas) {
    const tests::TemporaryFolder state;
    write_old(state);
    stage_new(Staging(state.path()));
    expect_old(state);
    EXPECT_FALSE(complete(state.path()));
}

TEST(Staging, ThatIsCommittedTakesThePlaceOfWhatWasThere) {
    const tests::TemporaryFolder state;
    write_old(state);
    Staging staging(state.path());
    stage_new(staging);
    staging.commit("before");
    expect_new(state);
}

TEST(Staging, ThatWasLeftBeforeItsNoteIsDropped) {
    const tests::TemporaryFolder state;
    write_old(state);
    fs::create_directory(state / "restoring");
    state.write("restoring/quadrat.db", "half of a new one");
    EXPECT_FALSE(is_interrupted(state.path()));
    EXPECT_FALSE(complete(state.path()));
    expect_old(state);
}

// After its note, each number of moves may be the last before the plug is pulled.
TEST(Staging, ThatWasInterruptedAfterAnyMoveIsCompleted) {
    struct Move {
        const char* from;
        const char* to;
    };
    const Move moves[] = {{"quadrat.db-wal", "before/quadrat.db-wal"},
                          {"quadrat.db", "before/quadrat.db"},
                          {"restoring/quadrat.db", "quadrat.db"},
                          {"words.json", "before/words.json"},
                          {"restoring/words.json", "words.json"},
                          {"words.previous.json", "before/words.previous.json"},
                          {"buttons.map", "before/buttons.map"},
                          {"earlier/landscape-1.png", "before/earlier/landscape-1.png"},
                          {"restoring/earlier/landscape-1.png", "earlier/landscape-1.png"}};
    for (std::size_t done = 0; done <= std::size(moves); ++done) {
        const tests::TemporaryFolder state;
        write_old(state);
        fs::create_directories(state / "restoring/earlier");
        fs::create_directories(state / "before/earlier");
        for (const std::string& name : kNew) state.write("restoring/" + name, "new " + name);
        state.write("restoring/ready", "before\nquadrat.db\nwords.json\nearlier/landscape-1.png\n");
        for (std::size_t i = 0; i < done; ++i) fs::rename(state / moves[i].from, state / moves[i].to);
        EXPECT_TRUE(is_interrupted(state.path()));
        EXPECT_TRUE(complete(state.path())) << done;
        expect_new(state);
        EXPECT_FALSE(complete(state.path())) << "there is nothing left to do";
    }
}

TEST(Staging, OfACollectionIsWhatItsNamesSay) {
    for (const char* name : {"collection/0123456789abcdef.png", "collection/0123456789abcdef.code"})
        EXPECT_TRUE(is_of_a_collection(name)) << name;
    for (const char* name :
         {"", "collection/", "collection/0123456789abcdef", "collection/0123456789abcdef.toml",
          "collection/0123456789ABCDEF.png", "collection/../../0123456789.png", "collection/0123456789abcdef.png/x",
          "bred/0123456789abcdef.png", "collection/0123456789abcde.png", "collection/0123456789abcdef0.png"})
        EXPECT_FALSE(is_of_a_collection(name)) << name;
}

// Which landscapes there are is another on each side, and a pull of the plug may come after any of them.
TEST(Staging, TakesTheWholeCollectionInThePlaceOfWhatWasThere) {
    const std::string both = "collection/00000000000000aa.code", old = "collection/00000000000000bb.code",
                      fresh = "collection/00000000000000cc.png";
    for (int moved = 0; moved <= 4; ++moved) {
        const tests::TemporaryFolder state;
        for (const char* folder : {"collection", "before/collection", "restoring/collection"})
            fs::create_directories(state / folder);
        for (const std::string& name : {both, old}) state.write(name, "old");
        for (const std::string& name : {both, fresh}) state.write("restoring/" + name, "new");
        state.write("restoring/ready", "before\n" + both + "\n" + fresh + "\n../elsewhere.png\n");
        const std::pair<std::string, std::string> moves[] = {{both, "before/" + both},
                                                             {"restoring/" + both, both},
                                                             {old, "before/" + old},
                                                             {"restoring/" + fresh, fresh}};
        for (int i = 0; i < moved; ++i) fs::rename(state / moves[i].first, state / moves[i].second);
        EXPECT_TRUE(complete(state.path())) << moved;
        EXPECT_EQ(tests::contents_of(state / both), "new") << moved;
        EXPECT_EQ(tests::contents_of(state / fresh), "new") << moved;
        EXPECT_FALSE(fs::exists(state / old)) << moved;
        EXPECT_EQ(tests::contents_of(state / "before" / both), "old") << moved;
        EXPECT_EQ(tests::contents_of(state / "before" / old), "old") << moved;
    }
}

TEST(Staging, ANoteThatNamesAFolderElsewhereIsRefused) {
    for (const char* note : {"../elsewhere\nquadrat.db\n", "/tmp\n", "", ".\n"}) {
        const tests::TemporaryFolder state;
        fs::create_directory(state / "restoring");
        state.write("restoring/ready", note);
        EXPECT_THROW(complete(state.path()), base::InputError) << note;
    }
}

TEST(Staging, DatedNamesAreFree) {
    const tests::TemporaryFolder folder;
    const archive::WallTime at{std::chrono::sys_days{std::chrono::year{2031} / 2 / 3} + std::chrono::hours{4}};
    EXPECT_EQ(dated_name(folder.path(), "before", at), "before-20310203-040000");
    folder.write("before-20310203-040000", "");
    EXPECT_EQ(dated_name(folder.path(), "before", at), "before-20310203-040000-2");
}

}  // namespace
}  // namespace quadrat::backup
