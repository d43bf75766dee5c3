// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "render/choose/crowd.hpp"
#include "render/choose/view_block.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"
#include "scene/flora.hpp"

namespace quadrat::render::passes {

struct WoodOnGpu {
    gl::Buffer places;    // what moves a vertex: read by the binner too
    gl::Buffer surfaces;  // what only lights it
    gl::Buffer indices;
    std::size_t index_count = 0;
};

struct MassOnGpu {
    gl::Buffer places;
    gl::Buffer surfaces;
    gl::Buffer indices;
    std::size_t index_count = 0;
};

struct SpeciesOnGpu {
    std::vector<WoodOnGpu> wood;  // finest first
    std::vector<MassOnGpu> masses;
    gl::Buffer leaf_places;
    gl::Buffer leaf_surfaces;
    gl::Buffer leaf_indices;
    gl::Buffer plain_leaf_indices;
    std::size_t blades = 0;
    std::size_t vertices_per_blade = 0;
    std::size_t vertices_per_plain_blade = 0;
    std::size_t indices_per_blade = 0;
    std::size_t indices_per_plain_blade = 0;
    gl::Texture2D bark;
    gl::Texture2D leaf;
    gl::Texture2D foliage;
    glm::vec3 bark_colour{0.2F};
    glm::vec2 crown{0, 1};  // of the light on its limbs, what its leaves take; where it begins, of the height
    float height_m = 1;
    float blade_m = 0.3F;
};

struct FloraOnGpu {
    std::vector<SpeciesOnGpu> species;
    std::vector<choose::PlantKind> kinds;
};

// Adds the slices that fill flora, which must stay where it is until they are done.
void add_flora(gl::Slices& slices, FloraOnGpu& flora, const std::shared_ptr<const scene::Flora>& source);

// Trees and undergrowth: wood and leaves of every batch, instanced.
class PlantsPass {
  public:
    PlantsPass();
    struct Drawn {
        gl::Work leaves;  // and crowns
        gl::Work wood;
    };
    Drawn draw(const FloraOnGpu& flora, const std::vector<choose::Batch>& batches, const gl::StreamBuffer& instances,
               const choose::ViewBlock& view) const;

  private:
    gl::Work draw_wood(const SpeciesOnGpu& species, const choose::Batch& batch, GLuint instances,
                       const choose::ViewBlock& view) const;
    gl::Work draw_leaves(const SpeciesOnGpu& species, const choose::Batch& batch, GLuint instances) const;

    gl::Work draw_mass(const SpeciesOnGpu& species, const choose::Batch& batch, GLuint instances) const;

    gl::Program wood_;
    gl::Program masses_;
    gl::Program leaves_;
    gl::Program plain_leaves_;  // too small on the screen to show their veins
    gl::Program copied_leaves_;
    gl::Program plain_copied_leaves_;
    gl::VertexArray wood_vertices_;
    gl::VertexArray leaf_vertices_;
    gl::VertexArray mass_vertices_;
};

}  // namespace quadrat::render::passes
