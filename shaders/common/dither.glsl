// SPDX-License-Identifier: Apache-2.0
// Half a step of noise against banding in slow gradients (interleaved gradient noise, Jimenez 2014).
float dither() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) * (1.0 / 255.0) - 0.5 / 255.0;
}
