// SPDX-License-Identifier: Apache-2.0
#include "kiosk/stage.hpp"

#include <gtest/gtest.h>

#include "kiosk/easel.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;

// The four candidates of a visit that asks for the best trees, on a stage of 320 by 180.
class AStage : public testing::Test {
  protected:
    AStage() : easel_(320, 180), stage_(easel_.renderer(), configuration_) {
        const auto scene = grow(genome::random_recipe(base::Seed{1}), {65, 64, 128});
        const auto gpu = upload_now(easel_.renderer(), scene);
        for (int i = 0; i < 4; ++i) cast_.scenes.push_back({scene, gpu});
        state_.screen = exhibit::Screen::Ask;
    }
    render::Frame frame(Instant now) {
        return stage_.frame({state_, timings_, cast_, flash_, 0.5F, now}, easel_.display().begin_frame());
    }
    mesh::Image drawn(Instant now) {
        const render::Frame f = frame(now);
        easel_.renderer().draw(f);
        return easel_.renderer().read_pixels(f);
    }

    Configuration configuration_;
    Easel easel_;
    Stage stage_;
    exhibit::State state_;
    exhibit::Timings timings_;
    Cast cast_;
    std::optional<Flash> flash_;
};

TEST_F(AStage, ShowsFourWhileItAsksAndOneOtherwise) {
    EXPECT_EQ(frame(3s).views.size(), 4U);
    state_.screen = exhibit::Screen::Attract;
    EXPECT_EQ(frame(3s).views.size(), 1U);
    state_.screen = exhibit::Screen::Finale;
    EXPECT_EQ(frame(3s).views.size(), 1U);
    cast_.scenes.clear();
    EXPECT_TRUE(frame(3s).views.empty());
    EXPECT_FALSE(frame(3s).signs.empty()) << "the words are there before the first landscapes are";
}

TEST_F(AStage, EveryButtonIsAcknowledgedOnTheNextFrameWhateverIsShown) {
    for (const auto screen : {exhibit::Screen::Ask, exhibit::Screen::Attract, exhibit::Screen::Breed,
                              exhibit::Screen::StillThere, exhibit::Screen::Finale}) {
        state_.screen = screen;
        state_.since = 5s;
        for (const auto button :
             {exhibit::Choice::A, exhibit::Choice::B, exhibit::Choice::C, exhibit::Choice::D, exhibit::Choice::Back}) {
            flash_.reset();
            const mesh::Image before = drawn(10s);
            flash_ = Flash{button, 10s};
            const mesh::Image pressed = drawn(10s);
            std::size_t changed = 0;
            for (std::size_t i = 0; i < before.bytes.size(); ++i)
                changed += std::abs(before.bytes[i] - pressed.bytes[i]) > 40 ? 1U : 0U;
            EXPECT_GT(changed, 200U) << static_cast<int>(screen) << " " << static_cast<int>(button);
            const mesh::Image later = drawn(11s);
            flash_.reset();
            EXPECT_EQ(later, drawn(11s)) << "it is gone a second later";
        }
    }
}

TEST_F(AStage, TheFourAreSeenFromTheSamePlaceInPlan) {
    const render::Frame f = frame(20s);
    for (const render::View& view : f.views) {
        EXPECT_EQ(view.camera.eye_m.x, f.views[0].camera.eye_m.x);
        EXPECT_EQ(view.camera.eye_m.z, f.views[0].camera.eye_m.z);
    }
}

TEST_F(AStage, CountsDownInTheSitesOwnWords) {
    configuration_.texts["still-there"] = "Noch da?";
    state_.screen = exhibit::Screen::StillThere;
    state_.since = 10s;
    EXPECT_EQ(words({state_, timings_, cast_, flash_, 0, 13s}, configuration_), "Noch da?  7");
}

}  // namespace
}  // namespace quadrat::kiosk
