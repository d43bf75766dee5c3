// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/gl/program.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/work.hpp"

namespace quadrat::render::passes {

// Where a view sees what was held: the uniforms of shaders/held_distance.vert.
struct DistanceWarp {
    glm::mat3 way_from_clip{1};
    glm::mat3 held_from_way{1};
    glm::mat3 sky_from_view{1};
    glm::vec4 moved_radius{0, 0, 0, 1};
    glm::vec3 split{1, 0, 0};
    glm::vec2 kept{1};
};

// What is far in a view and the sky behind it, as pictures of some frames ago: over whatever near things lie beyond the
// split, plants excepted, and wherever there is nothing near.
class DistancePass {
  public:
    DistancePass();
    gl::Work draw(const gl::Texture2D& held, const gl::Texture2D& held_sky, const DistanceWarp& warp) const;

  private:
    gl::Program program_;
};

// Near things mark the pixels where they are in front: a plant's are its own, however far it leans over the split.
class NearMarks {
  public:
    NearMarks();
    ~NearMarks();
    NearMarks(const NearMarks&) = delete;
    NearMarks& operator=(const NearMarks&) = delete;
    void begin_plants() const;
    void begin_others() const;
    void begin_distance() const;
};

}  // namespace quadrat::render::passes
