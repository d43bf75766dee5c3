// SPDX-License-Identifier: Apache-2.0
// What goes wrong between an exhibit and its broker, with a real one: each fault is named, and none becomes a storm.
#include <gmock/gmock.h>

#include <csignal>

#include "journeys/fleet.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;

TEST_F(AFleet, OfTwoMachinesWithOneNameThrowsNeitherOutAndBothLogsNameTheOther) {
    configure("mqtt", "");
    std::filesystem::create_directory(folder / "state");
    std::filesystem::create_directory(folder / "other");
    const auto house = broker("allow_anonymous true\n");
    const auto one = publisher("state", "one"), two = publisher("other", "two");
    EXPECT_TRUE(comes_true([&] { return publisher_says(path("other"), "one"); })) << said("one");
    EXPECT_TRUE(comes_true([&] { return publisher_says(path("state"), "two"); })) << said("two");
    EXPECT_THAT(said("one"), HasSubstr("another exhibit publishes under the same name, hall-2"));
    EXPECT_EQ(count_of(said("one"), "another exhibit"), 1U);
    EXPECT_THAT(contents_of(folder / "broker/stderr.txt"), Not(HasSubstr("already connected")));

    listen_until_heard("quadrat/hall-2/status online");
    two->kill(SIGKILL);
    EXPECT_TRUE(comes_true([&] { return was_heard("quadrat/hall-2/status offline\nquadrat/hall-2/status online"); }))
        << "the last will of one is not the last word: " << heard();
}

TEST_F(AFleet, WhereOneStateFolderIsPublishedTwiceReconnectsEverMoreSeldomAndNamesTheCause) {
    configure("mqtt", "");
    std::filesystem::create_directory(folder / "state");
    const auto house = broker("allow_anonymous true\n");
    const auto one = publisher("state", "one"), two = publisher("state", "two");
    const auto explains = [&](const char* who) { return publisher_says("on this state folder", who); };
    EXPECT_TRUE(comes_true([&] { return explains("one") || explains("two"); })) << said("one") << said("two");
    std::this_thread::sleep_for(std::chrono::seconds{10});
    EXPECT_LE(count_of(contents_of(folder / "broker/stderr.txt"), "already connected"), 12U)
        << "a second, two, four, eight: of each of the two";
    EXPECT_LE(count_of(said("one"), "\n"), 6U) << said("one");
}

// Made by an authority of the test's own.
class ItsCertificate : public AFleet {
  protected:
    void SetUp() override {
        AFleet::SetUp();
        std::filesystem::create_directory(folder / "state");
        ASSERT_TRUE(succeeds(run({"sh", "-c",
                                  "openssl req -x509 -newkey rsa:2048 -nodes -keyout ca.key -out ca.pem -days 3 "
                                  "-subj /CN=house && openssl req -x509 -newkey rsa:2048 -nodes -keyout other.key -out "
                                  "other.pem -days 3 -subj /CN=other"},
                                 folder)));
        configure("mqtts", "ca_file = \"" + path("ca.pem") + "\"\n");
    }
    // A broker with a certificate for this name, for so many days.
    std::unique_ptr<Process> certified(const std::string& name, const std::string& days,
                                       const std::string& more = "") const {
        return signed_by(
            "openssl x509 -req -in broker.csr -CA ca.pem -CAkey ca.key -CAcreateserial -out broker.pem "
            "-extfile names -days " +
                days,
            name, more);
    }
    std::unique_ptr<Process> signed_by(const std::string& authority, const std::string& name,
                                       const std::string& more = "") const {
        const std::string make =
            "openssl req -newkey rsa:2048 -nodes -keyout broker.key -out broker.csr -subj /CN=" + name +
            " && echo subjectAltName=DNS:" + name + " > names && " + authority + " && chmod 644 *.key *.pem";
        EXPECT_TRUE(succeeds(run({"sh", "-c", make}, folder)));
        return broker("allow_anonymous true\ncafile " + path("ca.pem") + "\ncertfile " + path("broker.pem") +
                      "\nkeyfile " + path("broker.key") + "\n" + more);
    }
    void expect_told(const std::string& what) const {
        const auto sender = publisher();
        EXPECT_TRUE(comes_true([&] { return publisher_says(what); })) << said();
        sender->kill(SIGTERM);
        EXPECT_TRUE(succeeds(sender->wait()));
    }
};

TEST_F(ItsCertificate, IsOfAnotherHost) {
    const auto house = certified("broker.elsewhere", "2");
    expect_told("is of another host: it has the name broker.elsewhere, not localhost");
}

TEST_F(ItsCertificate, HasExpired) {
    const auto house = certified("localhost", "0");
    expect_told("the broker's certificate has expired, on 20");
}

