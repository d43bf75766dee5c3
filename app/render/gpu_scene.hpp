// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "render/gl/texture.hpp"
#include "render/light_and_air.hpp"
#include "render/passes/ground.hpp"
#include "render/passes/plants.hpp"
#include "render/passes/sky.hpp"
#include "render/passes/stone.hpp"
#include "render/passes/water.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace quadrat::render {

// What a picture of the scene needs, and nothing else of it: the grown scene may go once this is whole.
class GpuScene {
  public:
    passes::LandOnGpu land;
    passes::FreshWaterOnGpu fresh_water;
    passes::StoneOnGpu stone;
    passes::SkyOnGpu sky;
    std::shared_ptr<passes::FloraOnGpu> flora;  // shared with scenes that inherited it
    std::vector<scene::Plant> plants;
    LightAndAir air;
    float haze_distance_m = 1;
};

struct Texture {
    gl::Texture2D picture;
};

}  // namespace quadrat::render
