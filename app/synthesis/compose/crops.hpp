// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/settlement.hpp"
#include "scene/sward.hpp"
#include "synthesis/houses/fields.hpp"

namespace quadrat::synthesis {

// How a crop stands on its field.
struct Stand {
    scene::CoverKind kind = scene::CoverKind::Grass;
    float height_m = 0;     // 0: nothing stands
    float radius_m = 0.3F;  // of a tuft
    float closed = 1;       // of the places for tufts, those that bear one
    float rows_m = 0;       // from row to row; 0: sown all over
    glm::vec3 tint{1};      // its colour to the field's
};

// The fields of a settlement, to ask of many places. They outlive it.
class Crops {
  public:
    explicit Crops(const std::vector<scene::FieldPlot>& fields);
    // The field that a place lies in, its edge left out; none: null.
    const scene::FieldPlot* at(glm::vec2 at_m) const;

  private:
    struct Plot {
        const scene::FieldPlot* field;
        houses::Extent extent;
        houses::Inside inside;
    };
    std::vector<Plot> plots_;
};

Stand stand_of(scene::Crop crop);

// The place in the row that is nearest to a place.
glm::vec2 in_row(const scene::FieldPlot& field, float rows_m, glm::vec2 at_m);

}  // namespace quadrat::synthesis
