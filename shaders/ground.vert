#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/cloud_shadow.glsl"
#include "common/land.glsl"

void main() { show_land(); }
