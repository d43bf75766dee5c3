// SPDX-License-Identifier: Apache-2.0
#include "sound/mixer.hpp"

#include <algorithm>
#include <cassert>

#include "sound/tones.hpp"

namespace quadrat::sound {
namespace {

constexpr FrameIndex kGlide = frames_of(2.0);
constexpr std::size_t kMostSignals = 8;
constexpr float kSpeechGain = 0.9F;

}  // namespace

Mixer::Mixer(const Soundscape& soundscape, const Levels& levels)
    : soundscape_(soundscape), levels_(levels), level_(levels.all) {
    sounding_.reserve(kMostSignals);
    part_.resize(kLongestBlock);
}

void Mixer::hear(const Order& order) {
    std::visit([this](const auto& one) { take(one); }, order);
}

// Of more than can be told apart, the oldest ends.
void Mixer::take(const Sounds& order) {
    if (sounding_.size() == kMostSignals) sounding_.erase(sounding_.begin());
    sounding_.push_back({order, 0});
}

void Mixer::take(const Says& order) {
    if (order.number < hushed_before_ || !order.samples || order.samples->empty()) {
        said_ = std::max(said_, order.number);
        return;
    }
    speech_.push_back(order);
}

void Mixer::take(const Hushes& order) {
    hushed_before_ = std::max(hushed_before_, order.before);
    while (!speech_.empty() && speech_.front().number < hushed_before_) {
        said_ = std::max(said_, speech_.front().number);
        speech_.pop_front();
        spoken_ = 0;
    }
}

void Mixer::take(const Surrounds& order) {
    if (order.surroundings == to_) return;
    from_ = between(from_, to_, static_cast<float>(now_ - changed_at_) / static_cast<float>(kGlide));
    to_ = order.surroundings;
    changed_at_ = now_;
}

void Mixer::add_soundscape(Block block) {
    const bool is_quiet = levels_.soundscape <= 0;
    const auto share = [this](FrameIndex at) {
        return static_cast<float>(at - changed_at_) / static_cast<float>(kGlide);
    };
    const Block part = Block(part_).first(block.size());
    std::ranges::fill(part, Frame{});
    const FrameIndex end = now_ + static_cast<FrameIndex>(block.size());
    if (!is_quiet) soundscape_.add(part, now_, between(from_, to_, share(now_)), between(from_, to_, share(end)));
    const bool is_spoken = is_speaking() && levels_.speech > 0;
    for (std::size_t i = 0; i < block.size(); ++i)
        block[i] += part[i] * (levels_.soundscape * ducking_.next(is_spoken ? kDucked : 1.0F));
}

void Mixer::add_signals(Block block) {
    const Block part = Block(part_).first(block.size());
    std::ranges::fill(part, Frame{});
    for (Sounding& one : sounding_) {
        add_signal(part, one.at, one.what.signal, one.what.place);
        one.at += static_cast<FrameIndex>(block.size());
    }
    std::erase_if(sounding_, [](const Sounding& one) { return one.at >= frames_of(one.what.signal); });
    for (std::size_t i = 0; i < block.size(); ++i) block[i] += part[i] * levels_.signals;
}

void Mixer::add_speech(Block block) {
    for (std::size_t i = 0; i < block.size() && !speech_.empty();) {
        const std::vector<float>& samples = *speech_.front().samples;
        const float value = samples[spoken_] * kSpeechGain * levels_.speech;
        block[i++] += {value, value};
        if (++spoken_ < samples.size()) continue;
        said_ = std::max(said_, speech_.front().number);
        speech_.pop_front();
        spoken_ = 0;
    }
}

void Mixer::fill(Block block) {
    assert(block.size() <= kLongestBlock);
    std::ranges::fill(block, Frame{});
    add_soundscape(block);
    add_signals(block);
    add_speech(block);
    limiter_.limit(block);
    for (Frame& frame : block) frame = frame * level_.next(levels_.all);
    now_ += static_cast<FrameIndex>(block.size());
}

}  // namespace quadrat::sound
