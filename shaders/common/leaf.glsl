// SPDX-License-Identifier: Apache-2.0
// A leaf's vertex, from its attributes to where it is drawn and how it is lit.
layout(location = 0) in vec3 site_m;
layout(location = 1) in vec3 corner_m;
layout(location = 2) in vec2 age_sway;
layout(location = 3) in float rank;  // the blade's place in the shuffled order, 0 to 1
layout(location = 4) in vec4 leaf_normal;
layout(location = 5) in vec4 root_colour_shade;  // rgb: square root of the colour; a: light through the own crown
layout(location = 6) in vec2 blade;  // from the midrib to the rim, from the foot to the tip

layout(location = 0) uniform vec4 blade_picture;  // of one leaf or of many; xy: how much of it a blade shows, y: for
                                                  // each time that it is enlarged; zw: how far it shows, the same
layout(location = 2) uniform vec2 moved;          // how far one blade's part lies from another's

out vec3 shown;
out vec3 on_blade;

// A share of the blades stands for all of them, each enlarged; those about to leave shrink first, so none pops. Copies
// come as they would leave.
float blade_scale(float grown, float times) {
    float share = turn_grown_share.w;
    float leaving = clamp((1.0 - rank / share) * 6.5, 0.0, 1.0);
    return grown * leaving * times;
}

// Where a corner lies that is so far from where the blade is attached: the shader's own.
vec3 fanned(vec3 from_site_m);

void main() {
    // A blade that stands for many shows many; where one picture takes the other's place neither shows.
    float times = 0.5 / half_tint_enlarged.a;
    on_blade.xy = blade * (blade_picture.x + blade_picture.y * times) + rank * moved;
    on_blade.z = clamp(blade_picture.z + blade_picture.w * times, 0.0, 1.0) * (1.0 - air.a);  // the air hides it too
    float grown = unfolded(age_sway.x);
    vec3 in_plant_m = site_m * grown + fanned(corner_m * blade_scale(grown, times));
    float flutter = 0.012 * sin(view.eye_seconds.w * 4.3 + rank * 97.0);
    in_plant_m.y += flutter * age_sway.y;
    gl_Position = view.clip_from_world * vec4(planted(in_plant_m, age_sway.y), 1.0);

    shown = leaf_shown(turned(leaf_normal.xyz), root_colour_shade);
}
