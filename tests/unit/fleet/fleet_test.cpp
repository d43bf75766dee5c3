// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "base/error.hpp"
#include "fleet/back_off.hpp"
#include "fleet/identity.hpp"
#include "site/broker_address.hpp"
#include "support/process.hpp"

namespace quadrat::fleet {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

std::string refusal_of(const std::function<void()>& what) {
    try {
        what();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(BrokerAddress, IsASchemeAHostAndAPort) {
    EXPECT_EQ(site::parse_broker("mqtts://broker.example:8884"), (site::Broker{"broker.example", 8884, true}));
    EXPECT_EQ(site::parse_broker("mqtts://broker.example"), (site::Broker{"broker.example", 8883, true}));
    EXPECT_EQ(site::parse_broker("mqtt://10.0.0.1/"), (site::Broker{"10.0.0.1", 1883, false}));
    EXPECT_EQ(site::parse_broker("MQTT://Hall_2:1"), (site::Broker{"Hall_2", 1, false}));
    EXPECT_EQ(site::parse_broker("mqtt://host.:65535"), (site::Broker{"host.", 65535, false}));
    EXPECT_EQ(site::parse_broker("mqtt://[::1]:1884"), (site::Broker{"::1", 1884, false}));
    EXPECT_EQ(site::parse_broker("mqtts://[2001:db8::1]"), (site::Broker{"2001:db8::1", 8883, true}));
    EXPECT_EQ(site::parse_broker("mqtt://[fe80::1%25eth0]:1883"), (site::Broker{"fe80::1%eth0", 1883, false}));
    EXPECT_EQ(site::parse_broker("mqtt://[fe80::1%eth0]"), (site::Broker{"fe80::1%eth0", 1883, false}));
    EXPECT_EQ(to_text(site::Broker{"::1", 1883, false}), "[::1]:1883");
    EXPECT_EQ(to_text(site::Broker{"fe80::1%eth0", 1883, false}), "[fe80::1%25eth0]:1883");
}

TEST(BrokerAddress, IsRefusedWithWhatIsWrongAndWhatWouldBeRight) {
    const std::pair<const char*, const char*> wrong[] = {
        {"", "begins with neither"},
        {"broker.example", "begins with neither"},
        {"broker.example:1883", "begins with neither"},
        {"http://broker", "begins with neither"},
        {"wss://broker", "begins with neither"},
        {" mqtt://broker", "begins with neither"},
        {"mqtt:/broker", "begins with neither"},
        {"mqtt://", "names no host"},
        {"mqtt://:1883", "names no host"},
        {"mqtt://host:", "no number from 1 to 65535"},
        {"mqtt://host:0", "no number from 1 to 65535"},
        {"mqtt://host:65536", "no number from 1 to 65535"},
        {"mqtt://host:4294967297", "no number from 1 to 65535"},
        {"mqtt://host:-1", "no number from 1 to 65535"},
        {"mqtt://host:+1883", "no number from 1 to 65535"},
        {"mqtt://host: 1883", "no number from 1 to 65535"},
        {"mqtt://host:1883 ", "no number from 1 to 65535"},
        {"mqtt://host:many", "no number from 1 to 65535"},
        {"mqtt://ho st", "no name of letters"},
        {"mqtt://-host", "no name of letters"},
        {"mqtt://a..b", "no name of letters"},
        {"mqtt://m\xc3\xbcnchen", "no name of letters"},
        {"mqtt://10.0.0.256", "no IPv4 address"},
        {"mqtt://10.0.1", "no IPv4 address"},
        {"mqtt://host/topic", "has a path"},
        {"mqtt://host?a=b", "has a path"},
        {"mqtt://::1", "an IPv6 address has brackets"},
        {"mqtt://::1:1883", "an IPv6 address has brackets"},
        {"mqtt://[::1", "[ without its ]"},
        {"mqtt://[]", "no IPv6 address between"},
        {"mqtt://[1::2::3]", "no IPv6 address between"},
        {"mqtt://[10.0.0.1]", "no IPv6 address between"},
        {"mqtt://[::1]1883", "something other than :PORT"},
        {"mqtt://[::1]:0", "no number from 1 to 65535"},
        {"mqtt://[fe80::1%]", "names no interface"},
    };
    for (const auto& [address, what] : wrong) {
        const std::string said = refusal_of([&, text = address] { site::parse_broker(text); });
        EXPECT_THAT(said, HasSubstr(what)) << address;
        EXPECT_THAT(said, HasSubstr("write mqtts://HOST:PORT")) << address;
    }
    EXPECT_THAT(refusal_of([] { site::parse_broker("mqtt://" + std::string(300, 'a')); }),
                HasSubstr("no name of letters"));
}

TEST(BrokerAddress, NeverRepeatsWhatMayBeAPassword) {
    for (const char* address :
         {"mqtt://museum:hunter2@host", "museum:hunter2@host", "mqtt://museum:hunter2", "mqtt://hunter2 is it",
          "mqtt://u:hun/ter2@host", "hunter2", "mqtt://hunter2@[::1]:99999"}) {
        const std::string said = refusal_of([&] { site::parse_broker(address); });
        EXPECT_FALSE(said.empty()) << address;
        EXPECT_THAT(said, testing::Not(HasSubstr("hun"))) << address;
    }
}

TEST(BackOff, DoublesUntilAConnectionHasLasted) {
    BackOff back_off;
    BackOff::Moment now{};
    for (const auto wait : {1s, 2s, 4s, 8s, 16s, 32s, 60s, 60s}) {
        back_off.tried(now);
        EXPECT_EQ(back_off.next_try() - now, wait);
        now = back_off.next_try();
    }
    EXPECT_FALSE(back_off.stands(now, now + 179s)) << "thrown out as soon as let in";
    back_off.lost(now + 179s);
    EXPECT_EQ(back_off.next_try(), now + 179s + 60s);
    EXPECT_TRUE(back_off.stands(now, now + 180s));
    EXPECT_FALSE(back_off.stands(now, now + 181s)) << "told once";
    back_off.lost(now + 190s);
    EXPECT_EQ(back_off.next_try(), now + 191s);
}

// A broker takes two for one: whoever comes throws out the other, for a day.
TEST(BackOff, OfTwoThatThrowEachOtherOutLetsNeitherBeginAnew) {
    BackOff rivals[2];
    std::size_t inside = 0;
    int times = 0;
    BackOff::Moment since{};
    rivals[inside].tried(since);
    for (const auto end = since + 24h; since < end; ++times) {
        const auto now = std::max(since, rivals[1 - inside].next_try());
        rivals[inside].stands(since, now);
        rivals[1 - inside].tried(now);
        rivals[inside].lost(now);
        inside = 1 - inside;
        since = now;
    }
    EXPECT_LE(times, 24 * 60 + 12) << "once a minute, but for the first few";
}

// A machine's own marks, in folders of the test's.
class ClientId : public testing::Test {
  protected:
    ClientId() {
        machine.write("machine-id", "0123456789abcdef0123456789abcdef\n");
        has_card("eth0", "devices/pci/0", "d8:3a:dd:00:00:01\n");
    }
    void has_card(const std::string& name, const std::string& device, const std::string& address) const {
        std::filesystem::create_directories(machine / device);
        std::filesystem::create_directories(machine / ("class/net/" + name));
        std::error_code exists;
        std::filesystem::create_directory_symlink(machine / device, machine / ("class/net/" + name + "/device"),
                                                  exists);
        machine.write("class/net/" + name + "/address", address);
        machine.write("class/net/" + name + "/addr_assign_type", "0\n");
    }
    std::string id(const char* state = "/var/lib/quadrat") const {
        return client_id(state, machine.path(), machine.path());
    }
    tests::TemporaryFolder machine;
};

TEST_F(ClientId, IsWhatEveryBrokerMustTakeAndTheSameAtEachStart) {
    EXPECT_THAT(id(), testing::MatchesRegex("quadrat[0-9a-f]+"));
    EXPECT_EQ(id().size(), 23U);
    EXPECT_EQ(id(), id());
    for (const char* same : {"/var/lib/quadrat/", "/var/lib/quadrat/.", "/var/lib/../lib/quadrat", "//var/lib/quadrat"})
        EXPECT_EQ(id(same), id()) << same;
    const std::string here = std::filesystem::current_path() / "not-there-yet";
    EXPECT_EQ(id("not-there-yet/"), id(here.c_str()));
    EXPECT_EQ(client_id("/a", "/nowhere", "/nowhere").size(), 23U);
}

TEST_F(ClientId, IsAnotherForEachStateFolderAndEachMachineOfOneImage) {
    std::set<std::string> ids{id(), id("/var/lib/other")};
    has_card("eth0", "devices/pci/0", "d8:3a:dd:00:00:02\n");
    ids.insert(id());
    std::filesystem::create_directories(machine / "firmware/devicetree/base");
    machine.write("firmware/devicetree/base/serial-number", "10000000c0ffee");
    ids.insert(id());
    machine.write("machine-id", "fedcba9876543210fedcba9876543210\n");
    ids.insert(id());
    EXPECT_EQ(ids.size(), 5U);
}

TEST_F(ClientId, IsAnotherAtEachStartWhereTheMachineTellsNothingOfItself) {
    EXPECT_NE(client_id("/state", "/nowhere", "/nowhere"), client_id("/state", "/nowhere", "/nowhere"));
}

TEST_F(ClientId, StaysWhereACardIsPluggedInOrABridgeIsMade) {
    const std::string before = id();
    has_card("usb0", "devices/pci/usb1/1-1", "d8:3a:dd:00:00:03\n");
    EXPECT_EQ(id(), before);
    std::filesystem::create_directories(machine / "class/net/br0");
    machine.write("class/net/br0/address", "d8:3a:dd:00:00:04\n");
    EXPECT_EQ(id(), before);
}

TEST(Password, IsTheFirstLineWhateverEditorSavedIt) {
    const tests::TemporaryFolder folder;
    const auto saved = [&](const std::string& bytes) { return password_in(folder.write("password", bytes)); };
    EXPECT_EQ(saved("secret1"), "secret1");
    EXPECT_EQ(saved("secret1\n"), "secret1");
    EXPECT_EQ(saved("secret1\r\nmore\r\n"), "secret1");
    EXPECT_EQ(saved("\xef\xbb\xbfsecret1\r\n"), "secret1");
    EXPECT_EQ(saved(" a b \n"), " a b ") << "blanks are of it";
    EXPECT_THAT(refusal_of([&] { saved("\r\nsecret1"); }), HasSubstr("is empty"));
    EXPECT_THAT(refusal_of([&] { saved(std::string("\xff\xfes\0e\0", 6)); }),
                HasSubstr("is UTF-16 text; save it as UTF-8"));
    EXPECT_THAT(refusal_of([&] { saved(std::string("sec\0ret", 7)); }), HasSubstr("NUL"));
    EXPECT_THAT(refusal_of([&] { password_in(folder / "missing"); }),
                testing::AllOf(HasSubstr("fleet.password_file"), HasSubstr("missing"), HasSubstr("may read")));
}

}  // namespace
}  // namespace quadrat::fleet
