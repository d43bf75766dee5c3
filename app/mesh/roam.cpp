// SPDX-License-Identifier: Apache-2.0
// Duchaineau, Wolinsky, Sigeti, Miller, Aldrich & Mineev-Weinstein, "ROAMing terrain: real-time optimally adapting
// meshes" (1997). Ours has its queues in the order in which an eye that moves could first make a triangle's priority
// cross what is allowed (their section 6, "deferred priority recomputation"), and bounds that are nested boxes: the
// mesh is then the same however the eye came there.
#include "mesh/roam.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace quadrat::mesh {

Roam::Roam(const Field& height_m, float cell_m) : height_m_(height_m), cell_m_(cell_m) {
    assert(height_m.columns == height_m.rows && height_m.columns >= 2);
    make_roots();
}

// Squares as large as can be halved down to cells, two triangles each.
void Roam::make_roots() {
    const int cells = height_m_.columns - 1;
    int side = 1;
    while (cells % (2 * side) == 0) side *= 2;
    const int squares = cells / side;
    const auto first = [&](int column, int row) { return static_cast<std::uint32_t>(2 * (row * squares + column)); };
    for (int row = 0; row < squares; ++row) {
        for (int column = 0; column < squares; ++column) {
            const glm::ivec2 low{column * side, row * side};
            const glm::ivec2 high = low + side;
            Triangle north;
            north.corners = {low, {low.x, high.y}, {high.x, low.y}};
            north.base = first(column, row) + 1;
            north.left = column > 0 ? first(column - 1, row) + 1 : kNone;
            north.right = row > 0 ? first(column, row - 1) + 1 : kNone;
            Triangle south;
            south.corners = {high, {high.x, low.y}, {low.x, high.y}};
            south.base = first(column, row);
            south.left = column + 1 < squares ? first(column + 1, row) : kNone;
            south.right = row + 1 < squares ? first(column, row + 1) : kNone;
            for (Triangle* t : {&north, &south}) {
                t->bound = bound_of(t->corners);
                triangles_.push_back(*t);
            }
        }
    }
    roots_ = static_cast<std::uint32_t>(triangles_.size());
    leaves_ = roots_;
}

// kNone for a triangle whose base has no sample in its middle.
std::uint32_t Roam::bound_of(const Corners& c) {
    const glm::ivec2 sum = c.left + c.right;
    if (sum.x % 2 != 0 || sum.y % 2 != 0) return kNone;
    const glm::ivec2 middle = sum / 2;
    const auto at = static_cast<std::uint32_t>(bounds_.size());
    bounds_.emplace_back();
    const auto height = [&](glm::ivec2 p) { return height_m_.at(p.x, p.y); };
    Bound bound;
    bound.error_m = std::abs(height(middle) - 0.5F * (height(c.left) + height(c.right)));
    bound.low_m = std::min({height(c.apex), height(c.left), height(c.right), height(middle)});
    bound.high_m = std::max({height(c.apex), height(c.left), height(c.right), height(middle)});
    const std::uint32_t one = bound_of({middle, c.apex, c.left});
    const std::uint32_t other = bound_of({middle, c.right, c.apex});
    assert((one == kNone) == (other == kNone));
    float below_m = 0;
    for (const std::uint32_t child : {one, other}) {
        if (child == kNone) continue;
        below_m = std::max(below_m, bounds_[child].error_m);
        bound.low_m = std::min(bound.low_m, bounds_[child].low_m);
        bound.high_m = std::max(bound.high_m, bounds_[child].high_m);
    }
    bound.error_m += below_m;
    if (one != kNone) bound.children = static_cast<std::uint32_t>(links_.size());
    if (one != kNone) links_.push_back({one, other});
    bounds_[at] = bound;
    return at;
}

void Roam::box_of(const Triangle& t, glm::vec3& low_m, glm::vec3& high_m) const {
    const glm::ivec2 low = glm::min(t.corners.apex, glm::min(t.corners.left, t.corners.right));
    const glm::ivec2 high = glm::max(t.corners.apex, glm::max(t.corners.left, t.corners.right));
    const float middle = 0.5F * static_cast<float>(height_m_.columns - 1);
    const auto metres = [&](int sample) { return (static_cast<float>(sample) - middle) * cell_m_; };
    const Bound& bound = bounds_[t.bound];
    low_m = {metres(low.x), bound.low_m, metres(low.y)};
    high_m = {metres(high.x), bound.high_m, metres(high.y)};
}

