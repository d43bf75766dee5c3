// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>

namespace quadrat::render::choose {

// How much of each part of a view is left to be seen past the crowns before it: plants are put before it from near to
// far, and each asks first. In a forest most of what stands behind the first rows is hidden, and the triangles that it
// would take are better spent on those. A grid over the view, multiplied down by each crown's cover; all is continuous
// in where a plant stands, so that what slowly moves slowly changes.
class Canopy {
  public:
    // A crown's box in clip space divided by w: x and y from -1 to 1 are the view.
    struct Box {
        glm::vec2 low;
        glm::vec2 high;
    };

    Canopy() { left_.fill(1); }

    // Of what lies in the box, the share that is seen: 0 to 1. Outside the view all of it is.
    float seen(const Box& box) const;
    // From now on a crown of this opacity, 0 to 1, stands in the box, as an ellipse within it.
    void add(const Box& box, float opacity);

  private:
    static constexpr int kColumns = 48;
    static constexpr int kRows = 27;

    // With each cell that the box covers part of: its index and that part, 0 to 1.
    template <typename With>
    static void for_each_cell(const Box& box, const With& with);

    std::array<float, kColumns * kRows> left_;
};

}  // namespace quadrat::render::choose
