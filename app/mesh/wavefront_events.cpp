// SPDX-License-Identifier: Apache-2.0
// In which order segments vanish and reflex vertices split others. Every possible split is queued that lies on a
// vertex's present path and between a segment's present ends; when a segment gets another end it is looked at anew.
// What may meet is found by boxes round what vertices and segments sweep within a slab of heights, then within the
// next; a slab is as high as the wavefront is coarse, so that each holds a steady share of all events.
#include <algorithm>
#include <cmath>

#include "mesh/wavefront.hpp"

namespace quadrat::mesh {
namespace {
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSlab = 0.5;  // of the spacing of vertices
constexpr double kBeyondAll = 1.0e9;
constexpr double kSharpest = 1.0e-6;  // a path between lines that are nearly parallel is not boxed
}  // namespace

Wavefront::Wavefront(Start start)
    : planes_(std::move(start.planes)), profile_(std::move(start.profile)), ambiguity_(start.ambiguity) {
    const std::vector<glm::dvec2>& points = start.points;
    for (const glm::dvec2& p : points) domain_.include(p);
    double slowest = kNever;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        const double speed = planes_[static_cast<int>(i)].speed_d;
        has_outward_ = has_outward_ || speed < 0;
        slowest = std::min(slowest, speed);
        fastest_ = std::max(fastest_, std::abs(speed));
    }
    const glm::dvec2 size = domain_.high - domain_.low;
    if (slowest > 0) highest_ = 0.51 * std::min(size.x, size.y) / slowest;
    for (std::size_t i = 0; i < planes_.size(); ++i) group_.push_back(static_cast<int>(i));
    most_events_ = 1000 + 60 * static_cast<long>(points.size());
    vertices_.reserve(4 * points.size());
    std::vector<int> born;
    for (const std::vector<int>& loop : start.loops) {
        const auto first = static_cast<int>(vertices_.size());
        const auto count = static_cast<int>(loop.size());
        for (int i = 0; i < count; ++i) {
            const int before = loop[static_cast<std::size_t>((i + count - 1) % count)];
            const int edge = loop[static_cast<std::size_t>(i)];
            nodes_.emplace_back(points[static_cast<std::size_t>(edge)], 0.0);
            born.push_back(add_vertex(before, edge, first + (i + count - 1) % count, first + (i + 1) % count,
                                      static_cast<int>(nodes_.size()) - 1, {before, edge}));
        }
    }
    for (const int v : born) arcs_.push_back({vertex(v).node, vertex(vertex(v).next).node, vertex(v).right, -1});
    settle_flat_corners(born, points);
    touched_.clear();
    for (int v = 0; v < static_cast<int>(vertices_.size()); ++v)
        if (vertex(v).is_alive) queue_collapse(v);
    next_slab();
}

// Points of the plan between edges of one line: no corner, and not to be placed by these lines.
void Wavefront::settle_flat_corners(const std::vector<int>& born, const std::vector<glm::dvec2>& points) {
    std::vector<int> flat;
    for (const int v : born) {
        if (!is_special(v)) continue;
        flat.push_back(v);
        const MovingLine along = planes_[vertex(v).right];
        const glm::dvec2 p = points[static_cast<std::size_t>(vertex(v).right)];
        const double offset = (along.ny_d * p.x - along.nx_d * p.y) / kOffsetUnit;
        vertex(v).at[1] = planes_.add(moving_line(along.ny, -along.nx, std::llround(offset), 0));
        profile_.push_back(-1);
        group_.push_back(vertex(v).at[1]);
    }
    for (const int v : flat) merge_shared_plane(v);
    for (const int v : flat)
        if (vertex(v).is_alive) settle(v);
}

