// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>

#include "render/renderer.hpp"

namespace quadrat::kiosk {

// So much and no more a frame, whatever this machine could do: for tests, and to see on one machine what another draws.
struct Budget {
    std::size_t triangles = 0;  // 0: no bound
    std::size_t pixels = 0;     // of the views; 0: no bound
};

// The finest detail, up to `most`, within it. triangles_at: how many a frame has with some detail; more with more
// alpha.
render::Detail detail_within(const Budget& budget, glm::ivec2 size, const render::Detail& most,
                             const std::function<std::size_t(const render::Detail&)>& triangles_at);

}  // namespace quadrat::kiosk
