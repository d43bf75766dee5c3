// SPDX-License-Identifier: Apache-2.0
// A version comes from the site's own signed repository, is watched, and goes where the exhibit does worse with it:
// deploy/repository, apt, dpkg and quadrat-update as they are, on a machine that is a folder; the exhibit on it is a
// script that does as its version does.
#include <gmock/gmock.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "journeys/quadrat_program.hpp"

namespace {

namespace fs = std::filesystem;
using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

// What a version is like: "well", "bad" (it says so), "dies" (it is started again and again), "mute", "unready" (it
// cannot be configured).
constexpr const char* kMake = R"sh(set -eu
version=$1 how=$2
rm -rf deb && mkdir -p deb/DEBIAN deb/usr/bin
printf 'Package: quadrat\nVersion: %s\nArchitecture: amd64\nMaintainer: a test\nDescription: a test\n' $version >deb/DEBIAN/control
[ $how != unready ] || { printf '#!/bin/sh\nexit 1\n' >deb/DEBIAN/preinst; chmod 755 deb/DEBIAN/preinst; }
printf '#!/bin/sh\necho %s\n' $how >deb/usr/bin/how
chmod 755 deb/usr/bin/how
dpkg-deb --root-owner-group -b deb quadrat_$version.deb >/dev/null
)sh";

constexpr const char* kSystemctl = R"sh(#!/bin/sh
run=$QUADRAT_ROOT/run/quadrat
case "$*" in
    *is-active*) [ -e $run/active ] ;;
    stop*) rm -f $run/active $run/health.json ;;
    start*) : >$run/active; echo 0 >$run/restarts ;;
    *NRestarts*)
        how=$($QUADRAT_ROOT/usr/bin/how) verdict=good
        [ $how != bad ] || verdict=bad
        [ $how != dies ] || echo $(($(cat $run/restarts) + 1)) >$run/restarts
        [ $how = mute ] || printf '{\n "mode": "usual",\n "verdict": "%s"\n}\n' $verdict >$run/health.json
        cat $run/restarts ;;
esac
)sh";

constexpr const char* kQuadrat = R"sh(#!/bin/sh
case "$*" in
    doctor*) exit "$(cat $QUADRAT_ROOT/doctor 2>/dev/null || echo 0)" ;;
    *--backup*) for last; do :; done; echo backup >"$last" ;;
    *--restore*) echo restored >>$QUADRAT_ROOT/restored; rm -f $QUADRAT_ROOT/doctor ;;
esac
)sh";

// Pulls the plug in the midst of dpkg, once, where the file says so.
constexpr const char* kDpkg = R"sh(#!/bin/bash
if [ -e $QUADRAT_ROOT/cut ] && [ "${*: -2:1}" = -i ]; then
    rm $QUADRAT_ROOT/cut
    /usr/bin/dpkg --unpack "${@: -1}" >/dev/null
    kill -9 $PPID
    exit 1
fi
exec /usr/bin/dpkg "$@"
)sh";

