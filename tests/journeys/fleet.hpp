// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "support/free_port.hpp"

namespace quadrat::tests {

inline testing::AssertionResult comes_true(const std::function<bool()>& what) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{60};
    while (std::chrono::steady_clock::now() < until) {
        if (what()) return testing::AssertionSuccess();
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    return testing::AssertionFailure() << "it did not within a minute";
}

// An exhibit that has had two visits, and what publishes them; each process in a folder of its own for its output.
class AFleet : public testing::Test {
  protected:
    void SetUp() override {
        // A broker that is started as root reads its settings as somebody else.
        std::filesystem::permissions(folder.path(), std::filesystem::perms{0755});
        for (const char* name : {"exhibit", "broker", "publisher", "listener"})
            std::filesystem::create_directory(folder / name);
        std::filesystem::create_directory(folder / "run");
        folder.write("run/health.json", "{\"verdict\": \"good\"}\n");
    }
    void configure(const std::string& scheme, const std::string& more, const std::string& host = "localhost") const {
        folder.write("quadrat.toml", "[picture]\nland_samples = 65\n[fleet]\nname = \"hall-2\"\nbroker = \"" + scheme +
                                         "://" + host + ":" + std::to_string(port) + "\"\n" + more);
    }
    void have_visits() const {
        folder.write("visit.script", "at 100ms press A\nwait 60s\npress B\nwait 60s\n");
        const Ended ended =
            run(program({"run", "--config", path("quadrat.toml"), "--display", "headless", "--size", "64x64", "--input",
                         "script:" + path("visit.script"), "--state", path("state"), "--seed", "5"}),
                folder);
        ASSERT_TRUE(succeeds(ended));
    }
    std::string path(const std::string& name) const { return (folder / name).string(); }
    std::unique_ptr<Process> publisher(const std::string& state = "state",
                                       const std::string& says_in = "publisher") const {
        std::filesystem::create_directory(folder / says_in);
        return std::make_unique<Process>(
            program({"publish", "--config", path("quadrat.toml"), "--state", path(state), "--runtime", path("run")}),
            folder / says_in);
    }
    std::unique_ptr<Process> broker(const std::string& more, const std::string& address = "127.0.0.1") const {
        folder.write("broker.conf",
                     "listener " + std::to_string(port) + " " + address + "\npersistence false\n" + more);
        return std::make_unique<Process>(std::vector<std::string>{"/usr/sbin/mosquitto", "-c", path("broker.conf")},
                                         folder / "broker");
    }
    std::unique_ptr<Process> listener(std::vector<std::string> more = {}) const {
        std::vector<std::string> command{
            "stdbuf", "-oL", "mosquitto_sub", "-h", "localhost", "-p", std::to_string(port), "-v", "-t", "quadrat/#"};
        command.insert(command.end(), more.begin(), more.end());
        return std::make_unique<Process>(command, folder / "listener");
    }
    std::string heard() const { return contents_of(folder / "listener/stdout.txt"); }
    std::string said(const std::string& by = "publisher") const { return contents_of(folder / (by + "/stderr.txt")); }
    bool publisher_says(const std::string& what, const std::string& by = "publisher") const {
        return said(by).find(what) != std::string::npos;
    }
    bool was_heard(const std::string& what) const { return heard().find(what) != std::string::npos; }
    void listen_until_heard(const std::string& what, std::vector<std::string> more = {}) {
        // A listener that came before the broker has ended.
        ASSERT_TRUE(comes_true([&] {
            if (!ear_ || !ear_->is_running()) ear_ = listener(more);
            return was_heard(what);
        })) << what
            << "; heard: " << heard() << contents_of(folder / "publisher/stderr.txt");
    }

    TemporaryFolder folder;
    int port = free_port();

  private:
    std::unique_ptr<Process> ear_;
};

}  // namespace quadrat::tests
