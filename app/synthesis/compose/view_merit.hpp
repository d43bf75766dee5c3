// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/camera.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

// What a camera of 16 by 9 sees of a land, as shares of its picture.
struct Outlook {
    float sky = 0;
    float water = 0;
    float near = 0;    // ground nearer than 45 m
    float far = 0;     // farther than 500 m
    float walled = 0;  // nearer than 12 m: a slope before the eyes
    float roofed = 0;  // of houses nearer than 32 m: walls and roofs before the eyes
    float stony = 0;   // of rock that stands on the ground nearer than 55 m and that the picture's sides cut off
    float housed = 0;  // of a settlement's houses, the share that the picture holds, large enough and not behind land
    float made = 0;    // of arches and standing stones in sight: the sum of how large they look, in radians
    float marked = 0;  // of the largest landmark in sight that is no cave: how large it looks, in radians
    float cave = 0;    // of the largest mouth of a cave in sight, the same
    float road = 0;    // of roads that are no lanes
};
Outlook outlook(const scene::Land& land, const scene::Camera& camera);

// How well a landscape painter would like it: something near, something far, water if there is any, a third of sky.
float view_merit(const Outlook& seen);

}  // namespace quadrat::synthesis
