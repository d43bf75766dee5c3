// SPDX-License-Identifier: Apache-2.0
// Where the light that falls on a point has come through the lower clouds. The C++ mirror, for plants, is
// passes/cloud_shadow.hpp.
vec2 under_clouds(vec3 at_m) {
    return view.shadow_place.xy - view.shadow_place.zw * at_m.y + view.shadow_turn.xy * at_m.x +
           view.shadow_turn.zw * at_m.z;
}
