// SPDX-License-Identifier: Apache-2.0
// What every pass knows of its view. The C++ mirror is passes/view_block.hpp; one test says that they agree.
// Two kinds of colour: light is linear; a "shown" colour is encoded for the display already (common/encode.glsl). Light
// is summed while it is linear; what lies before or behind another thing (air, cloud, water) is mixed as shown, which is
// how a painter mixes it and spares every pixel the encoding. All of them arrive dimmed.
precision highp float;
precision highp int;

layout(std140, binding = 0) uniform ViewBlock {
    mat4 clip_from_world;
    vec4 eye_seconds;    // xyz: eye, m; w: the scene's time, s
    vec4 to_sun;         // xyz: unit; w: what dimming leaves of a shown colour
    vec4 sunlight;       // rgb: light, irradiance / pi facing the sun; w: factor of the ground's picture
    vec4 light_above;    // rgb: light from above; w: 1 / side of the land, 1/m
    vec4 light_around;   // rgb: light from the horizon; w: 1 / tile of the ground's grain, 1/m
    vec4 light_below;    // rgb: light from the ground; w: factor of the grain
    vec4 far_colour;     // rgb: linear, of the surround; w: half the sum of the ripples' cosine and sine
    vec4 haze_colour;    // rgb: shown, across the sun; w: log2(e) / haze distance, 1/m
    vec4 haze_sunward;   // rgb: shown, toward the sun; w: log2(e) / haze height, 1/m
    vec4 shallow_water;  // rgb: shown; w: cosine of the ripples' turn
    vec4 deepening;      // rgb: shown, deep water less shallow; w: sine of the ripples' turn
    vec4 mirrored;       // rgb: shown, the high sky in the water; w: brightness of foam, shown
    vec4 sun_colour;     // rgb: shown, of the disc and its glow; w: the disc's radius
    vec4 cloud_place[2]; // xy: texture coordinate over the eye; z: (height - eye) / tile; w: opacity
    vec4 cloud_shaded;   // rgb: shown; w: the upper layer's light on the lower one's scale: factor
    vec4 cloud_gain;     // rgb: shown, sunlit less shaded; w: the same: what is added
} view;
