// SPDX-License-Identifier: Apache-2.0
#include "sound/noise_bands.hpp"

#include "sound/tones.hpp"

namespace quadrat::sound {
namespace {

using base::unit_of;

constexpr std::array<std::size_t, NoiseBands::kBands> kLoopFrames{131'071, 126'989, 122'869, 118'787, 114'679, 110'597};

// Biquad band pass (Bristow-Johnson), run over the loop twice, so that its end fits its beginning.
struct BandPass {
    float b0, a1, a2;
    float x1 = 0, x2 = 0, y1 = 0, y2 = 0;

    explicit BandPass(float centre_Hz) {
        constexpr float kWidth = 0.55F;  // sin(w) / 2Q for octaves and a half, about
        const float turns = centre_Hz / static_cast<float>(kRate);
        const float alpha = sine(turns) * kWidth;
        b0 = alpha / (1 + alpha);
        a1 = -2 * sine(turns + 0.25F) / (1 + alpha);
        a2 = (1 - alpha) / (1 + alpha);
    }
    float operator()(float x) {
        const float y = b0 * (x - x2) - a1 * y1 - a2 * y2;
        x2 = x1, x1 = x, y2 = y1, y1 = y;
        return y;
    }
};

std::vector<float> noise_loop(std::size_t frames, float centre_Hz, base::Seed seed) {
    std::vector<float> loop(frames);
    BandPass first(centre_Hz), second(centre_Hz);
    const auto white = [&](std::size_t i) {
        return unit_of(hash_of(seed, static_cast<std::int64_t>(i), 0)) * 2.0F - 1.0F;
    };
    for (int pass = 0; pass < 2; ++pass)
        for (std::size_t i = 0; i < frames; ++i) loop[i] = second(first(white(i)));
    double sum = 0;
    for (const float value : loop) sum += static_cast<double>(value) * static_cast<double>(value);
    const auto gain = static_cast<float>(1.0 / std::sqrt(sum / static_cast<double>(frames)));
    for (float& value : loop) value *= gain;
    return loop;
}

}  // namespace

NoiseBands::NoiseBands(base::Seed seed) {
    for (std::size_t band = 0; band < kBands; ++band)
        loops_[band] = noise_loop(kLoopFrames[band], kCentres_Hz[band], seed.child(band));
}

Frame NoiseBands::at(std::size_t band, FrameIndex index) const {
    const std::vector<float>& loop = loops_[band];
    const auto frames = static_cast<FrameIndex>(loop.size());
    const FrameIndex left = index - floor_div(index, frames) * frames;
    const FrameIndex right = left >= frames / 2 ? left - frames / 2 : left + frames - frames / 2;
    return {loop[static_cast<std::size_t>(left)], loop[static_cast<std::size_t>(right)]};
}

}  // namespace quadrat::sound
