// SPDX-License-Identifier: Apache-2.0
// deploy/install on the root of a machine that is only a folder: nothing of ours stays behind, and nothing is done
// twice.
#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>

#include "journeys/quadrat_program.hpp"

namespace {

namespace fs = std::filesystem;
using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

// A machine as Debian leaves it, as far as the script looks.
class Machine {
  public:
    Machine() {
        for (const char* folder : {"root/etc/systemd/system", "root/etc/default", "root/var/lib",
                                   "root/usr/lib/systemd/system", "root/boot/firmware", "root/run", "root/tmp"})
            fs::create_directories(folder_ / folder);
        // What systemctl --root needs to know of.
        folder_.write("root/usr/lib/systemd/system/multi-user.target", "[Unit]\n");
        folder_.write("root/usr/lib/systemd/system/graphical.target", "[Unit]\n");
        folder_.write("root/usr/lib/systemd/system/getty@.service", "[Service]\nExecStart=/bin/true\n");
        folder_.write("root/usr/lib/systemd/system/reboot.target", "[Unit]\n[Install]\nAlias=ctrl-alt-del.target\n");
        fs::create_symlink("reboot.target", folder_ / "root/usr/lib/systemd/system/ctrl-alt-del.target");
        folder_.write("root/etc/fstab",
                      "LABEL=root / ext4 defaults 0 1\nLABEL=bootfs  /boot/firmware  vfat  defaults,noatime  0  2\n");
        folder_.write("root/boot/firmware/cmdline.txt", "root=LABEL=root rootwait quiet\n");
        fs::create_symlink("/usr/lib/systemd/system/graphical.target",
                           folder_ / "root/etc/systemd/system/default.target");
    }
    Ended install(std::vector<std::string> arguments = {}, const std::string& input = {}) const {
        return run(command(std::move(arguments)), folder_, input);
    }
    std::vector<std::string> command(std::vector<std::string> arguments) const {
        const std::vector<std::string> install{QUADRAT_SOURCE_DIR "/deploy/install", "--root", "root"};
        arguments.insert(arguments.begin(), install.begin(), install.end());
        return arguments;
    }
    const fs::path& folder() const { return folder_.path(); }
    Ended install_program(std::vector<std::string> more = {}) const {
        more.insert(more.end(), {"--binary", QUADRAT_BINARY});
        return install(more);
    }
    // Every file with what is in it, but for what systemd keeps of users: they go with the machine.
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "root")) {
            const std::string name = entry.path().lexically_relative(folder_ / "root").string();
            if (entry.is_symlink())
                all[name] = fs::read_symlink(entry.path()).string();
            else if (entry.is_regular_file() && !is_of_users(name))
                all[name] = contents_of(entry.path());
        }
        return all;
    }
    void remove(const std::string& name) const { fs::remove(folder_ / ("root/" + name)); }
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / ("root/" + name)).parent_path());
        folder_.write("root/" + name, text);
    }
    std::string file(const std::string& name) const { return contents_of(folder_ / "root" / name); }

  private:
    static bool is_of_users(const std::string& name) {
        return name.starts_with("etc/passwd") || name.starts_with("etc/group") || name.starts_with("etc/shadow") ||
               name.starts_with("etc/gshadow") || name.starts_with("etc/.");
    }
    TemporaryFolder folder_;
};

TEST(Install, DryRunSaysEverythingAndDoesNothing) {
    const Machine machine;
    const auto before = machine.files();
    const Ended ended = machine.install({"--dry-run", "--data", "LABEL=quadrat-data", "--read-only"});
    ASSERT_TRUE(succeeds(ended));
    for (const char* what : {"quadrat.service", "71-quadrat.rules", "journald.conf.d", "user quadrat", "fstab",
                             "overlayroot.local.conf", "/boot/firmware", "cmdline.txt", "coredump.conf.d",
                             "login prompt", "Ctrl+Alt+Del", "logind.conf.d", "/etc/quadrat/quadrat.toml"})
        EXPECT_THAT(ended.out, HasSubstr(what));
    for (const std::string& line : lines_of(ended.out)) EXPECT_TRUE(line.starts_with("would ")) << line;
    EXPECT_EQ(machine.files(), before);
}

