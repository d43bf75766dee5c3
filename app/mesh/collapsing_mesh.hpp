// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/collapse_queue.hpp"
#include "mesh/progressive.hpp"
#include "mesh/quadric.hpp"

namespace quadrat::mesh {

// A mesh on its way to fewer vertices, cheapest collapse first. Around each vertex it knows the far edge of each of its
// triangles and nothing else; that of most vertices is one line of the processor's cache.
class CollapsingMesh {
  public:
    CollapsingMesh(const Mesh& mesh, const ProgressiveOptions& options);

    std::size_t vertex_count() const { return alive_; }
    float error_m() const { return error_ / scale_; }  // of the dearest collapse so far

    // False when no vertex is left that may collapse.
    bool collapse_until(std::size_t vertices);

    // The mesh as it is, and for each vertex of the last level so taken the one it has become.
    Progressive::Level level(std::vector<std::uint32_t>& parents);

  private:
    // How a vertex may move.
    enum class Kind : std::uint8_t {
        Free,    // triangles all around it
        Border,  // along an edge that has a triangle on one side only
        Seam,    // the same with a twin across it, at the same place
        Fixed,   // where these begin, end or meet, and where the surface is none
    };
    struct alignas(64) Vertex {
        glm::vec3 at;
        Quadric quadric;          // of all vertices at this place
        float weight;             // of the quadric: square of a length
        std::uint32_t twin : 30;  // the next vertex at this place, round and round
        std::uint32_t kind : 2;
    };
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    static constexpr std::uint32_t kTwinBits = 0x3FFFFFFFU;
    struct Edge {
        std::uint32_t from, to;  // of a triangle, counter-clockwise about the vertex that it is kept for
    };
    // Eight of them, or what is left and then kNone: one line of the cache, and tested all at once.
    struct alignas(64) Fan {
        std::array<std::uint32_t, 8> from, to;
    };
    struct Ring {
        std::uint32_t first = 0, fans = 0, count = 0;  // fans: room in fans_
    };
    class Around {
      public:
        Around(const Fan* fans, std::uint32_t count) : fans_(fans), count_(count) {}
        struct Iterator {
            const Fan* fans;
            std::uint32_t i;
            Edge operator*() const { return {fans[i / 8].from[i % 8], fans[i / 8].to[i % 8]}; }
            Iterator& operator++() {
                ++i;
                return *this;
            }
            bool operator!=(const Iterator& o) const { return i != o.i; }
        };
        Iterator begin() const { return {fans_, 0}; }
        Iterator end() const { return {fans_, count_}; }
        Edge operator[](std::uint32_t i) const { return *Iterator{fans_, i}; }
        std::uint32_t size() const { return count_; }
        bool has_from(std::uint32_t v) const { return count_from(v) > 0; }
        bool has_to(std::uint32_t v) const {
            for (const Edge& e : *this)
                if (e.to == v) return true;
            return false;
        }
        std::uint32_t count_from(std::uint32_t v) const {
            std::uint32_t found = 0;
            for (const Fan* fan = fans_; fan < fans_ + (count_ + 7) / 8; ++fan)
                for (std::size_t i = 0; i < 8; ++i) found += fan->from[i] == v ? 1U : 0U;
            return found;
        }

      private:
        const Fan* fans_;
        std::uint32_t count_;
    };
    struct Collapse {
        float along = 0;  // 0 where the first vertex is, 1 where the second is
        glm::vec3 to{0};
        float cost = 0;
    };

    // How it begins: collapsing_mesh_start.cpp.
    void take_triangles(const Mesh& mesh, std::span<const std::uint8_t> materials);
    void take_vertices(const Mesh& mesh, const ProgressiveOptions& options);
    void make_rings();
    void find_kinds();
    void find_twins(std::span<const std::uint32_t> rims);
    Kind kind_at(std::uint32_t vertex) const;
    bool is_sealed(std::uint32_t vertex) const;

    Around around(std::uint32_t v) const { return {fans_.data() + rings_[v].first, rings_[v].count}; }
    Kind kind(std::uint32_t v) const { return static_cast<Kind>(vertices_[v].kind); }
    bool is_dead(std::uint32_t v) const { return parents_[v] != v; }
    // The two ends of a chain of triangles.
    struct Ends {
        std::uint32_t first, last;
    };
    Ends ends_of(std::uint32_t rim) const;

    void make_quadrics();
    void add_planes(std::uint32_t v);
    void add_rim_planes(std::uint32_t rim);
    void share_quadric(std::uint32_t v);
    Collapse collapse_of(const Vertex& from, const Vertex& into, int steps) const;
    void begin_level();
    void fetch_ahead() const;
    enum class Which { All, Later };  // of a vertex's edges: those to later vertices only, so that each comes once
    void enqueue(std::uint32_t v, Which which);
    using Four [[gnu::vector_size(16)]] = float;
    Four costs_of(const Vertex& from, const std::array<const Vertex*, 4>& into) const;
    bool try_collapse(std::uint32_t from, std::uint32_t into);

    bool may_join(std::uint32_t from, std::uint32_t into, glm::vec3 to);
    bool keeps_topology(std::uint32_t from, std::uint32_t into) const;
    bool keeps_topology_of_places(std::uint32_t from, std::uint32_t into) const;
    bool keeps_sides(std::uint32_t of, std::uint32_t but, glm::vec3 to) const;
    std::uint32_t twin_target(std::uint32_t from, std::uint32_t into) const;

    void place(std::uint32_t from, std::uint32_t into, const Collapse& collapse);
    void mix_channels(std::uint32_t from, std::uint32_t into, float along);
    void join(std::uint32_t from, std::uint32_t into);
    void replace(std::uint32_t in_ring_of, std::uint32_t from, std::uint32_t into);
    void drop(std::uint32_t in_ring_of, std::uint32_t one, std::uint32_t other);
    void set_ring(std::uint32_t v);

    std::vector<std::uint32_t> corners_;  // of the triangles it began with; level() takes them
    std::vector<std::uint8_t> triangle_materials_;
    std::vector<std::uint32_t> sources_;   // a vertex: of the given mesh
    std::vector<std::uint8_t> materials_;  // a vertex; empty: one for all
    std::vector<Vertex> vertices_;
    std::vector<Ring> rings_;
    std::vector<Fan> fans_;
    std::vector<float> channels_;  // a vertex: normal, texture coordinate, attributes
    std::size_t channels_a_vertex_ = 0;
    bool has_normals_ = false;
    bool has_texcoords_ = false;
    std::size_t attributes_ = 0;
    std::vector<std::uint32_t> parents_;   // itself while it lives
    std::vector<std::uint32_t> places_;    // the first vertex at the same place; empty: no two are
    std::vector<std::uint32_t> live_;      // of the last level taken, ascending
    std::vector<std::uint32_t> versions_;  // how often a vertex has changed
    CollapseQueue queue_;
    std::vector<Edge> joined_;  // kept for its memory
    std::size_t alive_ = 0;
    float scale_ = 1;  // a power of two: everything within has a size of about one
    bool is_fitted_ = true;
    float error_ = 0;
    float error_before_ = 0;  // up to the last level
};

}  // namespace quadrat::mesh
