// SPDX-License-Identifier: Apache-2.0
// Earcons (Blattner, Sumikawa & Greenberg 1989): short motives of one family, a struck bar of wood or of glass.
#include "sound/signals.hpp"

#include <array>
#include <span>

#include "sound/tones.hpp"

namespace quadrat::sound {
namespace {

struct Note {
    float at_s, length_s, pitch_Hz, gain, wood;  // wood: 1 a dull knock, 0 a clear tone
};

// A pentatonic scale: whatever sounds together, sounds well.
constexpr std::array kPlaces_Hz{392.0F, 440.0F, 523.25F, 587.33F, 329.63F};
// As the quarters lie on the screen; Back in the middle.
constexpr std::array kPans{-0.6F, 0.6F, -0.6F, 0.6F, 0.0F};

constexpr std::array kKnock{Note{0, 0.12F, 1, 0.5F, 1}};
constexpr std::array kTwoKnocks{Note{0, 0.12F, 1, 0.45F, 1}, Note{0.09F, 0.14F, 0.75F, 0.4F, 1}};
constexpr std::array kTick{Note{0, 0.08F, 2, 0.22F, 0.4F}};
constexpr std::array kRise{Note{0, 0.22F, 1, 0.3F, 0.2F}, Note{0.1F, 0.4F, 1.5F, 0.34F, 0}};
constexpr std::array kThree{Note{0, 0.35F, 523.25F, 0.26F, 0}, Note{0.13F, 0.35F, 659.25F, 0.26F, 0},
                            Note{0.26F, 0.8F, 783.99F, 0.3F, 0}};
constexpr std::array kChord{Note{0, 1.8F, 261.63F, 0.2F, 0}, Note{0.12F, 1.7F, 392.0F, 0.18F, 0},
                            Note{0.24F, 1.6F, 523.25F, 0.18F, 0}, Note{0.36F, 1.5F, 659.25F, 0.16F, 0},
                            Note{0.48F, 1.6F, 783.99F, 0.16F, 0}};
constexpr std::array kAsk{Note{0, 0.4F, 493.88F, 0.22F, 0.1F}, Note{0.45F, 0.5F, 587.33F, 0.22F, 0.1F}};

struct Motive {
    std::span<const Note> notes;
    bool is_of_a_place;  // pitches are factors of the place's
};

Motive motive_of(Signal signal) {
    switch (signal) {
        case Signal::Press:
            return {kKnock, true};
        case Signal::Back:
            return {kTwoKnocks, true};
        case Signal::Mark:
            return {kTick, true};
        case Signal::Choice:
            return {kRise, true};
        case Signal::Round:
            return {kThree, false};
        case Signal::Finale:
            return {kChord, false};
        case Signal::StillThere:
        case Signal::count:
            break;
    }
    return {kAsk, false};
}

float struck(const Note& note, float pitch_Hz, float s) {
    if (s < 0 || s >= note.length_s) return 0;
    const float onset = std::min(1.0F, s * 500);
    const float tone = sine(pitch_Hz * s) + 0.25F * dying(4 * s / note.length_s) * sine(3.93F * pitch_Hz * s);
    const float knock = sine(0.5F * pitch_Hz * s) * dying(3 * s / note.length_s);
    return note.gain * onset * dying(s / note.length_s) * ((1 - 0.7F * note.wood) * tone + note.wood * knock);
}

}  // namespace

void add_signal(Block block, FrameIndex first, Signal signal, int place) {
    const Motive motive = motive_of(signal);
    const auto which = static_cast<std::size_t>(std::clamp(place, 0, 4));
    const float pitch_Hz = motive.is_of_a_place ? kPlaces_Hz[which] : 1.0F;
    const float pan = motive.is_of_a_place ? kPans[which] : 0.0F;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const float s = static_cast<float>(first + static_cast<FrameIndex>(i)) / static_cast<float>(kRate);
        float value = 0;
        for (const Note& note : motive.notes) value += struck(note, note.pitch_Hz * pitch_Hz, s - note.at_s);
        block[i] += panned(value, pan);
    }
}

FrameIndex frames_of(Signal signal) {
    float ends_s = 0;
    for (const Note& note : motive_of(signal).notes) ends_s = std::max(ends_s, note.at_s + note.length_s);
    return frames_of(static_cast<double>(ends_s)) + 1;
}

}  // namespace quadrat::sound