float Roam::slack_m(std::uint32_t t) const {
    glm::vec3 low_m;
    glm::vec3 high_m;
    box_of(triangles_[t], low_m, high_m);
    const float distance_m = glm::length(eye_m_ - glm::clamp(eye_m_, low_m, high_m));
    return distance_m - bounds_[triangles_[t].bound].error_m / allowed_;
}

void Roam::push(std::vector<Due>& queue, double at_m, std::uint32_t t) {
    queue.push_back({at_m, t, triangles_[t].version});
    std::push_heap(queue.begin(), queue.end());
}

void Roam::look_at_leaf(std::uint32_t t) {
    if (triangles_[t].children != kNone || triangles_[t].bound == kNone) return;
    if (bounds_[triangles_[t].bound].error_m <= 0) return;  // flat
    const float slack = slack_m(t);
    if (slack < 0)
        rough_.push_back(t);  // not at once: that could split what is being split
    else
        push(splits_, due_m(slack), t);
}

// Two split triangles at one base whose four children are whole; at the rim one of two.
bool Roam::is_diamond(std::uint32_t t) const {
    const auto has_whole_children = [&](std::uint32_t v) {
        const std::uint32_t c = triangles_[v].children;
        return c != kNone && triangles_[c].children == kNone && triangles_[c + 1].children == kNone;
    };
    const std::uint32_t base = triangles_[t].base;
    return has_whole_children(t) && (base == kNone || has_whole_children(base));
}

// When the eye may have gone so far. Never now: what is looked at again at once, with as little left, would be for
// ever.
double Roam::due_m(float slack_m) const {
    return std::max(gone_m_ + 0.999 * static_cast<double>(slack_m),
                    std::nextafter(gone_m_, std::numeric_limits<double>::infinity()));
}

void Roam::push_diamond(std::uint32_t t) {
    if (t == kNone || !is_diamond(t)) return;
    const std::uint32_t one = std::min(t, triangles_[t].base);  // the same from both sides
    ++triangles_[one].version;                                  // and once only
    push(merges_, gone_m_, one);
}

void Roam::look_at_diamond(std::uint32_t t) {
    if (!is_diamond(t)) return;
    const std::uint32_t base = triangles_[t].base;
    const float slack = std::min(slack_m(t), base == kNone ? slack_m(t) : slack_m(base));
    if (slack >= 0)
        merge(t);
    else
        push(merges_, due_m(-slack), t);
}

void Roam::settle() {
    const auto take = [&](std::vector<Due>& queue, std::uint32_t& t) {
        while (!queue.empty() && queue.front().at_m <= gone_m_) {
            std::pop_heap(queue.begin(), queue.end());
            const Due due = queue.back();
            queue.pop_back();
            t = due.triangle;
            if (triangles_[t].version == due.version) return true;
        }
        return false;
    };
    std::uint32_t t = kNone;
    const auto split_rough = [&] {
        while (!rough_.empty()) {
            t = rough_.back();
            rough_.pop_back();
            split(t);
        }
    };
    split_rough();
    while (take(splits_, t)) {
        look_at_leaf(t);
        split_rough();
    }
    while (take(merges_, t)) look_at_diamond(t);
    assert(rough_.empty());  // nothing is merged that would have to be split
}

// What is allowed has changed: everything has to be looked at.
void Roam::restart() {
    splits_.clear();
    merges_.clear();
    std::vector<std::uint32_t> leaves;
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t t = 0; t < roots_; ++t) waiting.push_back(t);
    while (!waiting.empty()) {
        const std::uint32_t t = waiting.back();
        waiting.pop_back();
        if (triangles_[t].children == kNone) {
            leaves.push_back(t);
            continue;
        }
        push_diamond(t);
        waiting.push_back(triangles_[t].children);
        waiting.push_back(triangles_[t].children + 1);
    }
    for (const std::uint32_t t : leaves) look_at_leaf(t);
    settle();
}

