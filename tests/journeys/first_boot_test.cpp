// SPDX-License-Identifier: Apache-2.0
// What a machine that was made of an image asks at its first start, by a file that any editor may have saved.
#include <gmock/gmock.h>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class AFirstBoot : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name :
             {"root/etc/quadrat", "root/usr/share/zoneinfo/Europe", "root/usr/share/zoneinfo/Etc",
              "root/usr/share/quadrat", "root/var/lib/quadrat", "root/boot/efi", "root/boot/firmware"})
            fs::create_directories(folder / name);
        fs::copy(QUADRAT_SOURCE_DIR "/deploy/quadrat.toml", folder / "root/etc/quadrat/quadrat.toml");
        for (const char* name : {"root/usr/share/zoneinfo/Europe/Berlin", "root/usr/share/zoneinfo/Etc/UTC"})
            folder.write(name, "TZif");
        folder.write("root/usr/share/quadrat/overlayroot.conf", "overlayroot=\"tmpfs\"\n");
        folder.write("root/etc/fstab", fstab("/boot/efi"));
        fs::copy(QUADRAT_SOURCE_DIR "/deploy/first-boot/quadrat-setup.txt", folder / "root/boot/efi/quadrat-setup.txt");
    }
    static std::string fstab(const std::string& boot) {
        return "LABEL=quadrat-root / ext4 defaults 0 1\nLABEL=QUADRAT " + boot + " vfat ro 0 2\n";
    }
    void fill_in(const std::string& text) const { folder.write("root/boot/efi/quadrat-setup.txt", text); }
    Ended start() const {
        const std::string programs = fs::path(QUADRAT_BINARY).parent_path().string();
        return run({"env", "QUADRAT_ROOT=" + (folder / "root").string(), "bash", "-c",
                    "PATH=" + programs + ":$PATH exec " QUADRAT_SOURCE_DIR "/deploy/first-boot/quadrat-first-boot"},
                   elsewhere);
    }
    std::string file(const std::string& name) const { return contents_of(folder / name); }
    std::string answer() const { return file("root/boot/efi/quadrat-answer.txt"); }

    TemporaryFolder folder, elsewhere;
};

TEST_F(AFirstBoot, TakesWhatWasFilledInAndClosesTheDisk) {
    fill_in(
        "\xef\xbb\xbf# on Windows\r\nname = Foyer-2 \r\nzone=Europe/Berlin\r\nlanguage = \"de\"\r\n"
        "passphrase = a sentence of staff\r\n");
    ASSERT_TRUE(succeeds(start()));
    EXPECT_EQ(file("root/etc/hostname"), "foyer-2\n");
    EXPECT_THAT(file("root/etc/hosts"), HasSubstr("127.0.1.1 foyer-2\n"));
    EXPECT_EQ(fs::read_symlink(folder / "root/etc/localtime"), "/usr/share/zoneinfo/Europe/Berlin");
    EXPECT_THAT(file("root/etc/quadrat/quadrat.toml"), HasSubstr("\nlanguage = \"de\" "));
    EXPECT_THAT(file("root/var/lib/quadrat/desk.passphrase"), AllOf(Not(HasSubstr("sentence")), Not("")));
    EXPECT_THAT(file("root/boot/efi/quadrat-setup.txt"), AllOf(HasSubstr("passphrase ="), Not(HasSubstr("sentence"))));
    EXPECT_EQ(file("root/etc/overlayroot.local.conf"), "overlayroot=\"tmpfs\"\n");
    EXPECT_EQ(answer(), "name: foyer-2\r\nzone: Europe/Berlin\r\nlanguage: de\r\npassphrase: kept\r\n");
    fill_in("name = another\n");
    ASSERT_TRUE(succeeds(start()));
    EXPECT_EQ(file("root/etc/hostname"), "foyer-2\n") << "it asks once";
}

