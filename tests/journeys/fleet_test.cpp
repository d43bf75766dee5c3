// SPDX-License-Identifier: Apache-2.0
// Health and visits, published to a real broker.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <csignal>
#include <functional>
#include <memory>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "journeys/state_database.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;

int free_port() {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address);
    socklen_t length = sizeof address;
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length);
    ::close(socket);
    return ntohs(address.sin_port);
}

testing::AssertionResult comes_true(const std::function<bool()>& what) {
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
    void configure(const std::string& scheme, const std::string& more) const {
        folder.write("quadrat.toml", "[picture]\nland_samples = 65\n[fleet]\nname = \"hall-2\"\nbroker = \"" + scheme +
                                         "://localhost:" + std::to_string(port) + "\"\n" + more);
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
    std::unique_ptr<Process> publisher() const {
        return std::make_unique<Process>(
            program({"publish", "--config", path("quadrat.toml"), "--state", path("state"), "--runtime", path("run")}),
            folder / "publisher");
    }
    std::unique_ptr<Process> broker(const std::string& more) const {
        folder.write("broker.conf", "listener " + std::to_string(port) + " 127.0.0.1\npersistence false\n" + more);
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
    bool publisher_says(const std::string& what) const {
        return contents_of(folder / "publisher/stderr.txt").find(what) != std::string::npos;
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

TEST_F(AFleet, HearsOfVisitsThatWaitedForTheNetworkAndOfAnEndThatNobodyTold) {
    configure("mqtt", "");
    have_visits();
    auto sender = publisher();
    EXPECT_TRUE(comes_true([&] { return publisher_says("no connection to localhost"); })) << "without a broker";
    EXPECT_TRUE(sender->is_running());
    const auto house = broker("allow_anonymous true\n");
    listen_until_heard("quadrat/hall-2/status");
    EXPECT_TRUE(comes_true([&] { return count_of(heard(), "\"ending\":\"left\"") >= 2; })) << heard();
    EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-2/status online"); }));
    EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-2/health {\"verdict\": \"good\"}"); }));
    EXPECT_TRUE(comes_true([&] {
        return Database(folder / "state/quadrat.db").number("SELECT count(*) FROM outbox") == 0;
    })) << "what has arrived is forgotten";
    sender->kill(SIGKILL);
    EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-2/status offline"); })) << "its last will";
    const std::size_t before = count_of(heard(), "/visits ");
    sender = publisher();
    EXPECT_TRUE(comes_true([&] { return count_of(heard(), "status online") >= 2; }));
    sender->kill(SIGTERM);
    EXPECT_TRUE(succeeds(sender->wait()));
    // Its last word comes after all it had to say.
    EXPECT_TRUE(comes_true([&] { return count_of(heard(), "status offline") >= 2; }));
    EXPECT_EQ(count_of(heard(), "/visits "), before) << "what has arrived is not sent again";
}

TEST_F(AFleet, SpeaksEncryptedWithItsPasswordAndTrustsNobodyElse) {
    const Ended made =
        run({"sh", "-c",
             "openssl req -x509 -newkey rsa:2048 -nodes -keyout key.pem -out ca.pem -days 2 -subj /CN=localhost "
             "-addext subjectAltName=DNS:localhost && chmod 644 key.pem ca.pem && chmod 755 . && "
             "openssl req -x509 -newkey rsa:2048 -nodes -keyout other.key -out other.pem -days 2 -subj /CN=other && "
             "touch users && chmod 600 users && mosquitto_passwd -b users hall secret && chmod 644 users"},
            folder);
    ASSERT_TRUE(succeeds(made));
    folder.write("password", "secret\n");
    const std::string user = "user = \"hall\"\npassword_file = \"" + path("password") + "\"\n";
    configure("mqtts", user + "ca_file = \"" + path("ca.pem") + "\"\n");
    const auto house = broker("cafile " + path("ca.pem") + "\ncertfile " + path("ca.pem") + "\nkeyfile " +
                              path("key.pem") + "\nallow_anonymous false\npassword_file " + path("users") + "\n");
    auto sender = publisher();
    listen_until_heard("quadrat/hall-2/status online", {"--cafile", path("ca.pem"), "-u", "hall", "-P", "secret"});
    sender->kill(SIGTERM);
    sender->wait();
    EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-2/status offline"); }));

    configure("mqtts", user + "ca_file = \"" + path("other.pem") + "\"\n");
    sender = publisher();
    EXPECT_TRUE(comes_true([&] { return publisher_says("no connection to localhost"); }));
    EXPECT_EQ(count_of(heard(), "status online"), 1U) << "another's certificate is not trusted";
    EXPECT_TRUE(sender->is_running());
}

TEST(Fleet, IsOffByDefaultAndRefusesWhatIsNoBroker) {
    const TemporaryFolder folder;
    folder.write("quadrat.toml", "# the defaults\n");
    const Ended off = run(program({"publish", "--config", "quadrat.toml"}), folder);
    EXPECT_EQ(off.status, 0);
    EXPECT_THAT(off.err, HasSubstr("no broker is named"));
    for (const char* wrong : {"broker.example", "http://broker", "mqtt://", "mqtt://host:0", "mqtt://host:many"}) {
        folder.write("quadrat.toml", std::string("[fleet]\nbroker = \"") + wrong + "\"\n");
        const Ended ended = run(program({"publish", "--config", "quadrat.toml"}), folder);
        EXPECT_EQ(ended.status, 2) << wrong;
        EXPECT_THAT(ended.err, HasSubstr("write mqtts://HOST:PORT"));
    }
}

}  // namespace
