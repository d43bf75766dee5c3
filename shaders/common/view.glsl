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
    vec4 to_sun;         // xyz: toward the light that casts shadows, unit; w: what dimming leaves of a shown colour
    vec4 to_glow;        // xyz: toward where the sky is brightest, unit; w: light of thin cloud before it
    vec4 sunlight;       // rgb: light, irradiance / pi facing the sun; w: factor of the ground's picture, shown
    vec4 ambient[3];     // light of sky and ground on a surface, for red, green and blue: xyz times its normal plus w
    vec4 scales;         // x: 1 / side of the land, 1/m; y: 1 / tile of its grain, 1/m; z: factor of the grain; w: share of
                         // windows that are lit
    vec4 haze_colour;    // rgb: shown, across the glow; w: log2(e) / haze distance, 1/m
    vec4 haze_sunward;   // rgb: shown, toward the glow; w: log2(e) / haze height, 1/m
    vec4 mist;           // x: log2(e) * extinction, 1/m; y: its level, m; z: log2(e) / its depth, 1/m;
                         // w: how soon the sky rises out of the haze, in powers of two a sine of height
    vec4 eye_snow;       // x: how much of a colour an eye sees in so little light; y: what is seen of it as grey; z: from
                         // where snow lies on plants, m; w: how much more of it a metre above, 1/m
    vec4 shallow_water;  // rgb: shown
    vec4 deepening;      // rgb: shown, deep water less shallow
    vec4 mirrored;       // rgb: shown, the high sky in the water; w: brightness of foam, shown
    vec4 disc;           // rgb: shown, of the sun's or the moon's; w: radius of its picture
    vec4 glare;          // rgb: shown, about the disc; w: strength of the rainbow, shown
    vec4 cloud_turn[2];  // from metres over the eye for a metre of height to a layer's tile: two columns
    vec4 cloud_place[2]; // of the lower: x: how far it has drifted, rad; y: how far the season has withered green
                         // ground; z: darkness of its shadow; of the upper: xy: texture coordinate over the eye;
                         // z: of the sun, what reaches houses; w: what dimming leaves of a lamp
    vec4 shadow_turn;    // from metres over the ground to the lower layer's tile along the light: two columns
    vec4 shadow_place;   // xy: texture coordinate of the land's middle at the sea; zw: less for a metre of height
    vec4 cloud_shaded;   // rgb: shown; w: the upper layer's light on the lower one's scale: factor
    vec4 cloud_gain;     // rgb: shown, sunlit less shaded; w: the same: what is added
} view;