TEST(Install, DoesNothingTheSecondTimeAndIsTakenBackWhole) {
    const Machine machine;
    const auto before = machine.files();
    const std::vector<std::string> how{"--data", "LABEL=quadrat-data", "--read-only"};
    ASSERT_TRUE(succeeds(machine.install_program(how)));
    const auto installed = machine.files();
    EXPECT_TRUE(installed.contains("usr/lib/systemd/system/quadrat.service"));
    EXPECT_EQ(installed.at("etc/systemd/system/getty@tty1.service"), "/dev/null");
    EXPECT_EQ(installed.at("etc/systemd/system/ctrl-alt-del.target"), "/dev/null");
    for (const char* line : {"\nNAutoVTs=0\n", "\nReserveVT=0\n"})
        EXPECT_THAT(machine.file("etc/systemd/logind.conf.d/quadrat.conf"), HasSubstr(line));
    EXPECT_THAT(machine.file("etc/systemd/system.conf.d/quadrat.conf"), HasSubstr("\nCtrlAltDelBurstAction=none\n"));
    EXPECT_THAT(installed.at("etc/systemd/system/default.target"), HasSubstr("multi-user"));
    EXPECT_THAT(machine.file("etc/fstab"), HasSubstr("LABEL=quadrat-data /var/lib/quadrat ext4"));
    EXPECT_THAT(machine.file("etc/fstab"),
                HasSubstr("LABEL=bootfs  /boot/firmware  vfat  defaults,noatime,ro  0  2\n"));
    EXPECT_THAT(machine.file("etc/systemd/system/systemd-remount-fs.service.d/quadrat.conf"),
                HasSubstr("\nEnvironment=LIBMOUNT_FORCE_MOUNT2=always\n"));
    EXPECT_THAT(machine.file("etc/overlayroot.local.conf"), HasSubstr("\noverlayroot=\"tmpfs:swap=0,recurse=0\"\n"));
    EXPECT_THAT(machine.file("etc/systemd/journald.conf.d/quadrat.conf"), HasSubstr("\nStorage=persistent\n"));
    EXPECT_THAT(machine.file("etc/passwd"), HasSubstr("quadrat:"));
    EXPECT_EQ(count_of(machine.file("boot/firmware/cmdline.txt"), "quiet"), 1U);
    EXPECT_THAT(machine.file("boot/firmware/cmdline.txt"), HasSubstr("vt.global_cursor_default=0"));

    const Ended again = machine.install_program(how);
    ASSERT_TRUE(succeeds(again));
    EXPECT_EQ(again.out, "Everything is as it should be.\n");
    EXPECT_EQ(machine.files(), installed);

    ASSERT_TRUE(succeeds(machine.install({"--remove"})));
    EXPECT_EQ(machine.files(), before);
    const Ended nothing = machine.install({"--remove"});
    EXPECT_EQ(nothing.out, "Nothing of the exhibit is installed.\n");
}

TEST(Install, GoesToItsEndOnAMachineThatIsNoRaspberryPi) {
    const Machine machine;
    machine.remove("boot/firmware/cmdline.txt");
    const auto before = machine.files();
    const Ended ended = machine.install_program();
    ASSERT_TRUE(succeeds(ended));
    EXPECT_THAT(ended.out, HasSubstr("\nDone. "));
    EXPECT_EQ(machine.install_program().out, "Everything is as it should be.\n");
    ASSERT_TRUE(succeeds(machine.install({"--remove"})));
    EXPECT_EQ(machine.files(), before);
}

