// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "mesh/image.hpp"
#include "render/gl/texture.hpp"
#include "render/passes/ground.hpp"
#include "render/passes/plants.hpp"
#include "render/passes/sky.hpp"
#include "render/passes/view_block.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace quadrat::render {

// What a picture of the scene needs, and nothing else of it: the grown scene may go once this is whole.
class GpuScene {
  public:
    passes::LandOnGpu land;
    passes::SkyOnGpu sky;
    std::shared_ptr<passes::FloraOnGpu> flora;  // shared with scenes that inherited it
    std::vector<scene::Plant> plants;
    passes::ViewBlock colours;                      // all of it that does not change with camera and time
    std::array<scene::CloudLayer, 2> cloud_layers;  // without their images
    float haze_distance_m = 1;
};

struct Texture {
    gl::Texture2D picture;
};

// What of a scene's light and air every view of it shares.
passes::ViewBlock colours_of(const scene::Scene& scene);

}  // namespace quadrat::render
