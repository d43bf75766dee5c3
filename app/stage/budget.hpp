// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>

#include "render/renderer.hpp"

namespace quadrat::stage {

// So much and no more a frame, whatever this machine could do: for tests, and to see on one machine what another draws.
struct Budget {
    std::size_t triangles = 0;  // 0: no bound
    std::size_t pixels = 0;     // of the views; 0: no bound

    bool is_bound() const { return triangles > 0 || pixels > 0; }
    // The largest share of a side of the views within it.
    float scale(glm::ivec2 size, float most = 1) const;
};

// The finest detail, up to `most`, within it. triangles_at: how many a frame has with some detail; more with more
// alpha.
render::Detail detail_within(const Budget& budget, glm::ivec2 size, const render::Detail& most,
                             const std::function<std::size_t(const render::Detail&)>& triangles_at);

// The same while the camera moves: from what the last frame had. A frame may have more until the next one or two.
class BudgetKeeper {
  public:
    BudgetKeeper(const Budget& budget, float most_alpha) : budget_(budget), most_(most_alpha), alpha_(most_alpha) {}

    render::Detail detail(glm::ivec2 size) const { return {alpha_, budget_.scale(size)}; }
    void drew(std::size_t triangles);

  private:
    Budget budget_;
    float most_;
    float alpha_;
};

}  // namespace quadrat::stage
