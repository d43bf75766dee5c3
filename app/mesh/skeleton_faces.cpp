// SPDX-License-Identifier: Apache-2.0
// Kelly's 5.1.9: a face is the walk round the lines that have its plane on one side. Where edges of one line had become
// one, their common face is cut apart from the node of their meeting straight up its slope.
#include "mesh/skeleton_faces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "mesh/shared_nodes.hpp"

namespace quadrat::mesh {
namespace {

constexpr double kOneNode = 1.0e-9;  // of the extent
constexpr double kSameWay = 1.0e-9;  // no farther from a line than that is on it; a needle of a weighted roof is wider
constexpr double kLevel = 1.0e-9;    // no higher than that over a node is at it; extents are some hundred

struct Step {
    int plane;  // its representative
    int from, to;
    int owner;  // the plane itself
    bool is_base;
};

struct Ring {
    int plane;
    std::vector<int> nodes;
};

struct Walk {
    std::vector<Step> steps;  // each begins where the one before ends
};

class Faces {
  public:
    explicit Faces(const FinishedFront& finished)
        : plan_(finished.plan), front_(finished.front), owners_(finished.owners), scale_(finished.metres_per_scaled) {
        for (const glm::dvec3& node : front_.nodes()) nodes_.push_back(node);
        tops_ = front_.tops();
        merged_.resize(nodes_.size());
        std::iota(merged_.begin(), merged_.end(), 0);
    }

    Roof roof() {
        std::vector<Walk> walks = all_walks();
        cut_apart(walks);
        merge_nodes(walks);
        for (std::size_t i = 0; i < walks.size(); ++i)
            while (drop_spike(walks, i)) {
            }
        std::map<std::pair<int, int>, std::vector<Walk>> by_face;
        for (Walk& walk : walks) {
            const PlaneOwner of = owner_of(walk);
            by_face[{plan_.edge[static_cast<std::size_t>(of.point)], of.course}].push_back(std::move(walk));
        }
        for (const auto& [key, of_face] : by_face) add_faces(key, of_face);
        for (const Ring& hole : holes_) add_hole(hole);
        for (const std::vector<int>& top : tops_) {
            std::vector<std::uint32_t> loop = numbered(clean(top));
            if (loop.size() >= 3) roof_.tops.push_back(std::move(loop));
        }
        share_nodes(roof_);
        return std::move(roof_);
    }

  private:
    int find(int node) {
        while (merged_[static_cast<std::size_t>(node)] != node) node = merged_[static_cast<std::size_t>(node)];
        return node;
    }
    const glm::dvec3& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }

    glm::dvec2 along(int plane) const {
        const MovingLine& line = front_.planes()[plane];
        return {line.ny_d, -line.nx_d};
    }
    // On the face's plane: along its edge, and up.
    glm::dvec2 on_face(int plane, int node) const {
        const glm::dvec3& p = at(node);
        return {glm::dot(along(plane), glm::dvec2(p.x, p.y)), p.z};
    }

    // Nodes nearer to each other along a line than the radius are one; a point of the plan stays where it is.
    void merge_nodes(std::vector<Walk>& walks) {
        glm::dvec2 low(1.0e300);
        glm::dvec2 high(-1.0e300);
        for (std::size_t i = 0; i < plan_.points.size(); ++i) {
            low = glm::min(low, glm::dvec2(nodes_[i]));
            high = glm::max(high, glm::dvec2(nodes_[i]));
        }
        const double radius = kOneNode * std::max(high.x - low.x, high.y - low.y);
        for (Walk& walk : walks)
            for (Step& step : walk.steps) {
                if (glm::distance(at(step.from), at(step.to)) > radius) continue;
                const int a = find(step.from);
                const int b = find(step.to);
                merged_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
            }
        for (Walk& walk : walks) {
            for (Step& step : walk.steps) {
                step.from = find(step.from);
                step.to = find(step.to);
            }
            std::erase_if(walk.steps, [](const Step& step) { return step.from == step.to; });
        }
        std::erase_if(walks, [](const Walk& walk) { return walk.steps.empty(); });
        for (std::vector<int>& top : tops_)
            for (int& node : top) node = find(node);
    }

