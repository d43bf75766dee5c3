// SPDX-License-Identifier: Apache-2.0
// Where a ray meets the layers of cloud, seen from the eye and with the layers' height as the unit; divided by a little
// more than the ray's own, so that they bend down to the horizon as the earth's do. A vertex that lies there has its
// texture coordinates right in between, without a division a pixel: a layer is flat.
vec3 on_clouds(vec3 ray) { return ray / (max(ray.y, 0.0) + 0.045); }

// A point on the layers in the tiles of both, for clouds_at(): a tile may be turned and stretched.
vec4 cloud_tiles(vec3 on_layers) {
    return vec4(view.cloud_place[0].xy + view.cloud_turn[0].xy * on_layers.x + view.cloud_turn[0].zw * on_layers.z,
                view.cloud_place[1].xy + view.cloud_turn[1].xy * on_layers.x + view.cloud_turn[1].zw * on_layers.z);
}
