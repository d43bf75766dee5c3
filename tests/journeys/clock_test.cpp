// SPDX-License-Identifier: Apache-2.0
// An exhibit that opens and closes by the clock, with a kernel that says what the test wants of it.
#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

// A service's folders, the exhibit in them, and its zone.
class AnExhibitWithHours : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::create_directories(folder / "run");
        ::setenv("RUNTIME_DIRECTORY", (folder / "run").c_str(), 1);
        ::setenv("CLOCK_IS", "synchronised", 1);
        ::setenv("TZ", (folder / "zone").c_str(), 1);
        zone_becomes("Etc/UTC");
    }
    void TearDown() override {
        for (const char* name : {"RUNTIME_DIRECTORY", "CLOCK_IS", "TZ"}) ::unsetenv(name);
    }
    void zone_becomes(const char* name) const {
        std::filesystem::create_symlink(std::string("/usr/share/zoneinfo/") + name, folder / "next");
        std::filesystem::rename(folder / "next", folder / "zone");
    }
    void opens(const std::string& span) const {
        std::string text = "[picture]\nland_samples = 65\n[hours]\ncard_s = 1\n";
        for (const char* day : {"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"})
            text.append(day).append(" = \"").append(span).append("\"\n");
        folder.write("quadrat.toml", text);
    }
    std::unique_ptr<Process> exhibit() const {
        ::setenv("LD_PRELOAD", QUADRAT_KERNEL_CLOCK, 1);
        auto started = std::make_unique<Process>(
            program({"run", "--config", "quadrat.toml", "--display", "headless", "--size", "160x90", "--input",
                     "script:" + folder.write("visit.script", "wait 600s\n").string(), "--state", "state", "--seed",
                     "5", "--speed", "1.001"}),
            folder.path());
        ::unsetenv("LD_PRELOAD");
        return started;
    }
    Ended looked_at_by(const std::vector<std::string>& command) const {
        ::setenv("LD_PRELOAD", QUADRAT_KERNEL_CLOCK, 1);
        Ended ended = run(program(command), elsewhere);
        ::unsetenv("LD_PRELOAD");
        return ended;
    }
    std::string log() const { return contents_of(folder / "stderr.txt"); }
    template <typename HasCome>
    testing::AssertionResult comes(const HasCome& has_come) const {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{60};
        while (std::chrono::steady_clock::now() < until) {
            if (has_come()) return testing::AssertionSuccess();
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
        }
        return testing::AssertionFailure() << "it has not come within a minute: " << log();
    }
    testing::AssertionResult is_logged(const std::string& what) const {
        return comes([&] { return log().find(what) != std::string::npos; });
    }
    nlohmann::json health() const {
        return nlohmann::json::parse(contents_of(folder / "run/health.json"), nullptr, false);
    }
    // An hour's span, so many hours from now in UTC.
    static std::string hour_from_now(int ahead) {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        const long hour = std::chrono::duration_cast<std::chrono::hours>(now).count() + ahead;
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), "%02ld:00-%02ld:00", hour % 24, (hour + 1) % 24);
        return text.data();
    }
    TemporaryFolder folder, elsewhere;
};

TEST_F(AnExhibitWithHours, ThatIsClosedTellsSoInHealthAndToWhoeverAsksForAPicture) {
    opens(hour_from_now(4));
    const auto running = exhibit();
    ASSERT_TRUE(is_logged("closed: the screen is switched off"));
    EXPECT_TRUE(comes([&] { return health().is_object() && health()["screen"] == "dark"; }));
    EXPECT_EQ(health()["open"], false);
    EXPECT_EQ(health()["verdict"], "good");
    EXPECT_EQ(health()["clock"]["trusted"], true);
    EXPECT_EQ(health()["clock"]["source"], "synchronised");
    EXPECT_THAT(health()["opening"].get<std::string>(), HasSubstr("closed until "));
    for (const char* line : {"quadrat_open 0\n", "quadrat_screen_failed 0\n", "quadrat_screen_up 0\n"})
        EXPECT_TRUE(comes([&] { return contents_of(folder / "run/quadrat.prom").find(line) != std::string::npos; }))
            << line;
    const auto begun = std::chrono::steady_clock::now();
    const Ended shot = run(program({"shot", "-o", "now.png"}), elsewhere);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds{9}) << "it answers";
    EXPECT_EQ(shot.status, 2);
    EXPECT_THAT(shot.err, HasSubstr("is closed until "));
    EXPECT_FALSE(std::filesystem::exists(elsewhere / "now.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "run/picture.asked"));
    EXPECT_THAT(run(program({"doctor", "--only", "service"}), elsewhere).out,
                HasSubstr("its screen is dark as planned: closed until "));
    opens("00:00-24:00");
    ASSERT_TRUE(is_logged("hours: open"));
    const Ended again = run(program({"shot", "-o", "now.png"}), elsewhere);
    EXPECT_TRUE(succeeds(again)) << "what was refused is no answer to the next";
    running->kill(SIGTERM);
    EXPECT_TRUE(succeeds(running->wait()));
}

TEST_F(AnExhibitWithHours, OpensAsSoonAsItsZoneIsSet) {
    opens(hour_from_now(9));  // now, in Tokyo
    const auto running = exhibit();
    ASSERT_TRUE(is_logged("closed: the screen is switched off"));
    zone_becomes("Asia/Tokyo");
    EXPECT_TRUE(is_logged("hours: open"));
    EXPECT_THAT(log(), HasSubstr("Asia/Tokyo (JST, UTC+09:00), synchronised"));
    running->kill(SIGTERM);
    EXPECT_TRUE(succeeds(running->wait()));
}

TEST_F(AnExhibitWithHours, FollowsThemOnlyWithAClockThatIsTrustedAndSaysSo) {
    ::setenv("CLOCK_IS", "on its own", 1);
    opens(hour_from_now(4));
    const Ended doubtful = looked_at_by({"doctor", "--only", "clock", "--config", (folder / "quadrat.toml").string(),
                                         "--state", (folder / "state").string()});
    EXPECT_EQ(doubtful.status, 3);
    EXPECT_THAT(doubtful.out, HasSubstr("nothing keeps it right: nothing synchronises it"));
    EXPECT_THAT(doubtful.out, Not(HasSubstr("it can be trusted")));
    const auto running = exhibit();
    ASSERT_TRUE(comes([&] { return health().is_object(); }));
    EXPECT_EQ(health()["open"], true);
    EXPECT_EQ(health()["verdict"], "doubtful");
    EXPECT_EQ(health()["clock"]["trusted"], false);
    EXPECT_THAT(log(), HasSubstr("not trusted: nothing synchronises it"));
    EXPECT_THAT(log(), Not(HasSubstr("hours: clos")));
    running->kill(SIGTERM);
    EXPECT_TRUE(succeeds(running->wait()));
}

TEST_F(AnExhibitWithHours, KeepsTheLastTimeThatItTrusted) {
    opens("00:00-24:00");
    const auto running = exhibit();
    EXPECT_TRUE(comes([&] { return contents_of(folder / "state/clock.seen").find(" UTC") != std::string::npos; }));
    running->kill(SIGKILL);
    const Ended good = looked_at_by({"doctor", "--only", "clock", "--config", (folder / "quadrat.toml").string()});
    EXPECT_EQ(good.status, 0);
    EXPECT_THAT(good.out, HasSubstr("Etc/UTC (UTC, UTC+00:00): it can be trusted (synchronised); open for good"));
}

}  // namespace