TEST(Install, KeepsThePassphraseOfTheStaffsPageThatItIsHanded) {
    const Machine machine;
    const std::vector<std::string> how{"--passphrase-fd", "0", "--binary", QUADRAT_BINARY};
    const Ended ended = machine.install(how, "a sentence of staff\n");
    ASSERT_TRUE(succeeds(ended));
    EXPECT_THAT(ended.out, HasSubstr("keep the passphrase"));
    EXPECT_THAT(ended.out, HasSubstr("systemctl enable --now quadrat-desk"));
    EXPECT_THAT(ended.out + ended.err, Not(HasSubstr("sentence of staff")));
    EXPECT_THAT(machine.file("var/lib/quadrat/desk.passphrase"), testing::StartsWith("scrypt$"));
    for (const auto& [name, text] : machine.files()) EXPECT_THAT(text, Not(HasSubstr("a sentence of staff"))) << name;
    const auto kept = machine.files();
    ASSERT_TRUE(succeeds(machine.install_program()));
    EXPECT_EQ(machine.files(), kept) << "what is kept is not asked for again";
}

// A program at a terminal, where somebody types when it asks.
class Typist {
  public:
    Typist(const std::vector<std::string>& command, const fs::path& folder) {
        child_ = ::forkpty(&terminal_, nullptr, nullptr, nullptr);
        if (child_ != 0) return;
        if (::chdir(folder.c_str()) != 0) ::_exit(126);
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        ::execvp(arguments[0], arguments.data());
        ::_exit(127);
    }
    ~Typist() { ::close(terminal_); }
    Typist(const Typist&) = delete;
    Typist& operator=(const Typist&) = delete;

