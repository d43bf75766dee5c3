// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "sound/levels.hpp"
#include "sound/signals.hpp"
#include "sound/soundscape.hpp"

namespace quadrat::sound {

// How loud, each 0 to 1.
struct Levels {
    float all = 0.5F;         // of everything; no sample passes this
    float soundscape = 0.6F;  // of that, the landscape's
    float speech = 1;         // and who speaks; 0: not here
    float signals = 1;
    friend bool operator==(const Levels&, const Levels&) = default;
};

// ---- what a mixer is told

struct Sounds {
    Signal signal = Signal::Press;
    int place = 0;
};
// After what is being said. number: grows with each.
struct Says {
    std::int64_t number = 0;
    std::shared_ptr<const std::vector<float>> samples;
};
// Nothing of what was to be said before this number is said any more.
struct Hushes {
    std::int64_t before = 0;
};
struct Surrounds {
    Surroundings surroundings;  // from now on; it takes two seconds to come
};
struct SetsLevels {
    Levels levels;
};
using Order = std::variant<Sounds, Says, Hushes, Surrounds, SetsLevels>;

// What is heard of all of it: one frame after the other, from orders alone.
class Mixer {
  public:
    // The soundscape is borrowed.
    Mixer(const Soundscape& soundscape, const Levels& levels);

    void hear(const Order& order);
    void fill(Block block);  // replaces what is in it; at most kLongestBlock frames
    bool is_speaking() const { return !speech_.empty(); }
    std::int64_t said() const { return said_; }  // the last number that was said to its end, or hushed

    static constexpr std::size_t kLongestBlock = 4'800;
    static constexpr float kDucked = 0.22F;  // what is left of the soundscape while somebody speaks: -13 dB

  private:
    struct Sounding {
        Sounds what;
        FrameIndex at = 0;
    };
    void add_soundscape(Block block);
    void add_signals(Block block);
    void add_speech(Block block);
    void take(const Sounds& order);
    void take(const Says& order);
    void take(const Hushes& order);
    void take(const Surrounds& order);
    void take(const SetsLevels& order) { levels_ = order.levels; }

    const Soundscape& soundscape_;
    Levels levels_;
    FrameIndex now_ = 0;
    Surroundings from_, to_;
    FrameIndex changed_at_ = 0;
    std::vector<Sounding> sounding_;
    std::deque<Says> speech_;
    std::size_t spoken_ = 0;  // samples of the first of them
    std::int64_t hushed_before_ = 0;
    std::int64_t said_ = -1;
    Fader ducking_, level_;
    Limiter limiter_{1};
    std::vector<Frame> part_;
};

}  // namespace quadrat::sound
