// SPDX-License-Identifier: Apache-2.0
// What an event does to the loops of vertices. Events of one height come one after the other; what has no length then
// is gone before the next (the paper's chains within one point), a vertex that meets a vertex is linked to its other
// side at once (its chains between), and ridges that lie level run to their nearer end.
#include <algorithm>

#include "mesh/wavefront.hpp"

namespace quadrat::mesh {

int Wavefront::representative(int plane) const {
    while (group_[static_cast<std::size_t>(plane)] != plane) plane = group_[static_cast<std::size_t>(plane)];
    return plane;
}

int Wavefront::add_vertex(int left, int right, int prev, int next, int node, std::array<int, 2> at) {
    Vertex made;
    made.left = left;
    made.right = right;
    made.prev = prev;
    made.next = next;
    made.node = node;
    made.at = at;
    made.born = now_;
    made.segment_end = std::numeric_limits<double>::infinity();
    const auto v = static_cast<int>(vertices_.size());
    vertices_.push_back(made);
    if (prev >= 0 && prev < v) vertex(prev).next = v;
    if (next >= 0 && next < v) vertex(next).prev = v;
    ++alive_;
    return v;
}

void Wavefront::end_vertex(int v, int node) {
    arcs_.push_back({vertex(v).node, node, vertex(v).left, vertex(v).right});
    vertex(v).is_alive = false;
    --alive_;
}

std::array<int, 2> Wavefront::whereabouts(int v) const {
    if (is_special(v)) return vertex(v).at;
    return {vertex(v).left, vertex(v).right};
}

int Wavefront::add_node(std::array<int, 2> at) {
    nodes_.emplace_back(planes_.point(at[0], at[1], now_.height), now_.height);
    return static_cast<int>(nodes_.size()) - 1;
}

void Wavefront::collapse(int start) {
    const Vertex u = vertex(start);
    const Vertex v = vertex(u.next);
    const std::array<int, 2> at = is_special(start) ? whereabouts(u.next) : whereabouts(start);
    const int node = add_node(at);
    const auto is_of = [&](int plane) { return plane == u.left || plane == u.right || plane == v.right; };
    if (now_.i >= 0 && is_of(now_.i) && is_of(now_.j) && is_of(now_.k)) nodes_.back() = planes_.point(now_);
    end_vertex(start, node);
    end_vertex(u.next, node);
    settle(add_vertex(u.left, v.right, u.prev, v.next, node, at));
}

// Lies what is between the splitter's two segments within the angle that the target leaves open for it?
bool Wavefront::is_within_wedge(int splitter, int target) const {
    const Vertex& v = vertex(splitter);
    const Vertex& q = vertex(target);
    struct Ray {
        int plane;
        int sign;
    };
    const auto turn = [this](Ray a, Ray b) { return a.sign * b.sign * planes_.turn(a.plane, b.plane); };
    const auto is_between = [&](Ray x, Ray from, Ray to) {
        const int span = turn(from, to);
        if (span > 0) return turn(from, x) >= 0 && turn(x, to) >= 0;
        if (span < 0) return !(turn(to, x) > 0 && turn(x, from) > 0);
        return turn(from, x) >= 0;
    };
    const bool is_from_inside = planes_.turn(v.left, v.right) < 0;
    const Ray open = is_from_inside ? Ray{q.right, 1} : Ray{q.left, -1};
    const Ray shut = is_from_inside ? Ray{q.left, -1} : Ray{q.right, 1};
    return is_between({v.left, -1}, open, shut) && is_between({v.right, 1}, open, shut);
}

void Wavefront::split(const Event& event) {
    const int splitter = event.vertex;
    const Vertex v = vertex(splitter);
    const int p = event.other;
    const int q = vertex(p).next;
    const std::array<int, 2> at{v.left, v.right};
    const bool is_at_q = planes_.side(at[0], at[1], vertex(q).right, now_) == 0;
    const bool is_at_p = planes_.side(at[0], at[1], vertex(p).left, now_) == 0;
    if (is_at_q && is_at_p) return;
    if (is_at_q && (vertex(q).next == splitter || !is_within_wedge(splitter, q))) return;
    if (is_at_p && (vertex(p).prev == splitter || !is_within_wedge(splitter, p))) return;
    nodes_.push_back(planes_.point(now_));
    const auto node = static_cast<int>(nodes_.size()) - 1;
    const Vertex start = vertex(p);
    const Vertex end = vertex(q);
    end_vertex(splitter, node);
    if (is_at_q) end_vertex(q, node);
    if (is_at_p) end_vertex(p, node);
    const int first = is_at_q ? add_vertex(v.left, end.right, v.prev, end.next, node, at)
                              : add_vertex(v.left, event.plane, v.prev, q, node, {v.left, event.plane});
    const int second = is_at_p ? add_vertex(start.left, v.right, start.prev, v.next, node, at)
                               : add_vertex(event.plane, v.right, p, v.next, node, {event.plane, v.right});
    if (planes_.is_parallel(v.left, event.plane)) vertex(first).at = at;
    if (planes_.is_parallel(event.plane, v.right)) vertex(second).at = at;
    settle(first);
    if (vertex(second).is_alive) settle(second);
}

void Wavefront::settle(int v) {
    if (finish_small_loop(v)) return;
    if (is_special(v)) {
        const bool has_one_direction = planes_.has_direction_of(vertex(v).left, vertex(v).right);
        if (!has_one_direction) {
            close_ridge(v);
        } else if (!merge_shared_plane(v)) {
            resolve_same_direction(v);
        }
        return;
    }
    if (!absorb_neighbours(v)) touch(v);
}

bool Wavefront::finish_small_loop(int v) {
    const int other = vertex(v).next;
    if (vertex(other).next != v) return false;
    if (other == v) {
        end_vertex(v, vertex(v).node);
        return true;
    }
    if (is_special(v)) {  // a level ridge between the two
        end_vertex(v, vertex(other).node);
        vertex(other).is_alive = false;
        --alive_;
        return true;
    }
    const int node = add_node(whereabouts(v));
    end_vertex(v, node);
    end_vertex(other, node);
    return true;
}

// Two edges of one line and one profile: from now on they are one segment. The faces are cut apart afterwards.
bool Wavefront::merge_shared_plane(int v) {
    const Vertex at = vertex(v);
    if (!planes_.is_same(at.left, at.right) ||
        profile_[static_cast<std::size_t>(at.left)] != profile_[static_cast<std::size_t>(at.right)])
        return false;
    const int left = representative(at.left);
    const int right = representative(at.right);
    group_[static_cast<std::size_t>(std::max(left, right))] = std::min(left, right);
    cuts_.push_back({at.node, at.left, at.right});
    vertex(v).is_alive = false;
    --alive_;
    vertex(at.prev).next = at.next;
    vertex(at.next).prev = at.prev;
    vertex(at.next).left = at.left;
    if (finish_small_loop(at.prev)) return true;
    touch(at.prev);
    touch(at.next);
    return true;
}

// One plane gives way to the other along all of its segment.
void Wavefront::resolve_same_direction(int v) {
    const Vertex at = vertex(v);
    const double left = planes_[at.left].speed_d;
    const double right = planes_[at.right].speed_d;
    bool left_goes_on = ambiguity_ == Ambiguity::LeastVolume ? left > right : left < right;
    if (left == right) left_goes_on = at.left < at.right;
    const int target = left_goes_on ? at.next : at.prev;
    const Vertex end = vertex(target);
    const std::array<int, 2> where = whereabouts(target);
    const int node = add_node(where);
    end_vertex(v, node);
    end_vertex(target, node);
    settle(left_goes_on ? add_vertex(at.left, end.right, at.prev, end.next, node, where)
                        : add_vertex(end.left, at.right, end.prev, at.next, node, where));
}

// Two opposite lines are one now: the ridge between them lies level, as far as the nearer of their other ends.
void Wavefront::close_ridge(int v) {
    const Vertex at = vertex(v);
    const Vertex u = vertex(at.prev);
    const Vertex w = vertex(at.next);
    const std::array<int, 2> at_u = whereabouts(at.prev);
    const std::array<int, 2> at_w = whereabouts(at.next);
    const int across = planes_.is_parallel(at_w[0], at.right) ? at_w[1] : at_w[0];
    const int ahead = planes_.side(at_u[0], at_u[1], across, now_) * planes_.turn(at.right, across);
    const bool takes_u = ahead >= 0;
    const bool takes_w = ahead < 0 || (ahead == 0 && u.prev != at.next);
    const std::array<int, 2> where = takes_u ? at_u : at_w;
    const int node = add_node(where);
    end_vertex(v, node);
    if (takes_u) end_vertex(at.prev, node);
    if (takes_w) end_vertex(at.next, node);
    settle(add_vertex(takes_u ? u.left : at.left, takes_w ? w.right : at.right, takes_u ? u.prev : at.prev,
                      takes_w ? w.next : at.next, node, where));
}

bool Wavefront::absorb_neighbours(int v) {
    const int prev = vertex(v).prev;
    const int next = vertex(v).next;
    if (planes_.is_same_point(whereabouts(v), whereabouts(prev), now_)) {
        collapse(prev);
        return true;
    }
    if (planes_.is_same_point(whereabouts(v), whereabouts(next), now_)) {
        collapse(v);
        return true;
    }
    return false;
}

void Wavefront::change_planes(std::int64_t height, const std::vector<std::pair<int, int>>& changes) {
    now_ = ExactPlanes::at_height(height);
    std::vector<int> becomes(planes_.size(), -1);
    for (const auto& [from, to] : changes) becomes[static_cast<std::size_t>(from)] = to;
    standing_.clear();
    const auto next_of = [&becomes](int plane) { return becomes[static_cast<std::size_t>(plane)]; };
    queue_.clear();
    const auto count = static_cast<int>(vertices_.size());
    std::vector<int> before(vertices_.size(), -1);  // the plane of the segment that starts there
    for (int v = 0; v < count; ++v) {
        Vertex& at = vertex(v);
        if (!at.is_alive) continue;
        before[static_cast<std::size_t>(v)] = at.right;
        at.is_registered = false;
        touch(v);
        standing_.push_back(v);
        const int left = next_of(at.left);
        const int right = next_of(at.right);
        if (left < 0 && right < 0) continue;
        const int node = add_node({at.left, at.right});
        arcs_.push_back({at.node, node, at.left, at.right});
        at.node = node;
        at.left = left < 0 ? at.left : left;
        at.right = right < 0 ? at.right : right;
    }
    for (int v = 0; v < count; ++v) {
        const int old = before[static_cast<std::size_t>(v)];
        if (old >= 0 && next_of(old) >= 0)
            arcs_.push_back({vertex(v).node, vertex(vertex(v).next).node, next_of(old), old});
    }
    near_segments_ = NearbyBoxes(domain_, standing_.size());
    near_splitters_ = NearbyBoxes(domain_, standing_.size());
    refresh();
}

void Wavefront::truncate(std::int64_t height) {
    now_ = ExactPlanes::at_height(height);
    const auto count = static_cast<int>(vertices_.size());
    for (int first = 0; first < count; ++first) {
        if (!vertex(first).is_alive) continue;
        std::vector<int> loop;
        std::vector<int> planes;
        for (int v = first; vertex(v).is_alive; v = vertex(v).next) {
            loop.push_back(add_node(whereabouts(v)));
            planes.push_back(vertex(v).right);
            end_vertex(v, loop.back());
        }
        for (std::size_t i = 0; i < loop.size(); ++i)
            arcs_.push_back({loop[(i + 1) % loop.size()], loop[i], planes[i], -1});
        tops_.push_back(std::move(loop));
    }
}

}  // namespace quadrat::mesh
