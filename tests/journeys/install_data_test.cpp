// SPDX-License-Identifier: Apache-2.0
// What deploy/install is told, and the partition that it uses or makes: nothing is done before all of it has been
// looked at. Disks are folders of facts, which stand-ins of lsblk and its like read and change.
#include <gmock/gmock.h>

#include <map>

#include "journeys/quadrat_program.hpp"

namespace {

namespace fs = std::filesystem;
using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

using Facts = std::map<std::string, std::string>;

// clang-format off
constexpr const char* kLsblk = R"sh(for device; do :; done
before=; for word; do [ "$before" != --output ] || name=$word; before=$word; done
folder=DISKS/$(basename "$device")
[ -d "$folder" ] || exit 32
case $name in
    NAME,TYPE) for one in "$folder"*; do echo "/dev/$(basename "$one") $(cat "$one/TYPE")"; done ;;
    *) cat "$folder/$name" 2>/dev/null || echo ;;
esac
)sh";
constexpr const char* kBlkid = R"sh([ "$1" = -t ] || exit 2
for folder in DISKS/*; do
    [ "LABEL=$(cat "$folder/LABEL" 2>/dev/null)" != "$2" ] || { echo "/dev/$(basename "$folder")"; exit 0; }
done
exit 2
)sh";
constexpr const char* kSfdisk = R"sh(for device; do :; done
folder=DISKS/$(basename "$device")
case $1 in --list-free) cat "$folder/ROOM" 2>/dev/null; exit 0 ;; esac
echo "sfdisk $*" >>DISKS.done
mkdir "${folder}9"; echo part >"${folder}9/TYPE"; echo dos >"$folder/PTTYPE"
)sh";
constexpr const char* kMkfs = R"sh(for device; do :; done
before=; for word; do [ "$before" != -L ] || label=$word; before=$word; done
echo "mkfs $device" >>DISKS.done
echo ext4 >DISKS/$(basename "$device")/FSTYPE
echo "$label" >DISKS/$(basename "$device")/LABEL
)sh";
// clang-format on

class Workshop {
  public:
    Workshop() {
        for (const char* name :
             {"root/etc/systemd/system", "root/usr/lib/systemd/system", "root/var/lib", "disks", "bin"})
            fs::create_directories(folder_ / name);
        folder_.write("root/usr/lib/systemd/system/getty@.service", "[Service]\nExecStart=/bin/true\n");
        folder_.write("root/etc/fstab", "LABEL=root / ext4 defaults 0 1\n");
        stand_in("lsblk", kLsblk);
        stand_in("blkid", kBlkid);
        stand_in("sfdisk", kSfdisk);
        stand_in("mkfs.ext4", kMkfs);
        for (const char* name : {"wipefs", "partx", "udevadm"}) stand_in(name, "");
    }
    void disk(const std::string& name, const Facts& facts) const {
        fs::create_directories(folder_ / "disks" / name);
        for (const auto& [fact, value] : facts) folder_.write("disks/" + name + "/" + fact, value + "\n");
    }
    Ended install(std::vector<std::string> arguments, const std::string& root = "root") const {
        std::vector<std::string> command{"env", "PATH=" + (folder_ / "bin").string() + ":" + std::getenv("PATH"),
                                         QUADRAT_SOURCE_DIR "/deploy/install"};
        if (!root.empty()) command.insert(command.end(), {"--root", root});
        command.insert(command.end(), arguments.begin(), arguments.end());
        return run(command, folder_);
    }
    Ended install_on(const std::vector<std::string>& data) const {
        std::vector<std::string> arguments{"--binary", QUADRAT_BINARY, "--data"};
        arguments.insert(arguments.end(), data.begin(), data.end());
        return install(arguments);
    }
    bool is_untouched() const {
        const std::string expected = "LABEL=root / ext4 defaults 0 1\n";
        return !fs::exists(folder_ / "root/usr/bin/quadrat") && contents_of(folder_ / "root/etc/fstab") == expected &&
               done().empty();
    }
    std::string fstab() const { return contents_of(folder_ / "root/etc/fstab"); }
    std::string done() const { return contents_of(folder_ / "disks.done"); }

  private:
    void stand_in(const std::string& name, std::string text) const {
        for (auto at = text.find("DISKS"); at != std::string::npos; at = text.find("DISKS"))
            text.replace(at, 5, (folder_ / "disks").string());
        fs::permissions(folder_.write("bin/" + name, "#!/bin/sh\n" + text), fs::perms::owner_all);
    }
    TemporaryFolder folder_;
};

testing::AssertionResult refuses(const Workshop& workshop, const Ended& ended, const std::string& message) {
    if (ended.status != 2)
        return testing::AssertionFailure() << "ended with " << ended.status << ended.out << ended.err;
    if (ended.err.find("quadrat: " + message) == std::string::npos || count_of(ended.err, "\n") != 1)
        return testing::AssertionFailure() << "said: " << ended.err;
    if (!ended.out.empty() || !workshop.is_untouched())
        return testing::AssertionFailure() << "did something: " << ended.out << workshop.done();
    return testing::AssertionSuccess();
}

TEST(InstallArguments, AreRefusedOneByOneBeforeAnythingIsDone) {
    const std::pair<std::vector<std::string>, const char*> mistakes[] = {
        {{"--data", "foo"}, "--data foo: write a device"},
        {{"--data"}, "--data needs a device"},
        {{"--data", ""}, "--data needs a device"},
        {{"--data", "--dry-run"}, "--data needs a device"},
        {{"--data", "LABEL="}, "--data LABEL=: write a device"},
        {{"--data", "/dev/nonexist99"}, "--data /dev/nonexist99: there is no such device"},
        {{"--data", "/dev/nonexist99", "--dry-run"}, "--data /dev/nonexist99: there is no such device"},
        {{"--binary", "/nope"}, "--binary /nope: there is no such file"},
        {{"--binary", "/nope", "--dry-run"}, "--binary /nope: there is no such file"},
        {{"--binary", "/usr"}, "--binary /usr: is no program"},
        {{"--binary", "/bin/sh"}, "--binary /bin/sh: ../lib/quadrat/images.so is not beside it"},
        {{"--binary"}, "--binary needs a file"},
        {{"--format"}, "--format needs --data DEVICE"},
        {{"--force"}, "--force needs --format"},
        {{"--remove", "--format"}, "--remove goes with --dry-run and --root alone"},
        {{"--nonsense"}, "--nonsense is not known"},
    };
    for (const auto& [arguments, message] : mistakes) {
        const Workshop workshop;
        EXPECT_TRUE(refuses(workshop, workshop.install(arguments), message)) << message;
    }
    const Workshop workshop;
    EXPECT_TRUE(refuses(workshop, workshop.install({}, "nowhere"), "--root nowhere: there is no such folder"));
    EXPECT_TRUE(refuses(workshop, workshop.install({}, "bin"), "--root bin: holds no /etc"));
    EXPECT_TRUE(refuses(workshop, workshop.install({"--root"}, ""), "--root needs a folder"));
    EXPECT_TRUE(refuses(workshop, workshop.install({"--dry-run", "--data", "LABEL=nobodys"}, ""),
                        "--data LABEL=nobodys: there is no such device"));
}

TEST(InstallArguments, AreAllLookedAtAtOnce) {
    const Workshop workshop;
    const Ended ended = workshop.install({"--nonsense", "--data", "foo", "--binary", "/nope"});
    EXPECT_EQ(ended.status, 2);
    for (const char* mistake : {"quadrat: --nonsense", "quadrat: --data foo", "quadrat: --binary /nope"})
        EXPECT_THAT(ended.err, HasSubstr(mistake));
    EXPECT_TRUE(workshop.is_untouched());
}

TEST(InstallData, UsesAPartitionWithOurFileSystemAndLabelOnly) {
    const Workshop workshop;
    workshop.disk("sda", {{"TYPE", "disk"}, {"PTTYPE", "dos"}});
    workshop.disk("sda1", {{"TYPE", "part"}, {"FSTYPE", "vfat"}});
    workshop.disk("sda2", {{"TYPE", "part"}, {"FSTYPE", "ext4"}, {"LABEL", "rootfs"}, {"MOUNTPOINTS", "/"}});
    workshop.disk("sda3", {{"TYPE", "part"}});
    workshop.disk("sda4", {{"TYPE", "part"}, {"FSTYPE", "ext4"}, {"LABEL", "quadrat-data"}, {"MOUNTPOINTS", "/mnt"}});
    const std::pair<const char*, const char*> mistakes[] = {
        {"/dev/sda", "--data /dev/sda: this is a whole disk"},
        {"/dev/sda1", "--data /dev/sda1: holds vfat, and ext4 is needed"},
        {"/dev/sda2", "--data /dev/sda2: its label is \"rootfs\""},
        {"/dev/sda3", "--data /dev/sda3: holds no file system; add --format"},
        {"/dev/sda4", "--data /dev/sda4: is in use as /mnt"},
        {"LABEL=quadrat-data", "--data LABEL=quadrat-data: is in use as /mnt"},
        {"LABEL=rootfs", "--data LABEL=rootfs: is in use as /"},
    };
    for (const auto& [device, message] : mistakes)
        EXPECT_TRUE(refuses(workshop, workshop.install_on({device}), message)) << device;
}

TEST(InstallData, IsMountedByItsLabelAndKeepsTheJournalAndCrashes) {
    const Workshop workshop;
    workshop.disk("sdb3", {{"TYPE", "part"}, {"FSTYPE", "ext4"}, {"LABEL", "quadrat-data"}});
    ASSERT_TRUE(succeeds(workshop.install_on({"/dev/sdb3"})));
    for (const char* line : {"LABEL=quadrat-data /var/lib/quadrat ext4 ",
                             "/var/lib/quadrat/.machine/journal /var/log/journal none bind,nofail,",
                             "/var/lib/quadrat/.machine/coredump /var/lib/systemd/coredump none bind,nofail,"})
        EXPECT_THAT(workshop.fstab(), HasSubstr(line));
    EXPECT_EQ(workshop.done(), "") << "nothing is formatted that was not told to be";
    workshop.disk("sdb3", {{"MOUNTPOINTS", "/var/lib/systemd/coredump\n/var/log/journal\n/var/lib/quadrat"}});
    EXPECT_EQ(workshop.install_on({"/dev/sdb3"}).out, "Everything is as it should be.\n");
    EXPECT_EQ(workshop.install_on({"LABEL=quadrat-data"}).out, "Everything is as it should be.\n");
}

TEST(InstallData, FormatsAnEmptyPartitionAndNoOtherUnlessForced) {
    const Workshop workshop;
    workshop.disk("sda3", {{"TYPE", "part"}});
    const Ended dry = workshop.install_on({"/dev/sda3", "--format", "--dry-run"});
    EXPECT_THAT(dry.out, HasSubstr("would make a file system on /dev/sda3, with the label quadrat-data\n"));
    EXPECT_TRUE(workshop.is_untouched());
    ASSERT_TRUE(succeeds(workshop.install_on({"/dev/sda3", "--format"})));
    EXPECT_EQ(workshop.done(), "mkfs /dev/sda3\n");
    const Ended again = workshop.install_on({"/dev/sda3", "--format"});
    EXPECT_EQ(again.status, 2);
    EXPECT_THAT(again.err, HasSubstr("--format: /dev/sda3 holds a file system (ext4); --force"));
    EXPECT_EQ(workshop.done(), "mkfs /dev/sda3\n");
    ASSERT_TRUE(succeeds(workshop.install_on({"/dev/sda3", "--format", "--force"})));
    EXPECT_EQ(workshop.done(), "mkfs /dev/sda3\nmkfs /dev/sda3\n");
}

TEST(InstallData, FormatsNothingThatIsInUseOrWouldBeTheSecondOfItsLabel) {
    const Workshop workshop;
    workshop.disk("sda2", {{"TYPE", "part"}, {"FSTYPE", "ext4"}, {"MOUNTPOINTS", "/"}});
    EXPECT_TRUE(refuses(workshop, workshop.install_on({"/dev/sda2", "--format", "--force"}),
                        "--format: /dev/sda2 is in use as /"));
    workshop.disk("sdb1", {{"TYPE", "part"}, {"FSTYPE", "ext4"}, {"LABEL", "quadrat-data"}});
    workshop.disk("sda3", {{"TYPE", "part"}});
    EXPECT_TRUE(refuses(workshop, workshop.install_on({"/dev/sda3", "--format"}),
                        "--format: /dev/sdb1 has the label quadrat-data already"));
    EXPECT_TRUE(refuses(workshop, workshop.install_on({"LABEL=quadrat-data", "--format"}), "--format needs a device"));
}

TEST(InstallData, MakesAPartitionInTheFreeRoomOfADisk) {
    const Workshop workshop;
    workshop.disk("sda", {{"TYPE", "disk"},
                          {"PTTYPE", "dos"},
                          {"MOUNTPOINTS", "/"},
                          {"ROOM", "Start End Sectors Size\n1 2 100000 48M"}});
    workshop.disk("sda1", {{"TYPE", "part"}, {"FSTYPE", "ext4"}, {"MOUNTPOINTS", "/"}});
    EXPECT_TRUE(refuses(workshop, workshop.install_on({"/dev/sda", "--format"}), "--format: /dev/sda has 51 MB"));
    workshop.disk("sda", {{"ROOM", "Start End Sectors Size\n1 2 4194304 2G"}});
    ASSERT_TRUE(succeeds(workshop.install_on({"/dev/sda", "--format"})));
    EXPECT_EQ(workshop.done(), "sfdisk --quiet --append --no-reread /dev/sda\nmkfs /dev/sda9\n");
    EXPECT_THAT(workshop.fstab(), HasSubstr("\nLABEL=quadrat-data /var/lib/quadrat ext4 "));
}

TEST(InstallData, GivesAnEmptyDiskItsFirstPartitionTable) {
    const Workshop workshop;
    workshop.disk("sdb", {{"TYPE", "disk"}});
    ASSERT_TRUE(succeeds(workshop.install_on({"/dev/sdb", "--format"})));
    EXPECT_EQ(workshop.done(), "sfdisk --quiet /dev/sdb\nmkfs /dev/sdb9\n");
    const Workshop other;
    other.disk("sdb", {{"TYPE", "disk"}, {"FSTYPE", "vfat"}});
    EXPECT_TRUE(
        refuses(other, other.install_on({"/dev/sdb", "--format"}), "--format: /dev/sdb holds a file system (vfat)"));
}

}  // namespace
