// SPDX-License-Identifier: Apache-2.0
// What a house control asks of an exhibit by its broker, and what it is told.
#include <gmock/gmock.h>

#include <csignal>

#include "journeys/fleet.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

class AHouseControl : public AFleet {
  protected:
    void ask(const std::string& what, const std::string& value, std::vector<std::string> more = {}) const {
        std::vector<std::string> command{"mosquitto_pub",          "-h", "localhost", "-p",
                                         std::to_string(port),     "-q", "1",         "-t",
                                         "quadrat/hall-2/" + what, "-m", value};
        command.insert(command.end(), more.begin(), more.end());
        ASSERT_TRUE(succeeds(run(command, elsewhere)));
    }
    // Once more answers have come than there were.
    std::string answer_to(const std::string& what, const std::string& value, std::vector<std::string> more = {}) {
        ask("set/" + what, value, std::move(more));
        ++asked_;
        EXPECT_TRUE(comes_true([&] { return count_of(heard(), "hall-2/answer ") >= asked_; })) << heard() << said();
        const std::string all = heard();
        const std::size_t last = all.rfind("hall-2/answer ");
        return all.substr(last, all.find('\n', last) - last);
    }
    std::unique_ptr<Process> publisher_beside() const {
        return std::make_unique<Process>(
            program({"publish", "--config", path("quadrat.toml"), "--state", path("state")}), folder / "publisher");
    }
    TemporaryFolder elsewhere;

  private:
    std::size_t asked_ = 0;
};

TEST_F(AHouseControl, HasARunningExhibitStandByStartAnewAndShowAThemeInAnotherLanguage) {
    configure("mqtt", "orders = true\ndiscovery = \"homeassistant\"\n[themes.autumn]\nwords = { wet = [0, 1] }\n");
    folder.write("visit.script", "wait 600s\n");
    std::filesystem::create_directory(folder / "state");
    const auto house = broker("allow_anonymous true\n");
    Process exhibit(
        program({"run", "--config", path("quadrat.toml"), "--display", "headless", "--size", "64x64", "--input",
                 "script:" + path("visit.script"), "--state", path("state"), "--seed", "5", "--speed", "1.001"}),
        folder / "exhibit");
    auto sender = publisher_beside();
    listen_until_heard("quadrat/hall-2/state/standby off", {"-t", "homeassistant/#"});
    EXPECT_TRUE(comes_true([&] { return was_heard("homeassistant/select/quadrat_hall-2/theme/config {"); }));
    EXPECT_TRUE(comes_true([&] { return was_heard("\"restart\""); })) << "a button";
    EXPECT_TRUE(comes_true([&] { return std::filesystem::exists(folder / "state/health.json"); }));

    EXPECT_THAT(answer_to("standby", "on"), HasSubstr("\"done\":true"));
    EXPECT_TRUE(comes_true([&] { return was_heard("hall-2/state/standby on"); }));
    EXPECT_TRUE(comes_true([&] { return was_heard("on stand-by, as staff asked"); })) << "its health";
    EXPECT_THAT(answer_to("wake", ""), HasSubstr("\"done\":true"));
    EXPECT_TRUE(comes_true([&] { return count_of(heard(), "hall-2/state/standby off") >= 2; }));

    EXPECT_THAT(answer_to("theme", "autumn"), HasSubstr("\"done\":true"));
    EXPECT_TRUE(comes_true([&] { return was_heard("hall-2/state/theme autumn"); }));
    EXPECT_TRUE(comes_true([&] {
        return contents_of(folder / "exhibit/stderr.txt").find("theme: autumn") != std::string::npos;
    })) << contents_of(folder / "exhibit/stderr.txt");
    EXPECT_THAT(answer_to("language", "fr"), HasSubstr("\"done\":true"));
    EXPECT_THAT(contents_of(folder / "state/desk.toml"), HasSubstr("language = 'fr'"));
    EXPECT_THAT(contents_of(folder / "state/desk.log"), HasSubstr("the broker asked for language fr"));

    EXPECT_THAT(answer_to("restart", "now"), HasSubstr("\"done\":true"));
    EXPECT_TRUE(comes_true([&] { return !exhibit.is_running(); })) << "whoever keeps it running starts it anew";
    sender->kill(SIGTERM);
    EXPECT_TRUE(succeeds(sender->wait()));
}