// What sweeps through the slab above the last.
void Wavefront::next_slab() {
    const double before = slab_end_;
    const glm::dvec2 size = domain_.high - domain_.low;
    const double spacing = std::sqrt(size.x * size.y / std::max(alive_, 1));
    slab_height_ = events_ == events_at_slab_ ? 2 * slab_height_ : 0;
    slab_height_ = std::max(slab_height_, kSlab * spacing / std::max(fastest_, 1.0e-3));
    events_at_slab_ = events_;
    slab_end_ = std::max(slab_end_, now_.height) + slab_height_;
    standing_.clear();
    for (int v = 0; v < static_cast<int>(vertices_.size()); ++v)
        if (vertex(v).is_alive) standing_.push_back(v);
    look_around(before);
}

void Wavefront::look_around(double after) {
    near_segments_ = NearbyBoxes(domain_, standing_.size());
    near_splitters_ = NearbyBoxes(domain_, standing_.size());
    for (const int v : standing_) near_segments_.enter(v, segment_box(v));
    for (const int v : standing_) {
        vertex(v).is_registered = false;
        look_for_splits(v, after);
    }
}

bool Wavefront::is_later(const Event& a, const Event& b) const {
    const int order = planes_.compare(a.when, b.when);
    if (order != 0) return order > 0;
    if (a.kind != b.kind) return a.kind > b.kind;
    if (a.vertex != b.vertex) return a.vertex > b.vertex;
    return a.other > b.other;
}

void Wavefront::push(const Event& event) {
    queue_.push_back(event);
    std::push_heap(queue_.begin(), queue_.end(), [this](const Event& a, const Event& b) { return is_later(a, b); });
}

void Wavefront::run_to(std::int64_t height) {
    const Meeting until = ExactPlanes::at_height(height);
    run(&until);
}

void Wavefront::run_out() { run(nullptr); }

void Wavefront::run(const Meeting* until) {
    while (alive_ > 0 && !has_run_wild()) {
        if (queue_.empty() || queue_.front().when.height - queue_.front().when.error > slab_end_) {
            if (until != nullptr ? slab_end_ > until->height : slab_end_ > std::min(highest_, kBeyondAll)) break;
            next_slab();
            continue;
        }
        if (until != nullptr && planes_.compare(queue_.front().when, *until) > 0) break;
        std::pop_heap(queue_.begin(), queue_.end(), [this](const Event& a, const Event& b) { return is_later(a, b); });
        const Event event = queue_.back();
        queue_.pop_back();
        if (!vertex(event.vertex).is_alive || !vertex(event.other).is_alive) continue;
        if (event.kind == Kind::Collapse) {
            if (vertex(event.vertex).next != event.other) continue;
            now_ = event.when;
            collapse(event.vertex);
        } else {
            if (vertex(event.other).right != event.plane || !is_split_possible(event.vertex, event.other, event.when))
                continue;
            now_ = event.when;
            split(event);
        }
        ++events_;
        refresh();
    }
}

bool Wavefront::is_splitter(int v) const {
    const int turn = planes_.turn(vertex(v).left, vertex(v).right);
    return turn < 0 || (turn > 0 && has_outward_);
}

bool Wavefront::has_path(int v) const {
    const MovingLine& a = planes_[vertex(v).left];
    const MovingLine& b = planes_[vertex(v).right];
    return std::abs(a.nx_d * b.ny_d - a.ny_d * b.nx_d) > kSharpest;
}

Box Wavefront::path_box(int v, double until) const {
    Box box;
    if (!has_path(v)) {
        box.low = glm::dvec2(-1.0e200);
        box.high = glm::dvec2(1.0e200);
        return box;
    }
    box.include(planes_.point(vertex(v).left, vertex(v).right, now_.height));
    box.include(planes_.point(vertex(v).left, vertex(v).right, until));
    box.grow(1.0e-6);
    return box;
}

Box Wavefront::segment_box(int start) const {
    const double until = std::min(vertex(start).segment_end, slab_end_);
    Box box = path_box(start, until);
    const Box other = path_box(vertex(start).next, until);
    box.include(other.low);
    box.include(other.high);
    return box;
}

