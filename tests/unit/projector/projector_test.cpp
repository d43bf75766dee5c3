// SPDX-License-Identifier: Apache-2.0
// How a projector is named, spoken to over the network and through the cable, and kept as it is wanted.
#include "projector/projector.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <tuple>

#include "projector/cec.hpp"
#include "projector/pjlink.hpp"
#include "support/fake_projector.hpp"
#include "support/free_port.hpp"
#include "support/process.hpp"

namespace quadrat::projector {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using tests::FakeProjector;

TEST(AProjectorsAddress, IsOfTheCableOrOfTheNetwork) {
    EXPECT_EQ(parse_address("cec"), Address(Cec{"/dev/cec0"}));
    EXPECT_EQ(parse_address("cec:/dev/cec1"), Address(Cec{"/dev/cec1"}));
    EXPECT_EQ(parse_address("pjlink://192.168.0.30"), Address(PjLink{"192.168.0.30", 4352}));
    EXPECT_EQ(parse_address("pjlink://hall-2.museum.example:4353"), Address(PjLink{"hall-2.museum.example", 4353}));
    EXPECT_EQ(parse_address("pjlink://[fd00::3]:1"), Address(PjLink{"fd00::3", 1}));
    for (const char* text : {"cec:/dev/cec1", "pjlink://192.168.0.30:4352", "pjlink://[fd00::3]:4352"})
        EXPECT_EQ(to_text(parse_address(text)), text);
}

TEST(AProjectorsAddress, ThatIsWrongIsRefusedWithWhatWouldBeRight) {
    for (const auto& [text, why] : {std::pair{"CEC", "neither CEC nor PJLink"},
                                    {"cec:", "no device"},
                                    {"cec:/dev/cec0/../sda", "no device"},
                                    {"cec:/etc/passwd", "no device"},
                                    {"http://192.168.0.30", "neither"},
                                    {"pjlink://", "no name or number"},
                                    {"pjlink://-v", "no name or number"},
                                    {"pjlink://a b", "no name or number"},
                                    {"pjlink://host:0", "its port"},
                                    {"pjlink://host:65536", "its port"},
                                    {"pjlink://host:4352x", "its port"},
                                    {"pjlink://[fd00::3", "has no ]"},
                                    {"pjlink://[fd00::3]x", "behind the address"}})
        EXPECT_THAT([address = std::string(text)] { parse_address(address); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(why), HasSubstr("write cec"))))
            << text;
}

// PJLink Specifications 1.04, section 5.4: its own example.
TEST(PjLinkSpeech, ProvesThePasswordAsTheSpecificationsExampleDoes) {
    EXPECT_EQ(command_text("498e4a67", "JBMIAProjectorLink", "%1POWR ?"), "5d8409bc1c3fa39749434aa3a5c38682%1POWR ?\r");
    EXPECT_EQ(command_text("", "JBMIAProjectorLink", "%1POWR 1"), "%1POWR 1\r");
}

TEST(PjLinkSpeech, IsUnderstoodOrRefused) {
    EXPECT_EQ(challenge_of("PJLINK 0"), "");
    EXPECT_EQ(challenge_of("PJLINK 1 498e4a67"), "498e4a67");
    for (const char* greeting : {"", "PJLINK", "PJLINK 1", "PJLINK 1 498e4a6", "PJLINK 1 498e4a6x", "PJLINK 2 0"})
        EXPECT_THROW(challenge_of(greeting), Trouble) << greeting;
    EXPECT_EQ(answer_from("%1POWR=OK", "POWR"), "OK");
    EXPECT_EQ(answer_from("%1powr=1", "POWR"), "1");
    EXPECT_EQ(answer_from("%1POWR=ERR3", "POWR"), std::nullopt);
    for (const char* line : {"", "%1POWR", "%1ERST=000000", "%2POWR=1", "PJLINK ERRA", "%1POWR=ERR1", "%1POWR=ERR4"})
        EXPECT_THROW(answer_from(line, "POWR"), Trouble) << line;
    for (const char* power : {"", "4", "00", "OK"}) EXPECT_THROW(power_from(power), Trouble) << power;
    EXPECT_EQ(ailments_from("000000"), "");
    EXPECT_EQ(ailments_from("021000"), "lamp: error, temperature: warning");
    EXPECT_EQ(ailments_from("21"), "");
}

class AProjector : public testing::TestWithParam<const char*> {
  protected:
    std::unique_ptr<Projector> open(const FakeProjector& fake, const std::string& password = GetParam()) const {
        return open_projector(parse_address(fake.address()), password, 2s);
    }
};

TEST_P(AProjector, IsSwitchedAndAsked) {
    FakeProjector fake(GetParam());
    const auto projector = open(fake);
    EXPECT_EQ(projector->power(), Power::Off);
    fake.take_time(true);
    projector->turn_on();
    EXPECT_EQ(projector->power(), Power::Warming);
    fake.set_power('1');
    EXPECT_EQ(projector->power(), Power::On);
    projector->turn_off();
    EXPECT_EQ(projector->power(), Power::Cooling);
    fake.set_ailments("010020");
    EXPECT_EQ(projector->ailments(), "lamp: warning, filter: error");
    EXPECT_THAT(fake.heard(),
                ElementsAre("%1POWR ?", "%1POWR 1", "%1POWR ?", "%1POWR ?", "%1POWR 0", "%1POWR ?", "%1ERST ?"));
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutAPassword, AProjector, testing::Values("", "JBMIAProjectorLink"));

