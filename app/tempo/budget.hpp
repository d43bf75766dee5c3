// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

namespace quadrat::tempo {

// How finely a frame is drawn: see render::Detail.
struct Fineness {
    float alpha = 1;
    float scale = 1;  // of each side of the views
};

// So much and no more per frame, whatever this machine could do: for tests, and to see on one machine what another
// draws.
struct Budget {
    std::size_t triangles = 0;  // 0: no bound
    std::size_t pixels = 0;     // of the views; 0: no bound
    bool is_bound() const { return triangles > 0 || pixels > 0; }
    // The largest share of a side of views with so many pixels within it.
    float scale(double pixels_of_views, float most = 1) const;
};

// The finest detail within it while the camera moves: from what the last frame had. A frame may have more until the
// next one or two.
class BudgetKeeper {
  public:
    BudgetKeeper(const Budget& budget, float most_alpha) : budget_(budget), most_(most_alpha), alpha_(most_alpha) {}
    Fineness fineness(double pixels_of_views) const { return {alpha_, budget_.scale(pixels_of_views)}; }
    void drew(std::size_t triangles);

    static constexpr float kLeastAlpha = 0.01F;

  private:
    Budget budget_;
    float most_;
    float alpha_;
};

}  // namespace quadrat::tempo