void Wavefront::touch(int v) { touched_.push_back(v); }

// What an event changed: the segments beside the vertices it made, their ends, and how far paths are looked along.
void Wavefront::refresh() {
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    std::erase_if(touched_, [this](int v) { return !vertex(v).is_alive; });
    std::vector<int> segments;
    for (const int v : touched_) {
        segments.push_back(v);
        segments.push_back(vertex(v).prev);
    }
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    for (const int start : segments) queue_collapse(start);
    for (const int start : segments) near_segments_.enter(start, segment_box(start));
    std::vector<int> ends = touched_;
    for (const int v : touched_) {
        ends.push_back(vertex(v).prev);
        ends.push_back(vertex(v).next);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (const int v : ends) look_for_splits(v, -kNever);
    for (const int start : segments) look_for_splitters(start);
    touched_.clear();
}

// The segment's length is -T(h) / (turn at its start × turn at its end).
void Wavefront::queue_collapse(int start) {
    Vertex& u = vertex(start);
    const Vertex& v = vertex(u.next);
    u.segment_end = kNever;
    const Meeting m = planes_.meeting(u.left, u.right, v.right);
    if (m.speed_sign == 0) return;
    if (m.speed_sign * planes_.turn(u.left, u.right) * planes_.turn(v.left, v.right) < 0) return;
    if (planes_.compare(m, now_) < 0) return;
    u.segment_end = m.height + m.error;
    push({m, Kind::Collapse, start, u.next, u.right});
}

void Wavefront::look_for_splits(int v, double after) {
    if (!is_splitter(v)) return;
    Vertex& at = vertex(v);
    const double horizon = std::min({at.segment_end, vertex(at.prev).segment_end, slab_end_});
    if (at.is_registered && horizon <= at.horizon) {
        at.horizon = std::min(at.horizon, horizon);
        return;
    }
    const double looked_to = at.is_registered ? at.horizon : after;
    at.horizon = horizon;
    at.is_registered = true;
    const Box box = path_box(v, horizon);
    near_splitters_.enter(v, box);
    near_segments_.each(box, [this, v, looked_to](int start) {
        if (!vertex(start).is_alive) return false;
        try_split(v, start, looked_to);
        return true;
    });
}

void Wavefront::look_for_splitters(int start) {
    near_splitters_.each(segment_box(start), [this, start](int v) {
        if (!vertex(v).is_alive) return false;
        try_split(v, start, -kNever);
        return true;
    });
}

void Wavefront::try_split(int v, int start, double after) {
    const Vertex& at = vertex(v);
    const Vertex& p = vertex(start);
    if (start == v || p.next == v || p.right == at.left || p.right == at.right) return;
    const Meeting m = planes_.meeting(at.left, at.right, p.right);
    if (m.speed_sign >= 0 || m.height + m.error < after) return;
    if (m.height - m.error > std::min(at.horizon, p.segment_end)) return;
    if (m.height + m.error < now_.height - now_.error || planes_.compare(m, now_) < 0) return;
    // What parts at a point still touches there: that is no new meeting from outside.
    if (has_outward_ && planes_.turn(at.left, at.right) > 0 && planes_.compare(m, at.born) <= 0) return;
    if (is_split_possible(v, start, m)) push({m, Kind::Split, v, start, p.right});
}

// Is the point where the vertex meets the segment's line between the segment's ends then?
bool Wavefront::is_split_possible(int v, int start, const Meeting& when) const {
    const Vertex& at = vertex(v);
    const Vertex& p = vertex(start);
    const Vertex& q = vertex(p.next);
    if (start == v || p.next == v) return false;
    const int e = p.right;
    return planes_.side(at.left, at.right, q.right, when) * planes_.turn(e, q.right) >= 0 &&
           planes_.side(at.left, at.right, p.left, when) * planes_.turn(p.left, e) >= 0;
}

}  // namespace quadrat::mesh
