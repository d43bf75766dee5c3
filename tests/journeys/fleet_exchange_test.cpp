// SPDX-License-Identifier: Apache-2.0
// What visitors bred in one hall is shown in the other's.
#include <gmock/gmock.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <set>

#include "journeys/fleet.hpp"

namespace {

using namespace quadrat::tests;
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class TwoHalls : public AFleet {
  protected:
    // One of the halls: its settings, state and what it says are in a folder of its name.
    void furnish(const std::string& hall, const std::string& fleet, const std::string& more = "") const {
        fs::create_directories(folder / hall / "state");
        folder.write(hall + "/quadrat.toml", "[picture]\nland_samples = 65\n" + more + "[fleet]\nname = \"" + hall +
                                                 "\"\nbroker = \"mqtt://localhost:" + std::to_string(port) + "\"\n" +
                                                 fleet);
    }
    std::unique_ptr<Process> in(const std::string& hall, const std::string& as,
                                std::vector<std::string> arguments) const {
        for (const char* word : {"--config", "quadrat.toml", "--state", "state"})
            arguments.push_back(word[0] == '-' ? word : path(hall + "/" + word));
        fs::create_directories(folder / hall / as);
        return std::make_unique<Process>(program(arguments), folder / hall / as);
    }
    std::unique_ptr<Process> exhibit(const std::string& hall, const std::string& script,
                                     const std::string& speed = "1.001") const {
        folder.write(hall + "/visit.script", script);
        return in(hall, "exhibit",
                  {"run", "--display", "headless", "--size", "96x64", "--input",
                   "script:" + path(hall + "/visit.script"), "--seed", "5", "--speed", speed});
    }
    std::string log(const std::string& hall, const std::string& as) const {
        return contents_of(folder / hall / as / "stderr.txt");
    }
    std::set<std::string> files(const std::string& at, const std::string& ending) const {
        std::set<std::string> names;
        std::error_code error;
        for (const auto& file : fs::directory_iterator(folder / at, error))
            if (file.path().extension() == ending) names.insert(file.path().stem().string());
        return names;
    }
    void say(const std::string& topic, const std::string& what) const {
        elsewhere.write("message", what);
        // The broker may just have been started.
        ASSERT_TRUE(comes_true([&] {
            return run({"mosquitto_pub", "-h", "localhost", "-p", std::to_string(port), "-r", "-q", "1", "-t", topic,
                        "-f", (elsewhere / "message").string()},
                       elsewhere)
                       .status == 0;
        }));
    }
    TemporaryFolder elsewhere;
};

constexpr const char* kVisit = "[visit]\nrounds = 1\nfinale_s = 2\ndescribe_words = 0\npatience_s = 600\n";

TEST_F(TwoHalls, ShareWhatVisitorsBredAndOneThatIsHiddenGoes) {
    furnish("hall-1", "shares = \"bred\"\n", kVisit);
    furnish("hall-2", "takes = \"all\"\nshares = \"bred\"\n");
    const auto house = broker("allow_anonymous true\n");
    {
        const auto playing = exhibit("hall-1",
                                     "wait 8s\npress A\nwait 3s\npress A\nwait 3s\npress B\nwait 3s\npress C\n"
                                     "wait 600s\n");
        ASSERT_TRUE(comes_true([&] { return !files("hall-1/state/bred", ".code").empty(); }))
            << log("hall-1", "exhibit");
        playing->kill(SIGTERM);
        EXPECT_TRUE(succeeds(playing->wait()));
    }
    const std::set<std::string> bred = files("hall-1/state/bred", ".code");
    const auto resting = exhibit("hall-2", "wait 600s\n");
    auto tells = in("hall-1", "publisher", {"publish"});
    listen_until_heard("quadrat/hall-1/favourites {");
    const auto hears = in("hall-2", "publisher", {"publish"});
    ASSERT_TRUE(comes_true([&] { return files("hall-2/state/guests", ".png") == bred; }))
        << log("hall-2", "publisher") << log("hall-1", "publisher");
    EXPECT_EQ(files("hall-2/state/guests", ".code"), bred);
    EXPECT_TRUE(comes_true([&] {
        return log("hall-2", "exhibit").find("landscapes that other exhibits share") != std::string::npos;
    })) << log("hall-2", "exhibit");

    // Nothing of who or when: a code, and where its picture is.
    const std::string all = heard();
    const std::size_t at = all.find("quadrat/hall-1/favourites {") + 26;
    const auto said = nlohmann::json::parse(all.substr(at, all.find('\n', at) - at));
    ASSERT_EQ(said.size(), 1U);
    std::set<std::string> pictures;
    std::string codes;
    for (const auto& one : said.at("favourites")) {
        EXPECT_EQ(one.size(), 2U) << one;
        pictures.insert(one.at("picture").get<std::string>());
        codes += "\"" + one.at("code").get<std::string>() + "\", ";
    }
    EXPECT_EQ(pictures, bred);
    EXPECT_THAT(all, Not(HasSubstr("quadrat/hall-2/favourites {"))) << "a guest is not handed on";

    // Staff of the first hall hide them: they go from both, and the broker forgets them.
    tells->kill(SIGTERM);
    EXPECT_TRUE(succeeds(tells->wait()));
    folder.write("hall-1/state/desk.toml", "[attract]\nhidden = [" + codes + "]\n");
    tells = in("hall-1", "publisher", {"publish"});
    EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-1/favourites (null)"); })) << heard();
    for (const std::string& picture : pictures)
        EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-1/favourites/" + picture + " (null)"); }));
    hears->kill(SIGTERM);
    EXPECT_TRUE(succeeds(hears->wait()));
}

TEST_F(TwoHalls, AreLeftAsTheyWereByWhatIsWrong) {
    furnish("hall-2", "takes = \"chosen\"\n");
    fs::create_directories(folder / "hall-2/state/guests");
    const auto house = broker("allow_anonymous true\n");
    say("quadrat/hall-1/favourites", "a hall\xff");
    say("quadrat/hall-3/favourites", R"({"favourites": [{"code": "Q1-AAAA"}]})");
    say("quadrat/hall-4/favourites/0123456789abcdef", "no picture");
    say("quadrat/hall-4/favourites", std::string(300'000, '['));
    const auto hears = in("hall-2", "publisher", {"publish"});
    for (const char* hall : {"hall-1", "hall-3", "hall-4"})
        EXPECT_TRUE(comes_true([&] {
            return log("hall-2", "publisher").find("what " + std::string(hall) + " shares is left as it was") !=
                   std::string::npos;
        })) << log("hall-2", "publisher");
    EXPECT_TRUE(fs::is_empty(folder / "hall-2/state/guests"));
    hears->kill(SIGTERM);
    EXPECT_TRUE(succeeds(hears->wait()));
}

}  // namespace
