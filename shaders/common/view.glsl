// SPDX-License-Identifier: Apache-2.0
// What every pass knows of its view. The C++ mirror is passes/view_block.hpp; one test says that they agree.
// Light, haze and cloud colours arrive already dimmed.
precision highp float;
precision highp int;

layout(std140, binding = 0) uniform ViewBlock {
    mat4 clip_from_world;
    vec4 eye_seconds;       // xyz: eye, m; w: the scene's time, s
    vec4 to_sun;            // xyz: unit; w: land's half side, m
    vec4 sunlight;          // rgb: irradiance / pi facing the sun; w: dim, what is left of the light
    vec4 light_above;       // rgb: ambient from above; w: 1 / side of the land, 1/m
    vec4 light_around;      // rgb: from the horizon; w: 1 / tile of the ground's grain, 1/m
    vec4 light_below;       // rgb: from the ground; w: strength of the ground's grain
    vec4 haze_colour;       // rgb: across the sun; w: log2(e) / haze distance, 1/m
    vec4 haze_sunward;      // rgb: toward the sun; w: log2(e) / haze height, 1/m
    vec4 far_colour;        // rgb: of the surround
    vec4 shallow_colour;    // rgb: of water, lit; w: cosine of the ripples' turn
    vec4 deep_colour;       // rgb: of water, lit; w: sine of it
    vec4 sun_colour;        // rgb: of the disc and its glow; w: cosine of the disc's radius
    vec4 cloud_place[2];    // xy: texture coordinate over the eye; z: (height - eye) / tile; w: opacity
    vec4 cloud_sunlit[2];
    vec4 cloud_shaded[2];
} view;
