// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis_state.hpp"

#include <gmock/gmock.h>

#include "archive/archive.hpp"
#include "archive/sqlite.hpp"
#include "archive/state_lock.hpp"
#include "learning/school.hpp"
#include "support/process.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void make_state(const tests::TemporaryFolder& state) {
    auto archive = archive::Archive::open(state.path(), {}).archive;
    for (int i = 0; i < 60; ++i) ASSERT_FALSE(archive.post("visits", std::string(300, 'x')));
}

// Each with what is wrong with the folder, and what is said of it.
struct Wrong {
    const char* name;
    void (*spoil)(const tests::TemporaryFolder& state);
    const char* said;
};
void PrintTo(const Wrong& wrong, std::ostream* os) { *os << wrong.name; }

class StateThatIsWrong : public testing::TestWithParam<Wrong> {};

TEST_P(StateThatIsWrong, IsDoubtfulBeforeTheNextStart) {
    const tests::TemporaryFolder state;
    make_state(state);
    EXPECT_EQ(worst_of(examine_state_files(state.path())), Health::Good);
    GetParam().spoil(state);
    const auto findings = examine_state_files(state.path());
    EXPECT_EQ(worst_of(findings), Health::Doubtful);
    EXPECT_THAT(report_of(findings), HasSubstr(GetParam().said));
    EXPECT_THAT(report_of(findings), HasSubstr("->")) << "what mends it";
}

void overwrite(const fs::path& file, std::streamoff at, std::size_t count) {
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(at).write(std::string(count, '\xa5').data(), static_cast<std::streamsize>(count));
}

INSTANTIATE_TEST_SUITE_P(
    State, StateThatIsWrong,
    testing::Values(
        Wrong{"DamagedPages", [](const tests::TemporaryFolder& state) { overwrite(state / "quadrat.db", 8192, 4096); },
              "is damaged: "},
        Wrong{"CutFile",
              [](const tests::TemporaryFolder& state) {
                  fs::resize_file(state / "quadrat.db", fs::file_size(state / "quadrat.db") / 2);
              },
              "is damaged: "},
        Wrong{"NewerSchema",
              [](const tests::TemporaryFolder& state) {
                  archive::Connection(state / "quadrat.db").run("PRAGMA user_version=99");
              },
              "schema version is 99"},
        Wrong{"TableThatIsMissing",
              [](const tests::TemporaryFolder& state) {
                  archive::Connection(state / "quadrat.db").run("DROP TABLE outbox");
              },
              "its tables are not those of its version"},
        Wrong{"BrokenWords", [](const tests::TemporaryFolder& state) { state.write("words.json", "{\"quadrat\":"); },
              "words.json"},
        Wrong{"BrokenMap",
              [](const tests::TemporaryFolder& state) { state.write("buttons.map", "A is the red one\n"); },
              "buttons.map:1: "},
        Wrong{"InterruptedRestore",
              [](const tests::TemporaryFolder& state) {
                  fs::create_directory(state / "restoring");
                  state.write("restoring/ready", "before-restore\n");
              },
              "a restore was interrupted"},
        Wrong{"SetAside",
              [](const tests::TemporaryFolder& state) { state.write("quadrat.db.damaged-20310203-040506", ""); },
              "was set aside, the last: quadrat.db.damaged-20310203-040506"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DoctorOfState, FindsDamageBesideARunningExhibitAndSaysHowLargeItsLogIs) {
    const tests::TemporaryFolder state;
    make_state(state);
    auto running = archive::Archive::open(state.path(), {}).archive;
    const auto lock = archive::lock_or_refuse(state.path(), {"the exhibit", "", "", "", ""});
    ASSERT_FALSE(running.post("visits", "{}"));
    const std::string good = report_of(examine_state_files(state.path()));
    EXPECT_THAT(good, HasSubstr("in its log beside it (-wal)"));
    EXPECT_THAT(good, HasSubstr("in use by the exhibit (process "));
    overwrite(state / "quadrat.db", 8192, 4096);
    EXPECT_EQ(worst_of(examine_state_files(state.path())), Health::Doubtful);
}

TEST(Words, ThatAreDamagedAreSetAsideBeforeALessonReplacesThem) {
    const tests::TemporaryFolder state;
    state.write("words.json", "what a curator taught, cut o");
    learning::keep_site_words(state.path(), {});
    std::string kept;
    for (const auto& entry : fs::directory_iterator(state.path()))
        if (entry.path().filename().string().starts_with("words.json.damaged-"))
            kept = tests::contents_of(entry.path());
    EXPECT_EQ(kept, "what a curator taught, cut o");
}

}  // namespace
}  // namespace quadrat::doctor
