// SPDX-License-Identifier: Apache-2.0
// Who sounds now and then. Birds as frequency-modulated chirps, insects as pulses of one tone, bubbles as decaying
// tones that rise (van den Doel 2005, "Physically based models for liquid sounds"), bells as the partials that founders
// name (Rossing 2000, "Science of Percussion Instruments"). All phases are in closed form, so that any frame can be
// asked for without those before it.
#include "sound/calls.hpp"

#include <algorithm>

#include "sound/tones.hpp"

namespace quadrat::sound {
namespace {

using base::unit_of;

// One call of one singer.
struct Call {
    base::Seed singer;  // the same in all its calls: its kind and its voice
    base::Seed self;
    const NoiseBands& noise;
    float chance(int which) const { return unit_of(hash_of(self, which, 0)); }
    float own(int which) const { return unit_of(hash_of(singer, which, 1)); }
    float own(int which, float low, float high) const { return low + (high - low) * own(which); }
};

// A syllable or a pulse that the moment lies in, and how far.
struct Part {
    int number;
    float s;  // since it began
};
Part part_at(float s, float period_s) {
    const float number = std::floor(s / period_s);
    return {static_cast<int>(number), s - number * period_s};
}

float songbird(const Call& call, float s, FrameIndex /*at*/) {
    const float period = call.own(0, 0.09F, 0.26F);
    const int syllables = 3 + static_cast<int>(call.chance(0) * 7);
    const Part part = part_at(s, period);
    if (part.number >= syllables) return 0;
    const float length = period * call.own(1, 0.55F, 0.9F);
    // A phrase of three notes that it always sings, and each time goes on with from elsewhere.
    const int note = (part.number + static_cast<int>(call.chance(1) * 3)) % 3;
    const float from_Hz = call.own(2, 2'300, 4'800) * (1.0F + 0.35F * call.own(10 + note));
    const float slope = from_Hz * (call.own(20 + note) - 0.5F) / length;
    const float warble = call.own(3) < 0.4F ? 1.0F * sine(call.own(4, 25, 60) * part.s) : 0.0F;
    const float turns = from_Hz * part.s + 0.5F * slope * part.s * part.s + warble;
    return hill(part.s / length) * sine(turns);
}

float gull(const Call& call, float s, FrameIndex /*at*/) {
    constexpr float kPeriod_s = 0.52F, kLength_s = 0.4F;
    const Part part = part_at(s, kPeriod_s);
    if (part.number >= 2 + static_cast<int>(call.chance(0) * 4)) return 0;
    const float from_Hz = call.own(0, 900, 1'250);
    const float fall = 60.0F;  // turns that a falling voice is ahead of an even one, at most
    const float turns = from_Hz * part.s + fall * sine(part.s / (2.0F * kLength_s));
    const float voice = sine(turns) + 0.6F * sine(2 * turns) + 0.4F * sine(3 * turns) + 0.2F * sine(4 * turns);
    return 0.45F * hill(part.s / kLength_s) * voice;
}

float owl(const Call& call, float s, FrameIndex /*at*/) {
    struct Hoot {
        float at_s, length_s;
    };
    constexpr std::array kHoots{Hoot{0, 0.55F}, Hoot{1.7F, 0.22F}, Hoot{2.05F, 0.22F}, Hoot{2.45F, 1.1F}};
    const float pitch_Hz = call.own(0, 330, 430);
    float value = 0;
    for (const Hoot& hoot : kHoots) {
        const float since = s - hoot.at_s;
        if (since < 0 || since >= hoot.length_s) continue;
        const float turns = pitch_Hz * since + 1.2F * sine(6 * since);
        value += hill(since / hoot.length_s) * (sine(turns) + 0.15F * sine(2 * turns));
    }
    return value;
}

float frog(const Call& call, float s, FrameIndex /*at*/) {
    const float period = call.own(0, 0.45F, 0.8F);
    const Part croak = part_at(s, period);
    if (croak.number >= 2 + static_cast<int>(call.chance(0) * 4)) return 0;
    const float length = 0.7F * period;
    const float pulses_Hz = call.own(1, 24, 42);
    const Part pulse = part_at(croak.s, 1 / pulses_Hz);
    const float pitch_Hz = call.own(2, 480, 950) * (1.0F + 0.25F * croak.s / length);
    const float tone = sine(pitch_Hz * pulse.s) + 0.5F * sine(2.02F * pitch_Hz * pulse.s);
    return hill(croak.s / length) * dying(pulse.s * pulses_Hz * 1.2F) * std::min(1.0F, pulse.s * 2'000) * tone;
}

constexpr float kRun_s = 7;  // of insects

float cricket(const Call& call, float s, FrameIndex /*at*/) {
    const float period = call.own(0, 0.38F, 0.62F);
    const Part chirp = part_at(s, period);
    constexpr float kPulse_s = 0.032F;
    const Part pulse = part_at(chirp.s, kPulse_s);
    if (pulse.number >= 3) return 0;
    return hill(s / kRun_s) * hill(pulse.s / (0.6F * kPulse_s)) * sine(call.own(1, 4'100, 5'100) * pulse.s);
}

float cicada(const Call& call, float s, FrameIndex at) {
    const float swell = hill(s / kRun_s) * (0.6F + 0.4F * sine(call.own(0, 2, 5) * s));
    const float clicks = 0.5F + 0.5F * sine(call.own(1, 90, 170) * s);
    return swell * clicks * (0.55F * call.noise.at(4, at).left + 0.3F * sine(call.own(2, 4'500, 6'500) * s));
}

float thunder(const Call& call, float s, FrameIndex at) {
    float loud = 0;
    for (int peal = 0; peal < 5; ++peal) {
        const float begins_s = 3.0F * call.chance(peal) * call.chance(peal + 10);
        const float since = s - begins_s;
        if (since < 0) continue;
        loud += (0.3F + 0.7F * call.chance(peal + 20)) * std::min(1.0F, since * 12) * dying(since / 5);
    }
    const Frame rumble = call.noise.at(0, at), crack = call.noise.at(1, at + 7'919);
    return loud * (0.5F * rumble.left + 0.22F * dying(s / 1.5F) * crack.left);
}

float bell(const Call& call, float s, FrameIndex /*at*/) {
    struct Partial {
        float ratio, gain, lasts_s;
    };
    // Hum, prime, tierce, quint, nominal and two above.
    constexpr std::array kPartials{Partial{0.5F, 0.5F, 5}, Partial{1, 0.6F, 4},     Partial{1.2F, 0.5F, 3.2F},
                                   Partial{1.5F, 0.2F, 2}, Partial{2, 0.55F, 2.4F}, Partial{2.67F, 0.2F, 1.2F},
                                   Partial{4, 0.12F, 0.7F}};
    constexpr float kPeriod_s = 1.9F;
    const int strokes = 2 + static_cast<int>(call.chance(0) * 4);
    const float prime_Hz = call.own(0, 300, 520);
    float value = 0;
    for (int stroke = 0; stroke < strokes; ++stroke) {
        const float since = s - kPeriod_s * static_cast<float>(stroke);
        if (since < 0) break;
        const float struck = std::min(1.0F, since * 400);
        for (const Partial& partial : kPartials)
            value += struck * partial.gain * dying(since / partial.lasts_s) * sine(prime_Hz * partial.ratio * since);
    }
    return 0.4F * value;
}

float bubble(const Call& call, float s, FrameIndex /*at*/) {
    const float pitch_Hz = 380 + 1'300 * call.chance(0) * call.chance(0);
    constexpr float kRise_per_s = 4;
    const float turns = pitch_Hz * s * (1.0F + 0.5F * kRise_per_s * s);
    return std::min(1.0F, s * 900) * dying(s / 0.09F) * sine(turns);
}

float drop(const Call& call, float s, FrameIndex /*at*/) {
    const float pitch_Hz = 1'500 + 3'500 * call.chance(0);
    return std::min(1.0F, s * 3'000) * dying(s / 0.03F) * sine(pitch_Hz * s);
}

struct Singer {
    Voice voice;
    const char* name;
    int count;        // of them, each in its own place
    float every_s;    // one of them calls at most so often
    float longest_s;  // less than that
    float loudness;   // of the nearest
    float (*sing)(const Call&, float s, FrameIndex at);
};
constexpr std::array kSingers{
    Singer{Voice::Songbirds, "songbird", 5, 4.6F, 2.4F, 0.11F, songbird},
    Singer{Voice::Gulls, "gull", 2, 9.0F, 3.1F, 0.07F, gull},
    Singer{Voice::Owls, "owl", 2, 13.0F, 3.6F, 0.16F, owl},
    Singer{Voice::Frogs, "frog", 4, 6.0F, 4.1F, 0.07F, frog},
    Singer{Voice::Crickets, "cricket", 4, 8.0F, kRun_s, 0.07F, cricket},
    Singer{Voice::Cicadas, "cicada", 3, 8.0F, kRun_s, 0.08F, cicada},
    Singer{Voice::Thunder, "thunder", 1, 17.0F, 8.0F, 0.5F, thunder},
    Singer{Voice::Bells, "bell", 1, 31.0F, 13.0F, 0.15F, bell},
    Singer{Voice::Stream, "bubble", 6, 0.16F, 0.09F, 0.07F, bubble},
    Singer{Voice::Rain, "drop", 6, 0.06F, 0.03F, 0.04F, drop},
};

// Where one of them is, and how near.
struct Place {
    float pan, gain;
};
Place place_of(base::Seed singer) {
    return {unit_of(hash_of(singer, 0, 2)) * 1.8F - 0.9F, 0.35F + 0.65F * unit_of(hash_of(singer, 1, 2))};
}

// The less there is of a voice, the more of its calls are left out; each fades as it goes.
float presence(float share, float chance) { return share_of(share, 0.85F * chance, 0.85F * chance + 0.15F); }

void add_call(Block block, FrameIndex first, FrameIndex begins, const Singer& singer, const Call& call, float gain) {
    const Place place = place_of(call.singer);
    const Frame loud = panned(gain * singer.loudness * place.gain, place.pan);
    const FrameIndex ends = begins + frames_of(static_cast<double>(singer.longest_s));
    const FrameIndex from = std::max(first, begins);
    const FrameIndex to = std::min(first + static_cast<FrameIndex>(block.size()), ends);
    for (FrameIndex at = from; at < to; ++at) {
        const float s = static_cast<float>(at - begins) / static_cast<float>(kRate);
        block[static_cast<std::size_t>(at - first)] += loud * singer.sing(call, s, at);
    }
}

}  // namespace

void add_calls(Block block, FrameIndex first, const Surroundings& heard, const NoiseBands& noise, base::Seed seed) {
    for (const Singer& singer : kSingers) {
        const float share = heard[singer.voice];
        if (share <= 0) continue;
        const FrameIndex every = frames_of(static_cast<double>(singer.every_s));
        const FrameIndex spare = every - frames_of(static_cast<double>(singer.longest_s));
        for (int i = 0; i < singer.count; ++i) {
            const base::Seed own = seed.child(singer.name).child(static_cast<std::uint64_t>(i));
            const FrameIndex last = first + static_cast<FrameIndex>(block.size()) - 1;
            for (FrameIndex turn = floor_div(first, every); turn <= floor_div(last, every); ++turn) {
                const Call call{own, base::Seed{hash_of(own, turn, 3)}, noise};
                const float gain = presence(share, call.chance(100)) * share_of(share, 0, 0.25F);
                const auto wait = static_cast<FrameIndex>(call.chance(101) * static_cast<float>(spare));
                if (gain > 0) add_call(block, first, turn * every + wait, singer, call, gain);
            }
        }
    }
}

}  // namespace quadrat::sound
