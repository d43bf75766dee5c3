// SPDX-License-Identifier: Apache-2.0
// What a site has made: held by one exhibit at a time, backed up, restored, and looked into before it is lost.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "journeys/state_database.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

class SiteState : public testing::Test {
  protected:
    void SetUp() override {
        ::unsetenv("RUNTIME_DIRECTORY");
        folder.write("quadrat.toml", "[picture]\nland_samples = 65\n[fleet]\nname = \"Foyer\" # by the door\n");
        folder.write("visit.script", "at 1s press A\nafter 1s press B\nwait 600s\n");
    }
    void TearDown() override { ::unsetenv("RUNTIME_DIRECTORY"); }

    // It runs in real time: a clock at the speed of 1.001.
    std::vector<std::string> exhibit(const std::string& state = "state") const {
        return program({"run", "--config", "quadrat.toml", "--display", "headless", "--size", "64x64", "--input",
                        "script:visit.script", "--state", state, "--seed", "5", "--speed", "1.001"});
    }
    // What a tool says must not replace what the exhibit says in its folder.
    Ended tool(const std::vector<std::string>& arguments) const { return run(program(arguments), elsewhere); }
    std::string at(const std::string& name) const { return (folder / name).string(); }

    void wait_for_log(Process& process, const std::string& what) const {
        const auto begun = std::chrono::steady_clock::now();
        while (contents_of(folder / "stderr.txt").find(what) == std::string::npos) {
            ASSERT_TRUE(process.is_running()) << contents_of(folder / "stderr.txt");
            ASSERT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds{120})
                << what << " has not come: " << contents_of(folder / "stderr.txt");
            std::this_thread::sleep_for(std::chrono::milliseconds{5});
        }
    }
    // A state of one visit that was interrupted.
    void make_state() const {
        Process running(exhibit(), folder.path());
        wait_for_log(running, "the four of round 1 are");
        wait_for_log(running, "press A");
        running.kill(SIGTERM);
        ASSERT_TRUE(succeeds(running.wait()));
        std::filesystem::remove(folder / "stderr.txt");
    }
    // What of the folder is the site's own, but for dated copies.
    std::string state_bytes(const std::string& state) const { return contents_of(folder / (state + "/quadrat.db")); }

    TemporaryFolder folder, elsewhere;
};

TEST_F(SiteState, OfARunningExhibitIsWrittenToByNobodyElse) {
    Process running(exhibit(), folder.path());
    wait_for_log(running, "a new state file");
    folder.write("lesson.json", "[]");
    const std::vector<std::vector<std::string>> writers{
        {"run", "--display", "headless", "--size", "64x64", "--state", at("state"), "--rounds", "1"},
        {"state", "--state", at("state"), "--move-to", "1"},
        {"state", "--state", at("state"), "--restore", at("lesson.json")},
        {"words", "--state", at("state"), "forget", "--yes"},
        {"words", "--state", at("state"), "train"},
        {"doctor", "--calibrate", "--state", at("state")}};
    for (const auto& writer : writers) {
        const Ended refused = tool(writer);
        EXPECT_EQ(refused.status, 2) << writer[0] << refused.err;
        EXPECT_THAT(refused.err, HasSubstr("is in use by the exhibit (process ")) << writer[0];
        EXPECT_THAT(refused.err, HasSubstr("end that first: kill ")) << writer[0];
    }
    EXPECT_EQ(Database(folder / "state/quadrat.db").number("PRAGMA user_version"), 4);
    EXPECT_TRUE(succeeds(tool({"words", "--state", at("state"), "export", "-o", "said.json"})));
    EXPECT_TRUE(succeeds(tool({"words", "--state", at("state"), "show"})));
    EXPECT_THAT(tool({"doctor", "--state", at("state"), "--only", "state"}).out, HasSubstr("in use by the exhibit"));
    EXPECT_TRUE(running.is_running());
    running.kill(SIGKILL);
    running.wait();
    EXPECT_TRUE(succeeds(tool({"state", "--state", at("state"), "--move-to", "3"}))) << "a crash holds nothing";
}

