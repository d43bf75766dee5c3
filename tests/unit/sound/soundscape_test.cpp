// SPDX-License-Identifier: Apache-2.0
#include "sound/soundscape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sound/levels.hpp"
#include "sound/signals.hpp"

namespace quadrat::sound {
namespace {

Surroundings only(Voice voice, float share = 1) {
    Surroundings heard;
    heard.set(voice, share);
    return heard;
}

std::vector<Frame> heard(const Soundscape& soundscape, const Surroundings& what, double seconds, FrameIndex first = 0) {
    std::vector<Frame> frames(static_cast<std::size_t>(frames_of(seconds)));
    soundscape.add(frames, first, what, what);
    return frames;
}

float peak_of(const std::vector<Frame>& frames) {
    float peak = 0;
    for (const Frame& frame : frames) peak = std::max({peak, std::abs(frame.left), std::abs(frame.right)});
    return peak;
}

float mean_of(const std::vector<Frame>& frames) {
    double sum = 0;
    for (const Frame& frame : frames)
        sum += static_cast<double>(frame.left * frame.left + frame.right * frame.right) / 2;
    return static_cast<float>(std::sqrt(sum / static_cast<double>(frames.size())));
}

// How often the left channel passes zero, per second: a measure of its pitch.
double crossings_per_s(const std::vector<Frame>& frames) {
    int crossings = 0;
    for (std::size_t i = 1; i < frames.size(); ++i) crossings += (frames[i].left < 0) != (frames[i - 1].left < 0);
    return crossings * static_cast<double>(kRate) / static_cast<double>(frames.size());
}

TEST(Soundscape, IsTheSameInWhateverBlocksItIsAskedFor) {
    Surroundings all;
    for (std::size_t i = 0; i < kVoices; ++i) all.set(static_cast<Voice>(i), 0.9F);
    const Soundscape soundscape(base::Seed{5});
    const std::vector<Frame> whole = heard(soundscape, all, 4, 1'000'000);
    std::vector<Frame> parts(whole.size());
    const std::size_t lengths[] = {480, 1, 77, 4'800, 960};
    for (std::size_t at = 0, i = 0; at < parts.size(); ++i) {
        const std::size_t length = std::min(lengths[i % 5], parts.size() - at);
        soundscape.add(Block(parts).subspan(at, length), 1'000'000 + static_cast<FrameIndex>(at), all, all);
        at += length;
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        ASSERT_NEAR(parts[i].left, whole[i].left, 1e-6F) << i;
        ASSERT_NEAR(parts[i].right, whole[i].right, 1e-6F) << i;
    }
}

TEST(Soundscape, IsSilentWhereNothingIsHeard) { EXPECT_EQ(peak_of(heard(Soundscape(base::Seed{5}), {}, 1)), 0); }

TEST(Soundscape, LetsEveryVoiceBeHeardWithinAMinuteAndNoneAlone) {
    const Soundscape soundscape(base::Seed{11});
    for (std::size_t i = 0; i < kVoices; ++i) {
        const auto voice = static_cast<Voice>(i);
        const std::vector<Frame> frames = heard(soundscape, only(voice), 60);
        EXPECT_GT(decibels(mean_of(frames)), -52) << name_of(voice);
        EXPECT_LT(decibels(mean_of(frames)), -14) << name_of(voice);
        EXPECT_LT(peak_of(frames), 1) << name_of(voice);
        EXPECT_GT(peak_of(frames), peak_of(heard(soundscape, only(voice, 0.1F), 60))) << name_of(voice);
    }
}

TEST(Soundscape, SeldomReachesTheLimiterWithAllVoicesTogether) {
    Surroundings all;
    for (std::size_t i = 0; i < kVoices; ++i) all.set(static_cast<Voice>(i), 1);
    const std::vector<Frame> frames = heard(Soundscape(base::Seed{2}), all, 60);
    const auto loud = std::ranges::count_if(
        frames, [](const Frame& frame) { return std::max(std::abs(frame.left), std::abs(frame.right)) > 1; });
    EXPECT_LT(static_cast<double>(loud), 0.005 * static_cast<double>(frames.size()));
}

TEST(Soundscape, HasItsVoicesInTheirOwnPitch) {
    const Soundscape soundscape(base::Seed{11});
    const auto pitch = [&](Voice voice) { return crossings_per_s(heard(soundscape, only(voice), 20)); };
    EXPECT_LT(pitch(Voice::Wind), 0.5 * pitch(Voice::Needles));
    EXPECT_LT(pitch(Voice::Needles), 0.6 * pitch(Voice::Leaves));
    EXPECT_LT(pitch(Voice::Stream), pitch(Voice::Rain));
}

TEST(Soundscape, GlidesFromOneToTheOther) {
    const Soundscape soundscape(base::Seed{11});
    std::vector<Frame> frames(static_cast<std::size_t>(frames_of(4.0)));
    soundscape.add(frames, 0, only(Voice::Rain), {});
    const std::size_t quarter = frames.size() / 4;
    const std::vector<Frame> first(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(quarter));
    const std::vector<Frame> last(frames.end() - static_cast<std::ptrdiff_t>(quarter), frames.end());
    EXPECT_LT(mean_of(last), 0.5F * mean_of(first));
}

TEST(Signals, StayWithinTheirBoundsAndEndInSilence) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(Signal::count); ++i)
        for (int place = 0; place <= 4; ++place) {
            const auto signal = static_cast<Signal>(i);
            std::vector<Frame> frames(static_cast<std::size_t>(frames_of(signal)));
            add_signal(frames, 0, signal, place);
            EXPECT_LE(peak_of(frames), 1) << i;
            EXPECT_GT(peak_of(frames), 0.1F) << i;
            EXPECT_LT(std::abs(frames.back().left), 1e-3F) << i;
            std::vector<Frame> after(4'800);
            add_signal(after, frames_of(signal), signal, place);
            EXPECT_LT(peak_of(after), 1e-6F) << i;
        }
}

TEST(Signals, OfAPlaceRiseFromAToDAndStandWhereTheSignsStand) {
    double below = 0;
    for (int place = 0; place < 4; ++place) {
        std::vector<Frame> frames(4'800);
        add_signal(frames, 0, Signal::Choice, place);
        const double pitch = crossings_per_s(frames);
        EXPECT_GT(pitch, below) << place;
        below = pitch;
        double left = 0, right = 0;
        for (const Frame& frame : frames) left += std::abs(frame.left), right += std::abs(frame.right);
        EXPECT_EQ(left > right, place % 2 == 0) << place;
    }
}

}  // namespace
}  // namespace quadrat::sound