TEST_F(AHouseControl, IsToldWhyNotAndChangesNothing) {
    configure("mqtt", "orders = true\n");
    std::filesystem::create_directory(folder / "state");
    const auto house = broker("allow_anonymous true\n");
    const auto sender = publisher_beside();
    listen_until_heard("quadrat/hall-2/state/theme by date");
    for (const auto& [what, value, why] : {std::tuple{"standby", "on", "no exhibit runs here"},
                                           {"theme", "winter", "there is no such theme; there are by date, none"},
                                           {"standby", "perhaps", "write on or off"},
                                           {"shell", "rm -rf /", "nobody knows how to do that"}}) {
        const std::string answer = answer_to(what, value);
        EXPECT_THAT(answer, HasSubstr(why));
        EXPECT_THAT(answer, HasSubstr("\"done\":false"));
    }
    EXPECT_THAT(answer_to("language", "de", {"-r"}), HasSubstr("\"done\":true")) << "it was there to hear it";
    EXPECT_THAT(answer_to("language", "fr"), HasSubstr("asked for just now"));
    EXPECT_TRUE(comes_true([&] {
        return answer_to("language", "tlh").find("there is no such language") != std::string::npos;
    })) << "a second later";
    EXPECT_FALSE(std::filesystem::exists(folder / "state/standby"));
}

// It would be done again with each connection: an exhibit would start anew for ever.
TEST_F(AHouseControl, IsNotObeyedInWhatTheBrokerKept) {
    configure("mqtt", "orders = true\n");
    std::filesystem::create_directory(folder / "state");
    const auto house = broker("allow_anonymous true\n");
    EXPECT_TRUE(comes_true([&] {
        return run({"mosquitto_pub", "-h", "localhost", "-p", std::to_string(port), "-r", "-t",
                    "quadrat/hall-2/set/language", "-m", "fr"},
                   elsewhere)
                   .status == 0;
    }));
    const auto sender = publisher_beside();
    listen_until_heard("hall-2/answer {\"done\":false");
    EXPECT_THAT(heard(), HasSubstr("it is retained by the broker"));
    EXPECT_THAT(heard(), HasSubstr("hall-2/state/language en"));
    EXPECT_FALSE(std::filesystem::exists(folder / "state/desk.toml"));
}

TEST_F(AHouseControl, IsNotHeardWhereTheSettingsDoNotSaySo) {
    configure("mqtt", "");
    std::filesystem::create_directory(folder / "state");
    const auto house = broker("allow_anonymous true\n");
    const auto sender = publisher_beside();
    listen_until_heard("quadrat/hall-2/status online");
    ask("set/language", "fr");
    ask("status", "offline");
    EXPECT_TRUE(comes_true([&] { return count_of(heard(), "status online") >= 2; })) << "what came later was heard";
    EXPECT_THAT(heard(), Not(HasSubstr("hall-2/answer")));
    EXPECT_THAT(heard(), Not(HasSubstr("hall-2/state")));
    EXPECT_FALSE(std::filesystem::exists(folder / "state/desk.toml"));
}

// As deploy/README.md says it: who may ask is the broker's to decide.
TEST_F(AHouseControl, IsWhomTheBrokersAccessListNames) {
    configure("mqtt", "orders = true\nuser = \"hall-2\"\npassword_file = \"" + path("password") + "\"\n");
    std::filesystem::create_directory(folder / "state");
    folder.write("password", "secret\n");
    ASSERT_TRUE(succeeds(run({"sh", "-c",
                              "touch users && chmod 600 users && for who in hall-2 house guest; do mosquitto_passwd -b "
                              "users $who secret; done && chmod 644 users"},
                             folder)));
    folder.write("acl",
                 "user hall-2\ntopic readwrite quadrat/hall-2/#\nuser house\ntopic read quadrat/#\ntopic write "
                 "quadrat/+/set/+\nuser guest\ntopic read quadrat/#\n");
    std::filesystem::permissions(folder / "acl", std::filesystem::perms{0644});
    const auto house =
        broker("allow_anonymous false\npassword_file " + path("users") + "\nacl_file " + path("acl") + "\n");
    const auto sender = publisher_beside();
    listen_until_heard("quadrat/hall-2/state/language en", {"-u", "house", "-P", "secret"});
    ask("set/language", "fr", {"-u", "guest", "-P", "secret"});
    EXPECT_THAT(answer_to("language", "de", {"-u", "house", "-P", "secret"}), HasSubstr("\"to\":\"de\""));
    EXPECT_TRUE(comes_true([&] { return was_heard("hall-2/state/language de"); }));
    EXPECT_THAT(heard(), Not(HasSubstr("language fr")));
    EXPECT_EQ(count_of(heard(), "hall-2/answer"), 1U);
}

}  // namespace
