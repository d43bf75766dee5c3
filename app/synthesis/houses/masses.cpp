// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/masses.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::synthesis::houses {

void add_face(scene::Masses& to, std::span<const glm::vec3> corners, const Look& look, std::span<const float> shades) {
    if (corners.size() < 3) return;
    glm::vec3 area{0};
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    if (glm::dot(area, area) < 1.0e-10F) return;
    const glm::vec3 normal = glm::normalize(area);
    const glm::vec2 level{normal.z, -normal.x};
    const glm::vec3 along =
        glm::dot(level, level) > 1.0e-6F ? glm::normalize(glm::vec3{level.x, 0, level.y}) : glm::vec3{1, 0, 0};
    const glm::vec3 up = glm::cross(normal, along);
    // Far from the middle the surface counts anew: what is drawn holds metres in few bits.
    constexpr float kAnew_m = 64;
    const float from_m = kAnew_m * std::round(glm::dot(along, corners[0]) / kAnew_m);
    const auto first = static_cast<std::uint32_t>(to.mesh.positions_m.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        to.mesh.positions_m.push_back(corners[i]);
        to.mesh.normals.push_back(normal);
        to.mesh.texcoords.emplace_back(glm::dot(along, corners[i]) - from_m, glm::dot(up, corners[i]));
        to.colours.push_back(look.colour * (shades.empty() ? 1.0F : shades[i]));
        to.claddings.push_back(look.cladding);
        to.lamps.push_back(look.lamp);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        for (const std::uint32_t corner : {0U, i - 1, i}) to.mesh.indices.push_back(first + corner);
}

void add_box(scene::Masses& to, const Box& box, const Look& look, float foot_shade) {
    const glm::vec3 a = box.across * box.half_m.x;
    const glm::vec3 deep = glm::vec3{-box.across.z, 0, box.across.x} * box.half_m.z;
    const glm::vec3 up{0, box.half_m.y, 0};
    const std::array<glm::vec3, 4> foot{box.foot_m - a + deep, box.foot_m + a + deep, box.foot_m + a - deep,
                                        box.foot_m - a - deep};
    const std::array<float, 4> shades{foot_shade, foot_shade, 1, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3 p = foot[i];
        const glm::vec3 q = foot[(i + 1) % 4];
        add_face(to, std::array{p, q, q + up, p + up}, look, shades);
    }
    add_face(to, std::array{foot[0] + up, foot[1] + up, foot[2] + up, foot[3] + up}, look);
}

std::vector<glm::dvec2> left_of(const std::vector<glm::dvec2>& polygon, glm::dvec2 a, glm::dvec2 b) {
    std::vector<glm::dvec2> left;
    const auto side = [&](glm::dvec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i];
        const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
        const double from = side(p);
        const double to = side(q);
        if (from >= 0) left.push_back(p);
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) left.push_back(p + (q - p) * (from / (from - to)));
    }
    return left;
}

}  // namespace quadrat::synthesis::houses
