// SPDX-License-Identifier: Apache-2.0
// The staff's guide: each of its commands is tried somewhere, or it is written down why not.
#include <gmock/gmock.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "journeys/quadrat_program.hpp"

namespace {

namespace fs = std::filesystem;
using namespace quadrat::tests;

struct Command {
    std::string where;
    std::string ends_with;  // statuses, or why it is never tried
    std::string text;
};

std::vector<Command> listed_commands() {
    std::vector<Command> commands;
    for (const std::string& line : lines_of(contents_of(QUADRAT_SOURCE_DIR "/tests/journeys/guide_commands.txt"))) {
        static const std::regex row(R"((here|machine|scripted|never) (.+?) \| (.+))");
        std::smatch parts;
        if (line.starts_with("#")) continue;
        EXPECT_TRUE(std::regex_match(line, parts, row)) << line;
        commands.push_back({parts[1], parts[2], parts[3]});
    }
    return commands;
}

// Indented lines, and what stands between backticks and begins with a program that staff type.
std::set<std::string> commands_of_the_guide() {
    std::set<std::string> commands;
    std::string prose;
    for (const std::string& line : lines_of(contents_of(QUADRAT_SOURCE_DIR "/deploy/README.md"))) {
        const std::size_t start = line.find_first_not_of(' ');
        if (start != std::string::npos && start >= 4)
            commands.insert(line.substr(start));
        else
            prose += line.substr(start == std::string::npos ? line.size() : start) + ' ';
    }
    static const std::regex quoted("`([^`]+)`");
    static const std::regex typed(
        R"((sudo|systemctl|journalctl|coredumpctl|quadrat|timedatectl|df|dmesg|lsblk|findmnt|git|deploy/\w+)( .*)?)");
    for (std::sregex_iterator at(prose.begin(), prose.end(), quoted), end; at != end; ++at) {
        const std::string text = (*at)[1];
        const bool is_a_file = text.starts_with("deploy/") && text.find(' ') == std::string::npos;
        if (std::regex_match(text, typed) && !is_a_file) commands.insert(text);
    }
    return commands;
}

// A machine's folders below one, its programs before the system's; sudo and overlayroot-chroot only run their words.
class Workplace {
  public:
    Workplace() {
        for (const char* name : {"bin", "root/etc/ssh", "root/etc/quadrat", "root/var/lib/dbus", "root/var/lib/quadrat",
                                 "root/run/quadrat"})
            fs::create_directories(folder_ / name);
        write_program("bin/sudo", "while [ \"$1\" = -u ]; do shift 2; done\nexec \"$@\"\n");
        write_program("bin/overlayroot-chroot", "exec \"$@\"\n");
        fs::copy(QUADRAT_SOURCE_DIR "/deploy/quadrat.toml", folder_ / "root/etc/quadrat/quadrat.toml");
        fs::copy(QUADRAT_SOURCE_DIR "/deploy/system/overlayroot.conf", folder_ / "root/etc/overlayroot.local.conf");
        folder_.write("root/etc/hosts", "127.0.0.1 localhost\n127.0.1.1 quadrat-01\n");
        folder_.write("root/etc/hostname", "quadrat-01\n");
        folder_.write("root/etc/machine-id", "0123456789abcdef0123456789abcdef\n");
        folder_.write("root/etc/ssh/ssh_host_ed25519_key", "of the first\n");
    }
    Ended type(std::string text) const {
        static const std::regex folders(R"((^|[ =])(/(etc|var|run)/))");
        text = std::regex_replace(text, folders, "$1" + (folder_ / "root").string() + "$2");
        static const std::regex ours(R"((^| )deploy/)");
        text = std::regex_replace(text, ours, "$1" QUADRAT_SOURCE_DIR "/deploy/");
        const std::string path = (folder_ / "bin").string() + ":" + fs::path(QUADRAT_BINARY).parent_path().string();
        return run({"bash", "-c", "PATH=" + path + ":$PATH; " + text}, folder_);
    }
    std::string file(const std::string& name) const { return contents_of(folder_ / ("root/" + name)); }

  private:
    void write_program(const std::string& name, const std::string& text) const {
        fs::permissions(folder_.write(name, "#!/bin/sh\n" + text), fs::perms::owner_all);
    }
    TemporaryFolder folder_;
};

TEST(Guide, EachOfItsCommandsIsTriedSomewhereOrItIsSaidWhyNot) {
    std::set<std::string> listed;
    for (const Command& command : listed_commands()) listed.insert(command.text);
    const std::set<std::string> told = commands_of_the_guide();
    for (const std::string& command : told) EXPECT_TRUE(listed.contains(command)) << "not listed: " << command;
    for (const std::string& command : listed) EXPECT_TRUE(told.contains(command)) << "not in the guide: " << command;
}

TEST(Guide, WhatTheEmulatedMachinesStoryTriesIsInIt) {
    const std::string story = contents_of(QUADRAT_SOURCE_DIR "/tests/guest/installed.py");
    for (const Command& command : listed_commands())
        if (command.where == "scripted") {
            EXPECT_NE(story.find(command.text), std::string::npos) << command.text;
        }
}

TEST(Guide, CommandsThatNeedNoMachineWorkAsTheyAreWritten) {
    const Workplace workplace;
    for (const Command& command : listed_commands()) {
        if (command.where != "here") continue;
        const Ended ended = workplace.type(command.text);
        std::istringstream allowed(command.ends_with);
        bool is_allowed = false;
        for (std::string status; std::getline(allowed, status, ',');)
            is_allowed |= status == std::to_string(ended.status);
        EXPECT_TRUE(is_allowed) << command.text << '\n' << ended.out << ended.err;
    }
    EXPECT_EQ(workplace.file("etc/hostname"), "quadrat-07\n");
    EXPECT_EQ(workplace.file("etc/hosts"), "127.0.0.1 localhost\n127.0.1.1 quadrat-07\n");
    EXPECT_EQ(workplace.file("etc/machine-id"), "");
    EXPECT_EQ(workplace.file("etc/ssh/ssh_host_ed25519_key"), "");
    EXPECT_THAT(workplace.file("etc/quadrat/quadrat.toml"), testing::HasSubstr("\nname = \"quadrat-07\"\n"));
    EXPECT_THAT(workplace.file("etc/overlayroot.local.conf"), testing::HasSubstr("\noverlayroot=\"disabled\"\n"));
}

}  // namespace
