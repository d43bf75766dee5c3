// SPDX-License-Identifier: Apache-2.0
// A museum's thousand exhibits on one broker, on this machine's own network. A process has a part of them each, since
// libmosquitto takes three descriptors a connection and select() no more than 1024.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <chrono>
#include <memory>
#include <set>
#include <thread>

#include "fleet/publisher.hpp"
#include "support/free_port.hpp"
#include "support/process.hpp"

namespace quadrat::fleet {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int kProcesses = 8, kEach = 125;
constexpr std::size_t kAll = std::size_t{kProcesses} * kEach;
constexpr auto kPatience = 120s;

// Where each exhibit keeps what it was told.
Orders orders_of(const std::shared_ptr<std::string>& theme) {
    Orders orders;
    orders.carry_out = [theme](const std::string&, const std::string& value) { *theme = value; };
    orders.state = [theme] { return std::map<std::string, std::string>{{"theme", *theme}}; };
    orders.choices = [](const std::string&) { return std::vector<std::string>{"by date", "autumn"}; };
    return orders;
}

class AThousandExhibits : public testing::Test {
  protected:
    void SetUp() override {
        rlimit files{};
        ::getrlimit(RLIMIT_NOFILE, &files);
        files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
        if (files.rlim_cur < 2048 || ::setrlimit(RLIMIT_NOFILE, &files) != 0)
            GTEST_SKIP() << "the broker may not have that many connections here";
        if (!std::filesystem::exists("/usr/sbin/mosquitto")) GTEST_SKIP() << "mosquitto is not installed";
        std::filesystem::permissions(folder_.path(), std::filesystem::perms{0755});
        settings_.broker = "mqtt://127.0.0.1:" + std::to_string(port_);
        settings_.discovery = "homeassistant";
        folder_.write("broker.conf", "listener " + std::to_string(port_) +
                                         " 127.0.0.1\nallow_anonymous true\npersistence false\nmax_queued_messages "
                                         "100000\nmax_inflight_messages 0\n");
        broker_ = std::make_unique<tests::Process>(
            std::vector<std::string>{"/usr/sbin/mosquitto", "-c", (folder_ / "broker.conf").string()}, folder_.path());
    }
    void TearDown() override {
        for (const pid_t child : children_) {
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
        }
    }
    void begin() {
        for (int i = 0; i < kProcesses; ++i) {
            const pid_t child = ::fork();
            if (child == 0) be_exhibits(i * kEach);
            children_.push_back(child);
        }
    }
    [[noreturn]] void be_exhibits(int first) const {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        std::vector<std::unique_ptr<Publisher>> exhibits;
        for (int i = first; i < first + kEach; ++i) {
            site::Configuration::Fleet own = settings_;
            own.name = "hall-" + std::to_string(i);
            PublisherOptions how{1ms, "1", orders_of(std::make_shared<std::string>("by date"))};
            exhibits.push_back(
                std::make_unique<Publisher>(own, folder_ / own.name, folder_ / own.name, std::move(how)));
        }
        for (;;)
            for (const auto& one : exhibits) one->look();
    }
    // Of the thousand, how many said this where they say it, until all have.
    std::size_t heard_of(Link& ear, const std::string& what) {
        for (const auto until = Clock::now() + kPatience; Clock::now() < until && said_[what].size() < kAll;)
            ear.look();
        return said_[what].size();
    }
    void hear(const std::string& topic, const std::string& text) {
        const std::size_t from = std::string("quadrat/").size(), end = topic.find('/', from);
        said_[topic.substr(end + 1) + " " + text.substr(0, 200)].insert(topic.substr(from, end - from));
    }

    tests::TemporaryFolder folder_;
    int port_ = tests::free_port();
    site::Configuration::Fleet settings_;
    std::unique_ptr<tests::Process> broker_;
    std::vector<pid_t> children_;
    std::map<std::string, std::set<std::string>> said_;  // who said what
};

TEST_F(AThousandExhibits, AreHeardAskedAndMissedOnOneBroker) {
    Link* link = nullptr;
    LinkEvents events;
    events.connected = [&] {
        for (const char* topic : {"quadrat/+/status", "quadrat/+/answer", "quadrat/+/state/theme"})
            link->subscribe(topic);
    };
    events.acknowledged = [](int) {};
    events.heard = [&](const std::string& topic, const std::string& text, bool) { hear(topic, text); };
    events.lost = [] {};
    site::Configuration::Fleet own = settings_;
    own.name = "house";
    Link ear(own, {"the-house", "house/status", 10ms}, events);
    link = &ear;
    const auto begun = Clock::now();
    while (!ear.look()) ASSERT_LT(Clock::now() - begun, kPatience) << "no broker";
    begin();
    EXPECT_EQ(heard_of(ear, "status online"), kAll);
    EXPECT_EQ(heard_of(ear, "state/theme by date"), kAll);
    const auto connected = Clock::now();
    for (std::size_t i = 0; i < kAll; ++i) {
        ASSERT_NE(ear.publish("quadrat/hall-" + std::to_string(i) + "/set/theme", "autumn", false), 0);
        if (i % 20 == 0) ear.look();
    }
    EXPECT_EQ(heard_of(ear, R"(answer {"done":true,"set":"theme","to":"autumn","why":""})"), kAll);
    EXPECT_EQ(heard_of(ear, "state/theme autumn"), kAll);
    const auto answered = Clock::now();
    for (const pid_t child : children_) ::kill(child, SIGKILL);
    EXPECT_EQ(heard_of(ear, "status offline"), kAll) << "their last will";
    const auto seconds = [](auto span) { return std::chrono::duration<double>(span).count(); };
    RecordProperty("connected_s", std::to_string(seconds(connected - begun)));
    RecordProperty("answered_s", std::to_string(seconds(answered - connected)));
    EXPECT_LT(seconds(answered - connected), 60) << "asked and answered";
    std::printf("connected in %.1f s, asked and answered in %.1f s, missed in %.1f s\n", seconds(connected - begun),
                seconds(answered - connected), seconds(Clock::now() - answered));
}

}  // namespace
}  // namespace quadrat::fleet