TEST_F(SiteState, IsReportedBesideARunningExhibitInEveryForm) {
    Process running(exhibit(), folder.path());
    wait_for_log(running, "press B");
    const auto report = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"report", "--state", at("state")});
        return tool(more);
    };
    const Ended text = report({});
    ASSERT_TRUE(succeeds(text));
    EXPECT_THAT(text.out, HasSubstr("visits           1\n"));
    EXPECT_THAT(text.out, HasSubstr("left, stuck, cut 0, 0, 1\n"));
    ASSERT_TRUE(succeeds(report({"-o", "visits.html", "--title", "The foyer"})));
    EXPECT_THAT(contents_of(elsewhere / "visits.html"), HasSubstr("<h1>The foyer</h1>"));
    ASSERT_TRUE(succeeds(report({"-o", "visits.csv"})));
    EXPECT_EQ(count_of(contents_of(elsewhere / "visits.csv"), "\r\n"), 2U);
    const Ended json = report({"-o", "-"});
    ASSERT_TRUE(succeeds(json));
    EXPECT_EQ(nlohmann::json::parse(json.out)["all"]["visits"], 1);
    EXPECT_THAT(report({"--from", "2001-01-01", "--to", "2001-12-31"}).out, HasSubstr("no visits"));
    EXPECT_TRUE(running.is_running());

    const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
        {{"--from", "2001-02-30"}, "--from"},
        {{"--from", "2026-02-02", "--to", "2026-01-01"}, "is after"},
        {{"-o", "visits.pdf"}, "visits.pdf"},
        {{"-o", "no/such/visits.html"}, "no/such"},
    };
    for (const auto& [arguments, named] : mistakes) {
        const Ended refused = report(arguments);
        EXPECT_EQ(refused.status, 2) << arguments[1];
        EXPECT_THAT(refused.err, HasSubstr(named));
    }
    EXPECT_EQ(tool({"report", "--state", at("nowhere")}).status, 2);
    running.kill(SIGKILL);
    running.wait();
}

