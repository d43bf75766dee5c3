// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "render/gl/picture_upload.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture_target.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

inline constexpr float kGrain = 0.55F;  // how much of the ground's brightness its grain is

// What the ground is made of, as long as it is needed to paint its picture.
struct MaterialOnGpu {
    gl::Texture2D roots;  // of its colour's linear light
    gl::Texture2D kinds;  // how far its grain is soft ground's, how far stone's
};
void add_material(gl::Slices& slices, MaterialOnGpu& material, const std::shared_ptr<const scene::Land>& land);

// The ground as it is seen, under a sun that stands still.
struct GroundPictureOnGpu {
    gl::Texture2D lit;  // what it sends to the eye, shown, its coarse relief in it; alpha: how deep water over it looks
    gl::Texture2D grain;  // of soft ground and of stone, lit; 0.5 is level ground
};

// Multiplies what the ground is made of and the light baked for it, once a scene: a pixel fetches their product.
class GroundPainter {
  public:
    GroundPainter();

    struct Sheet {
        const gl::Texture2D& light;  // scene::BakedLight
        const MaterialOnGpu& material;
        float relief_tiles;  // of the coarse relief, to a side of the land
    };
    // So many rows of picture.lit. Leaves the framebuffer that was bound bound, and no test enabled.
    void paint(const Sheet& sheet, const GroundPictureOnGpu& picture, int first_row, int rows) const;

  private:
    gl::Program program_;
    gl::TextureTarget target_;
};

// Adds the slices that paint picture, which must stay where it is until they are done.
void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture,
                        const std::shared_ptr<const GroundPainter>& painter,
                        const std::shared_ptr<const MaterialOnGpu>& material,
                        const std::shared_ptr<const scene::Scene>& scene);

}  // namespace quadrat::render::passes
