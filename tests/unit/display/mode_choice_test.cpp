// SPDX-License-Identifier: Apache-2.0
#include "display/kms/mode_choice.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "display/kms/placement.hpp"
#include "unit/display/cards.hpp"

namespace quadrat::display {
namespace {

using ::testing::HasSubstr;
using testing::interlaced;
using ::testing::IsEmpty;
using testing::mode;
using testing::preferred;

std::string first(const std::vector<ScreenMode>& modes, std::string_view wanted = "") {
    const ModeLadder ladder = mode_ladder(modes, mode_from(wanted, "test"), {});
    if (ladder.rungs.empty()) return "none";
    const ScreenMode& best = modes[ladder.rungs[0].mode];
    return fmt::format("{}x{}{}@{:g}", best.size.width, best.size.height, best.is_interlaced ? "i" : "",
                       best.refresh_hz);
}

struct Case {
    const char* name;
    std::vector<ScreenMode> modes;
    const char* wanted;
    const char* chosen;
};
void PrintTo(const Case& tried, std::ostream* out) { *out << tried.name; }

class ModeChoice : public ::testing::TestWithParam<Case> {};
TEST_P(ModeChoice, IsTheOneExpected) { EXPECT_EQ(first(GetParam().modes, GetParam().wanted), GetParam().chosen); }

const std::vector<ScreenMode> kTelevision4k{
    preferred(3840, 2160, 60), mode(3840, 2160, 30),       mode(1920, 1080, 60), mode(1920, 1080, 59.94),
    mode(1920, 1080, 120),     interlaced(1920, 1080, 60), mode(1280, 720, 60),  mode(720, 576, 50)};

INSTANTIATE_TEST_SUITE_P(
    Screens, ModeChoice,
    ::testing::Values(
        Case{"Television4kIsDrivenAtItsOwnSize", kTelevision4k, "", "3840x2160@60"},
        Case{"Television4kWhoseCableCarries30",
             {preferred(3840, 2160, 30), mode(3840, 2160, 24), mode(1920, 1080, 60)},
             "",
             "3840x2160@30"},
        Case{"Television4kAt24IsBetterDrivenAtItsHalf",
             {preferred(3840, 2160, 24), mode(1920, 1080, 60), mode(1024, 768, 60)},
             "",
             "1920x1080@60"},
        Case{"ProjectorOf1200Lines",
             {preferred(1920, 1200, 59.95), mode(1920, 1080, 60), mode(1280, 720, 60), mode(1024, 768, 60)},
             "",
             "1920x1200@59.95"},
        Case{"OldProjectorOf1200Lines",
             {preferred(1600, 1200, 60), mode(1280, 1024, 60.02), mode(1024, 768, 60)},
             "",
             "1600x1200@60"},
        Case{"PortraitOf1920Lines", {preferred(1200, 1920, 59.95), mode(1080, 1920, 60)}, "", "1200x1920@59.95"},
        Case{"DeskMonitorOf1440Lines", {preferred(2560, 1440, 59.95), mode(1920, 1080, 60)}, "", "2560x1440@59.95"},
        Case{"FastMonitorOf1440LinesIsDrivenAt60",
             {preferred(2560, 1440, 165), mode(2560, 1440, 59.95), mode(1920, 1080, 60)},
             "",
             "2560x1440@59.95"},
        Case{"WiderThanAnyBufferTakesASmallerSizeOfItsShape",
             {preferred(5120, 2880, 60), mode(3840, 2400, 60), mode(2560, 1440, 60), mode(1024, 768, 60)},
             "",
             "2560x1440@60"},
        Case{"NeverAnotherShapeWhereThereIsOneOfItsOwn",
             {preferred(1920, 1200, 120), mode(1920, 1080, 60), mode(1680, 1050, 59.88), mode(1280, 1024, 60)},
             "",
             "1680x1050@59.88"},
        Case{"Configured4kIsTaken", kTelevision4k, "3840x2160@30", "3840x2160@30"},
        Case{"ConfiguredRateIsTakenAbove60", kTelevision4k, "1920x1080@120", "1920x1080@120"},
        Case{"ConfiguredWithoutARateIsNear60AndProgressive", kTelevision4k, "1920x1080", "1920x1080@60"},
        Case{"ConfiguredExactRateWins", kTelevision4k, "1920x1080@59.94", "1920x1080@59.94"},
        Case{"ConfiguredThatIsNotOfferedFallsBack", kTelevision4k, "1024x600@60", "3840x2160@60"},
        Case{"ConfiguredRateThatIsNotOfferedFallsBack", kTelevision4k, "1280x720@144", "3840x2160@60"},
        Case{"PreferredSmallPanelIsTaken", {mode(1920, 1080, 60), preferred(800, 480, 60.3)}, "", "800x480@60.3"},
        Case{"PreferredMissingTakesTheLargest",
             {mode(640, 480, 60), mode(1280, 720, 50), mode(1280, 720, 60)},
             "",
             "1280x720@60"},
        Case{"PortraitPanelIsTaken", {preferred(1080, 1920, 60), mode(640, 480, 60)}, "", "1080x1920@60"},
        Case{"FastPreferredGivesTheSameSizeAt60",
             {preferred(1920, 1080, 144), mode(1920, 1080, 60)},
             "",
             "1920x1080@60"},
        Case{"SmallFastPanelKeepsItsSize", {preferred(640, 480, 75), mode(1920, 1080, 60)}, "", "640x480@75"},
        Case{"FastOnlyFullHdIsTooMuchWork", {preferred(1920, 1080, 144), mode(1280, 720, 60)}, "", "1280x720@60"},
        Case{"PreferredAt30GivesItsSizeAt60", {preferred(1920, 1080, 30), mode(1920, 1080, 60)}, "", "1920x1080@60"},
        Case{"InterlacedPreferredIsNot",
             {ScreenMode{{1920, 1080}, 60, true, true}, mode(1280, 720, 60)},
             "",
             "1280x720@60"},
        Case{"OnlyTooLargeTakesTheSmallest", {mode(7680, 4320, 60), preferred(7680, 4320, 30)}, "", "7680x4320@30"},
        Case{"OnlyInterlacedIsBetterThanNothing", {interlaced(1920, 1080, 50)}, "", "1920x1080i@50"},
        Case{"NoModesGiveNone", {}, "1920x1080@60", "none"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(ModeLadder, WarnsWhenTheConfiguredModeIsNotOffered) {
    EXPECT_THAT(mode_ladder(kTelevision4k, WantedMode{{1024, 600}, 60}, {}).warning,
                ::testing::AllOf(HasSubstr("1024x600@60"), HasSubstr("3840x2160@60.00")));
    EXPECT_THAT(mode_ladder(kTelevision4k, WantedMode{{1280, 720}, 0}, {}).warning, IsEmpty());
    EXPECT_THAT(mode_ladder(kTelevision4k, {}, {}).warning, IsEmpty());
}

TEST(ModeLadder, ScalesFirstThenDrawsTheModesSizeThenGoesSmallerInItsShape) {
    const std::vector<ScreenMode> modes{preferred(1920, 1080, 60), mode(1280, 720, 60), mode(1024, 768, 60),
                                        mode(640, 360, 60), mode(640, 480, 60)};
    EXPECT_THAT(
        mode_ladder(modes, {}, {1280, 720}).rungs,
        ::testing::ElementsAre(Rung{0, {1280, 720}}, Rung{0, {1920, 1080}}, Rung{1, {1280, 720}}, Rung{3, {640, 360}}));
}

TEST(ModeLadder, OfALargePanelDrawsFullHdAndTriesTheSlowerRateBeforeASmallerMode) {
    EXPECT_THAT(mode_ladder(kTelevision4k, {}, {}).rungs,
                ::testing::ElementsAre(Rung{0, {1920, 1080}}, Rung{1, {1920, 1080}}, Rung{2, {1920, 1080}},
                                       Rung{6, {1280, 720}}, Rung{0, {3840, 2160}}));
    const std::vector<ScreenMode> desk{preferred(2560, 1440, 60), mode(1280, 720, 60)};
    EXPECT_THAT(mode_ladder(desk, {}, {}).rungs,
                ::testing::ElementsAre(Rung{0, {1920, 1080}}, Rung{0, {2560, 1440}}, Rung{1, {1280, 720}}))
        << "a card that cannot scale draws all of it";
}

TEST(ModeLadder, HasNoRungOfAnotherShapeThanThePanels) {
    const std::vector<ScreenMode> modes{preferred(1600, 1200, 60), mode(1280, 1024, 60.02), mode(1280, 720, 60),
                                        mode(1024, 768, 60),       mode(800, 600, 60.3),    mode(640, 480, 59.94)};
    const auto rungs = mode_ladder(modes, {}, {}).rungs;
    ASSERT_GE(rungs.size(), 3U);
    for (const Rung& rung : rungs) {
        EXPECT_TRUE(is_same_shape(modes[rung.mode].size, {4, 3})) << modes[rung.mode].size.width;
        EXPECT_TRUE(is_same_shape(rung.draw, {4, 3})) << rung.draw.width;
    }
}

TEST(ModeLadder, FallsBackFromAConfiguredSizeOfAnotherShapeToOneWithoutBars) {
    const std::vector<ScreenMode> modes{preferred(1920, 1200, 60)};
    EXPECT_THAT(mode_ladder(modes, {}, {1280, 720}).rungs,
                ::testing::ElementsAre(Rung{0, {1280, 720}}, Rung{0, {1920, 1200}}));
}

TEST(ModeLadder, DoesNotTryTheSameRungTwice) {
    const std::vector<ScreenMode> modes{preferred(1920, 1080, 60)};
    EXPECT_THAT(mode_ladder(modes, {}, {1920, 1080}).rungs, ::testing::ElementsAre(Rung{0, {1920, 1080}}));
}

}  // namespace
}  // namespace quadrat::display