TEST_F(SiteState, TheServiceWaitsForWhoeverHoldsItAndSaysSoOnce) {
    Process holder(exhibit(), folder.path());
    wait_for_log(holder, "a new state file");
    TemporaryFolder service;
    std::filesystem::create_directory(service / "run");
    ::setenv("RUNTIME_DIRECTORY", (service / "run").c_str(), 1);
    service.write("visit.script", "wait 600s\n");
    service.write("quadrat.toml", "[picture]\nland_samples = 65\n");
    Process waiting(exhibit(at("state")), service.path());
    const auto log = [&] { return contents_of(service / "stderr.txt"); };
    while (waiting.is_running() && log().find("the exhibit waits until that ends") == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    std::this_thread::sleep_for(std::chrono::seconds{1});
    EXPECT_TRUE(waiting.is_running());
    EXPECT_EQ(count_of(log(), "\n"), 1U) << "once: " << log();
    EXPECT_FALSE(std::filesystem::exists(service / "run/starts")) << "waiting is no start that could fail";
    holder.kill(SIGKILL);
    holder.wait();
    while (waiting.is_running() && log().find("state file is whole") == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    waiting.kill(SIGTERM);
    EXPECT_TRUE(succeeds(waiting.wait()));
}

TEST_F(SiteState, AServiceThatWaitsEndsWhenItIsTold) {
    Process holder(exhibit(), folder.path());
    wait_for_log(holder, "a new state file");
    TemporaryFolder service;
    ::setenv("RUNTIME_DIRECTORY", service.path().c_str(), 1);
    service.write("visit.script", "wait 600s\n");
    service.write("quadrat.toml", "");
    Process waiting(exhibit(at("state")), service.path());
    while (waiting.is_running() && contents_of(service / "stderr.txt").find("waits") == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    waiting.kill(SIGTERM);
    EXPECT_TRUE(succeeds(waiting.wait()));
    EXPECT_TRUE(holder.is_running());
}

TEST_F(SiteState, IsBackedUpBesideARunningExhibitAndRestoredOntoAnotherMachine) {
    Process running(exhibit(), folder.path());
    wait_for_log(running, "press A");
    wait_for_log(running, "press B");
    const Ended backup =
        tool({"state", "--state", at("state"), "--config", at("quadrat.toml"), "--backup", "site.tar.xz"});
    ASSERT_TRUE(succeeds(backup));
    EXPECT_THAT(backup.out, HasSubstr("state/quadrat.db"));
    EXPECT_THAT(backup.out, HasSubstr("settings/quadrat.toml"));
    EXPECT_TRUE(running.is_running());
    running.kill(SIGTERM);
    running.wait();
    struct stat facts {};
    ASSERT_EQ(::stat((elsewhere / "site.tar.xz").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0600U) << "a password may be in it";
    const Ended restored =
        tool({"state", "--state", at("new"), "--config", at("new.toml"), "--restore", "site.tar.xz"});
    ASSERT_TRUE(succeeds(restored));
    EXPECT_EQ(Database(folder / "new/quadrat.db").number("SELECT count(*) FROM visit"), 1);
    EXPECT_GE(Database(folder / "new/quadrat.db").number("SELECT count(*) FROM generation"), 1);
    EXPECT_EQ(contents_of(folder / "new.toml"), contents_of(folder / "quadrat.toml"));
    EXPECT_EQ(std::filesystem::exists(folder / "new/restoring"), false);
    std::filesystem::remove(folder / "stderr.txt");
    Process there(exhibit("new"), folder.path());
    wait_for_log(there, "taking up visit 1");
    there.kill(SIGTERM);
    EXPECT_TRUE(succeeds(there.wait()));
}

TEST_F(SiteState, ThatIsReplacedByARestoreLiesUnderADatedName) {
    make_state();
    ASSERT_TRUE(
        succeeds(tool({"state", "--state", at("state"), "--config", at("quadrat.toml"), "--backup", "site.tar.xz"})));
    folder.write("state/words.json", "what the site had afterwards");
    folder.write("quadrat.toml", "[visit]\nrounds = 3\n");
    const Ended restored =
        tool({"state", "--state", at("state"), "--config", at("quadrat.toml"), "--restore", "site.tar.xz"});
    ASSERT_TRUE(succeeds(restored));
    EXPECT_THAT(contents_of(folder / "quadrat.toml"), HasSubstr("Foyer"));
    EXPECT_FALSE(std::filesystem::exists(folder / "state/words.json")) << "it was not in the backup";
    std::filesystem::path before;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "state"))
        if (entry.path().filename().string().starts_with("before-restore-")) before = entry.path();
    ASSERT_FALSE(before.empty()) << restored.out;
    EXPECT_THAT(restored.out, HasSubstr(before.filename().string()));
    EXPECT_EQ(contents_of(before / "words.json"), "what the site had afterwards");
    EXPECT_EQ(contents_of(before / "settings/quadrat.toml"), "[visit]\nrounds = 3\n");
    EXPECT_EQ(Database(before / "quadrat.db").number("SELECT count(*) FROM visit"), 1);
}

TEST_F(SiteState, OfACloneHasNoVisitsAndNoNameOfTheFirst) {
    make_state();
    ASSERT_TRUE(
        succeeds(tool({"state", "--state", at("state"), "--config", at("quadrat.toml"), "--backup", "site.tar.xz"})));
    const Ended cloned =
        tool({"state", "--state", at("new"), "--config", at("new.toml"), "--restore", "site.tar.xz", "--clone"});
    ASSERT_TRUE(succeeds(cloned));
    EXPECT_EQ(Database(folder / "new/quadrat.db").number("SELECT count(*) FROM visit"), 0);
    EXPECT_EQ(contents_of(folder / "new.toml"), "[picture]\nland_samples = 65\n[fleet]\nname = \"\" # by the door\n");
    EXPECT_THAT(cloned.out, HasSubstr("stays another"));
}

TEST_F(SiteState, IsUntouchedByABackupThatIsCutOrChangedOrNone) {
    make_state();
    ASSERT_TRUE(succeeds(tool({"state", "--state", at("state"), "--backup", "site.tar.xz"})));
    const std::string whole = contents_of(elsewhere / "site.tar.xz");
    const std::string before = state_bytes("state");
    std::vector<std::string> bad{"", "x", std::string(5000, 'x'), whole.substr(0, 7)};
    for (std::size_t left : {std::size_t{1}, std::size_t{5}, std::size_t{12}, std::size_t{30}, whole.size() / 2})
        bad.push_back(whole.substr(0, whole.size() - left));
    bad.push_back(whole);
    bad.back()[whole.size() / 2] ^= 0x10;
    for (const std::string& bytes : bad) {
        elsewhere.write("bad.tar.xz", bytes);
        const Ended refused = tool({"state", "--state", at("state"), "--restore", "bad.tar.xz"});
        EXPECT_EQ(refused.status, 2) << bytes.size() << " of " << whole.size();
        EXPECT_THAT(refused.err, HasSubstr("bad.tar.xz: ")) << bytes.size();
        EXPECT_EQ(lines_of(refused.err).size(), 1U) << refused.err;
        EXPECT_EQ(state_bytes("state"), before);
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder / "state"))
        EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("restor")));
}

