// SPDX-License-Identifier: Apache-2.0
// Hidden surface removal using polygon area sorting (Weiler & Atherton 1977): walk one outline where it runs inside the
// other, and change over where they cross. Points in general position only, which callers have by chance.
#include "mesh/clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadrat::mesh {
namespace {

using Loop = std::vector<glm::dvec2>;
using Loops = std::vector<Loop>;

constexpr double kSure = 1.0e-12;  // of an orientation, to the product of its sides

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// On which side of the line from a to b: -1 right, 1 left, 0 one cannot tell.
int side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
    const double turn = cross(b - a, p - a);
    const double size = std::abs(b.x - a.x) * std::abs(p.y - a.y) + std::abs(b.y - a.y) * std::abs(p.x - a.x);
    if (std::abs(turn) <= kSure * size) return 0;
    return turn > 0 ? 1 : -1;
}

struct Node {
    glm::dvec2 at{0};
    double along = 0;      // its edge
    std::size_t twin = 0;  // the same crossing on the other shape
    bool is_crossing = false;
    bool enters = false;  // going on, this shape is inside the other one
    bool is_walked = false;
};

// A shape's loops, with the places where the other one crosses them.
class Walk {
  public:
    explicit Walk(const Loops& loops) : loops_(loops) {
        for (const Loop& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i) edges_.push_back({loop[i], loop[(i + 1) % loop.size()], {}});
    }

    struct Edge {
        glm::dvec2 from, to;
        std::vector<std::size_t> crossings;  // nodes
    };
    std::vector<Edge>& edges() { return edges_; }
    std::vector<Node>& nodes() { return nodes_; }

    // After all crossings are there: every loop as a chain of nodes.
    void link() {
        std::size_t edge = 0;
        for (const Loop& loop : loops_) {
            std::vector<std::size_t> chain;
            bool is_crossed = false;
            for (std::size_t i = 0; i < loop.size(); ++i, ++edge) {
                Node corner;
                corner.at = loop[i];
                nodes_.push_back(corner);
                chain.push_back(nodes_.size() - 1);
                std::vector<std::size_t>& crossings = edges_[edge].crossings;
                std::sort(crossings.begin(), crossings.end(),
                          [this](std::size_t a, std::size_t b) { return nodes_[a].along < nodes_[b].along; });
                chain.insert(chain.end(), crossings.begin(), crossings.end());
                is_crossed = is_crossed || !crossings.empty();
            }
            next_.resize(nodes_.size());
            for (std::size_t i = 0; i < chain.size(); ++i) next_[chain[i]] = chain[(i + 1) % chain.size()];
            if (!is_crossed) uncrossed_.push_back(loop);
        }
    }
    std::size_t next(std::size_t node) const { return next_[node]; }
    const Loops& uncrossed() const { return uncrossed_; }

  private:
    const Loops& loops_;
    std::vector<Edge> edges_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> next_;
    Loops uncrossed_;
};

// False where it cannot be told whether they cross.
bool cross_edges(Walk& a, Walk& b) {
    for (Walk::Edge& e : a.edges())
        for (Walk::Edge& f : b.edges()) {
            if (std::max(e.from.x, e.to.x) < std::min(f.from.x, f.to.x) ||
                std::max(f.from.x, f.to.x) < std::min(e.from.x, e.to.x) ||
                std::max(e.from.y, e.to.y) < std::min(f.from.y, f.to.y) ||
                std::max(f.from.y, f.to.y) < std::min(e.from.y, e.to.y))
                continue;
            const int from_e = side_of(f.from, f.to, e.from);
            const int to_e = side_of(f.from, f.to, e.to);
            const int from_f = side_of(e.from, e.to, f.from);
            const int to_f = side_of(e.from, e.to, f.to);
            if (from_e * to_e > 0 || from_f * to_f > 0) continue;
            if (from_e * to_e == 0 || from_f * to_f == 0) return false;
            const double turn = cross(e.to - e.from, f.to - f.from);
            const double along_e = cross(f.from - e.from, f.to - f.from) / turn;
            const double along_f = cross(f.from - e.from, e.to - e.from) / turn;
            const glm::dvec2 at = e.from + along_e * (e.to - e.from);
            a.nodes().push_back({at, along_e, b.nodes().size(), true, to_e > 0, false});
            b.nodes().push_back({at, along_f, a.nodes().size() - 1, true, to_e < 0, false});
            e.crossings.push_back(a.nodes().size() - 1);
            f.crossings.push_back(b.nodes().size() - 1);
        }
    return true;
}

std::optional<Loops> walked(Walk& a, Walk& b) {
    Loops found;
    const std::size_t most = a.nodes().size() + b.nodes().size();
    for (std::size_t first = 0; first < a.nodes().size(); ++first) {
        const Node& start = a.nodes()[first];
        if (!start.is_crossing || !start.enters || start.is_walked) continue;
        Loop loop;
        Walk* on = &a;
        std::size_t at = first;
        do {
            Node& node = on->nodes()[at];
            if (loop.size() > most || node.is_walked) return std::nullopt;
            node.is_walked = true;
            loop.push_back(node.at);
            at = on->next(at);
            while (!on->nodes()[at].is_crossing) {
                loop.push_back(on->nodes()[at].at);
                if (loop.size() > most) return std::nullopt;
                at = on->next(at);
            }
            if (on->nodes()[at].enters) return std::nullopt;
            at = on->nodes()[at].twin;
            on = on == &a ? &b : &a;
        } while (on != &a || at != first);
        found.push_back(std::move(loop));
    }
    return found;
}

}  // namespace

double signed_area(const Loop& loop) {
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) area += cross(loop[i], loop[(i + 1) % loop.size()]);
    return 0.5 * area;
}

bool is_inside(const Loops& loops, glm::dvec2 at) {
    bool is_in = false;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 p = loop[i];
            const glm::dvec2 q = loop[(i + 1) % loop.size()];
            if ((p.y > at.y) != (q.y > at.y) && at.x < p.x + (q.x - p.x) * (at.y - p.y) / (q.y - p.y)) is_in = !is_in;
        }
    return is_in;
}

std::optional<Loops> common_area(const Loops& a, const Loops& b) {
    Walk on_a(a);
    Walk on_b(b);
    if (!cross_edges(on_a, on_b)) return std::nullopt;
    on_a.link();
    on_b.link();
    std::optional<Loops> found = walked(on_a, on_b);
    if (!found) return std::nullopt;
    for (const Loop& loop : on_a.uncrossed())
        if (is_inside(b, loop.front())) found->push_back(loop);
    for (const Loop& loop : on_b.uncrossed())
        if (is_inside(a, loop.front())) found->push_back(loop);
    return found;
}

std::vector<Loops> sorted_into_shapes(const Loops& loops) {
    std::vector<Loops> shapes;
    for (const Loop& loop : loops)
        if (signed_area(loop) > 0) shapes.push_back({loop});
    for (const Loop& loop : loops) {
        if (signed_area(loop) > 0) continue;
        for (Loops& shape : shapes)
            if (is_inside({shape.front()}, loop.front())) {
                shape.push_back(loop);
                break;
            }
    }
    return shapes;
}

}  // namespace quadrat::mesh