TEST(AProjectorInTrouble, SaysWhyAndWhatMendsIt) {
    FakeProjector fake("JBMIAProjectorLink");
    const auto trouble_of = [&](const std::string& password) {
        try {
            open_projector(parse_address(fake.address()), password, 200ms)->power();
            return std::string("none");
        } catch (const Trouble& trouble) {
            return std::string(trouble.what()) + "; " + trouble.remedy();
        }
    };
    EXPECT_THAT(trouble_of(""), AllOf(HasSubstr("wants a password"), HasSubstr("screen.power_password_file")));
    EXPECT_THAT(trouble_of("another"), AllOf(HasSubstr("refuses our password"), Not(HasSubstr("another"))));
    using Manner = FakeProjector::Manner;
    for (const auto& [manner, says] : {std::pair{Manner::Silent, "does not answer; look at its network cable"},
                                       {Manner::HangsUp, "it hangs up"},
                                       {Manner::Rude, "speaks no PJLink; it says \"SSH-2.0"},
                                       {Manner::Failing, "reports a fault of its own"}}) {
        fake.behave(manner);
        EXPECT_THAT(trouble_of("JBMIAProjectorLink"), HasSubstr(says));
    }
    fake.behave(Manner::Busy);
    EXPECT_EQ(trouble_of("JBMIAProjectorLink"), "none") << "it is asked again";
    const auto nobody = open_projector(PjLink{"127.0.0.1", tests::free_port()}, "", 1s);
    EXPECT_THAT([&] { nobody->power(); }, ThrowsMessage<Trouble>(HasSubstr("Connection refused")));
    const auto nowhere = open_projector(PjLink{"projector.invalid", 4352}, "", 1s);
    EXPECT_THAT([&] { nowhere->power(); }, ThrowsMessage<Trouble>(HasSubstr("its name is not found")));
}

TEST(CecCtlsOutput, TellsPowerAndPlace) {
    EXPECT_EQ(power_in("    Received from TV (0 to 4):\n    REPORT_POWER_STATUS\n\tpwr-state: on (0x00)\n"), Power::On);
    EXPECT_EQ(power_in("\tpwr-state: standby (0x01)\n"), Power::Off);
    EXPECT_EQ(power_in("\tpwr-state: to-on (0x02)\n"), Power::Warming);
    EXPECT_EQ(power_in("\tpwr-state: to-standby (0x03)\n"), Power::Cooling);
    EXPECT_EQ(power_in("\tTx, Not Acknowledged (4), Max Retries\n"), Power::Unknown);
    EXPECT_EQ(power_in("pwr-state"), Power::Unknown);
    EXPECT_EQ(physical_address_in("\tPhysical Address           : 1.0.0.0\n"), "1.0.0.0");
    for (const char* printed : {"", "Physical Address", "Physical Address : f.f.f.f\n", "Physical Address: 1.0\n"})
        EXPECT_EQ(physical_address_in(printed), "") << printed;
}

// On PATH, before the one that may be installed: a screen on a cable, whose power is in a file.
class AScreenOnACable : public testing::Test {
  protected:
    void SetUp() override {
        folder_.write("cec-ctl", "#!/bin/sh\ncd " + folder_.path().string() + R"script(
echo "$*" >>asked
[ -e hangs ] && exec sleep 600
[ "$2" = /dev/cec0 ] || { echo "Failed to open $2: No such file or directory" >&2; exit 1; }
case "$*" in
*--playback*) printf '\tPhysical Address           : %s\n' "$(cat place)" ;;
*--image-view-on*) echo on >power ;;
*--standby*) echo standby >power ;;
*--give-device-power-status*) printf '\tpwr-state: %s (0x00)\n' "$(cat power)" ;;
esac
)script");
        std::filesystem::permissions(folder_ / "cec-ctl", std::filesystem::perms{0755});
        folder_.write("place", "1.0.0.0\n");
        folder_.write("power", "standby\n");
        path_ = std::getenv("PATH");
        ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
    }
    void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }
    std::string trouble_of(Projector& screen) const {
        try {
            screen.power();
            return "none";
        } catch (const Trouble& trouble) {
            return std::string(trouble.what()) + "; " + trouble.remedy();
        }
    }

    tests::TemporaryFolder folder_;
    std::string path_;
};

TEST_F(AScreenOnACable, IsSwitchedAndAskedByCecCtl) {
    const auto screen = open_projector(Cec{}, "", 5s);
    EXPECT_EQ(screen->power(), Power::Off);
    screen->turn_on();
    EXPECT_EQ(screen->power(), Power::On);
    EXPECT_THAT(tests::contents_of(folder_ / "asked"), HasSubstr("--active-source phys-addr=1.0.0.0"));
    screen->turn_off();
    EXPECT_EQ(screen->power(), Power::Off);
    EXPECT_EQ(screen->ailments(), "");
}

TEST_F(AScreenOnACable, ThatIsInTroubleSaysWhyAndWhatMendsIt) {
    EXPECT_THAT(trouble_of(*open_projector(Cec{"/dev/cec7"}, "", 5s)),
                AllOf(HasSubstr("/dev/cec7 cannot be opened: No such file"), HasSubstr("ls /dev/cec*")));
    const auto screen = open_projector(Cec{}, "", 5s);
    folder_.write("place", "f.f.f.f\n");
    EXPECT_THAT(trouble_of(*screen), AllOf(HasSubstr("nothing is plugged in"), HasSubstr("Anynet+")));
    folder_.write("hangs", "");
    EXPECT_THAT(trouble_of(*open_projector(Cec{}, "", 200ms)), HasSubstr("does not come to an end"));
    ::setenv("PATH", (folder_ / "nowhere").c_str(), 1);
    EXPECT_THAT(trouble_of(*screen), AllOf(HasSubstr("not installed"), HasSubstr("apt install v4l-utils")));
}

}  // namespace
}  // namespace quadrat::projector
