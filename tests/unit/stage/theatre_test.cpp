// SPDX-License-Identifier: Apache-2.0
#include "stage/theatre.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "unit/render/gpu_fixture.hpp"

namespace quadrat::stage {
namespace {

class TheatreTest : public render::Gpu {
  protected:
    void SetUp() override {
        render::Gpu::SetUp();
        theatre_.enter(canvas_);
        for (std::uint64_t i = 0; i < 8; ++i)
            scenes_.push_back(nursery::grow(genome::random_recipe(base::Seed{40}.child(i)), {65, 64, 128}));
    }

    // As many frames as it takes. What works in the background has only what others leave of the processors.
    void prepare_until(const nursery::Prospect& prospect, std::size_t ahead) {
        const auto began = std::chrono::steady_clock::now();
        const Theatre::Haste frame{1U << 22U, [] { return true; }, 1};
        while (theatre_.scenes_ahead() < ahead &&
               std::chrono::steady_clock::now() - began < std::chrono::seconds{120}) {
            theatre_.prepare_ahead(prospect, frame);
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
    }

    site::Configuration configuration_;
    Theatre theatre_{configuration_};
    nursery::Scenes scenes_;
};

TEST_F(TheatreTest, WhatIsAheadIsThereAtOnce) {
    prepare_until({{}, {scenes_[0], scenes_[1]}}, 2);
    EXPECT_EQ(theatre_.scenes_ahead(), 2U);
    const Theatre::Haste none{0, [] { return false; }, 1};
    EXPECT_TRUE(theatre_.prepare(nursery::Act{{scenes_[1], scenes_[0]}, {}, 1, {}}, none));
    EXPECT_FALSE(theatre_.prepare(nursery::Act{{scenes_[0], scenes_[2]}, {}, 2, {}}, none));
}

TEST_F(TheatreTest, WhatIsLitMeanwhileHoldsNothingBackWhereverItComes) {
    // Begun, and as many as are worked out at once.
    theatre_.prepare_ahead({{}, {scenes_.begin(), scenes_.begin() + 4}}, {1, [] { return false; }, 1});
    nursery::Scenes others_first(scenes_.rbegin(), scenes_.rend());
    prepare_until({{}, others_first}, scenes_.size());
    EXPECT_EQ(theatre_.scenes_ahead(), scenes_.size());
}

TEST_F(TheatreTest, DrawsTheGroundByWhatTheSiteDecidesAndThePictureSaysSo) {
    const nursery::Act act{{scenes_[0]}, {genome::random_recipe(base::Seed{40}.child(0))}, 1, {}};
    const auto photograph = [&](const std::string& ground) {
        site::Configuration configuration;
        configuration.picture.ground = ground;
        Theatre theatre(configuration);
        theatre.enter(canvas_);
        EXPECT_TRUE(theatre.prepare(act, Theatre::Haste::everything()));
        const pictures::Picture picture = picture_of(act, canvas_, configuration);
        EXPECT_EQ(picture.ground, render::ground_named(ground));
        return theatre.photograph(act, picture, canvas_);
    };
    EXPECT_EQ(photograph("blocks"), photograph("blocks"));
    EXPECT_NE(photograph("blocks"), photograph("roam"));
}

TEST_F(TheatreTest, WhatIsNoLongerAheadIsFreed) {
    prepare_until({{}, {scenes_[0], scenes_[1]}}, 2);
    theatre_.prepare_ahead({{}, {scenes_[1]}}, {1, [] { return false; }, 1});
    EXPECT_EQ(theatre_.scenes_ahead(), 1U);
}

}  // namespace
}  // namespace quadrat::stage