void Roam::update(const Wish& wish) {
    constexpr float kStep = 1.25F;
    const float before = allowed_;
    gone_m_ += static_cast<double>(glm::length(wish.eye_m - eye_m_));
    eye_m_ = wish.eye_m;
    if (wished_px_ != wish.error_px || wish.triangle_budget == static_cast<std::size_t>(-1)) error_px_ = wish.error_px;
    wished_px_ = wish.error_px;
    allowed_ = error_px_ / wish.pixels_per_radian;
    if (allowed_ == before)
        settle();
    else
        restart();
    const auto change = [&](float factor) {
        error_px_ = std::max(wish.error_px, error_px_ * factor);
        allowed_ = error_px_ / wish.pixels_per_radian;
        restart();
    };
    // In steps, and back only with room to spare: the mesh does not swing.
    std::size_t seen = seen_of(wish);
    for (; error_px_ > wish.error_px && seen <= wish.triangle_budget / 2; seen = seen_of(wish)) change(1 / kStep);
    for (; seen > wish.triangle_budget && leaves_ > roots_ && error_px_ < 1e6F; seen = seen_of(wish)) change(kStep);
}

void Roam::split(std::uint32_t t) {
    if (triangles_[t].children != kNone) return;
    const std::uint32_t base = triangles_[t].base;
    if (base != kNone && triangles_[base].base != t) split(base);
    const std::uint32_t across = triangles_[t].base;
    split_alone(t);
    if (across != kNone) {
        split_alone(across);
        join_children(t, across);
    }
    for (const std::uint32_t v : {t, across}) {
        if (v == kNone) continue;
        const std::uint32_t children = triangles_[v].children;
        look_at_leaf(children);
        look_at_leaf(children + 1);
    }
    push_diamond(t);
}

void Roam::split_alone(std::uint32_t t) {
    std::uint32_t children;
    if (free_.empty()) {
        children = static_cast<std::uint32_t>(triangles_.size());
        triangles_.resize(triangles_.size() + 2);
    } else {
        children = free_.back();
        free_.pop_back();
    }
    Triangle& whole = triangles_[t];
    const Corners& c = whole.corners;
    const glm::ivec2 middle = (c.left + c.right) / 2;
    const std::uint32_t link = bounds_[whole.bound].children;
    const auto set = [&](std::uint32_t child, const Corners& corners, int which) {
        Triangle& half = triangles_[child];
        half.children = kNone;
        half.parent = t;
        half.base = half.left = half.right = kNone;
        half.bound = link == kNone ? kNone : links_[link][static_cast<std::size_t>(which)];
        half.corners = corners;
        ++half.version;
    };
    set(children, {middle, c.apex, c.left}, 0);
    set(children + 1, {middle, c.right, c.apex}, 1);
    triangles_[children].base = whole.left;
    triangles_[children].left = children + 1;
    triangles_[children + 1].base = whole.right;
    triangles_[children + 1].right = children;
    relink(whole.left, t, children);
    relink(whole.right, t, children + 1);
    whole.children = children;
    ++whole.version;
    ++leaves_;
}

void Roam::join_children(std::uint32_t t, std::uint32_t across) {
    const std::uint32_t own = triangles_[t].children;
    const std::uint32_t other = triangles_[across].children;
    triangles_[own].right = other + 1;
    triangles_[other + 1].left = own;
    triangles_[own + 1].left = other;
    triangles_[other].right = own + 1;
}

void Roam::merge(std::uint32_t t) {
    const std::uint32_t across = triangles_[t].base;
    merge_alone(t);
    if (across != kNone) merge_alone(across);
    for (const std::uint32_t v : {t, across}) {
        if (v == kNone) continue;
        look_at_leaf(v);
        push_diamond(triangles_[v].parent);
    }
}

void Roam::merge_alone(std::uint32_t t) {
    Triangle& whole = triangles_[t];
    const std::uint32_t children = whole.children;
    whole.left = triangles_[children].base;
    whole.right = triangles_[children + 1].base;
    relink(whole.left, children, t);
    relink(whole.right, children + 1, t);
    whole.children = kNone;
    ++whole.version;
    ++triangles_[children].version;
    ++triangles_[children + 1].version;
    free_.push_back(children);
    --leaves_;
}

