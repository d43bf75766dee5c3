// SPDX-License-Identifier: Apache-2.0
// What water.frag needs of a point of still water: air, Fresnel's share and the mirrored sky change slowly enough over a
// triangle to be worked out at its corners.

out vec2 over_land;
out vec4 before;   // rgb: shown, the mirrored sky and the air, weighted; a: what is left for the water's own colour
out float glitter;  // how bright the sun is in level water, as a power of two
out float white;    // from how deep water on there is no foam: at the sea's shore some, in a fall's all of it

void show_water(vec3 at_m, float foams) {
    white = foams;
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    over_land = at_m.xz * view.scales.x + 0.5;

    vec3 away = normalize(at_m - view.eye_seconds.xyz);
    away.y = max(-away.y, 0.02);
    float grazing = 1.0 - away.y;
    float reflected = 0.04 + 0.76 * grazing * grazing * grazing * grazing;
    float cos_to_glow = dot(away, view.to_glow.xyz);
    vec3 sky = mix(haze_towards(cos_to_glow), view.mirrored.rgb, 1.0 - exp2(-4.5 * away.y));
    vec4 haze = haze_at(at_m);
    float clear = 1.0 - haze.a;
    before = vec4(haze.rgb * haze.a + sky * (reflected * clear), (1.0 - reflected) * clear);
    glitter = (dot(away, view.to_sun.xyz) - 1.04) * 70.0 + log2(clear * min(view.sunlight.g, 1.0) + 1e-4);
}
