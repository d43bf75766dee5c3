// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>

#include "render/renderer.hpp"
#include "tempo/budget.hpp"

namespace quadrat::stage {

// The finest detail, up to `most`, within the budget. triangles_at: how many a frame has with some detail; more with
// more alpha.
render::Detail detail_within(const tempo::Budget& budget, glm::ivec2 size, const render::Detail& most,
                             const std::function<std::size_t(const render::Detail&)>& triangles_at);

}  // namespace quadrat::stage