void Roam::relink(std::uint32_t neighbour, std::uint32_t from, std::uint32_t to) {
    if (neighbour == kNone) return;
    Triangle& n = triangles_[neighbour];
    for (std::uint32_t* side : {&n.base, &n.left, &n.right})
        if (*side == from) *side = to;
}

// Of the planes named by bits, those that still cut the triangle; false where it lies behind one.
bool Roam::may_be_seen(const Triangle& triangle, std::span<const glm::vec4> planes, std::uint32_t& cutting) const {
    glm::vec3 low_m;
    glm::vec3 high_m;
    box_of(triangle, low_m, high_m);
    const glm::vec3 middle = 0.5F * (low_m + high_m);
    const glm::vec3 half = high_m - middle;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if ((cutting >> i & 1U) == 0) continue;
        const glm::vec3 normal{planes[i]};
        const float at = glm::dot(normal, middle) + planes[i].w;
        const float reach = glm::dot(glm::abs(normal), half);
        if (at < -reach) return false;
        if (at >= reach) cutting &= ~(1U << i);
    }
    return true;
}

// What a walk over the triangles looks with: the eye on the map, in samples.
struct Roam::Sight {
    std::span<const glm::vec4> planes;
    glm::vec2 eye;

    std::uint32_t is_toward(glm::ivec2 way, glm::ivec2 from) const {
        return glm::dot(eye - glm::vec2(from), glm::vec2(way)) > 0 ? 1 : 0;
    }
};

template <typename Visit>
void Roam::visit_seen(std::uint32_t t, const Sight& sight, std::uint32_t cutting, const Visit& visit) const {
    const Triangle& triangle = triangles_[t];
    if (cutting != 0 && triangle.bound != kNone && !may_be_seen(triangle, sight.planes, cutting)) return;
    const Corners& c = triangle.corners;
    if (triangle.children == kNone) {
        visit(c);
        return;
    }
    // The halves meet in a line from the apex across the base.
    const std::uint32_t nearer = triangle.children + sight.is_toward(c.right - c.left, c.apex);
    const std::uint32_t other = 2 * triangle.children + 1 - nearer;
    visit_seen(nearer, sight, cutting, visit);
    visit_seen(other, sight, cutting, visit);
}

template <typename Visit>
void Roam::visit_seen(std::span<const glm::vec4> planes, const Visit& visit) const {
    assert(planes.size() < 32);
    const std::uint32_t cutting = (1U << planes.size()) - 1;
    const float middle = 0.5F * static_cast<float>(height_m_.columns - 1);
    const Sight sight{planes, glm::vec2{eye_m_.x, eye_m_.z} / cell_m_ + middle};
    for (std::uint32_t square = 0; square < roots_; square += 2) {
        const Corners& c = triangles_[square].corners;
        const std::uint32_t south_first = sight.is_toward(c.left + c.right - 2 * c.apex, c.left);
        visit_seen(square + south_first, sight, cutting, visit);
        visit_seen(square + 1 - south_first, sight, cutting, visit);
    }
}

// What counts against the budget; where all of them are few, all of them.
std::size_t Roam::seen_of(const Wish& wish) const {
    if (wish.planes.empty() || leaves_ <= wish.triangle_budget / 2) return leaves_;
    std::size_t seen = 0;
    visit_seen(wish.planes, [&](const Corners&) { ++seen; });
    return seen;
}

std::size_t Roam::append_indices(std::span<const glm::vec4> planes, std::vector<std::uint32_t>& indices) const {
    const std::size_t before = indices.size();
    visit_seen(planes, [&](const Corners& c) {
        indices.insert(indices.end(), {index_of(c.apex), index_of(c.left), index_of(c.right)});
    });
    return (indices.size() - before) / 3;
}

glm::vec3 Roam::place_m(std::uint32_t index) const {
    const auto columns = static_cast<std::uint32_t>(height_m_.columns);
    const float middle = 0.5F * static_cast<float>(columns - 1);
    return {(static_cast<float>(index % columns) - middle) * cell_m_, height_m_.samples[index],
            (static_cast<float>(index / columns) - middle) * cell_m_};
}

}  // namespace quadrat::mesh
