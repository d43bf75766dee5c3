// SPDX-License-Identifier: Apache-2.0
#include "staff/caretaker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "firmware-io/merged_buttons.hpp"
#include "site/settings.hpp"
#include "staff/landscapes.hpp"
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

TEST_F(AsksFromAfar, APreviewWaitsForWhoPlaysAndSaysSo) {
    const std::string wish = to_json({"fr", "attract", {{"attract", "Venez"}}});
    const auto waits = [&] { return exists(kPreviewWaits) && tests::contents_of(folder / kPreviewWaits) == "visitor"; };
    std::optional<PreviewWish> taken;
    const auto look = [&](bool has_visitor) {
        live(20ms, [] {});
        taken = caretaker.take_preview_wish(has_visitor);
    };
    // Another wish while the first waits: whoever asks takes away what was said of the first.
    for (int asked = 0; asked < 2; ++asked) {
        std::filesystem::remove(folder / kPreviewWaits);
        folder.write(kPreviewAsked, wish);
        EXPECT_TRUE(comes([&] { return look(true), waits(); })) << asked;
        EXPECT_FALSE(taken);
    }
    look(false);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->language, "fr");
    EXPECT_TRUE(comes([&] { return !exists(kPreviewWaits); }));
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

// An exhibit beside one that shares.
class ANeighbour : public testing::Test {
  protected:
    // What it shows of others, once it has looked so often as `until` wants.
    bool comes(Caretaker& caretaker, const std::function<bool()>& until) {
        const auto begun = std::chrono::steady_clock::now();
        while (!until() && std::chrono::steady_clock::now() - begun < 60s) {
            changes += caretaker.look(panel, {}, now += 20ms).follows_settings ? 1 : 0;
            std::this_thread::sleep_for(1ms);
        }
        return until();
    }
    CaretakerParts parts(const char* takes) {
        folder.write("quadrat.toml", std::string("[fleet]\ntakes = \"") + takes + "\"\n");
        const site::Settings settings = site::settings_for_people(folder / "quadrat.toml", folder.path());
        configuration = settings.configuration;
        return {configuration, settings, folder.path(), folder.path(), ladder, screen};
    }
    void share(const std::string& code) const { keep_guest(folder / kGuests, code, "hall-2"); }

    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    firmware_io::MergedButtons buttons{{}};
    Panel panel{buttons};
    Ladder ladder{"", folder.path(), Seconds{0}};
    tests::NamedScreen screen{"a GPU", "a screen"};
    base::Instant now = 1s;
    int changes = 0;
};

TEST_F(ANeighbour, ShowsLandscapesOfOtherExhibitsWhereTheSiteTakesThem) {
    Caretaker caretaker(parts("all"));
    const auto shows = [&](std::size_t count) {
        return comes(caretaker, [&, count] { return configuration.attract.guests.size() == count; });
    };
    share("Q1-AAAA");
    ASSERT_TRUE(shows(1));
    share("Q1-BBBB");
    ASSERT_TRUE(shows(2));
    EXPECT_THAT(configuration.attract.guests, testing::ElementsAre("Q1-AAAA", "Q1-BBBB"));
    std::filesystem::remove(folder / kGuests / (id_of_landscape("Q1-AAAA") + ".code"));
    ASSERT_TRUE(shows(1));
    EXPECT_EQ(changes, 3) << "whoever shows them is told, and only then";
}

TEST_F(ANeighbour, DoesNotShowThemBeforeStaffChooseThem) {
    for (const char* takes : {"nothing", "chosen"}) {
        Caretaker caretaker(parts(takes));
        share("Q1-AAAA");
        changes = 0;
        ASSERT_TRUE(comes(caretaker, [&] { return changes > 0; }));
        EXPECT_TRUE(configuration.attract.guests.empty()) << takes;
    }
}

}  // namespace
}  // namespace quadrat::staff
