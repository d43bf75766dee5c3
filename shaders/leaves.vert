#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/night_eye.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"
#include "common/leaf_light.glsl"
#include "common/leaf.glsl"

vec3 fanned(vec3 from_site_m) { return from_site_m; }