TEST_F(AFirstBoot, FindsTheFileWhereARaspberryPiHasIt) {
    folder.write("root/etc/fstab", fstab("/boot/firmware"));
    folder.write("root/boot/firmware/quadrat-setup.txt", "name = foyer-3\n");
    ASSERT_TRUE(succeeds(start()));
    EXPECT_EQ(file("root/etc/hostname"), "foyer-3\n");
    EXPECT_THAT(file("root/boot/firmware/quadrat-answer.txt"), HasSubstr("name: foyer-3\r\n"));
}

TEST_F(AFirstBoot, SaysWhatIsWrongAndKeepsWhatStandsInBrackets) {
    fill_in(
        "name = foyer 2; reboot\nzone = ../../etc/passwd\nlanguage = tlh\npassphrase = short\nssh_key = ssh-rsa x\n");
    ASSERT_TRUE(succeeds(start()));
    EXPECT_EQ(file("root/etc/hostname"), "quadrat\n");
    EXPECT_EQ(fs::read_symlink(folder / "root/etc/localtime"), "/usr/share/zoneinfo/Etc/UTC");
    EXPECT_THAT(file("root/etc/quadrat/quadrat.toml"), HasSubstr("\nlanguage = \"en\" "));
    EXPECT_FALSE(fs::exists(folder / "root/var/lib/quadrat/desk.passphrase"));
    EXPECT_THAT(answer(), AllOf(HasSubstr("name = foyer 2; reboot: small letters"), HasSubstr("there is no such zone"),
                                HasSubstr("the screen does not speak it"), HasSubstr("passphrase: it is not kept: "),
                                HasSubstr("at least 10"), HasSubstr("it is no public key"), Not(HasSubstr("short"))));
    EXPECT_FALSE(fs::exists(folder / "root/home/staff"));
}

TEST_F(AFirstBoot, IsContentWithTheFileAsItComesAndWithNone) {
    ASSERT_TRUE(succeeds(start()));
    EXPECT_EQ(answer(), "name: quadrat\r\nzone: Etc/UTC\r\nlanguage: en\r\npassphrase: none\r\n");
    fs::remove(folder / "root/etc/quadrat/set-up");
    fs::remove(folder / "root/boot/efi/quadrat-setup.txt");
    ASSERT_TRUE(succeeds(start())) << "cut off before its end, it begins anew";
    EXPECT_THAT(answer(), HasSubstr("there is no quadrat-setup.txt"));
}

TEST_F(AFirstBoot, KeepsAPublicKey) {
    ASSERT_TRUE(
        succeeds(run({"ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", (elsewhere / "key").string()}, elsewhere)));
    const std::string key = contents_of(elsewhere / "key.pub");
    fill_in("ssh_key = " + key);
    ASSERT_TRUE(succeeds(start()));
    EXPECT_EQ(file("root/home/staff/.ssh/authorized_keys"), key);
    EXPECT_THAT(answer(), HasSubstr("ssh_key: SHA256:"));
}

// Before anything is made.
TEST(AnImage, IsNotBegunWithWhatCannotBecomeOne) {
    const TemporaryFolder folder;
    folder.write("quadrat.deb", "no package");
    for (const auto& [words, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{}, "usage: deploy/image"},
             {{"mac"}, "mac is not known"},
             {{"pc"}, "say where to"},
             {{"pc", "-o", "x.img"}, "--package is missing"},
             {{"pc", "-o", "x.img", "--package", "gone.deb"}, "there is no such file"},
             {{"pc", "-o", "x.img", "--package", "quadrat.deb"}, "is no Debian package"},
             {{"pc", "-o", "x.img", "--package", "quadrat.deb", "--suite", "sid"}, "bookworm or trixie"}}) {
        std::vector<std::string> command{QUADRAT_SOURCE_DIR "/deploy/image"};
        command.insert(command.end(), words.begin(), words.end());
        const Ended ended = run(command, folder);
        EXPECT_EQ(ended.status, 2) << says;
        EXPECT_THAT(ended.err, HasSubstr(says));
        EXPECT_FALSE(fs::exists(folder / "x.img"));
    }
}

}  // namespace
