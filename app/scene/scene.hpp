// SPDX-License-Identifier: Apache-2.0
// The room `scene`: what a landscape is once it has grown, in metres and degrees. Land, flora, sky, light, cameras, and
// the parameters that the growers need. Nothing here grows (synthesis) or draws (render): they meet in these types.
#pragma once
#include <memory>
#include <vector>

#include "mesh/image.hpp"
#include "scene/camera.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"
#include "scene/mirror.hpp"
#include "scene/sky.hpp"
#include "scene/sward.hpp"

namespace quadrat::scene {

// How finely to grow. The picture's size does not enter: a scene is the same on every screen.
struct Fineness {
    int land_samples = 513;  // a side, 2^k + 1
    int light_px = 512;      // baked light a side
    int albedo_px = 1024;
};

// Light that stands still, baked while growing, over the land's square.
// Channels 0 to 2: what light reaches the ground (sun and sky, times the cosine), linear, halved: 255 is 2.
// Channel 3: depth of water over the ground, 255 is 24 m.
struct BakedLight {
    mesh::Image ground;
};

// What a scene stands on, whatever its sky.
struct Ground {
    std::shared_ptr<const Flora> flora;
    std::shared_ptr<const Land> land;
    friend bool operator==(const Ground&, const Ground&) = default;
};

// One landscape, whole and immutable once composed. The three aspects are shared with others that inherited them.
struct Scene {
    std::shared_ptr<const Flora> flora;
    std::shared_ptr<const Land> land;
    std::shared_ptr<const Sky> sky;
    std::vector<Plant> plants;  // sorted by species
    Sward sward;
    BakedLight light;
    Mirror mirror;         // of its water
    float exposure = 1;    // of all its light, when it is shown
    float floor_m = 0;     // above the sea: the low ground along its flight, on which mist lies
    float houses_sun = 1;  // of the sun, what reaches its houses past the land, 0 to 1
    Track track;
};

}  // namespace quadrat::scene