class Updates : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* tool : {"reprepro", "gpg", "apt-get", "dpkg-deb"})
            if (std::system((std::string("command -v ") + tool + " >/dev/null").c_str()) != 0)
                GTEST_SKIP() << tool << " is not installed";
        if (::geteuid() != 0) GTEST_SKIP() << "packages are installed by root alone";
        for (const char* name : {"root/etc/apt/sources.list.d", "root/etc/apt/apt.conf.d", "root/etc/apt/preferences.d",
                                 "root/var/lib/dpkg/info", "root/var/lib/dpkg/updates",
                                 "root/var/lib/apt/lists/partial", "root/var/cache/apt/archives/partial",
                                 "root/run/quadrat", "root/var/lib/quadrat", "root/usr/bin", "bin", "gnupg"})
            fs::create_directories(folder / name);
        fs::permissions(folder / "gnupg", fs::perms::owner_all);
        folder.write("root/var/lib/dpkg/status", "");
        folder.write("root/var/lib/dpkg/available", "");
        folder.write("make", kMake);
        tool("systemctl", kSystemctl);
        tool("quadrat", kQuadrat);
        tool("dpkg", kDpkg);
        folder.write("apt.conf", "Dir \"" + (folder / "root").string() + "\";\nDir::State::status \"" +
                                     (folder / "root/var/lib/dpkg/status").string() +
                                     "\";\nAPT::Sandbox::User \"root\";\nAPT::Architecture \"amd64\";\n");
        make("1.0", "well");
        const Ended made = in_shell("'" QUADRAT_SOURCE_DIR "/deploy/repository' repo --new-key Museum quadrat_1.0.deb");
        ASSERT_EQ(made.status, 0) << made.out << made.err;
        in_shell(
            "sed 's|https://museum.example/quadrat|file://'$PWD'/repo/public|; "
            "s|/usr/share/keyrings|'$PWD'/repo/public|' "
            "repo/public/quadrat.sources >root/etc/apt/sources.list.d/quadrat.sources");
        ASSERT_EQ(in_shell("dpkg -i quadrat_1.0.deb && systemctl start quadrat").status, 0);
        in_shell("systemctl show -p NRestarts");
    }
    void tool(const std::string& name, const char* script) const {
        folder.write("bin/" + name, script);
        fs::permissions(folder / ("bin/" + name), fs::perms::owner_all);
    }
    Ended in_shell(const std::string& command) const {
        return run({"bash", "-c",
                    "export QUADRAT_ROOT=$PWD/root DPKG_ROOT=$PWD/root DPKG_FORCE=not-root,script-chrootless "
                    "APT_CONFIG=$PWD/apt.conf PATH=$PWD/bin:$PATH "
                    "QUADRAT_UPDATE_PATIENCE=5 QUADRAT_UPDATE_WELL_FOR=2 GNUPGHOME=$PWD/gnupg\n" +
                        command},
                   folder);
    }
    void make(const std::string& version, const std::string& how) const {
        const Ended ended = in_shell("bash make " + version + " " + how);
        ASSERT_EQ(ended.status, 0) << ended.err;
    }
    void publish(const std::string& version, const std::string& how) const {
        make(version, how);
        const Ended ended = in_shell("'" QUADRAT_SOURCE_DIR "/deploy/repository' repo quadrat_" + version + ".deb");
        ASSERT_EQ(ended.status, 0) << ended.out << ended.err;
    }
    // With no more rights than its service has.
    static std::string update_command() {
        const std::string unit = contents_of(QUADRAT_SOURCE_DIR "/deploy/system/quadrat-update.service");
        constexpr std::string_view kKey = "\nCapabilityBoundingSet=";
        const std::size_t from = unit.find(kKey) + kKey.size();
        std::string rights = unit.substr(from, unit.find('\n', from) - from);
        for (std::size_t at = 0; (at = rights.find("CAP_", at)) != std::string::npos;) rights.replace(at, 4, "+");
        std::ranges::replace(rights, ' ', ',');
        std::ranges::transform(rights, rights.begin(), [](unsigned char c) { return std::tolower(c); });
        return "setpriv --no-new-privs --bounding-set -all," + rights +
               " '" QUADRAT_SOURCE_DIR "/deploy/system/quadrat-update' ";
    }
    Ended update(const std::string& arguments = "") const { return in_shell(update_command() + arguments); }
    std::string installed() const { return in_shell("dpkg-query -W -f '${Version} ${db:Status-Status}' quadrat").out; }
    bool is_at_rest() const { return !fs::exists(folder / "root/var/lib/quadrat-update/trial"); }
    TemporaryFolder folder;
};

TEST_F(Updates, TakeTheNewestThatDoesWellAndKeepTheOneBefore) {
    EXPECT_THAT(update().out, HasSubstr("1.0 is the newest"));
    publish("1.1", "well");
    EXPECT_THAT(update("--check").out, HasSubstr("installed: 1.0; newest: 1.1"));
    EXPECT_EQ(installed(), "1.0 installed");
    const Ended ended = update();
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("1.1 is well"));
    EXPECT_EQ(installed(), "1.1 installed");
    EXPECT_TRUE(is_at_rest());
    EXPECT_EQ(update("--back").status, 0);
    EXPECT_EQ(installed(), "1.0 installed");
    EXPECT_THAT(update().out, HasSubstr("1.1 was tried and did worse; 1.0 stays"));
}

TEST_F(Updates, GoBackByThemselvesFromWhatDoesWorse) {
    int minor = 1;
    for (const auto& [how, says] : {std::pair{"bad", "it says that something is wrong"},
                                    {"dies", "it was started again"},
                                    {"mute", "it has not said how it is"},
                                    {"unready", "it cannot be installed"}}) {
        const std::string version = "1." + std::to_string(minor++);
        publish(version, how);
        const Ended ended = update();
        EXPECT_EQ(ended.status, 1) << how << ended.out << ended.err;
        EXPECT_THAT(ended.out, HasSubstr(says)) << how;
        EXPECT_EQ(installed(), "1.0 installed") << how;
        EXPECT_TRUE(is_at_rest()) << how;
        EXPECT_TRUE(fs::exists(folder / "root/run/quadrat/active")) << how << ": it runs again";
        EXPECT_THAT(update().out, HasSubstr(version + " was tried and did worse")) << how;
    }
    publish("2.0", "well");
    EXPECT_EQ(update().status, 0);
    EXPECT_EQ(installed(), "2.0 installed");
}

TEST_F(Updates, PutBackAStateThatTheVersionBeforeCannotRead) {
    publish("1.1", "bad");
    folder.write("root/doctor", "4");
    EXPECT_EQ(update().status, 1);
    EXPECT_EQ(contents_of(folder / "root/restored"), "restored\n");
    EXPECT_EQ(installed(), "1.0 installed");
}

