// SPDX-License-Identifier: Apache-2.0
// A projector follows the exhibit beside it; and what staff learn when it does not.
#include <gmock/gmock.h>

#include <csignal>
#include <fstream>

#include "journeys/fleet.hpp"
#include "support/fake_projector.hpp"

namespace {

using namespace quadrat::tests;
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class ProjectorsRoom : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"state", "exhibit", "keeper"}) fs::create_directory(folder / name);
        folder.write("visit.script", "wait 3000s\n");
        folder.write("password", "JBMIAProjectorLink\n");
        configure(projector.address(), "password");
    }
    void configure(const std::string& power, const std::string& password) const {
        folder.write("quadrat.toml", "[picture]\nland_samples = 65\n[hours]\ncard_s = 1\n[screen]\npower = \"" + power +
                                         "\"\npower_password_file = \"" + path(password) + "\"\n");
    }
    std::string path(const std::string& name) const { return name.empty() ? "" : (folder / name).string(); }
    std::unique_ptr<Process> exhibit() const {
        return std::make_unique<Process>(
            program({"run", "--config", path("quadrat.toml"), "--display", "headless", "--size", "64x64", "--input",
                     "script:" + path("visit.script"), "--state", path("state"), "--seed", "5", "--speed", "1.001"}),
            folder / "exhibit");
    }
    std::vector<std::string> words(std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"projector", "--config", path("quadrat.toml"), "--state", path("state")};
        all.insert(all.end(), more.begin(), more.end());
        return program(all);
    }
    std::string said() const { return contents_of(folder / "keeper/stderr.txt"); }
    bool health_says(const std::string& what) const {
        // Whoever looks asks for the health of that moment.
        std::ofstream(folder / "state/health.asked");
        return contents_of(folder / "state/health.json").find(what) != std::string::npos;
    }

    TemporaryFolder folder, elsewhere;
    FakeProjector projector{"JBMIAProjectorLink"};
};

TEST_F(ProjectorsRoom, IsLitWhileTheExhibitShowsAndDarkOnStandBy) {
    const auto shows = exhibit();
    Process keeper(words(), folder / "keeper");
    EXPECT_TRUE(comes_true([&] { return projector.power() == '1'; })) << said();
    EXPECT_TRUE(comes_true([&] { return health_says("\"power\": \"on\""); }));
    folder.write("state/standby", "");
    EXPECT_TRUE(comes_true([&] { return projector.power() == '0'; })) << said();
    fs::remove(folder / "state/standby");
    EXPECT_TRUE(comes_true([&] { return projector.power() == '1'; })) << said();
    keeper.kill(SIGTERM);
    EXPECT_TRUE(succeeds(keeper.wait()));
    EXPECT_EQ(projector.power(), '1') << "an update's restart costs no lamp";
    EXPECT_FALSE(fs::exists(folder / "state/projector.json"));
}

TEST_F(ProjectorsRoom, IsToldOfOnceWhereItIsInTroubleAndTheShowGoesOn) {
    folder.write("password", "another\n");
    const auto shows = exhibit();
    Process keeper(words(), folder / "keeper");
    EXPECT_TRUE(comes_true([&] { return health_says("the projector refuses our password"); })) << said();
    EXPECT_TRUE(health_says("\"verdict\": \"doubtful\"")) << contents_of(folder / "state/health.json");
    const Ended doctor =
        run(program({"doctor", "--only", "projector", "--config", path("quadrat.toml"), "--state", path("state")}),
            elsewhere);
    EXPECT_EQ(doctor.status, 3);
    EXPECT_THAT(doctor.out, HasSubstr("refuses our password"));
    EXPECT_THAT(doctor.out, HasSubstr("screen.power_password_file"));
    const int tried = projector.visits();
    EXPECT_TRUE(comes_true([&] { return projector.visits() >= tried + 2; })) << "it is tried again";
    EXPECT_EQ(count_of(said(), "refuses our password"), 1U) << said();
    EXPECT_THAT(said(), Not(HasSubstr("another")));
    EXPECT_TRUE(health_says("\"screen\": \"shows\""));
}

TEST_F(ProjectorsRoom, IsSwitchedAndAskedByHand) {
    const Ended on = run(words({"--turn", "on"}), elsewhere);
    EXPECT_TRUE(succeeds(on));
    EXPECT_EQ(on.out, "on\n");
    projector.set_ailments("000010");
    EXPECT_EQ(run(words({"--ask"}), elsewhere).out, "on; it reports filter: warning\n");
    projector.behave(FakeProjector::Manner::HangsUp);
    const Ended gone = run(words({"--ask"}), elsewhere);
    EXPECT_EQ(gone.status, 2);
    EXPECT_THAT(gone.err, HasSubstr("it hangs up; look at its network cable"));
    const Ended doctor =
        run(program({"doctor", "--only", "projector", "--config", path("quadrat.toml"), "--state", path("state")}),
            elsewhere);
    EXPECT_EQ(doctor.status, 3);
    EXPECT_THAT(doctor.out, HasSubstr("it hangs up"));
}

TEST_F(ProjectorsRoom, ThatHasNoneEndsAndSaysSo) {
    folder.write("quadrat.toml", "[screen]\ndisplay = \"auto\"\n");
    const Ended ended = run(words(), elsewhere);
    EXPECT_TRUE(succeeds(ended));
    EXPECT_THAT(ended.err, HasSubstr("screen.power is empty"));
    folder.write("quadrat.toml", "[screen]\npower = \"hdmi\"\n");
    const Ended wrong = run(words(), elsewhere);
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, HasSubstr("quadrat.toml:2: screen.power is \"hdmi\": it is neither CEC nor PJLink"));
}

}  // namespace
