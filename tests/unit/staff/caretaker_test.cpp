// SPDX-License-Identifier: Apache-2.0
#include "staff/caretaker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "firmware-io/merged_buttons.hpp"
#include "support/process.hpp"
#include "unit/display/named_screen.hpp"

namespace quadrat::staff {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

TEST(Caretaker, NamesTheScreenThatIsThereNow) {
    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    firmware_io::MergedButtons buttons{{}};
    Panel panel(buttons);
    Ladder ladder("", folder.path(), Seconds{0});
    tests::NamedScreen screen("no GPU", "no graphics card yet");
    Caretaker caretaker({configuration, {}, folder.path(), folder.path(), ladder, screen});
    caretaker.step_figures();
    std::ignore = caretaker.look(panel, {}, 1s);
    ASSERT_NE(caretaker.board(), nullptr);
    EXPECT_THAT(caretaker.board()->lines, Contains(HasSubstr("no graphics card yet")));
    screen.becomes("V3D 4.2", "HDMI-A-1 1920x1080@60");
    std::ignore = caretaker.look(panel, {}, 2s);
    EXPECT_THAT(caretaker.board()->lines, Contains("V3D 4.2, HDMI-A-1 1920x1080@60"));
}

class AsksFromAfar : public testing::Test {
  protected:
    // Looks once a frame as the loop does, for so long of the exhibit's time; errands may be slower than that.
    template <typename Between>
    void live(base::Instant span, const Between& between) {
        for (const base::Instant until = now + span; now < until; now += 20ms) {
            between();
            std::ignore = caretaker.look(panel, {}, now);
            caretaker.framed(display::Presented{}, now, {1, 1, 1, 1, 1, 0, 0, 0});
            if (const std::string wish = caretaker.take_picture_wish(); !wish.empty()) wishes.push_back(wish);
            std::this_thread::sleep_for(1ms);
        }
    }
    // Frame by frame until it has come, on a disk however slow.
    template <typename Comes>
    bool comes(const Comes& has_come) {
        const auto begun = std::chrono::steady_clock::now();
        while (!has_come() && std::chrono::steady_clock::now() - begun < 60s) live(20ms, [] {});
        return has_come();
    }
    bool exists(const char* name) const { return std::filesystem::exists(folder / name); }

    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    firmware_io::MergedButtons buttons{{}};
    Panel panel{buttons};
    Ladder ladder{"", folder.path(), Seconds{0}};
    tests::NamedScreen screen{"a GPU", "a screen"};
    Caretaker caretaker{{configuration, {}, folder.path(), folder.path(), ladder, screen}};
    base::Instant now = 1s;
    std::vector<std::string> wishes;
};

TEST_F(AsksFromAfar, AFloodOfThemCostsAPictureASecond) {
    live(10s, [&] { folder.write(kGlanceAsked, ""), folder.write(kHealthAsked, ""); });
    EXPECT_GE(wishes.size(), 1U);
    EXPECT_LE(wishes.size(), 12U);
    EXPECT_TRUE(comes([&] { return exists("health.json"); }));
}

TEST_F(AsksFromAfar, HealthIsOfTheMomentItWasAskedFor) {
    ASSERT_TRUE(comes([&] { return exists("health.json"); }));
    std::filesystem::remove(folder / "health.json");
    live(3s, [] {});
    EXPECT_FALSE(exists("health.json")) << "by itself it comes once a minute";
    folder.write(kHealthAsked, "");
    EXPECT_TRUE(comes([&] { return exists("health.json") && !exists(kHealthAsked); }));
}

TEST_F(AsksFromAfar, TheLampsAreTestedForAWhileAndThenAreTheVisits) {
    live(2s, [] {});
    EXPECT_EQ(caretaker.lamps(now), std::nullopt);
    folder.write(kLampTestAsked, "");
    ASSERT_TRUE(comes([&] { return caretaker.lamps(now).has_value(); }));
    EXPECT_FALSE(exists(kLampTestAsked));
    EXPECT_EQ(*caretaker.lamps(now), lamp_test(now));
    live(14s, [] {});
    EXPECT_EQ(caretaker.lamps(now), std::nullopt);
}

}  // namespace
}  // namespace quadrat::staff