TEST_F(Updates, GoOnAfterThePlugWasPulledInTheMidst) {
    publish("1.1", "well");
    folder.write("root/cut", "");
    EXPECT_NE(update().status, 0);
    EXPECT_EQ(installed(), "1.1 unpacked") << "neither here nor there";
    EXPECT_FALSE(is_at_rest());
    const Ended resumed = update("--resume");
    EXPECT_EQ(resumed.status, 0) << resumed.out << resumed.err;
    EXPECT_EQ(installed(), "1.1 installed");
    EXPECT_TRUE(is_at_rest());
    // On the way back, too.
    publish("1.2", "bad");
    EXPECT_EQ(in_shell("(sleep 1.5; touch root/cut) & " + update_command()).status == 0, false);
    for (int i = 0; i < 3 && !is_at_rest(); ++i) update("--resume");
    EXPECT_TRUE(is_at_rest());
    EXPECT_EQ(installed(), "1.1 installed");
    EXPECT_THAT(update("--resume").out, HasSubstr("nothing was interrupted"));
}

TEST_F(Updates, EndWithOneOfTheTwoWheneverThePlugIsPulled) {
    int minor = 1;
    for (const int after_ms : {100, 300, 500, 800, 1200, 2000}) {
        const std::string version = "1." + std::to_string(minor++);
        publish(version, "well");
        in_shell("timeout -s KILL " + std::to_string(after_ms / 1000.0) + " " + update_command());
        for (int i = 0; i < 3 && !is_at_rest(); ++i) update("--resume");
        EXPECT_TRUE(is_at_rest()) << after_ms;
        EXPECT_THAT(installed(), HasSubstr(" installed")) << after_ms;
        const Ended ended = update();
        EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
        EXPECT_EQ(installed(), version + " installed") << after_ms;
    }
}

TEST_F(Updates, BlameAVersionWithWhichTheMachineStartsAgainAndAgain) {
    publish("1.1", "well");
    folder.write("root/cut", "");
    update();
    for (int i = 0; i < 4 && !is_at_rest(); ++i) in_shell("timeout -s KILL 0.7 " + update_command() + "--resume");
    EXPECT_EQ(update("--resume").out.find("1.1 is well"), std::string::npos);
    for (int i = 0; i < 3 && !is_at_rest(); ++i) update("--resume");
    EXPECT_EQ(installed(), "1.0 installed");
}

TEST_F(Updates, TakeNothingThatIsNotSignedByTheSite) {
    publish("1.1", "well");
    in_shell("sed -i s/1.1/6.6/ repo/public/dists/quadrat/InRelease");
    const Ended forged = update();
    EXPECT_EQ(forged.status, 2) << forged.out;
    EXPECT_THAT(forged.err, HasSubstr("the repository cannot be used"));
    EXPECT_EQ(installed(), "1.0 installed");
    EXPECT_EQ(in_shell("echo x >>repo/public/pool/main/q/quadrat/quadrat_1.1_amd64.deb; "
                       "GNUPGHOME=repo/key reprepro -b repo/base --silent export")
                  .status,
              0);
    const Ended swapped = update();
    EXPECT_EQ(swapped.status, 2) << swapped.out;
    EXPECT_THAT(swapped.err, HasSubstr("1.1 cannot be fetched. Nothing was changed"));
    EXPECT_EQ(installed(), "1.0 installed");
    EXPECT_TRUE(is_at_rest());
}

TEST_F(Updates, SayWhatIsWrongInOneLine) {
    EXPECT_EQ(update("--now").status, 2);
    EXPECT_THAT(update("--back").err, HasSubstr("no version before is kept"));
    fs::remove(folder / "root/etc/apt/sources.list.d/quadrat.sources");
    EXPECT_THAT(update().err, HasSubstr("quadrat.sources is missing"));
    const auto repository = [&](const std::string& arguments) {
        return in_shell("'" QUADRAT_SOURCE_DIR "/deploy/repository' " + arguments);
    };
    EXPECT_EQ(repository("").status, 2);
    EXPECT_THAT(repository("new quadrat_1.0.deb").err, HasSubstr("is new: name the key that signs it"));
    EXPECT_THAT(repository("new --key nobody").err, HasSubstr("there is no such key of yours"));
    EXPECT_THAT(repository("repo --key x").err, HasSubstr("is signed already"));
    EXPECT_THAT(repository("repo nowhere.deb").err, HasSubstr("there is no such file"));
    EXPECT_THAT(repository("repo make").err, HasSubstr("is no Debian package"));
    make("0.9", "well");
    EXPECT_THAT(repository("repo quadrat_0.9.deb").err, HasSubstr("0.9 is not newer than 1.0"));
    EXPECT_THAT(repository("repo quadrat_1.0.deb").out, HasSubstr("is there already"));
}

}  // namespace
