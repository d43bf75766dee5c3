// SPDX-License-Identifier: Apache-2.0
// Health and visits, published to a real broker.
#include <gmock/gmock.h>

#include <csignal>

#include "journeys/fleet.hpp"
#include "journeys/state_database.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;

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
