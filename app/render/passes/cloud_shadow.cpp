// SPDX-License-Identifier: Apache-2.0
#include "render/passes/cloud_shadow.hpp"

#include "render/gl/texture.hpp"

namespace quadrat::render::passes {

mesh::Image shadow_map_of(const mesh::Image& density) {
    if (density.width < kShadowSide) return mesh::Image(kShadowSide, kShadowSide, 1);
    mesh::Image map = density;
    while (map.width > kShadowSide) map = gl::halved(map);
    return map;
}

ShadowTable shadow_table(const mesh::Image& map) {
    ShadowTable table{};
    for (int y = 0; y < kShadowSide; ++y) {
        for (int x = 0; x < kShadowSide; ++x) {
            std::uint32_t four = 0;
            for (int corner = 3; corner >= 0; --corner)
                four = four << 8U | *map.pixel((x + corner % 2) % kShadowSide, (y + corner / 2) % kShadowSide);
            table[static_cast<std::size_t>(y * kShadowSide + x)] = four;
        }
    }
    return table;
}

}  // namespace quadrat::render::passes