TEST_F(SiteState, OfANewerProgramIsNotRestored) {
    make_state();
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder / "state/quadrat.db").c_str(), &database), SQLITE_OK);
    sqlite3_exec(database, "PRAGMA user_version=99", nullptr, nullptr, nullptr);
    sqlite3_close(database);
    const Ended doctor = tool({"doctor", "--state", at("state"), "--only", "state"});
    EXPECT_EQ(doctor.status, 3);
    EXPECT_THAT(doctor.out, HasSubstr("schema version is 99"));
    const Ended backup = tool({"state", "--state", at("state"), "--backup", "site.tar.xz"});
    EXPECT_EQ(backup.status, 2);
    EXPECT_THAT(backup.err, HasSubstr("schema version is 99"));
    EXPECT_FALSE(std::filesystem::exists(elsewhere / "site.tar.xz"));
}

TEST_F(SiteState, ThatABackupWouldReplaceIsNot) {
    make_state();
    const std::string before = state_bytes("state");
    const Ended refused = tool({"state", "--state", at("state"), "--backup", at("state/quadrat.db")});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("is no backup of Quadrat"));
    EXPECT_EQ(state_bytes("state"), before);
    ASSERT_TRUE(succeeds(tool({"state", "--state", at("state"), "--backup", "site.tar.xz"})));
    EXPECT_TRUE(succeeds(tool({"state", "--state", at("state"), "--backup", "site.tar.xz"}))) << "a backup it may";
}

TEST_F(SiteState, AndALanguageThatAreNotThereAreRefused) {
    EXPECT_EQ(tool({"words", "--state", at("nowhere"), "show"}).status, 2);
    EXPECT_THAT(tool({"words", "--state", at("nowhere"), "show"}).err, HasSubstr("there is no such folder"));
    const Ended tongue = tool({"words", "--language", "tlh", "show"});
    EXPECT_EQ(tongue.status, 2);
    EXPECT_THAT(tongue.err, HasSubstr("ar, de, el, en, es, fr"));
}

TEST_F(SiteState, HoldsNothingThatIsNeitherBackedUpNorTheMachinesOwn) {
    make_state();
    ASSERT_TRUE(succeeds(tool({"state", "--state", at("state"), "--backup", "site.tar.xz"})));
    // Of this machine or of this moment. Whoever adds a file to the state folder decides where it belongs: here, or to
    // the site's files in app/backup/staged.cpp.
    const std::vector<std::string> own{"lock",        "last-good.toml", "clock.seen", "reboots",       "running",
                                       "health.json", "quadrat.prom",   "faults",     "picture.asked", "picture.png"};
    const std::vector<std::string> backed_up{"quadrat.db", "words.json", "words.previous.json", "buttons.map",
                                             "earlier"};
    for (const auto& entry : std::filesystem::directory_iterator(folder / "state")) {
        const std::string name = entry.path().filename().string();
        const bool is_known = std::ranges::find(own, name) != own.end() ||
                              std::ranges::find(backed_up, name) != backed_up.end() || name.starts_with("fault-");
        EXPECT_TRUE(is_known) << name;
    }
}

TEST_F(SiteState, TellsOfTheLastFaultsAfterTheMachineWasSwitchedOff) {
    std::filesystem::create_directory(folder / "run");
    ::setenv("RUNTIME_DIRECTORY", at("run").c_str(), 1);
    Process running(exhibit(), folder.path());
    wait_for_log(running, "the four of round 1 are");
    folder.write("quadrat.toml", "[visit]\nrounds = many\n");
    const auto kept = [&] { return contents_of(folder / "state/faults/faults.json"); };
    while (running.is_running() && kept().find("fault-1.png") == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    running.kill(SIGKILL);
    running.wait();
    std::filesystem::remove_all(folder / "run");
    ::unsetenv("RUNTIME_DIRECTORY");
    const Ended doctor = tool({"doctor", "--state", at("state"), "--only", "state"});
    EXPECT_THAT(doctor.out, HasSubstr("a fault that is kept: 20"));
    EXPECT_THAT(doctor.out, HasSubstr("quadrat.toml:2"));
    EXPECT_THAT(doctor.out, HasSubstr("faults/fault-1.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "state/faults/fault-1.png"));
    EXPECT_EQ(doctor.status, 0) << "it is over";
}

}  // namespace
