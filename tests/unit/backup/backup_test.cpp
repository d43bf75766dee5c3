// SPDX-License-Identifier: Apache-2.0
#include "backup/backup.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "archive/archive.hpp"
#include "archive/state_file.hpp"
#include "backup/manifest.hpp"
#include "backup/tar.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "support/process.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// SQLite, "Database File Format", section 1.3: four bytes, the highest first.
constexpr std::size_t kUserVersionAt = 60;

const Progress kUnheard = [](const std::string&, double) {};

// A site, its backup, and a machine that has a state of its own.
class ABackup : public testing::Test {
  protected:
    ABackup() {
        fs::create_directory(site / "state");
        archive::Archive::open(site / "state", archive::WallTime{}).archive.begin_visit(archive::WallTime{});
        write_backup({site / "state", "", archive::WallTime{}}, site / "site.tar.xz", kUnheard);
        machine.write("words.json", "taught here");
        machine.write(archive::kStateFile, "visited here");
    }
    // The same backup with one of its files as `change` makes it.
    fs::path with(const std::string& changed, const std::function<void(std::string&)>& change) const {
        TarReader from(site / "site.tar.xz");
        TarWriter to(site / "changed.tar.xz");
        while (const auto entry = from.next()) {
            std::string bytes = from.bytes(kLargest);
            if (entry->name == changed) change(bytes);
            to.add(entry->name, bytes, entry->ownership);
        }
        to.finish();
        return site / "changed.tar.xz";
    }
    void restore_from(const fs::path& backup) const {
        restore({machine.path(), "", archive::WallTime{}}, backup, {}, kUnheard);
    }
    void expect_untouched() const {
        EXPECT_EQ(base::read_file(machine / "words.json", kLargest), "taught here");
        EXPECT_EQ(base::read_file(machine / archive::kStateFile, kLargest), "visited here");
        EXPECT_EQ(std::distance(fs::directory_iterator(machine.path()), fs::directory_iterator()), 2);
    }
    tests::TemporaryFolder site, machine;
};

TEST_F(ABackup, ThatIsPackedAnewIsRestored) {
    restore_from(with("", {}));
    EXPECT_EQ(archive::examine_state_file(machine / archive::kStateFile).condition, archive::Condition::Whole);
    EXPECT_FALSE(fs::exists(machine / "words.json")) << "there was none in it";
}

TEST_F(ABackup, HasThePicturesOfWhatWasChosen) {
    fs::create_directory(site / "state/collection");
    site.write("state/collection/0123456789abcdef.png", "a picture");
    site.write("state/collection/0123456789abcdef.code", "a code\nfrom hall-2\n");
    site.write("state/collection/notes.txt", "somebody else's");
    write_backup({site / "state", "", archive::WallTime{}}, site / "site.tar.xz", kUnheard);
    fs::create_directory(machine / "collection");
    machine.write("collection/aaaaaaaaaaaaaaaa.png", "chosen here");
    restore_from(site / "site.tar.xz");
    EXPECT_EQ(tests::contents_of(machine / "collection/0123456789abcdef.png"), "a picture");
    EXPECT_EQ(tests::contents_of(machine / "collection/0123456789abcdef.code"), "a code\nfrom hall-2\n");
    EXPECT_FALSE(fs::exists(machine / "collection/aaaaaaaaaaaaaaaa.png"));
    EXPECT_FALSE(fs::exists(machine / "collection/notes.txt"));
}

TEST_F(ABackup, WithTheSchemaOfANewerProgramIsRefusedAndNothingIsTouched) {
    const auto changed = with(
        "state/quadrat.db", [](std::string& bytes) { bytes.replace(kUserVersionAt, 4, std::string("\0\0\0\x63", 4)); });
    EXPECT_THAT([&] { restore_from(changed); },
                ThrowsMessage<base::InputError>(AllOf(HasSubstr("changed.tar.xz: "), HasSubstr("schema version is 99"),
                                                      HasSubstr("a newer program made it"), HasSubstr("--move-to"),
                                                      HasSubstr("nothing was changed"))));
    expect_untouched();
}

TEST_F(ABackup, OfANewerKindIsRefusedAndNothingIsTouched) {
    const auto changed = with(kManifest, [](std::string& json) {
        const std::size_t at = json.find("\"version\": 1");
        ASSERT_NE(at, std::string::npos) << json;
        json.replace(at, 12, "\"version\": 2");
    });
    EXPECT_THAT([&] { restore_from(changed); }, ThrowsMessage<base::InputError>(HasSubstr("a newer program made it")));
    expect_untouched();
}

}  // namespace
}  // namespace quadrat::backup
