// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "render/gl/texture.hpp"
#include "render/light_and_air.hpp"
#include "render/passes/cover.hpp"
#include "render/passes/ground.hpp"
#include "render/passes/houses.hpp"
#include "render/passes/mirror.hpp"
#include "render/passes/plants.hpp"
#include "render/passes/sky.hpp"
#include "render/passes/smoke.hpp"
#include "render/passes/stone.hpp"
#include "render/passes/water.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace quadrat::render {

// What of a land needs no sky.
struct CountryOnGpu {
    passes::LandOnGpu land;
    passes::FreshWaterOnGpu fresh_water;
    passes::StoneOnGpu stone;
    passes::HousesOnGpu houses;
    passes::SmokeOnGpu smoke;
};

// What a picture of the scene needs.
class GpuScene {
  public:
    std::shared_ptr<const CountryOnGpu> country;  // all three shared with scenes that inherited them
    std::shared_ptr<const passes::FloraOnGpu> flora;
    std::shared_ptr<const passes::SkyOnGpu> sky;
    passes::GroundPictureOnGpu ground;
    passes::MirrorOnGpu mirror;
    choose::CoverOfScene cover;
    std::shared_ptr<const std::vector<scene::Plant>> plants;  // the grown scene's, which stays for them
    LightAndAir air;
};

struct Texture {
    gl::Texture2D picture;
};

}  // namespace quadrat::render
