// SPDX-License-Identifier: Apache-2.0
#include "display/kms/card_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/display/cards.hpp"

namespace quadrat::display {
namespace {

using ::testing::AllOf;
using testing::as;
using testing::connector;
using ::testing::HasSubstr;
using testing::v3d;
using testing::vc4;

constexpr Plug kIn = Plug::Connected;
constexpr Plug kOut = Plug::Disconnected;

// "card1 HDMI-A-1", "card1 without a screen: …" or "no card: …"
std::string chosen(const std::vector<Card>& cards, std::string_view wanted = "") {
    const CardChoice choice = choose_card(cards, wanted);
    if (const auto* none = std::get_if<NoCard>(&choice)) return "no card: " + none->reason;
    if (const auto* dark = std::get_if<NoScreen>(&choice))
        return cards[dark->card].path + " without a screen: " + dark->reason;
    const auto& found = std::get<ChosenConnector>(choice);
    return cards[found.card].path + " " + cards[found.card].connectors[found.connector].name;
}

TEST(ChooseCard, TakesTheOneThatShowsWhicheverNumberThePiGaveIt) {
    EXPECT_EQ(chosen({v3d("card0"), vc4("card1", kIn, kOut)}), "card1 HDMI-A-1");
    EXPECT_EQ(chosen({vc4("card0", kOut, kIn), v3d("card1")}), "card0 HDMI-A-2");
}

TEST(ChooseCard, TakesTheFirstOfTwoScreensUnlessAnotherIsConfigured) {
    const std::vector<Card> cards{v3d("card0"), vc4("card1", kIn, kIn)};
    EXPECT_EQ(chosen(cards), "card1 HDMI-A-1");
    EXPECT_EQ(chosen(cards, "HDMI-A-2"), "card1 HDMI-A-2");
}

TEST(ChooseCard, WaitsForTheConfiguredConnectorEvenWhenAnotherHasAScreen) {
    EXPECT_THAT(chosen({vc4("card0", kOut, kIn)}, "HDMI-A-1"),
                AllOf(HasSubstr("card0 without"), HasSubstr("HDMI-A-1")));
}

TEST(ChooseCard, FindsTheConfiguredConnectorOnTheSecondCard) {
    const Card nuc{"card1", "i915", true, "", {connector(7, "DP-1", kIn)}};
    EXPECT_EQ(chosen({vc4("card0", kIn, kIn), nuc}, "DP-1"), "card1 DP-1");
}

TEST(ChooseCard, AConnectorThatNoCardHasLeavesNoScreenDark) {
    const std::vector<Card> cards{vc4("card0", kIn, kOut)};
    EXPECT_EQ(chosen(cards, "HDMI-1"), "card0 HDMI-A-1");
    const CardChoice choice = choose_card(cards, "HDMI-1");
    EXPECT_THAT(std::get<ChosenConnector>(choice).warning,
                AllOf(HasSubstr("\"HDMI-1\""), HasSubstr("HDMI-A-1, HDMI-A-2")));
    EXPECT_EQ(std::get<ChosenConnector>(choose_card(cards, "HDMI-A-1")).warning, "");
    EXPECT_EQ(chosen(cards, "Writeback-1"), "card0 HDMI-A-1") << "nobody sees the recorder";
}

TEST(ChooseCard, NamesTheConnectorsThereAreWhenTheConfiguredOneIsNoneAndNoneHasAScreen) {
    EXPECT_THAT(chosen({vc4("card0", kOut, kOut)}, "HDMI-1"),
                AllOf(HasSubstr("\"HDMI-1\""), HasSubstr("HDMI-A-1, HDMI-A-2")));
}

TEST(ChooseCard, NeverTakesARecorderForAScreen) {
    const Card recorder{"card0", "vkms", true, "", {as(ConnectorUse::Writeback, connector(1, "Writeback-1", kIn))}};
    EXPECT_THAT(chosen({recorder}), AllOf(HasSubstr("no card"), HasSubstr("vkms")));
    EXPECT_THAT(chosen({vc4("card0", kOut, kOut)}), HasSubstr("card0 without a screen"));
}

TEST(ChooseCard, PrefersARealScreenToAVirtualOneAndTakesTheVirtualOneAlone) {
    const Card guest{"card0", "virtio_gpu", true, "", {as(ConnectorUse::Virtual, connector(1, "Virtual-1", kIn))}};
    EXPECT_EQ(chosen({guest}), "card0 Virtual-1");
    EXPECT_EQ(chosen({guest, vc4("card1", kIn, kOut)}), "card1 HDMI-A-1");
    EXPECT_EQ(chosen({guest, vc4("card1", kOut, kOut)}), "card0 Virtual-1");
}

TEST(ChooseCard, TriesAConnectorThatCannotTellOnlyWhenNoOtherIsSure) {
    const Card old{"card0", "i915", true, "", {connector(1, "VGA-1", Plug::Unknown), connector(2, "DP-1", kIn)}};
    EXPECT_EQ(chosen({old}), "card0 DP-1");
    const Card analogue{"card0", "i915", true, "", {connector(1, "VGA-1", Plug::Unknown), connector(2, "DP-1", kOut)}};
    EXPECT_EQ(chosen({analogue}), "card0 VGA-1");
}

TEST(ChooseCard, TakesAScreenWithoutAnEdidButNotOneWithoutModes) {
    Card card = vc4("card0", kIn, kOut);
    EXPECT_TRUE(card.connectors[0].edid.empty());
    EXPECT_EQ(chosen({card}), "card0 HDMI-A-1");
    card.connectors[0].modes.clear();
    EXPECT_THAT(chosen({card}), AllOf(HasSubstr("without a screen"), HasSubstr("names no modes yet")));
}

TEST(ChooseCard, PassesOverCardsThatCannotBeUsedAndSaysWhy) {
    Card denied = vc4("card0", kIn, kOut);
    denied.problem = "permission denied; add the user to the group video";
    Card old = vc4("card1", kIn, kOut);
    old.is_atomic = false;
    EXPECT_THAT(chosen({denied, old, v3d("card2")}),
                AllOf(HasSubstr("no card"), HasSubstr("group video"), HasSubstr("atomic"), HasSubstr("only renders")));
    EXPECT_EQ(chosen({denied, old, vc4("card3", kIn, kOut)}), "card3 HDMI-A-1");
}

TEST(ChooseCard, SaysWhatToCheckWhereThereIsNone) { EXPECT_THAT(chosen({}), HasSubstr("vc4-kms-v3d")); }

}  // namespace
}  // namespace quadrat::display
