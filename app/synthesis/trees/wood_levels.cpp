// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/wood_levels.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <numeric>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "mesh/nearness.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/species.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr std::size_t kSmoothTriangles = 3600;
constexpr std::size_t kTwigNodes = 1500;  // beside them
constexpr float kBareTwigs = 3;           // times as many of them and of limbs, where no leaf hides that they are few
constexpr std::size_t kMostSweptNodes = 780;  // of a bare tree
constexpr float kFewEnough = 0.75F;           // of a level's triangles, for another
constexpr float kLeastStep = 1.3F;            // from what one level leaves out to what the next does: room to morph
constexpr float kMostStretched = 1.5F;        // an edge, as the next level takes its place
constexpr float kJoints = 0.06F;              // of the trunk's thickness: what tubes miss of joints that are smooth

// Of three values at a triangle's corners, that of a point on it.
float between(const mesh::Mesh& mesh, const std::vector<float>& values, const mesh::Nearness::Nearest& on) {
    const std::uint32_t* corner = &mesh.indices[3 * std::size_t{on.triangle}];
    const glm::vec3 a = mesh.positions_m[corner[0]];
    const glm::vec3 b = mesh.positions_m[corner[1]];
    const glm::vec3 c = mesh.positions_m[corner[2]];
    const float of_a = glm::length(glm::cross(b - on.at_m, c - on.at_m));
    const float of_b = glm::length(glm::cross(c - on.at_m, a - on.at_m));
    const float of_c = glm::length(glm::cross(a - on.at_m, b - on.at_m));
    const float all = of_a + of_b + of_c;
    if (all <= 0) return values[corner[0]];
    return (values[corner[0]] * of_a + values[corner[1]] * of_b + values[corner[2]] * of_c) / all;
}

using Ways = std::vector<mesh::Nearness::Nearest>;

Ways nearest_on(const mesh::Mesh& next, const std::vector<glm::vec3>& from_m) {
    const mesh::Nearness surface(next);
    Ways ways;
    std::uint32_t last = 0;  // vertices that follow one another are neighbours
    for (const glm::vec3& at_m : from_m) {
        ways.push_back(surface.nearest(at_m, last, 0.3F));
        last = ways.back().triangle;
    }
    return ways;
}

