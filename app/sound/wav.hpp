// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "sound/frame.hpp"

namespace quadrat::sound {

// RIFF WAVE of 16 bits and two channels, at kRate. What passes 1 is cut off there.
std::string wav_of(Block block);

// Speech as it was recorded: one channel at kRate. Takes PCM of 8 or 16 bits and floats of 32, of any number of
// channels, which are mixed, at 8,000 to 192,000 frames per second; a length that a pipe's writer could not know is
// taken as "to the end". Throws InputError naming source, what is wrong and what would be right; also for more than a
// minute.
std::vector<float> speech_from_wav(std::string_view bytes, std::string_view source);

// The same sounds at another rate, by cubic interpolation between samples; both rates more than 0.
std::vector<float> resampled(const std::vector<float>& samples, int from_rate, int to_rate);

}  // namespace quadrat::sound
