// SPDX-License-Identifier: Apache-2.0
// Where a ray meets the upper layer of cloud, seen from the eye and with the layer's height as the unit; divided by a
// little more than the ray's own, so that it bends down to the horizon as the earth's does. A vertex that lies there has
// its texture coordinates right in between, without a division a pixel: a layer is flat.
vec3 on_clouds(vec3 ray) { return ray / (max(ray.y, 0.0) + 0.045); }

// A direction in the picture of the lower clouds, and a point on the upper layer in its tile, for clouds_at(): a tile
// may be turned and stretched. The C++ mirror of the first is scene::cloudscape_at().
vec4 cloud_tiles(vec3 direction, float bearing, vec3 on_layers) {
    float turned = bearing - view.cloud_place[0].x;
    float up = max(direction.y, 0.0);
    return vec4((turned + 0.7 * sin(turned)) * 0.1591549 + 0.5, up * 1.2 / (up + 0.2),
                view.cloud_place[1].xy + view.cloud_turn[1].xy * on_layers.x + view.cloud_turn[1].zw * on_layers.z);
}
