// SPDX-License-Identifier: Apache-2.0
#include "machine/journal.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "support/process.hpp"

namespace quadrat::machine {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Of an exhibit's machine: "line 0" to "line 11", another unit's line, a warning, an error, the manager's word of it.
class AJournal : public testing::Test {
  protected:
    void SetUp() override {
        const std::string unpack = "xz -dc '" QUADRAT_SOURCE_DIR "/tests/unit/machine/exhibit.journal.xz' >'" +
                                   (folder / "system.journal").string() + "'";
        ASSERT_EQ(std::system(unpack.c_str()), 0);
    }
    tests::TemporaryFolder folder;
};

TEST_F(AJournal, GivesTheLastLinesOfOneUnitTheNewestLast) {
    EXPECT_THAT(last_journal_lines("quadrat.service", 4, folder.path()),
                ElementsAre("2026-11-26 08:00:12 UTC line 11",
                            "2026-11-26 08:00:30 UTC warning: buttons: button B is stuck, since 61 s",
                            "2026-11-26 08:00:40 UTC error: the screen failed <b>for good</b>",
                            "2026-11-26 08:00:41 UTC quadrat.service: Scheduled restart job"));
    EXPECT_EQ(last_journal_lines("quadrat.service", 200, folder.path()).size(), 16U) << "and no more than there are";
    EXPECT_THAT(last_journal_lines("ssh.service", 200, folder.path()),
                ElementsAre("2026-11-26 08:00:20 UTC of another unit"));
    EXPECT_THAT(last_journal_lines("other.service", 200, folder.path()), IsEmpty());
}

TEST_F(AJournal, ThatIsDamagedOrMissingHasNoLines) {
    EXPECT_THAT(last_journal_lines("quadrat.service", 200, folder / "nowhere"), IsEmpty());
    folder.write("system.journal", "this is no journal");
    EXPECT_THAT(last_journal_lines("quadrat.service", 200, folder.path()), IsEmpty());
}

}  // namespace
}  // namespace quadrat::machine
