// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "render/gl/picture_upload.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture_target.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

inline constexpr float kGrain = 0.55F;  // how much of the ground's brightness its grain is

// What the ground's pictures have in common in any light, as long as they are painted.
struct MaterialOnGpu {
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
        const scene::GroundColours& colours;
        float relief_tiles;  // of the coarse relief, to a side of the land
    };
    static constexpr int kMostRows = 64;  // at once
    // So many rows of picture.lit. Leaves the framebuffer that was bound bound, and no test enabled.
    void paint(const Sheet& sheet, const GroundPictureOnGpu& picture, int first_row, int rows);
    // So many rows of a coarser level of it, from the next finer one, which is whole.
    void halve(const GroundPictureOnGpu& picture, int level, int first_row, int rows);

  private:
    const gl::Texture2D& band(int width);

    gl::Program program_;
    gl::Program halving_;
    gl::TextureTarget target_;
    gl::Texture2D band_;  // where rows are drawn, from its lower left on
};

// Adds the slices that paint picture, which must stay where it is until they are done.
void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture, const std::shared_ptr<GroundPainter>& painter,
                        const std::shared_ptr<const MaterialOnGpu>& material,
                        const std::shared_ptr<const scene::Scene>& scene);

}  // namespace quadrat::render::passes
