// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "mesh/field.hpp"

namespace quadrat::mesh {

// A square heightfield as right triangles, each halved where the ground is rough for its distance. What was right for
// the last eye is changed for the next one, and only where that can have come into question. No cracks: a triangle's
// edge is never shared by two.
class Roam {
  public:
    // The field's middle lies at the origin, x along its columns and z along its rows. At least one cell; a side of
    // 2^n cells is best, since triangles are halved as long as their sides are even.
    Roam(const Field& height_m, float cell_m);

    struct Wish {
        glm::vec3 eye_m{0};
        float pixels_per_radian = 1000;                              // of the view
        float error_px = 1.3F;                                       // how far the ground may lie from its true height,
        std::size_t triangle_budget = static_cast<std::size_t>(-1);  // and further where this would not hold it
        std::span<const glm::vec4> planes = {};  // what append_indices leaves of it is within the budget
    };
    void update(const Wish& wish);

    // Three indices a triangle into the field's samples, counter-clockwise seen from above, appended; without those
    // parts that lie behind one of the planes (inward normals, 31 at most; none: everything). Of two triangles of a
    // square, the one that may hide the other from the eye comes first. Returns how many triangles.
    std::size_t append_indices(std::span<const glm::vec4> planes, std::vector<std::uint32_t>& indices) const;

    std::size_t triangle_count() const { return leaves_; }
    glm::vec3 place_m(std::uint32_t index) const;  // of a sample
    float error_px() const { return error_px_; }   // what the budget made of the wish

  private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    // A triangle with a right angle at its apex; its base, from left to right, is the long side.
    struct Corners {
        glm::ivec2 apex, left, right;
    };
    struct Triangle {
        std::uint32_t children = kNone;  // this one and the next
        std::uint32_t parent = kNone;
        std::uint32_t base = kNone, left = kNone, right = kNone;  // across these sides; kNone: the rim
        std::uint32_t bound = kNone;                              // in bounds_; kNone: cannot be halved
        std::uint32_t version = 0;
        Corners corners{};
    };
    // All that lies within a triangle, however far it is halved.
    struct Bound {
        float error_m = 0;  // of the triangle's own plane, at most
        float low_m = 0, high_m = 0;
        std::uint32_t children = kNone;  // in links_
    };
    // Something to look at again when the eye has gone so far in all.
    struct Due {
        double at_m;
        std::uint32_t triangle, version;
        bool operator<(const Due& o) const { return at_m > o.at_m; }
    };

    void make_roots();
    std::uint32_t bound_of(const Corners& corners);
    void restart();
    double due_m(float slack_m) const;
    void settle();
    void look_at_leaf(std::uint32_t t);
    void look_at_diamond(std::uint32_t t);
    bool is_diamond(std::uint32_t t) const;
    void push(std::vector<Due>& queue, double at_m, std::uint32_t t);
    void push_diamond(std::uint32_t t);

    // How far the eye may still come, or still is too near; above 0: it is far enough for the triangle as it is.
    float slack_m(std::uint32_t t) const;
    void box_of(const Triangle& triangle, glm::vec3& low_m, glm::vec3& high_m) const;

    void split(std::uint32_t t);
    void split_alone(std::uint32_t t);
    void join_children(std::uint32_t t, std::uint32_t across);
    void merge(std::uint32_t t);
    void merge_alone(std::uint32_t t);
    void relink(std::uint32_t neighbour, std::uint32_t from, std::uint32_t to);
    // The corners of every leaf that planes leave, what may hide before what it may hide.
    struct Sight;
    template <typename Visit>
    void visit_seen(std::span<const glm::vec4> planes, const Visit& visit) const;
    template <typename Visit>
    void visit_seen(std::uint32_t t, const Sight& sight, std::uint32_t cutting, const Visit& visit) const;
    std::size_t seen_of(const Wish& wish) const;
    bool may_be_seen(const Triangle& triangle, std::span<const glm::vec4> planes, std::uint32_t& cutting) const;
    std::uint32_t index_of(glm::ivec2 p) const { return static_cast<std::uint32_t>(p.y * height_m_.columns + p.x); }

    Field height_m_;
    float cell_m_;
    std::vector<Bound> bounds_;
    std::vector<std::array<std::uint32_t, 2>> links_;  // from a bound to those of the halves
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> free_;  // pairs
    std::uint32_t roots_ = 0;
    std::size_t leaves_ = 0;
    std::vector<std::uint32_t> rough_;  // leaves to split now
    std::vector<Due> splits_, merges_;  // heaps, the next due first
    glm::vec3 eye_m_{0};
    double gone_m_ = 0;
    float allowed_ = 0;  // pixels over pixels a radian
    float error_px_ = 0;
    float wished_px_ = 0;
};

}  // namespace quadrat::mesh
