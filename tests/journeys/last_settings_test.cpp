// SPDX-License-Identifier: Apache-2.0
// A slip in the settings never leaves a dark screen: the exhibit as a service starts all the same, and says why.
#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "support/effort.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

// An installed exhibit's folders. Its clock runs twenty times as fast, so that a minute is three seconds.
class Installed {
  public:
    Installed() {
        std::filesystem::create_directories(folder / "run");
        ::setenv("RUNTIME_DIRECTORY", (folder / "run").c_str(), 1);
        folder.write("quiet.script", "wait 900s\n");
    }
    ~Installed() { ::unsetenv("RUNTIME_DIRECTORY"); }
    void settings(const std::string& toml) const { folder.write("quadrat.toml", toml); }
    std::vector<std::string> command() const {
        return program({"run", "--service", "--config", "quadrat.toml", "--display", "headless", "--size", "160x90",
                        "--input", "script:quiet.script", "--state", "state", "--seed", "5", "--speed", "20"});
    }
    std::string log() const { return contents_of(folder / "stderr.txt"); }
    nlohmann::json health() const {
        return nlohmann::json::parse(contents_of(folder / "run/health.json"), nullptr, false);
    }
    template <typename HasCome>
    void wait_until(Process& exhibit, const char* what, const HasCome& has_come) const {
        const auto begun = std::chrono::steady_clock::now();
        while (exhibit.is_running() && !has_come()) {
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
            if (std::chrono::steady_clock::now() - begun < std::chrono::seconds{kIsSanitized ? 300 : 120}) continue;
            ADD_FAILURE() << what << " has not come: " << log();
            return;
        }
        EXPECT_TRUE(exhibit.is_running()) << log();
    }
    void wait_for_log(Process& exhibit, const char* what) const {
        wait_until(exhibit, what, [&] { return log().find(what) != std::string::npos; });
    }
    void wait_for_settings_of(Process& exhibit, const char* from) const {
        wait_until(exhibit, from, [&] {
            const auto told = health();
            return told.is_object() && told["settings"]["from"] == from;
        });
    }
    // Written after the health that is told beside it.
    void wait_for_metric(Process& exhibit, const char* sample) const {
        wait_until(exhibit, sample,
                   [&] { return contents_of(folder / "run/quadrat.prom").find(sample) != std::string::npos; });
    }
    void end(Process& exhibit) const {
        exhibit.kill(SIGTERM);
        EXPECT_TRUE(succeeds(exhibit.wait()));
        for (const char* told : {"run/health.json", "run/quadrat.prom"}) std::filesystem::remove(folder / told);
    }
    TemporaryFolder folder;
};

const std::string kRight = "[picture]\nland_samples = 65\n[visit]\nrounds = 3\n";

TEST(LastSettings, AreKeptAfterAMinuteAndUsedWhenTheFileIsWrongEmptyCutOrGone) {
    const Installed exhibit;
    exhibit.settings(kRight);
    {
        Process first(exhibit.command(), exhibit.folder.path());
        exhibit.wait_for_log(first, "kept as the last that worked");
        exhibit.end(first);
    }
    EXPECT_EQ(contents_of(exhibit.folder / "state/last-good.toml"), kRight);
    for (const char* toml : {"[visit]\nrounds = 300\n", "", "[picture]\nland_samp", "gone"}) {
        exhibit.settings(toml);
        if (std::string(toml) == "gone") std::filesystem::remove(exhibit.folder / "quadrat.toml");
        Process next(exhibit.command(), exhibit.folder.path());
        exhibit.wait_for_settings_of(next, "last good");
        EXPECT_EQ(exhibit.health()["settings"]["mistakes"][0]["file"], "quadrat.toml") << toml;
        EXPECT_EQ(exhibit.health()["verdict"], "doubtful") << toml;
        exhibit.wait_for_metric(next, "quadrat_settings_up 0\n");
        EXPECT_THAT(exhibit.log(), HasSubstr("the last settings that worked are used"));
        exhibit.end(next);
    }
    EXPECT_EQ(contents_of(exhibit.folder / "state/last-good.toml"), kRight) << "what is wrong is never kept";
}

TEST(LastSettings, WithoutAnyTheDefaultsAreUsedAndWhoCorrectsTheFileIsHeard) {
    const Installed exhibit;
    exhibit.settings("[visit]\nrounds = 300\n");
    Process first(exhibit.command(), exhibit.folder.path());
    exhibit.wait_for_settings_of(first, "defaults");
    const auto mistake = exhibit.health()["settings"]["mistakes"][0];
    EXPECT_EQ(mistake["line"], 2);
    EXPECT_EQ(mistake["what"], "visit.rounds is 300");
    EXPECT_EQ(mistake["remedy"], "it must lie between 1 and 50");
    EXPECT_THAT(exhibit.log(), HasSubstr("quadrat.toml:2: visit.rounds is 300; it must lie between 1 and 50"));
    exhibit.settings("[visit]\nrounds = 4\n");
    exhibit.wait_for_settings_of(first, "file");
    EXPECT_TRUE(exhibit.health()["settings"]["mistakes"].empty());
    exhibit.wait_for_metric(first, "quadrat_settings_up 1\n");
    exhibit.end(first);
}

TEST(LastSettings, AFileThatTurnsBadWhileItRunsChangesNothingButWhatIsSaid) {
    const Installed exhibit;
    exhibit.settings(kRight);
    Process running(exhibit.command(), exhibit.folder.path());
    exhibit.wait_for_settings_of(running, "file");
    for (const char* toml : {"", "[visit]\nrounds = 300\n", "[visit]\nroun", "gone"}) {
        exhibit.settings(toml);
        if (std::string(toml) == "gone") std::filesystem::remove(exhibit.folder / "quadrat.toml");
        exhibit.wait_until(running, "the mistake", [&] {
            const auto told = exhibit.health();
            return told.is_object() && !told["settings"]["mistakes"].empty();
        });
        EXPECT_THAT(exhibit.log(), HasSubstr("the exhibit goes on as it was")) << toml;
        EXPECT_EQ(exhibit.health()["settings"]["from"], "file");
        exhibit.settings(kRight);
        exhibit.wait_until(running, "the settings again", [&] {
            const auto told = exhibit.health();
            return told.is_object() && told["settings"]["mistakes"].empty();
        });
    }
    exhibit.end(running);
}

TEST(LastSettings, AScreenThatCannotBeOpenedIsASlipTooForAServiceAndARefusalForPeople) {
    const Installed exhibit;
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(variable);
    exhibit.settings("[screen]\ndisplay = \"window\"\n[picture]\nland_samples = 65\n");
    std::filesystem::create_directory(exhibit.folder / "state");
    exhibit.folder.write("state/last-good.toml", "[screen]\ndisplay = \"headless\"\n[picture]\nland_samples = 65\n");
    auto command = exhibit.command();
    command.erase(std::ranges::find(command, "--display"), std::ranges::find(command, "--size"));
    {
        Process service(command, exhibit.folder.path());
        exhibit.wait_for_settings_of(service, "last good");
        EXPECT_THAT(exhibit.health()["settings"]["mistakes"][0]["what"].get<std::string>(), HasSubstr("DISPLAY"));
        exhibit.end(service);
    }
    ::unsetenv("RUNTIME_DIRECTORY");
    std::erase(command, "--service");
    const Ended people = run(command, exhibit.folder);
    EXPECT_TRUE(ends_with(people, 2));
    ::setenv("RUNTIME_DIRECTORY", (exhibit.folder / "run").c_str(), 1);
}

}  // namespace
