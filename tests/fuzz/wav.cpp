// SPDX-License-Identifier: Apache-2.0
// Any bytes as a recording of the site: sound within its bounds, or told to be wrong.
#include "sound/wav.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    try {
        const std::string_view given{reinterpret_cast<const char*>(bytes), size};
        const std::vector<float> samples = sound::speech_from_wav(given, "input");
        if (samples.size() > 61U * sound::kRate) std::abort();
        for (const float sample : samples)
            if (!(std::abs(sample) <= 2)) std::abort();
    } catch (const base::InputError& error) {
        if (!std::string_view(error.what()).starts_with("input: ")) std::abort();
    }
    return 0;
}
