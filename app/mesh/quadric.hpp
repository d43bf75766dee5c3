// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace quadrat::mesh {

// The weighted sum of squared distances of a point from planes: Q(x) = xT A x + 2 bT x + c, after Garland & Heckbert,
// "Surface simplification using quadric error metrics" (1997). Ours counts x from a place of its own, the vertex it
// belongs to: single precision then loses nothing, however far away the vertex is.
struct Quadric {
    float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;  // A
    glm::vec3 b{0};
    float c = 0;

    // A plane through the quadric's own place.
    void add_plane(glm::vec3 unit_normal, float weight) {
        const glm::vec3 n = weight * unit_normal;
        xx += n.x * unit_normal.x;
        yy += n.y * unit_normal.y;
        zz += n.z * unit_normal.z;
        xy += n.x * unit_normal.y;
        xz += n.x * unit_normal.z;
        yz += n.y * unit_normal.z;
    }

    // The place itself: the squared distance from it.
    void add_point(float weight) {
        xx += weight;
        yy += weight;
        zz += weight;
    }

    glm::vec3 times_a(glm::vec3 x) const {
        return {xx * x.x + xy * x.y + xz * x.z, xy * x.x + yy * x.y + yz * x.z, xz * x.x + yz * x.y + zz * x.z};
    }

    float at(glm::vec3 x) const { return glm::dot(x, times_a(x)) + 2 * glm::dot(b, x) + c; }

    // Half its gradient.
    glm::vec3 half_slope_at(glm::vec3 x) const { return times_a(x) + b; }

    // The same sum, counted from a place moved by so much.
    void move(glm::vec3 by) {
        const glm::vec3 a = times_a(by);
        c = std::max(0.0F, c + glm::dot(by, a + 2.0F * b));
        b += a;
    }

    Quadric& operator+=(const Quadric& o) {
        xx += o.xx;
        yy += o.yy;
        zz += o.zz;
        xy += o.xy;
        xz += o.xz;
        yz += o.yz;
        b += o.b;
        c += o.c;
        return *this;
    }
};

// The sum of two quadrics on the line through their places: of u at 0 and of v, which lies at `along` from u, at 1.
struct OnLine {
    float square, linear, constant;

    OnLine(const Quadric& u, const Quadric& v, glm::vec3 along) {
        const float of_u = glm::dot(along, u.times_a(along));
        const float of_v = glm::dot(along, v.times_a(along));
        const float slope_v = glm::dot(v.b, along);
        square = of_u + of_v;
        linear = glm::dot(u.b, along) + slope_v - of_v;
        constant = u.c + v.c + of_v - 2 * slope_v;
    }
    // Where it is least, in [low, high].
    float least(float low, float high) const {
        return square > 0 ? std::clamp(-linear / square, low, high) : 0.5F * (low + high);
    }
    float at(float t) const { return std::max(0.0F, constant + t * (2 * linear + t * square)); }
};

}  // namespace quadrat::mesh