// Which vertices edges lead to from each, one list after the other.
class Neighbours {
  public:
    explicit Neighbours(const mesh::Mesh& mesh) : first_(mesh.positions_m.size() + 1, 0), all_(mesh.indices.size()) {
        for (const std::uint32_t from : mesh.indices) ++first_[from + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        // A closed surface has each edge both ways.
        for (std::size_t i = 0; i < mesh.indices.size(); ++i)
            all_[next[mesh.indices[i]]++] = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    }
    std::span<const std::uint32_t> of(std::uint32_t vertex) const {
        return std::span(all_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
    }

  private:
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> all_;
};

// The tip of a limb that is left out may be nearest to another limb than its foot: its triangles would be drawn out to
// a web between both.
class Untorn {
  public:
    // slack_m: across a trunk's foot neighbours may go to opposite sides.
    Untorn(const mesh::Mesh& mesh, Ways ways, float slack_m)
        : mesh_(mesh), neighbours_(mesh), ways_(std::move(ways)), slack_m_(slack_m), is_settled_(ways_.size(), 1) {
        std::vector<std::uint32_t> torn = in_torn_pieces();
        std::ranges::stable_sort(torn, {}, [&](std::uint32_t v) { return ways_[v].distance_m; });
        for (const std::uint32_t vertex : torn)
            if (is_settled_[vertex] == 0) spread_from(vertex);
    }
    const Ways& ways() const { return ways_; }

  private:
    float apart2(std::uint32_t a, std::uint32_t b) const {
        const glm::vec3 off = mesh_.positions_m[a] - mesh_.positions_m[b];
        return glm::dot(off, off);
    }
    bool is_torn(std::uint32_t a, std::uint32_t b) const {
        const float off_m = glm::distance(ways_[a].at_m, ways_[b].at_m);
        return off_m > slack_m_ && off_m > slack_m_ + kMostStretched * std::sqrt(apart2(a, b));
    }
    // All vertices of pieces that have a torn edge, which are no longer settled.
    std::vector<std::uint32_t> in_torn_pieces() {
        std::vector<std::uint32_t> found;
        const auto find = [&](std::uint32_t vertex) {
            if (is_settled_[vertex] == 0) return;
            is_settled_[vertex] = 0;
            found.push_back(vertex);
        };
        std::size_t followed = 0;
        for (std::uint32_t vertex = 0; vertex < ways_.size(); ++vertex) {
            if (std::ranges::any_of(neighbours_.of(vertex), [&](std::uint32_t to) { return is_torn(vertex, to); }))
                find(vertex);
            for (; followed < found.size(); ++followed)
                for (const std::uint32_t to : neighbours_.of(found[followed])) find(to);
        }
        return found;
    }
    // From where a piece moves least its ways spread along it. A vertex whose own way leads off from its neighbours'
    // takes that of the closest: so a limb goes into the one that bears it.
    void spread_from(std::uint32_t first) {
        struct Reached {
            float distance_m;
            std::uint32_t vertex;
            auto operator<=>(const Reached&) const = default;
        };
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
        reached.push({ways_[first].distance_m, first});
        while (!reached.empty()) {
            const std::uint32_t vertex = reached.top().vertex;
            reached.pop();
            if (is_settled_[vertex] != 0) continue;
            bool leads_off = false;
            std::uint32_t closest = vertex;
            for (const std::uint32_t other : neighbours_.of(vertex)) {
                if (is_settled_[other] == 0) {
                    reached.push({ways_[other].distance_m, other});
                    continue;
                }
                leads_off = leads_off || is_torn(vertex, other);
                if (closest == vertex || apart2(vertex, other) < apart2(vertex, closest)) closest = other;
            }
            // What the next level has too stays on it: else one twig's way would draw its whole tree along.
            if (leads_off && ways_[vertex].distance_m > kOnIt * slack_m_) ways_[vertex] = ways_[closest];
            is_settled_[vertex] = 1;
        }
    }

    static constexpr float kOnIt = 0.12F;  // of the trunk's radius
    const mesh::Mesh& mesh_;
    const Neighbours neighbours_;
    Ways ways_;
    float slack_m_;
    std::vector<char> is_settled_;
};

}  // namespace

float thickest_left_out_m(const TreeSkeleton& skeleton, std::size_t most_nodes) {
    const std::vector<std::uint32_t> kept = strongest_limbs(skeleton, most_nodes);
    float thickest_m = 0;
    for (std::uint32_t i = 0; i < skeleton.limbs.size(); ++i)
        if (!std::ranges::binary_search(kept, i))
            thickest_m = std::max(thickest_m, 2 * skeleton.limbs[i].nodes.front().radius_m);
    return thickest_m;
}

std::vector<scene::Wood> wood_levels(const TreeSkeleton& skeleton, float bareness) {
    const float twiggy = 1 + (kBareTwigs - 1) * bareness;
    const auto nodes = [&](std::size_t count) {
        return static_cast<std::size_t>(std::lround(twiggy * static_cast<float>(count)));
    };
    MetaTubeDetail smooth;
    smooth.cell_m = cell_for(skeleton, kSmoothTriangles);
    smooth.most_nodes = nodes(kTwigNodes) + 4 * skeleton.limbs.front().nodes.size();
    smooth.twig_sides = 3;
    std::vector<scene::Wood> levels{mesh_meta_tubes(skeleton, smooth)};
    // Limbs that are all long need more triangles a node.
    while (levels.front().mesh.triangle_count() > kMostWoodTriangles) {
        const float room =
            static_cast<float>(kMostWoodTriangles) / static_cast<float>(levels.front().mesh.triangle_count());
        smooth.most_nodes = static_cast<std::size_t>(0.95F * room * static_cast<float>(smooth.most_nodes));
        levels.front() = mesh_meta_tubes(skeleton, smooth);
    }
    const std::size_t trunk = skeleton.limbs.front().nodes.size();
    const float thickness_m = 2 * skeleton.limbs.front().nodes.front().radius_m;
    struct Level {
        int sides;
        std::size_t nodes;  // beside the trunk's
        float flattest;
    };
    constexpr Level kLevels[] = {{8, 520, 0.4F}, {8, 260, 0.15F}, {7, 150, 0.25F}, {6, 90, 0.4F}, {5, 54, 0.55F},
                                 {4, 32, 0.75F}, {4, 16, 0.95F},  {3, 7, 1.4F},    {3, 0, 2.0F}};
    for (const Level& level : kLevels) {
        TubeDetail detail;
        detail.trunk_sides = level.sides;
        detail.most_nodes = trunk + std::min(nodes(level.nodes), kMostSweptNodes);
        detail.flattest = level.flattest;
        scene::Wood coarser = sweep_tubes(skeleton, detail);
        coarser.left_out_m =
            std::max(thickest_left_out_m(skeleton, detail.most_nodes), kLeastStep * levels.back().left_out_m);
        if (levels.size() == 1) coarser.left_out_m = std::max(coarser.left_out_m, kJoints * thickness_m);
        // The next limb may have been too long for one level more.
        const auto share = [&](float of_it) { return of_it * static_cast<float>(levels.back().mesh.triangle_count()); };
        if (static_cast<float>(coarser.mesh.triangle_count()) < share(kFewEnough)) levels.push_back(std::move(coarser));
    }
    return levels;
}

namespace {

constexpr float kFlare = 1.15F;  // of a coarsest stem's foot, to the trunk's radius

// One of three about a coarsest stem, or its tip. around_m: across its bark.
void set_stem_vertex(scene::Wood& wood, std::size_t i, const glm::vec3& at_m, const glm::vec3& outward, float around_m,
                     bool is_top) {
    wood.mesh.positions_m[i] = at_m;
    wood.mesh.normals[i] = outward;
    wood.mesh.texcoords[i] = {around_m, at_m.y};
    wood.grains[i] = {0, 1, 0, 1};
    wood.ages[i] = is_top ? 0.6F : 0;
    wood.sways[i] = is_top ? 0.3F : 0;
}

glm::vec3 third_of_turn(std::size_t i) {
    const float turn = 2.0944F * static_cast<float>(i);
    return {std::cos(turn), 0, -std::sin(turn)};
}

void add_coarsest(std::vector<scene::Wood>& levels, scene::Wood wood, float radius_m) {
    wood.left_out_m = std::max(2 * radius_m, kLeastStep * levels.back().left_out_m);
    levels.push_back(std::move(wood));
}

}  // namespace

void add_spindle(std::vector<scene::Wood>& levels, float height_m, float radius_m) {
    scene::Wood wood;
    resize_vertices(wood, 4);
    for (std::size_t i = 0; i < 3; ++i)
        set_stem_vertex(wood, i, third_of_turn(i) * radius_m * kFlare, third_of_turn(i), 1.4F * radius_m, false);
    set_stem_vertex(wood, 3, {0, 0.85F * height_m, 0}, {0, 1, 0}, 0, true);
    wood.mesh.indices = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1};
    add_coarsest(levels, std::move(wood), radius_m);
}

