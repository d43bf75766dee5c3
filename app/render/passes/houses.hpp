// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/passes/frustum.hpp"
#include "render/passes/grid.hpp"
#include "render/passes/horizon.hpp"
#include "render/passes/reach.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

// Which houses are drawn, and how closely: each by how large it is on the screen.
class HouseLevels {
  public:
    HouseLevels() = default;
    explicit HouseLevels(const scene::Settlement& settlement);

    struct Wish {
        glm::vec3 eye_m{0};
        float pixels_per_radian = 500;
        float fineness = 1;                // 2: as finely from twice as far
        float standing = 1;                // the share of the houses that are built, the oldest first
        const Horizon* horizon = nullptr;  // of the ground before them; null: none
        Reach reach = {};
    };
    // Appends the corners of what may be seen, three a triangle.
    void select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const;

  private:
    struct Level {
        std::uint32_t first = 0;  // corner
        std::size_t list = 0;     // of indices from there
    };
    struct Standing {
        glm::vec3 middle_m{0};
        float radius_m = 0;
        std::vector<Level> levels;  // finest first
        std::size_t finest = 2;     // of them, in the building's numbering
    };
    std::vector<std::vector<std::uint32_t>> indices_;
    std::vector<Standing> standing_;
};

struct HousesOnGpu {
    gl::Buffer corners;
    gl::Buffer looks;
    gl::Texture2D stains;
    HouseLevels levels;
};

// Adds the slices that fill houses, which must stay where it is until they are done.
void add_houses(gl::Slices& slices, HousesOnGpu& houses, const std::shared_ptr<const scene::Land>& land);

// Houses, and what bounds their plots.
class HousesPass {
  public:
    HousesPass();
    gl::Work draw(const HousesOnGpu& houses, const gl::StreamBuffer& indices, const IndexRange& range) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
