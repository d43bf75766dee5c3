// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "render/gl/picture_upload.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

inline constexpr float kGrain = 0.55F;  // how much of the ground's brightness its grain is

// Adds the slices that fill lit with what the ground sends to the eye, shown, its coarse relief in it (alpha: how deep
// water over it looks), and grain with that of soft ground and of stone, in the light of the sun: it stands still.
void add_ground_picture(gl::Slices& slices, gl::Texture2D& lit, gl::Texture2D& grain,
                        const std::shared_ptr<const scene::Scene>& scene);

}  // namespace quadrat::render::passes
