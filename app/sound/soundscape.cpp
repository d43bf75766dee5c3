// SPDX-License-Identifier: Apache-2.0
// Subtractive synthesis of wind and water (Farnell 2010, "Designing Sound"): noise in bands, each as loud as a voice
// asks for, with gusts and waves as slow noise. Ours has no state: a band is a loop, and a gust is known by its time.
#include "sound/soundscape.hpp"

#include "sound/calls.hpp"
#include "sound/tones.hpp"

namespace quadrat::sound {
namespace {

using base::unit_of;

using Gains = std::array<float, NoiseBands::kBands>;

constexpr FrameIndex kStep = 480;  // a hundredth of a second: what is slower than that is worked out so often

// How a voice colours noise, and how it swells.
struct Colour {
    Voice voice;
    Gains gains;    // a band each, at its loudest
    float swell_s;  // how long a gust or a wave lasts
    float depth;    // 0 steady to 1 gone between them
    float flutter;  // the same for what comes and goes several times a second
};
constexpr std::array kColours{
    Colour{Voice::Wind, {0.062F, 0.064F, 0.036F, 0.012F, 0.003F, 0.001F}, 5.0F, 0.75F, 0.10F},
    Colour{Voice::Leaves, {0.002F, 0.006F, 0.014F, 0.034F, 0.036F, 0.016F}, 4.0F, 0.70F, 0.35F},
    Colour{Voice::Needles, {0.004F, 0.014F, 0.026F, 0.022F, 0.010F, 0.003F}, 6.0F, 0.65F, 0.15F},
    Colour{Voice::Stream, {0.006F, 0.014F, 0.036F, 0.040F, 0.018F, 0.006F}, 9.0F, 0.15F, 0.45F},
    Colour{Voice::Surf, {0.044F, 0.046F, 0.040F, 0.028F, 0.016F, 0.008F}, 8.0F, 0.92F, 0.10F},
    Colour{Voice::Rain, {0.003F, 0.007F, 0.016F, 0.030F, 0.036F, 0.030F}, 12.0F, 0.30F, 0.15F},
};

// Slow noise, 0 to 1, that takes a second from one value to the next.
float slow_noise(base::Seed seed, double seconds) {
    const auto whole = static_cast<std::int64_t>(std::floor(seconds));
    const float share = smooth_step(static_cast<float>(seconds - std::floor(seconds)));
    const float from = unit_of(hash_of(seed, whole, 0));
    const float to = unit_of(hash_of(seed, whole + 1, 0));
    return from + (to - from) * share;
}

float swell(const Colour& colour, base::Seed seed, double seconds) {
    constexpr double kFlutterHz = 7;
    const base::Seed own = seed.child(name_of(colour.voice));
    const float gust = slow_noise(own, seconds / static_cast<double>(colour.swell_s));
    const float flutter = slow_noise(own.child("flutter"), seconds * kFlutterHz);
    return (1 - colour.depth + colour.depth * gust * gust * 2) * (1 - colour.flutter * flutter);
}

// How loud each band is at a moment.
Gains gains_at(FrameIndex step, const Surroundings& heard, base::Seed seed) {
    const double seconds = static_cast<double>(step) * (static_cast<double>(kStep) / kRate);
    Gains gains{};
    for (const Colour& colour : kColours) {
        const float share = heard[colour.voice];
        if (share <= 0) continue;
        const float now = share * swell(colour, seed, seconds);
        for (std::size_t band = 0; band < gains.size(); ++band) gains[band] += now * colour.gains[band];
    }
    return gains;
}

}  // namespace

Soundscape::Soundscape(base::Seed seed) : seed_(seed), noise_(seed.child("noise")) {}

void Soundscape::add_noise(Block block, FrameIndex first, const Surroundings& at_begin,
                           const Surroundings& at_end) const {
    const auto frames = static_cast<FrameIndex>(block.size());
    const auto heard = [&](FrameIndex step) {
        const auto share = static_cast<float>(step * kStep - first) / static_cast<float>(frames);
        return between(at_begin, at_end, share);
    };
    FrameIndex step = floor_div(first, kStep);
    Gains from = gains_at(step, heard(step), seed_), to = gains_at(step + 1, heard(step + 1), seed_);
    for (FrameIndex i = 0; i < frames; ++i) {
        if (const FrameIndex now = floor_div(first + i, kStep); now != step) {
            step = now;
            from = to;
            to = gains_at(step + 1, heard(step + 1), seed_);
        }
        const auto share = static_cast<float>(first + i - step * kStep) / static_cast<float>(kStep);
        for (std::size_t band = 0; band < NoiseBands::kBands; ++band) {
            const float gain = from[band] + (to[band] - from[band]) * share;
            if (gain > 0) block[static_cast<std::size_t>(i)] += noise_.at(band, first + i) * gain;
        }
    }
}

void Soundscape::add(Block block, FrameIndex first, const Surroundings& at_begin, const Surroundings& at_end) const {
    if (block.empty()) return;
    add_noise(block, first, at_begin, at_end);
    add_calls(block, first, at_end, noise_, seed_.child("calls"));
}

}  // namespace quadrat::sound
