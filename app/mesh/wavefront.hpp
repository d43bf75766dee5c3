// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/exact_planes.hpp"
#include "mesh/nearby_boxes.hpp"
#include "mesh/straight_skeleton.hpp"

// The polygon that shrinks: what straight_skeleton.cpp runs. Not for use from outside.
namespace quadrat::mesh {

// What a vertex of the wavefront left behind: the line between the faces of two planes. Along it the left plane's face
// is bounded from start to end, the right one's from end to start.
struct SkeletonArc {
    int start = -1, end = -1;   // nodes
    int left = -1, right = -1;  // planes
};

// Two edges on one line became one there.
struct SharedPlaneCut {
    int node = -1;
    int plane = -1;  // of the edge that ended there
    int right = -1;  // of the edge that began there
};

class Wavefront {
  public:
    struct Start {
        ExactPlanes planes;                   // one an edge, then those of their later courses
        std::vector<int> profile;             // of each plane; what differs there is never one plane
        std::vector<std::vector<int>> loops;  // edges; an edge starts at its point
        std::vector<glm::dvec2> points;
        Ambiguity ambiguity = Ambiguity::LeastVolume;
    };
    explicit Wavefront(Start start);

    // As far as this height, events at it included. Returns false where something would have to go on for ever.
    void run_to(std::int64_t height);
    void run_out();
    // From here the segments of a plane belong to another one that coincides with it at this height.
    void change_planes(std::int64_t height, const std::vector<std::pair<int, int>>& changes);
    void truncate(std::int64_t height);

    bool is_alive() const { return alive_ > 0; }
    bool has_run_wild() const { return events_ > most_events_; }
    int representative(int plane) const;

    const ExactPlanes& planes() const { return planes_; }
    const std::vector<SkeletonArc>& arcs() const { return arcs_; }
    const std::vector<glm::dvec3>& nodes() const { return nodes_; }
    const std::vector<SharedPlaneCut>& cuts() const { return cuts_; }
    const std::vector<std::vector<int>>& tops() const { return tops_; }  // nodes

  private:
    struct Vertex {
        int left = -1, right = -1;  // planes of the segments that end and start here
        int prev = -1, next = -1;
        int node = -1;            // where it was born
        std::array<int, 2> at{};  // two lines through its birthplace that are not parallel
        Meeting born;
        bool is_alive = true;
        bool is_registered = false;
        double segment_end = 0;  // the segment that starts here vanishes by then
        double horizon = 0;      // up to where its splits were looked for
    };
    enum class Kind : std::uint8_t { Collapse, Split };
    struct Event {
        Meeting when;
        Kind kind = Kind::Collapse;
        int vertex = -1;  // collapse: the segment's start; split: who splits
        int other = -1;   // collapse: its end; split: the start of the segment that is split
        int plane = -1;
    };

    Vertex& vertex(int v) { return vertices_[static_cast<std::size_t>(v)]; }
    const Vertex& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }

    // wavefront_links.cpp
    void collapse(int start);
    void split(const Event& event);
    bool is_within_wedge(int splitter, int target) const;
    int add_vertex(int left, int right, int prev, int next, int node, std::array<int, 2> at);
    void settle(int v);
    bool finish_small_loop(int v);
    bool merge_shared_plane(int v);
    void resolve_same_direction(int v);
    void close_ridge(int v);
    bool absorb_neighbours(int v);
    void end_vertex(int v, int node);
    int add_node(std::array<int, 2> at);
    std::array<int, 2> whereabouts(int v) const;
    bool is_special(int v) const { return planes_.is_parallel(vertex(v).left, vertex(v).right); }

    // wavefront_events.cpp
    void run(const Meeting* until);
    bool is_later(const Event& a, const Event& b) const;
    bool is_split_possible(int v, int start, const Meeting& when) const;
    bool is_splitter(int v) const;
    void touch(int v);
    void refresh();
    void queue_collapse(int start);
    void settle_flat_corners(const std::vector<int>& born, const std::vector<glm::dvec2>& points);
    void next_slab();
    void look_around(double after);
    void look_for_splits(int v, double after);
    void look_for_splitters(int start);
    void try_split(int v, int start, double after);
    void push(const Event& event);
    Box path_box(int v, double until) const;
    Box segment_box(int start) const;
    bool has_path(int v) const;

    ExactPlanes planes_;
    std::vector<int> profile_;
    std::vector<int> group_;
    std::vector<Vertex> vertices_;
    std::vector<glm::dvec3> nodes_;
    std::vector<SkeletonArc> arcs_;
    std::vector<SharedPlaneCut> cuts_;
    std::vector<std::vector<int>> tops_;
    std::vector<Event> queue_;
    std::vector<int> touched_;
    NearbyBoxes near_segments_, near_splitters_;
    Ambiguity ambiguity_;
    Meeting now_ = ExactPlanes::at_height(0);
    Box domain_;
    double fastest_ = 0;
    double slab_end_ = 0, slab_height_ = 0;  // up to where meetings were looked for
    long events_at_slab_ = -1;
    std::vector<int> standing_;
    bool has_outward_ = false;
    int alive_ = 0;
    long events_ = 0;
    long most_events_ = 0;
    double highest_ = std::numeric_limits<double>::infinity();  // nothing lives longer, as far as is known
};

}  // namespace quadrat::mesh
