// SPDX-License-Identifier: Apache-2.0
// Linear, exposed light to the display's sRGB values: a cubic in sqrt(x), fitted by least squares to the sRGB curve
// with a soft shoulder (identity below 0.72, white reached at 1.44). Within 0.021 of it everywhere. The C++ mirror is
// passes/encode.hpp.
vec3 encode_root(vec3 root) {
    vec3 s = min(root, 1.2);
    return s * (1.007595 + s * (0.352583 - 0.406319 * s));
}

vec3 encode(vec3 light) { return encode_root(sqrt(max(light, 0.0))); }
