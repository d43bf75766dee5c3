// SPDX-License-Identifier: Apache-2.0
// A step of noise against banding in slow gradients: the plane's R2 sequence (Roberts 2018), which is even at any scale.
float dither() { return fract(dot(gl_FragCoord.xy, vec2(0.7548777, 0.5698403))) * (1.0 / 255.0); }
