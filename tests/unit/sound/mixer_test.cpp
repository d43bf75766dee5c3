// SPDX-License-Identifier: Apache-2.0
#include "sound/mixer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "sound/mailbox.hpp"

namespace quadrat::sound {
namespace {

class AMixer : public testing::Test {
  protected:
    static const Soundscape& soundscape() {
        static const Soundscape once(base::Seed{1});
        return once;
    }
    static std::vector<Frame> next(Mixer& mixer, double seconds) {
        std::vector<Frame> frames(static_cast<std::size_t>(frames_of(seconds)));
        for (std::size_t at = 0; at < frames.size(); at += 480)
            mixer.fill(Block(frames).subspan(at, std::min<std::size_t>(480, frames.size() - at)));
        return frames;
    }
    static float mean_of(const std::vector<Frame>& frames) {
        double sum = 0;
        for (const Frame& frame : frames) sum += static_cast<double>(frame.left * frame.left);
        return static_cast<float>(std::sqrt(sum / static_cast<double>(frames.size())));
    }
    static float peak_of(const std::vector<Frame>& frames) {
        float peak = 0;
        for (const Frame& frame : frames) peak = std::max({peak, std::abs(frame.left), std::abs(frame.right)});
        return peak;
    }
    static Says speech(std::int64_t number, double seconds, float value = 0) {
        return {number, std::make_shared<const std::vector<float>>(frames_of(seconds), value)};
    }
    static Surrounds rain() {
        Surroundings surroundings;
        surroundings.set(Voice::Rain, 1);
        return {surroundings};
    }
};

TEST_F(AMixer, NeverPassesItsLevelHoweverMuchIsHeardAtOnce) {
    for (const float level : {0.1F, 0.5F, 1.0F}) {
        Mixer mixer(soundscape(), {level, 1, 1, 1});
        mixer.hear(rain());
        mixer.hear(speech(1, 3, 1));
        for (int i = 0; i < 20; ++i) mixer.hear(Sounds{Signal::Finale, i % 4});
        const float peak = peak_of(next(mixer, 3));
        EXPECT_LE(peak, level * 1.001F);
        EXPECT_GT(peak, level * 0.7F);
    }
}

TEST_F(AMixer, DucksTheLandscapeWhileSomebodySpeaks) {
    Mixer mixer(soundscape(), {1, 1, 1, 1});
    mixer.hear(rain());
    next(mixer, 3);
    const float before = mean_of(next(mixer, 2));
    mixer.hear(speech(1, 3));  // of silence: what is heard is the landscape
    next(mixer, 0.5);
    EXPECT_TRUE(mixer.is_speaking());
    const float during = mean_of(next(mixer, 2));
    EXPECT_NEAR(decibels(during / before), decibels(Mixer::kDucked), 2.5F);
    next(mixer, 3);
    EXPECT_FALSE(mixer.is_speaking());
    EXPECT_NEAR(decibels(mean_of(next(mixer, 2)) / before), 0, 2.5F);
}

TEST_F(AMixer, SaysOneAfterTheOtherAndNothingThatWasHushed) {
    Mixer mixer(soundscape(), {1, 0, 1, 1});
    mixer.hear(speech(1, 0.2, 0.3F));
    mixer.hear(speech(2, 0.2, 0.6F));
    next(mixer, 0.1);
    EXPECT_NEAR(peak_of(next(mixer, 0.05)), 0.27F, 0.01F);
    next(mixer, 0.1);
    EXPECT_NEAR(peak_of(next(mixer, 0.05)), 0.54F, 0.01F);
    EXPECT_EQ(mixer.said(), 1);
    mixer.hear(Hushes{4});
    EXPECT_EQ(mixer.said(), 2);
    next(mixer, 0.01);
    EXPECT_EQ(peak_of(next(mixer, 0.1)), 0);
    mixer.hear(speech(3, 0.2, 1));  // was being made while it was hushed
    EXPECT_EQ(peak_of(next(mixer, 0.3)), 0);
    mixer.hear(speech(4, 0.2, 1));
    EXPECT_GT(peak_of(next(mixer, 0.1)), 0.8F);
}

TEST_F(AMixer, IsSilentForWhomItIsNotMeant) {
    Mixer mixer(soundscape(), {1, 0, 0, 0});
    mixer.hear(rain());
    mixer.hear(speech(1, 0.3, 1));
    mixer.hear(Sounds{Signal::Press, 1});
    EXPECT_EQ(peak_of(next(mixer, 0.5)), 0);
    EXPECT_EQ(mixer.said(), 1) << "and time passes all the same";
    mixer.hear(SetsLevels{{1, 0, 0, 1}});
    mixer.hear(Sounds{Signal::Press, 1});
    EXPECT_GT(peak_of(next(mixer, 0.5)), 0.1F);
}

TEST(AMailbox, HoldsNoMoreThanItHasRoomForAndKeepsTheOrder) {
    Mailbox<int, 3> box;
    EXPECT_FALSE(box.take());
    EXPECT_TRUE(box.post(1) && box.post(2) && box.post(3));
    EXPECT_FALSE(box.post(4));
    EXPECT_EQ(box.take(), 1);
    EXPECT_TRUE(box.post(5));
    EXPECT_EQ(box.take(), 2);
    EXPECT_EQ(box.take(), 3);
    EXPECT_EQ(box.take(), 5);
    EXPECT_FALSE(box.take());
}

TEST(AMailbox, LosesNothingBetweenTwoThreads) {
    constexpr int kLetters = 100'000;
    Mailbox<int, 16> box;
    std::thread writer([&] {
        for (int i = 0; i < kLetters;)
            if (box.post(i))
                ++i;
            else
                std::this_thread::yield();
    });
    int expected = 0;
    while (expected < kLetters)
        if (const auto letter = box.take()) {
            if (*letter != expected) break;
            ++expected;
        }
    writer.join();
    EXPECT_EQ(expected, kLetters);
}

}  // namespace
}  // namespace quadrat::sound
