// SPDX-License-Identifier: Apache-2.0
// A surface's colour as an eye sees it by night. scene/night_eye.hpp says why.
vec3 seen_by_night(vec3 albedo) {
    return albedo * view.eye_snow.x + dot(albedo, vec3(0.06, 0.60, 0.34)) * view.eye_snow.y;
}

// Of leaves, whose green alone tells how light they are: it is cheaper.
vec3 leaf_seen_by_night(vec3 albedo) { return albedo * view.eye_snow.x + 0.85 * view.eye_snow.y * albedo.g; }