    // Once it has asked for this; an echo would come into what it said.
    void answer(const std::string& question, const std::string& line) {
        const std::size_t from = said_.size();
        while (said_.find(question, from) == std::string::npos) ASSERT_TRUE(listen()) << question << ": " << said_;
        const std::string typed = line + "\n";
        ASSERT_EQ(::write(terminal_, typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
    }
    std::string said_to_the_end() {
        while (listen()) continue;
        int status = 0;
        ::waitpid(child_, &status, 0);
        EXPECT_EQ(status, 0) << said_;
        return said_;
    }

  private:
    bool listen() {
        char some[4096];
        const ssize_t got = ::read(terminal_, some, sizeof some);
        if (got > 0) said_.append(some, static_cast<std::size_t>(got));
        return got > 0;
    }
    int terminal_ = -1;
    pid_t child_ = -1;
    std::string said_;
};

TEST(Install, AsksForThePassphraseTwiceAndShowsNothingOfIt) {
    const Machine machine;
    Typist typist(machine.command({"--binary", QUADRAT_BINARY}), machine.folder());
    typist.answer("Passphrase for the staff's page", "short");
    typist.answer("Passphrase for the staff's page", "a sentence of staff");
    typist.answer("Once more", "a sentence of stuff");
    typist.answer("Passphrase for the staff's page", "a sentence of staff");
    typist.answer("Once more", "a sentence of staff");
    const std::string said = typist.said_to_the_end();
    for (const char* told : {"at least 10 characters", "the two are not the same", "keep the passphrase"})
        EXPECT_THAT(said, HasSubstr(told));
    EXPECT_THAT(said, Not(HasSubstr("sentence of")));
    EXPECT_THAT(machine.file("var/lib/quadrat/desk.passphrase"), testing::StartsWith("scrypt$"));
    Typist again(machine.command({"--binary", QUADRAT_BINARY}), machine.folder());
    EXPECT_THAT(again.said_to_the_end(), Not(HasSubstr("Passphrase for"))) << "one is kept";
}

TEST(Install, GoesOnWithoutAPassphraseWhereNoneIsTyped) {
    const Machine machine;
    Typist typist(machine.command({"--binary", QUADRAT_BINARY}), machine.folder());
    typist.answer("Passphrase for the staff's page", "");
    EXPECT_THAT(typist.said_to_the_end(), HasSubstr("has no passphrase yet"));
    EXPECT_FALSE(machine.files().contains("var/lib/quadrat/desk.passphrase"));
}

TEST(Install, SaysThatThePageHasNoPassphraseWhereNobodyCanTypeOne) {
    const Machine machine;
    const Ended ended = machine.install_program();
    ASSERT_TRUE(succeeds(ended));
    EXPECT_THAT(ended.out, HasSubstr("has no passphrase yet"));
    EXPECT_THAT(ended.out, HasSubstr("sudo quadrat desk --set-passphrase"));
    EXPECT_FALSE(machine.files().contains("var/lib/quadrat/desk.passphrase"));
}

TEST(Install, APassphraseThatCannotBeKeptIsRefusedBeforeAnythingIsDone) {
    const Machine machine;
    const auto before = machine.files();
    struct Wrong {
        const char* descriptor;
        const char* input;
        const char* says;
    };
    for (const Wrong& wrong : {Wrong{"0", "short\n", "at least 10"}, Wrong{"0", "", "nothing can be read"},
                               Wrong{"77", "", "nothing can be read"}, Wrong{"x", "", "is no number"},
                               Wrong{"", "", "needs a file descriptor"}}) {
        const Ended ended =
            machine.install({"--passphrase-fd", wrong.descriptor, "--binary", QUADRAT_BINARY}, wrong.input);
        EXPECT_EQ(ended.status, 2) << wrong.descriptor;
        EXPECT_THAT(ended.err, HasSubstr(wrong.says));
    }
    EXPECT_EQ(machine.install({"--remove", "--passphrase-fd", "0"}, "a sentence of staff\n").status, 2);
    EXPECT_EQ(machine.files(), before);
}

TEST(Install, LeavesTheSitesOwnSettingsAlone) {
    const Machine machine;
    ASSERT_TRUE(succeeds(machine.install_program()));
    const std::string own = machine.file("etc/quadrat/quadrat.toml") + "# ours\n";
    machine.install({"--remove"});
    ASSERT_TRUE(succeeds(machine.install_program()));
    EXPECT_THAT(machine.file("etc/fstab"), Not(HasSubstr("quadrat"))) << "no partition was named";
}

TEST(Install, RefusesWhatWouldLoseWhatVisitorsDid) {
    const Machine machine;
    const Ended ended = machine.install_program({"--read-only"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, HasSubstr("--read-only needs --data"));
    EXPECT_EQ(machine.install({"--nonsense"}).status, 2);
}

TEST(Install, KeyboardsLoseTheirPowerKeysAfterSystemdHasGivenThemThese) {
    const Machine machine;
    machine.write("usr/lib/udev/rules.d/60-quadrat.rules", "# of an earlier version\n");
    ASSERT_TRUE(succeeds(machine.install_program()));
    std::vector<std::string> ours;
    for (const auto& [name, text] : machine.files())
        if (text.find("TAG-=\"power-switch\"") != std::string::npos) ours.push_back(name);
    ASSERT_THAT(ours, testing::SizeIs(1));
    EXPECT_GT(fs::path(ours.front()).filename(), "70-power-switch.rules");
    EXPECT_FALSE(machine.files().contains("usr/lib/udev/rules.d/60-quadrat.rules"));
}

// A broken partition is worth no black screen. StateDirectory= and its like make systemd require the mount.
TEST(Install, NoServiceRequiresThePartitionOfWhatVisitorsDid) {
    for (const char* name : {"quadrat.service", "quadrat-fleet.service", "quadrat-projector.service"}) {
        const std::string unit = contents_of(QUADRAT_SOURCE_DIR "/deploy/system/" + std::string(name));
        for (const char* requires_it : {"\nStateDirectory=", "\nCacheDirectory=", "\nLogsDirectory=",
                                        "\nWorkingDirectory=", "\nRequires", "\nBindsTo=", "\nRequisite="})
            EXPECT_THAT(unit, Not(HasSubstr(requires_it))) << name;
        EXPECT_THAT(unit, HasSubstr("\nReadWritePaths=-/var/lib/quadrat\n")) << name;
        EXPECT_THAT(unit, HasSubstr("\nWants=var-lib-quadrat.mount\n")) << name;
        EXPECT_THAT(unit, HasSubstr("\nAfter=var-lib-quadrat.mount systemd-tmpfiles-setup.service\n")) << name;
    }
}

TEST(Install, AFreshPartitionBelongsToTheExhibitOnceItIsMounted) {
    const Machine machine;
    ASSERT_TRUE(succeeds(machine.install_program({"--data", "LABEL=quadrat-data"})));
    EXPECT_THAT(machine.file("usr/lib/tmpfiles.d/quadrat.conf"),
                HasSubstr("\nd /var/lib/quadrat 0755 quadrat quadrat -\n"));
    const std::string fstab = machine.file("etc/fstab");
    for (const char* option :
         {",nofail,", ",x-systemd.device-timeout=5s,", ",x-systemd.before=systemd-tmpfiles-setup.service "})
        EXPECT_THAT(fstab, HasSubstr(option));
}

// How much of the machine each could harm, by systemd's own reckoning: 0 nothing, 10 everything.
TEST(Install, EveryServiceIsShutIn) {
    const TemporaryFolder folder;
    int services = 0;
    for (const auto& entry : fs::directory_iterator(QUADRAT_SOURCE_DIR "/deploy/system")) {
        if (entry.path().extension() != ".service") continue;
        ++services;
        // Packages are put in place by root, and come from the network.
        const bool replaces_programs = entry.path().filename() == "quadrat-update.service";
        const Ended ended =
            run({"systemd-analyze", "security", "--offline=true", "--no-pager",
                 std::string("--threshold=") + (replaces_programs ? "30" : "20"), entry.path().string()},
                folder);
        EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
        EXPECT_THAT(ended.out, HasSubstr("Overall exposure level for " + entry.path().filename().string()));
    }
    EXPECT_EQ(services, 8);
    const std::string unit = contents_of(QUADRAT_SOURCE_DIR "/deploy/system/quadrat.service");
    for (const char* line :
         {"ProtectSystem=strict", "NoNewPrivileges=yes", "DevicePolicy=closed", "SystemCallFilter=@system-service",
          "RestrictAddressFamilies=AF_UNIX AF_NETLINK", "WatchdogSec=10", "Type=notify"})
        EXPECT_THAT(unit, HasSubstr(line));
}

// ProtectClock= and @system-service forbid the call by which the kernel is asked; setting the clock takes a capability.
TEST(Install, TheServiceMayReadWhetherTheClockIsSynchronisedAndSetNone) {
    const std::string unit = contents_of(QUADRAT_SOURCE_DIR "/deploy/system/quadrat.service");
    EXPECT_THAT(unit, Not(HasSubstr("\nProtectClock=yes\n")));
    EXPECT_THAT(unit, HasSubstr("\nSystemCallFilter=adjtimex clock_adjtime clock_adjtime64\n"));
    EXPECT_THAT(unit, HasSubstr("\nCapabilityBoundingSet=\n"));
    EXPECT_THAT(unit, Not(HasSubstr("DeviceAllow=char-rtc")));
}

// What the package holds and may run when a newer one is installed: a service that is started once by another is not.
TEST(Install, ANewerPackageStartsWhatRunsAnew) {
    const std::string postinst = contents_of(QUADRAT_SOURCE_DIR "/deploy/system/postinst");
    const std::size_t start = postinst.find("systemctl try-restart ");
    ASSERT_NE(start, std::string::npos);
    const std::string restarts = postinst.substr(start, postinst.find('\n', start) - start);
    for (const std::string& line : lines_of(contents_of(QUADRAT_SOURCE_DIR "/deploy/system/files"))) {
        const std::string name = fs::path(line.substr(line.rfind(' ') + 1)).filename().string();
        if (!line.starts_with("program ") || !(name.ends_with(".service") || name.ends_with(".path"))) continue;
        const std::string unit = contents_of(QUADRAT_SOURCE_DIR "/deploy/system/" + name);
        if (unit.find("\n[Install]\n") != std::string::npos) {
            EXPECT_THAT(restarts, HasSubstr(" " + name));
        }
    }
}

}  // namespace