// Which is what a clock that is years behind makes of every one.
TEST_F(ItsCertificate, IsNotYetValid) {
    folder.write("index.txt", "");
    folder.write("authority",
                 "[ca]\ndefault_ca = house\n[house]\ndatabase = index.txt\nnew_certs_dir = .\nserial = serial\n"
                 "default_md = sha256\npolicy = any\n[any]\ncommonName = supplied\n");
    const auto house = signed_by(
        "openssl ca -batch -notext -config authority -create_serial -in broker.csr -cert ca.pem -keyfile ca.key "
        "-extfile "
        "names -startdate 20910203000000Z -enddate 20920203000000Z -out broker.pem",
        "localhost");
    expect_told("the broker's certificate is valid from 2091-02-03");
}

TEST_F(ItsCertificate, IsSignedBySomebodyElse) {
    const auto house = certified("localhost", "2");
    configure("mqtts", "ca_file = \"" + path("other.pem") + "\"\n");
    expect_told("is not signed by anybody in " + path("other.pem") + ": CN = house signed it");
}

TEST_F(ItsCertificate, IsMissingWhereABrokerSpeaksNoTls) {
    const auto house = broker("allow_anonymous true\n");
    expect_told("the broker speaks no TLS on this port");
}

TEST_F(ItsCertificate, IsFineButTheBrokerWantsOneOfEachClient) {
    const auto house = certified("localhost", "2", "require_certificate true\n");
    expect_told("an exhibit has no certificate of its own");
    EXPECT_EQ(count_of(said(), "Protocol error"), 0U) << said();
}

TEST_F(ItsCertificate, IsFineButTheAddressSaysNoEncryption) {
    const auto house = certified("localhost", "2");
    configure("mqtt", "");
    expect_told("where it wants encryption, write mqtts://");
}

TEST_F(ItsCertificate, IsVouchedForByAFileThatIsLookedAtBeforeAnythingIsConnected) {
    ASSERT_TRUE(succeeds(run({"openssl", "x509", "-in", "ca.pem", "-outform", "der", "-out", "ca.der"}, folder)));
    folder.write("empty.pem", "");
    for (const auto& [file, what] : {std::pair{"missing.pem", "no such file"},
                                     {"run", "is a folder"},
                                     {"empty.pem", "holds no certificate"},
                                     {"ca.key", "holds a private key"},
                                     {"ca.der", "DER form; write it as PEM"},
                                     {"quadrat.toml", "holds no certificate"}}) {
        configure("mqtts", "ca_file = \"" + path(file) + "\"\n");
        const auto sender = publisher();
        ASSERT_TRUE(comes_true([&] { return !sender->is_running(); })) << file << said();
        const Ended ended = sender->wait();
        EXPECT_EQ(ended.status, 2);
        EXPECT_THAT(ended.err, HasSubstr("fleet.ca_file"));
        EXPECT_THAT(ended.err, HasSubstr(what));
        EXPECT_THAT(ended.err, HasSubstr(path(file)));
    }
}

TEST_F(AFleet, TakesAPasswordFromAFileThatWindowsSaved) {
    ASSERT_TRUE(succeeds(run({"sh", "-c",
                              "touch users && chmod 600 users && mosquitto_passwd -b users hall secret1 && "
                              "chmod 644 users"},
                             folder)));
    const auto house = broker("allow_anonymous false\npassword_file " + path("users") + "\n");
    configure("mqtt", "user = \"hall\"\npassword_file = \"" + path("password") + "\"\n");
    for (const char* saved : {"secret1\n", "secret1", "secret1\r\n", "\xef\xbb\xbfsecret1\r\nits second line"}) {
        folder.write("password", saved);
        const auto sender = publisher();
        EXPECT_TRUE(comes_true([&] { return publisher_says("connected to the broker"); })) << saved << said();
    }
    folder.write("password", "hunter2\n");
    const auto sender = publisher();
    EXPECT_TRUE(comes_true([&] { return publisher_says("look at fleet.user and fleet.password_file"); })) << said();
    std::this_thread::sleep_for(std::chrono::seconds{4});
    EXPECT_EQ(count_of(said(), "it refuses"), 1U) << "once for each reason: " << said();
    EXPECT_THAT(said(), Not(HasSubstr("hunter2")));
}

TEST_F(AFleet, FindsABrokerByItsIpv6Address) {
    const auto house = broker("allow_anonymous true\n", "::1");
    configure("mqtt", "", "[::1]");
    const auto sender = publisher();
    EXPECT_TRUE(comes_true([&] { return publisher_says("connected to the broker [::1]:" + std::to_string(port)); }))
        << said() << contents_of(folder / "broker/stderr.txt");
}

TEST_F(AFleet, NeverWritesAPasswordThatStandsInTheAddress) {
    for (const char* host : {"museum:hunter2@localhost", "hunter2@localhost", "museum:hunter2"}) {
        configure("mqtt", "", host);
        const Ended ended = publisher()->wait();
        EXPECT_EQ(ended.status, 2) << host;
        EXPECT_THAT(ended.err, HasSubstr("fleet.broker has"));
        EXPECT_THAT(ended.err + ended.out, Not(HasSubstr("hunter2")));
    }
}

}  // namespace
