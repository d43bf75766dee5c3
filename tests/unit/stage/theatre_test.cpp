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
    void bring_until(const OnGpu::Wanted& wanted, std::size_t scenes) {
        const auto began = std::chrono::steady_clock::now();
        const OnGpu::Haste frame{1U << 22U, [] { return true; }};
        while (theatre_.on_gpu().size() < scenes &&
               std::chrono::steady_clock::now() - began < std::chrono::seconds{120}) {
            theatre_.on_gpu().bring(wanted, frame);
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        EXPECT_EQ(theatre_.on_gpu().size(), scenes);
    }
    void bring_nothing(const OnGpu::Wanted& wanted) {
        theatre_.on_gpu().bring(wanted, OnGpu::Haste{1, [] { return false; }});
    }

    site::Configuration configuration_;
    Theatre theatre_{configuration_};
    nursery::Scenes scenes_;
};

TEST_F(TheatreTest, WhatIsAheadIsThereAtOnce) {
    bring_until({{}, {}, {{}, {scenes_[0], scenes_[1]}}}, 2);
    bring_nothing({{{{scenes_[1], scenes_[0]}, true}}});
    EXPECT_TRUE(theatre_.has({{scenes_[1], scenes_[0]}, {}, 1, {}}));
    EXPECT_FALSE(theatre_.has({{scenes_[0], scenes_[2]}, {}, 2, {}}));
}

TEST_F(TheatreTest, WhatIsLitMeanwhileHoldsNothingBackWhereverItComes) {
    // Begun, and as many as are worked out at once.
    bring_nothing({{}, {}, {{}, {scenes_.begin(), scenes_.begin() + 4}}});
    bring_until({{}, {}, {{}, {scenes_.rbegin(), scenes_.rend()}}}, scenes_.size());
}

TEST_F(TheatreTest, OneBatchIsWholeBeforeTheNextBegins) {
    const OnGpu::Wanted wanted{{{{scenes_[0], scenes_[1]}}, {{scenes_[2], scenes_[3]}, true}}};
    bring_until(wanted, 1);
    EXPECT_FALSE(theatre_.has({{scenes_[2]}, {}, 1, {}}));
    bring_until(wanted, 4);
    EXPECT_TRUE(theatre_.has({{scenes_[0], scenes_[1], scenes_[2], scenes_[3]}, {}, 1, {}}));
}

TEST_F(TheatreTest, WhatIsHeldStaysAndIsNotBrought) {
    bring_until({{{{scenes_[0]}}}}, 1);
    bring_nothing({{}, {scenes_[0], scenes_[1]}});
    EXPECT_EQ(theatre_.on_gpu().size(), 1U);
    bring_nothing({});
    EXPECT_EQ(theatre_.on_gpu().size(), 0U);
}

TEST_F(TheatreTest, DrawsTheGroundByWhatTheSiteDecidesAndThePictureSaysSo) {
    const nursery::Act act{{scenes_[0]}, {genome::random_recipe(base::Seed{40}.child(0))}, 1, {}};
    const auto photograph = [&](const std::string& ground) {
        site::Configuration configuration;
        configuration.picture.ground = ground;
        Theatre theatre(configuration);
        theatre.enter(canvas_);
        theatre.on_gpu().bring({{{act.scenes}}}, OnGpu::Haste::everything());
        EXPECT_TRUE(theatre.has(act));
        const pictures::Picture picture = picture_of(act, canvas_, configuration);
        EXPECT_EQ(picture.ground, render::ground_named(ground));
        return theatre.photograph(act, picture, canvas_);
    };
    EXPECT_EQ(photograph("blocks"), photograph("blocks"));
    EXPECT_NE(photograph("blocks"), photograph("roam"));
}

TEST_F(TheatreTest, WhatIsNoLongerAheadIsFreed) {
    bring_until({{}, {}, {{}, {scenes_[0], scenes_[1]}}}, 2);
    bring_nothing({{}, {}, {{}, {scenes_[1]}}});
    EXPECT_EQ(theatre_.on_gpu().size(), 1U);
}

}  // namespace
}  // namespace quadrat::stage