    std::vector<Step> steps() const {
        std::vector<Step> steps;
        for (const SkeletonArc& arc : front_.arcs()) {
            const bool is_base = arc.right < 0 ? at(arc.start).z == 0 && at(arc.end).z == 0
                                               : arc.left >= 0 && is_above(arc.left, arc.right);
            if (arc.left >= 0)
                steps.push_back({front_.representative(arc.left), arc.start, arc.end, arc.left, is_base});
            if (arc.right >= 0)
                steps.push_back({front_.representative(arc.right), arc.end, arc.start, arc.right, false});
        }
        std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
            return a.plane != b.plane ? a.plane < b.plane : a.from < b.from;
        });
        return steps;
    }

    bool is_above(int upper, int lower) const {
        const PlaneOwner& a = owners_[static_cast<std::size_t>(upper)];
        const PlaneOwner& b = owners_[static_cast<std::size_t>(lower)];
        return a.point == b.point && a.course == b.course + 1;
    }

    std::vector<Walk> all_walks() const {
        const std::vector<Step> all = steps();
        std::vector<bool> is_taken(all.size(), false);
        std::vector<Walk> walks;
        for (std::size_t first = 0; first < all.size(); ++first) {
            if (is_taken[first]) continue;
            Walk walk;
            std::size_t next = first;
            while (!is_taken[next]) {
                is_taken[next] = true;
                walk.steps.push_back(all[next]);
                next = following(all, is_taken, all[next], first);
            }
            walks.push_back(std::move(walk));
        }
        return walks;
    }

    static std::size_t following(const std::vector<Step>& all, const std::vector<bool>& is_taken, const Step& step,
                                 std::size_t first) {
        auto it = std::lower_bound(all.begin(), all.end(), step, [](const Step& a, const Step& b) {
            return a.plane != b.plane ? a.plane < b.plane : a.from < b.to;
        });
        for (; it != all.end() && it->plane == step.plane && it->from == step.to; ++it) {
            const auto i = static_cast<std::size_t>(it - all.begin());
            if (!is_taken[i]) return i;
        }
        return first;
    }

    PlaneOwner owner_of(const Walk& walk) const {
        for (const Step& step : walk.steps)
            if (step.is_base) return owners_[static_cast<std::size_t>(step.owner)];
        return owners_[static_cast<std::size_t>(walk.steps.front().owner)];
    }

    void cut_apart(std::vector<Walk>& walks) {
        for (const SharedPlaneCut& cut : front_.cuts()) {
            const PlaneOwner left = owners_[static_cast<std::size_t>(cut.plane)];
            for (std::size_t i = 0; i < walks.size(); ++i) {
                const Step& any = walks[i].steps.front();
                if (any.plane != front_.representative(cut.plane)) continue;
                const auto& steps = walks[i].steps;
                const auto at_cut =
                    std::find_if(steps.begin(), steps.end(), [&](const Step& s) { return s.from == cut.node; });
                if (at_cut == steps.end()) continue;
                cut_at(walks, i, static_cast<std::size_t>(at_cut - steps.begin()), cut.plane);
                break;
            }
            cut_courses(walks, cut, left);
        }
    }

    // The courses above have one base along both edges.
    void cut_courses(std::vector<Walk>& walks, const SharedPlaneCut& cut, PlaneOwner left) {
        const std::size_t count = walks.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Step any = walks[i].steps.front();
            const PlaneOwner of = owners_[static_cast<std::size_t>(any.plane)];
            if (of.course == left.course || !is_on_line_of(any.plane, cut.plane)) continue;
            const double t = on_face(any.plane, cut.node).x;
            for (std::size_t s = 0; s < walks[i].steps.size(); ++s) {
                const Step step = walks[i].steps[s];
                if (!step.is_base || !(on_face(any.plane, step.from).x < t && t < on_face(any.plane, step.to).x))
                    continue;
                const int node = add_on(step, t);
                const int right = course_of(cut.right, of.course);
                pass_through(walks, step, node);
                walks[i].steps[s].to = node;
                walks[i].steps.insert(walks[i].steps.begin() + static_cast<std::ptrdiff_t>(s) + 1,
                                      {step.plane, node, step.to, right, true});
                cut_at(walks, i, s + 1, step.owner);
                break;
            }
        }
    }

    bool is_on_line_of(int plane, int other) const {
        const MovingLine& a = front_.planes()[plane];
        const MovingLine& b = front_.planes()[course_of(other, owners_[static_cast<std::size_t>(plane)].course)];
        return a.nx == b.nx && a.ny == b.ny && a.offset == b.offset && a.speed == b.speed;
    }

    int course_of(int plane, int course) const {
        const int point = owners_[static_cast<std::size_t>(plane)].point;
        for (std::size_t i = 0; i < owners_.size(); ++i)
            if (owners_[i].point == point && owners_[i].course == course) return static_cast<int>(i);
        return plane;
    }

    int add_on(const Step& step, double t) {
        const double from = on_face(step.plane, step.from).x;
        const double to = on_face(step.plane, step.to).x;
        nodes_.push_back(glm::mix(at(step.from), at(step.to), (t - from) / (to - from)));
        merged_.push_back(static_cast<int>(nodes_.size()) - 1);
        return merged_.back();
    }

    // Cuts a walk from where its step begins up to what lies over that.
    void cut_at(std::vector<Walk>& walks, std::size_t of, std::size_t first, int plane) {
        std::vector<Step> steps = walks[of].steps;
        std::rotate(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(first), steps.end());
        const glm::dvec2 base = on_face(plane, steps.front().from);
        std::size_t hit = steps.size();
        double lowest = 0;
        for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
            const glm::dvec2 a = on_face(plane, steps[i].from);
            const glm::dvec2 b = on_face(plane, steps[i].to);
            if (!(a.x >= base.x && b.x < base.x)) continue;
            const double z = a.y + (b.y - a.y) * (base.x - a.x) / (b.x - a.x);
            if (z < base.y - kLevel || (hit < steps.size() && z >= lowest)) continue;
            hit = i;
            lowest = z;
        }
        if (hit == steps.size() || is_hole_over(walks, of, base, lowest)) return;
        const Step over = steps[hit];
        const int start = steps.front().from;
        int node = on_face(plane, over.from).x == base.x ? over.from : add_on(over, base.x);
        if (lowest < base.y + kLevel) node = start;
        Walk right;
        right.steps.assign(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(hit));
        if (node != over.from) right.steps.push_back({over.plane, over.from, node, over.owner, false});
        const int right_owner = right.steps.front().owner;
        right.steps.push_back({over.plane, node, start, right_owner, false});
        Walk left;
        left.steps.push_back({over.plane, start, node, plane, false});
        left.steps.push_back({over.plane, node, over.to, over.owner, false});
        left.steps.insert(left.steps.end(), steps.begin() + static_cast<std::ptrdiff_t>(hit) + 1, steps.end());
        walks[of] = std::move(left);
        walks.push_back(std::move(right));
        if (node != over.from) pass_through(walks, over, node);
    }

    // A hole in the way of the cut: then the face of the one edge is the other's too.
    bool is_hole_over(const std::vector<Walk>& walks, std::size_t of, const glm::dvec2& base, double highest) const {
        const int plane = walks[of].steps.front().plane;
        for (std::size_t w = 0; w < walks.size(); ++w) {
            if (w == of || walks[w].steps.front().plane != plane) continue;
            for (const Step& step : walks[w].steps) {
                const glm::dvec2 a = on_face(plane, step.from);
                const glm::dvec2 b = on_face(plane, step.to);
                if ((a.x >= base.x) == (b.x >= base.x)) continue;
                const double z = a.y + (b.y - a.y) * (base.x - a.x) / (b.x - a.x);
                if (z > base.y && z < highest) return true;
            }
        }
        return false;
    }

    // The face beyond a line that got a node has it too, or the top.
    void pass_through(std::vector<Walk>& walks, const Step& line, int node) {
        for (Walk& walk : walks)
            for (std::size_t i = 0; i < walk.steps.size(); ++i) {
                const Step step = walk.steps[i];
                if (step.from != line.to || step.to != line.from || step.plane == line.plane) continue;
                walk.steps[i].to = node;
                walk.steps.insert(walk.steps.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                  {step.plane, node, step.to, step.owner, step.is_base});
                return;
            }
        for (std::vector<int>& top : tops_)
            for (std::size_t i = 0; i < top.size(); ++i)
                if (top[i] == line.to && top[(i + 1) % top.size()] == line.from) {
                    top.insert(top.begin() + static_cast<std::ptrdiff_t>(i) + 1, node);
                    return;
                }
    }

    // Where a plane took a level line and lost it again at once, its walk goes there and back.
    bool drop_spike(std::vector<Walk>& walks, std::size_t of) {
        for (std::size_t i = 0; walks[of].steps.size() > 2 && i < walks[of].steps.size(); ++i) {
            const std::size_t next = (i + 1) % walks[of].steps.size();
            const Step out = walks[of].steps[i];
            const Step back = walks[of].steps[next];
            const glm::dvec3 there = at(out.to) - at(out.from);
            const glm::dvec3 home = at(back.to) - at(back.from);
            const double there_m = glm::length(there);
            const double home_m = glm::length(home);
            if (there_m < kLevel || home_m < kLevel || glm::dot(there, home) > -there_m * home_m * (1 - 1.0e-12))
                continue;
            // A face of a needle goes there and back too, but not the same way.
            if (glm::length(glm::cross(there, home)) > kSameWay * std::max(there_m, home_m)) continue;
            Step kept{out.plane, out.from, back.to, out.owner, out.is_base};
            if (std::abs(there_m - home_m) > kLevel) {
                if (home_m < there_m) {
                    pass_through(walks, out, back.to);
                } else {
                    pass_through(walks, back, out.from);
                    kept.owner = back.owner;
                }
            } else if (out.from != back.to) {
                merged_[static_cast<std::size_t>(std::max(out.from, back.to))] = std::min(out.from, back.to);
            }
            walks[of].steps[i] = kept;
            walks[of].steps.erase(walks[of].steps.begin() + static_cast<std::ptrdiff_t>(next));
            std::erase_if(walks[of].steps, [this](const Step& step) { return find(step.from) == find(step.to); });
            return true;
        }
        return false;
    }

    std::vector<int> clean(const std::vector<int>& nodes) {
        std::vector<int> kept;
        for (const int node : nodes) {
            const int one = find(node);
            if (!kept.empty() && kept.back() == one) continue;
            if (kept.size() > 1 && kept[kept.size() - 2] == one) {
                kept.pop_back();
                continue;
            }
            kept.push_back(one);
        }
        while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
        while (kept.size() > 2 && kept[1] == kept.back()) {
            kept.erase(kept.begin());
            kept.pop_back();
        }
        return kept;
    }

    double area(int plane, const std::vector<int>& nodes) const {
        double area = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const glm::dvec2 a = on_face(plane, nodes[i]);
            const glm::dvec2 b = on_face(plane, nodes[(i + 1) % nodes.size()]);
            area += a.x * b.y - b.x * a.y;
        }
        return 0.5 * area;
    }

    void add_faces(std::pair<int, int> key, const std::vector<Walk>& walks) {
        for (const Walk& walk : walks) {
            const int plane = walk.steps.front().plane;
            std::vector<int> nodes;
            for (const Step& step : walk.steps) nodes.push_back(step.from);
            nodes = clean(nodes);
            if (nodes.size() < 3) continue;
            if (area(plane, nodes) > 0) {
                roof_.faces.push_back({key.first, key.second, numbered(nodes), {}});
                outlines_.push_back({plane, nodes});
            } else {
                holes_.push_back({plane, nodes});
            }
        }
    }

    // Edges of one line have one plane: a hole belongs to the face that lies around it.
    void add_hole(const Ring& hole) {
        const glm::dvec2 inside = on_face(hole.plane, hole.nodes.front());
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            if (outlines_[i].plane != hole.plane || !is_around(outlines_[i], inside)) continue;
            roof_.faces[i].holes.push_back(numbered(hole.nodes));
            return;
        }
    }

    bool is_around(const Ring& outline, const glm::dvec2& point) const {
        bool is_in = false;
        for (std::size_t i = 0; i < outline.nodes.size(); ++i) {
            const glm::dvec2 a = on_face(outline.plane, outline.nodes[i]);
            const glm::dvec2 b = on_face(outline.plane, outline.nodes[(i + 1) % outline.nodes.size()]);
            if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
                is_in = !is_in;
        }
        return is_in;
    }

    std::vector<std::uint32_t> numbered(const std::vector<int>& nodes) {
        std::vector<std::uint32_t> numbers;
        for (const int node : nodes) {
            const auto [it, is_new] = numbers_.try_emplace(node, static_cast<std::uint32_t>(roof_.vertices.size()));
            if (is_new) roof_.vertices.push_back(in_metres(node));
            numbers.push_back(it->second);
        }
        return numbers;
    }

    glm::dvec3 in_metres(int node) const {
        if (static_cast<std::size_t>(node) < plan_.given.size())
            return {plan_.given[static_cast<std::size_t>(node)], 0.0};
        const glm::dvec3 p = scale_ * at(node);
        return {p.x + plan_.centre_m.x, p.y + plan_.centre_m.y, p.z};
    }

    const CheckedPlan& plan_;
    const Wavefront& front_;
    const std::vector<PlaneOwner>& owners_;
    double scale_;
    std::vector<glm::dvec3> nodes_;
    std::vector<int> merged_;
    std::vector<std::vector<int>> tops_;
    std::map<int, std::uint32_t> numbers_;
    std::vector<Ring> outlines_;  // of the roof's faces
    std::vector<Ring> holes_;     // in them
    Roof roof_;
};

}  // namespace

Roof roof_from(const FinishedFront& finished) { return Faces(finished).roof(); }

}  // namespace quadrat::mesh
