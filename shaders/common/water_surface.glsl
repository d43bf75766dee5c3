// SPDX-License-Identifier: Apache-2.0
// What water.frag needs of a point of still water: air, Fresnel's share and where the mirrored picture is seen change
// slowly enough over a triangle to be worked out at its corners.
#include "common/mirror.glsl"

out vec2 over_land;
out float drifted;  // where the gusts that are here now were over the land, eastward
out vec3 before;    // shown, the air and the water's own colour, weighted
out vec3 mirrored;  // xy: in the mirrored picture; z: its share, to what water.frag leaves of a slope of 1; xy where
                    // that slope is 0
out float glitter;  // how bright the sun is in water of that slope, as a power of two
out float white;    // from how deep water on there is no foam: at the sea's shore some, in a fall's all of it

void show_water(vec3 at_m, float foams) {
    white = foams;
    drifted = at_m.x * view.scales.x - view.eye_seconds.w * 0.0008;
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    over_land = at_m.xz * view.scales.x + 0.5;

    vec3 away = normalize(at_m - view.eye_seconds.xyz);
    away.y = max(-away.y, 0.004);
    float grazing = 1.0 - away.y;
    float reflected = 0.05 + 0.85 * grazing * grazing * grazing * grazing;
    vec4 haze = haze_at(at_m);
    float clear = 1.0 - haze.a;
    vec3 own = view.shallow_water.rgb + view.deepening.rgb;
    before = haze.rgb * haze.a + own * ((1.0 - reflected) * clear);
    // By night the picture is open for the land: pale hills in the water would be a white sheet.
    float held = 0.48 + 0.64 * view.eye_snow.x;
    mirrored = vec3(in_mirror(at_m, away), held * reflected * clear * view.to_sun.w);
    mirrored.y -= mirror.ripple.x;
    // Gusts roughen some of the water and leave some of it smooth.
    vec2 gust = at_m.xz * 0.045 + view.eye_seconds.w * vec2(0.05, 0.03);
    float rough = sin(gust.x + 1.7 * sin(gust.y)) + sin(1.9 * gust.y - 0.7 * gust.x) + 0.6 * sin(3.1 * gust.x + gust.y);
    // It is many times as bright as the sky that it is seen with, by night too, when that is darker still.
    float bright = clear * min(view.sunlight.g, 1.0) / max(view.haze_colour.g, 0.08);
    // A low sun or moon leaves a path; a high one would make a bay a sheet: there ripples alone glitter.
    float low = max(1.0 - 4.0 * view.to_sun.y, 0.0);
    glitter = (dot(away, view.to_sun.xyz) - 1.0) * mirror.ripple.z - mirror.ripple.w + 0.5 * log2(bright + 1e-4) +
              min(1.2 * rough, 1.0 + 2.0 * low) + 3.4 * low - 0.7 - 0.5 * mirror.ripple.y;
}
