// SPDX-License-Identifier: Apache-2.0
#include "mesh/shared_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

namespace quadrat::mesh {
namespace {

using Node = std::uint32_t;
using Loop = std::vector<Node>;

constexpr double kOnLine = 1.0e-7;  // of the extent

template <typename Visit>
void for_loops(Roof& roof, const Visit& visit) {
    for (RoofFace& face : roof.faces) {
        visit(face.outline);
        for (Loop& hole : face.holes) visit(hole);
    }
    for (Loop& top : roof.tops) visit(top);
}

class Sharing {
  public:
    explicit Sharing(Roof& roof) : roof_(roof) {
        for_loops(roof, [this](const Loop& loop) {
            for (std::size_t i = 0; i < loop.size(); ++i) walked_.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
        });
        std::ranges::sort(walked_);
        for (const auto& [from, to] : walked_)
            if (is_open(from, to)) open_from_.emplace(from, to);
        double extent = 0;
        for (const glm::dvec3& v : roof.vertices) extent = std::max({extent, std::abs(v.x), std::abs(v.y), v.z});
        little_ = kOnLine * extent;
    }

    void share() {
        if (open_from_.empty()) return;
        for_loops(roof_, [this](Loop& loop) {
            Loop with;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                with.push_back(loop[i]);
                const Loop between = nodes_between(loop[i], loop[(i + 1) % loop.size()]);
                with.insert(with.end(), between.begin(), between.end());
            }
            loop = std::move(with);
        });
    }

  private:
    bool is_open(Node from, Node to) const {
        const bool is_of_plan = roof_.vertices[from].z == 0 && roof_.vertices[to].z == 0;
        return !is_of_plan && !std::ranges::binary_search(walked_, std::pair{to, from});
    }

    // Those that the faces beyond have on the way back, from the first to the last.
    Loop nodes_between(Node from, Node to) const {
        if (!is_open(from, to)) return {};
        const glm::dvec3 a = roof_.vertices[from];
        const glm::dvec3 along = roof_.vertices[to] - a;
        const double length2 = glm::dot(along, along);
        Loop back;
        double left = 1;
        for (Node at = to; at != from;) {
            Node next = at;
            for (auto [it, end] = open_from_.equal_range(at); it != end; ++it) {
                const glm::dvec3 there = roof_.vertices[it->second] - a;
                const double share = glm::dot(there, along) / length2;
                const bool is_on_line = glm::distance(there, share * along) <= little_;
                if (it->second == from || (is_on_line && share < left && share > 0)) next = it->second;
                if (it->second == from) break;
            }
            if (next == at) return {};
            at = next;
            if (at == from) break;
            left = glm::dot(roof_.vertices[at] - a, along) / length2;
            back.push_back(at);
        }
        std::ranges::reverse(back);
        return back;
    }

    Roof& roof_;
    std::vector<std::pair<Node, Node>> walked_;
    std::multimap<Node, Node> open_from_;
    double little_ = 0;
};

}  // namespace

void share_nodes(Roof& roof) { Sharing(roof).share(); }

}  // namespace quadrat::mesh
