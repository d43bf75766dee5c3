// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/gl/texture.hpp"
#include "render/renderer.hpp"

namespace quadrat::render {

double Renderer::upload_bytes_per_s() const {
    using Clock = std::chrono::steady_clock;
    constexpr int kSide = 512;
    constexpr int kTimes = 4;
    const gl::Texture2D texture{{.width = kSide, .height = kSide, .sampling = gl::Sampling::Flat}};
    const std::vector<std::uint8_t> pixels(std::size_t{kSide} * kSide * 4, 128);
    double best = 0;
    // The first turn takes the texture's memory.
    for (int turn = 0; turn < 4; ++turn) {
        glFinish();
        const auto began = Clock::now();
        for (int n = 0; n < kTimes; ++n) texture.write_rows(0, 0, kSide, pixels);
        glFinish();
        const std::chrono::duration<double> took = Clock::now() - began;
        best = std::max(best, kTimes * static_cast<double>(pixels.size()) / std::max(took.count(), 1e-9));
    }
    return best;
}

}  // namespace quadrat::render