void add_column(std::vector<scene::Wood>& levels, const Limb& trunk) {
    scene::Wood wood;
    resize_vertices(wood, 6);
    const Limb::Node& foot = trunk.nodes.front();
    const Limb::Node& top = trunk.nodes.back();
    const float foot_m = kFlare * foot.radius_m;
    const float top_m = std::max(top.radius_m, 0.5F * foot.radius_m);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 outward = third_of_turn(i);
        set_stem_vertex(wood, i, foot.at_m + foot_m * outward, outward, 1.4F * foot_m, false);
        set_stem_vertex(wood, 3 + i, top.at_m + top_m * outward, outward, 1.4F * top_m, true);
    }
    wood.mesh.indices = {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5, 0, 2, 1, 3, 4, 5};
    add_coarsest(levels, std::move(wood), foot.radius_m);
}

void set_coarser(std::vector<scene::Wood>& levels, float trunk_radius_m) {
    for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
        scene::Wood& wood = levels[level];
        const scene::Wood& next = levels[level + 1];
        if (next.mesh.indices.empty()) continue;
        wood.coarser_m.clear();
        wood.coarser_sways.clear();
        const Untorn untorn(wood.mesh, nearest_on(next.mesh, wood.mesh.positions_m), trunk_radius_m);
        for (const mesh::Nearness::Nearest& on : untorn.ways()) {
            wood.coarser_m.push_back(on.at_m);
            wood.coarser_sways.push_back(between(next.mesh, next.sways, on));
        }
    }
}

}  // namespace quadrat::synthesis::trees
