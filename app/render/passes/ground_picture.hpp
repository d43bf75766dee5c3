// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "mesh/image.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture_pool.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

// Of soft ground and of stone, under a sun that stands still; 0.5 is level ground.
struct GrainOnGpu {
    std::shared_ptr<const gl::Texture2D> lit;
    std::shared_ptr<const mesh::Image> coarser;  // the same, halved
};
void add_grain(gl::Slices& slices, GrainOnGpu& grain, const std::shared_ptr<gl::TexturePool>& pool,
               const std::shared_ptr<const scene::Land>& land, glm::vec3 to_sun);

// The ground as it is seen, under that sun.
struct GroundPictureOnGpu {
    // What it sends to the eye, shown, its coarse relief in it; alpha: how deep water over it looks.
    std::shared_ptr<const gl::Texture2D> lit;
    std::shared_ptr<const GrainOnGpu> grain;
};

// Adds the slices that bring picture, which must stay where it is until they are done. It has its grain, or that is
// among the slices before.
void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture, const std::shared_ptr<gl::TexturePool>& pool,
                        const std::shared_ptr<const scene::Scene>& scene);

}  // namespace quadrat::render::passes
