// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "render/gl/picture_upload.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture_pool.hpp"
#include "render/gl/texture_target.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

inline constexpr float kGrain = 0.55F;  // how much of the ground's brightness its grain is

// What the ground's pictures have in common in any light, as long as they are painted.
struct MaterialOnGpu {
    gl::Texture2D kinds;  // how far its grain is soft ground's, how far stone's
};
void add_material(gl::Slices& slices, MaterialOnGpu& material, const std::shared_ptr<const scene::Land>& land);

// Of soft ground and of stone, under a sun that stands still; 0.5 is level ground.
struct GrainOnGpu {
    gl::Texture2D lit;
};
void add_grain(gl::Slices& slices, GrainOnGpu& grain, const std::shared_ptr<const scene::Land>& land, glm::vec3 to_sun);

// The ground as it is seen, under that sun.
struct GroundPictureOnGpu {
    // What it sends to the eye, shown, its coarse relief in it; alpha: how deep water over it looks.
    std::shared_ptr<const gl::Texture2D> lit;
    std::shared_ptr<const GrainOnGpu> grain;
};

// Square roots of the ground's linear colours, in the size of its picture. Alpha: the rim is as under deep water, for
// all beyond it repeats the rim.
mesh::Image roots_of_rows(const scene::GroundColours& colours, const gl::TextureShape& picture, int first, int count);

// Multiplies what the ground is made of and the light baked for it, once a scene: a pixel fetches their product.
class GroundPainter {
  public:
    GroundPainter();

    struct Sheet {
        std::span<const std::uint8_t> roots;  // roots_of_rows() of those that are painted
        const gl::Texture2D& light;           // scene::BakedLight
        const MaterialOnGpu& material;
        float relief_tiles;  // of the coarse relief, to a side of the land
    };
    gl::TexturePool canvases;  // to paint on, and some of them to be seen too
    gl::TexturePool copies;    // never painted on
    // So many rows of it. Leaves the framebuffer that was bound bound, and no test enabled.
    void paint(const Sheet& sheet, const gl::Texture2D& grain, const gl::Texture2D& canvas, int first_row,
               int rows) const;
    // Some rows of what was painted, of its finest level.
    void copy_rows(const gl::Texture2D& canvas, const gl::Texture2D& lit, int first_row, int rows) const {
        target_.copy_rows(canvas, lit, 0, {first_row, rows});
    }
    void copy_coarser(const gl::Texture2D& canvas, const gl::Texture2D& lit) const { target_.copy(canvas, lit, 1); }

  private:
    gl::Program program_;
    gl::TextureTarget target_;
};

// Adds the slices that paint picture, which must stay where it is until they are done. It has its grain, or that is
// among the slices before.
void add_ground_picture(gl::Slices& slices, GroundPictureOnGpu& picture, const std::shared_ptr<GroundPainter>& painter,
                        const std::shared_ptr<const MaterialOnGpu>& material,
                        const std::shared_ptr<const scene::Scene>& scene);

}  // namespace quadrat::render::passes
