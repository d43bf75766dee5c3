// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "scene/camera.hpp"
#include "scene/flora.hpp"
#include "scene/scene.hpp"

namespace quadrat::synthesis {

// Lays the shade of a cloud over what is nearest to the flight, as landscape painters do: dark near by, light in the
// middle, pale far away. Ground and plants, trees by little: a dark lump of a tree before the light hides what one is
// to look at. left: of the light where it is darkest.
inline constexpr float kLeftByDay = 0.46F;
inline constexpr float kLeftByNight = 0.74F;
inline constexpr float kLeftAgain = 0.66F;  // of that, as often as a picture would have too few values without
void shade_what_is_near(scene::BakedLight& light, std::span<scene::Plant> plants, const scene::Flora& flora,
                        const scene::Track& track, float side_m, float left);

}  // namespace quadrat::synthesis
