// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/tube_frames.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kGrownShare = 0.9F;  // of a tree's arrival, by when its wood is there
constexpr int kMostSides = 16;

struct Circle {
    std::array<float, kMostSides> cosine;
    std::array<float, kMostSides> sine;
    std::array<float, kMostSides> turn;  // from the mark, 0 to pi
};

const Circle& circle(int sides) {
    static const std::array<Circle, kMostSides + 1> kCircles = [] {
        std::array<Circle, kMostSides + 1> all{};
        for (int n = 3; n <= kMostSides; ++n) {
            for (int k = 0; k < n; ++k) {
                const float angle = 6.2831853F * static_cast<float>(k) / static_cast<float>(n);
                all[n].cosine[k] = std::cos(angle);
                all[n].sine[k] = std::sin(angle);
                all[n].turn[k] = std::min(angle, 6.2831853F - angle);
            }
        }
        return all;
    }();
    return kCircles[std::clamp(sides, 3, kMostSides)];
}

// One limb as it is swept.
struct Tube {
    std::uint32_t limb = 0;
    std::uint32_t first_node = 0;  // in the sweeper's list
    std::uint32_t nodes = 0;
    std::uint32_t sides = 3;
};

class Sweeper {
  public:
    Sweeper(const TreeSkeleton& skeleton, const TubeDetail& detail) : skeleton_(skeleton), detail_(detail) {
        longest_ = 1 / std::max(skeleton.longest_path_m, 1.0e-3F);
    }

    void add(std::uint32_t index) {
        const Limb& limb = skeleton_.limbs[index];
        if (limb.nodes.size() < 2) return;
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        if (limb.parent < 0 && detail_.has_foot) {
            const std::vector<Limb::Node> footed = with_foot(limb);
            thin_out(footed, detail_.flattest);
        } else {
            thin_out(limb.nodes, detail_.flattest);
        }
        const float share = std::sqrt(limb.nodes.front().radius_m / std::max(thickest(), 1.0e-4F));
        const int sides = limb.parent < 0
                              ? detail_.trunk_sides
                              : std::max(3, static_cast<int>(static_cast<float>(detail_.trunk_sides) * share + 0.3F));
        tubes_.push_back({index, first, static_cast<std::uint32_t>(nodes_.size()) - first,
                          static_cast<std::uint32_t>(std::clamp(sides, 3, kMostSides))});
    }

    scene::Wood sweep(std::vector<TubeRing>* rings) {
        std::size_t vertices = 0;
        std::size_t triangles = 0;
        for (const Tube& tube : tubes_) {
            vertices += tube.nodes * tube.sides + 2;
            triangles += 2 * tube.nodes * tube.sides;
        }
        resize_vertices(wood_, vertices);
        wood_.mesh.indices.resize(3 * triangles);
        for (const Tube& tube : tubes_) sweep(tube, rings);
        return std::move(wood_);
    }

  private:
    float thickest() const { return skeleton_.limbs.empty() ? 0 : skeleton_.limbs.front().nodes.front().radius_m; }

    // Leaves out nodes that a straight limb would not miss; ends stay.
    void thin_out(std::span<const Limb::Node> nodes, float flattest) {
        nodes_.push_back(nodes.front());
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
            const Limb::Node& before = nodes_.back();
            const glm::vec3 span = nodes[i + 1].at_m - before.at_m;
            const glm::vec3 step = nodes[i].at_m - before.at_m;
            const float t = glm::dot(step, span) / std::max(glm::dot(span, span), 1.0e-9F);
            const glm::vec3 off = step - t * span;
            const float limit = flattest * before.radius_m;
            if (flattest > 0 && glm::dot(off, off) < limit * limit &&
                std::abs(before.radius_m - nodes[i].radius_m) < 0.25F * before.radius_m)
                continue;
            nodes_.push_back(nodes[i]);
        }
        if (nodes.size() > 1) nodes_.push_back(nodes.back());
    }

    void put(const glm::vec3& at_m, const glm::vec3& normal, const glm::vec2& texcoord, const glm::vec4& grain,
             float path_m, float sway) {
        wood_.mesh.positions_m[vertex_] = at_m;
        wood_.mesh.normals[vertex_] = normal;
        wood_.mesh.texcoords[vertex_] = texcoord;
        wood_.grains[vertex_] = grain;
        wood_.ages[vertex_] = std::min(kGrownShare * path_m * longest_, 1.0F);
        wood_.sways[vertex_] = sway;
        ++vertex_;
    }

    void sweep(const Tube& tube, std::vector<TubeRing>* rings) {
        const std::span<const Limb::Node> nodes(nodes_.data() + tube.first_node, tube.nodes);
        const Circle& around = circle(static_cast<int>(tube.sides));
        const auto first = static_cast<std::uint32_t>(vertex_);
        TubeFrame frame = frame_along(direction_at(nodes, 0));
        const Limb::Node& foot = nodes.front();
        put(foot.at_m - 0.5F * foot.radius_m * frame.along, -frame.along, {0, foot.path_m}, {frame.along, 0},
            foot.path_m, foot.sway);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            frame = transported(frame, direction_at(nodes, i));
            if (rings != nullptr)
                rings->push_back(
                    {tube.limb, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(vertex_), tube.sides});
            ring(nodes, i, frame, around, tube.sides);
        }
        const Limb::Node& tip = nodes.back();
        const float cone_m = std::max(2.0F * tip.radius_m, 0.005F);
        put(tip.at_m + cone_m * frame.along, frame.along, {0, tip.path_m + cone_m}, {frame.along, 0},
            tip.path_m + cone_m, tip.sway);
        faces(first, tube.nodes, tube.sides);
    }

    void ring(std::span<const Limb::Node> nodes, std::size_t i, const TubeFrame& frame, const Circle& around,
              std::uint32_t sides) {
        const Limb::Node& node = nodes[i];
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = std::min(i + 1, nodes.size() - 1);
        const float run_m = std::max(nodes[b].path_m - nodes[a].path_m, 1.0e-4F);
        const float taper = std::clamp((nodes[a].radius_m - nodes[b].radius_m) / run_m, -1.0F, 1.0F);
        const float unit = 1.0F / std::sqrt(1.0F + taper * taper);
        const glm::vec3 lean = taper * unit * frame.along;
        for (std::uint32_t k = 0; k < sides; ++k) {
            const glm::vec3 out = around.cosine[k] * frame.side + around.sine[k] * frame.up;
            put(node.at_m + node.radius_m * out, unit * out + lean, {around.turn[k] * node.radius_m, node.path_m},
                {frame.along, around.sine[k]}, node.path_m, node.sway);
        }
    }

    void faces(std::uint32_t first, std::uint32_t rings, std::uint32_t sides) {
        std::uint32_t* out = wood_.mesh.indices.data() + index_;
        const std::uint32_t tip = first + 1 + rings * sides;
        const std::uint32_t last = first + 1 + (rings - 1) * sides;
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t next = k + 1 == sides ? 0 : k + 1;
            *out++ = first;
            *out++ = first + 1 + next;
            *out++ = first + 1 + k;
            *out++ = last + k;
            *out++ = last + next;
            *out++ = tip;
        }
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t low = first + 1 + ring * sides;
            const std::uint32_t high = low + sides;
            for (std::uint32_t k = 0; k < sides; ++k) {
                const std::uint32_t next = k + 1 == sides ? 0 : k + 1;
                const std::uint32_t six[6] = {low + k, low + next, high + next, low + k, high + next, high + k};
                out = std::copy(six, six + 6, out);
            }
        }
        index_ = static_cast<std::size_t>(out - wood_.mesh.indices.data());
    }

    const TreeSkeleton& skeleton_;
    TubeDetail detail_;
    float longest_ = 1;
    std::vector<Limb::Node> nodes_;
    std::vector<Tube> tubes_;
    scene::Wood wood_;
    std::size_t vertex_ = 0;
    std::size_t index_ = 0;
};

}  // namespace

void resize_vertices(scene::Wood& wood, std::size_t count) {
    wood.mesh.positions_m.resize(count);
    wood.mesh.normals.resize(count);
    wood.mesh.texcoords.resize(count);
    wood.grains.resize(count);
    wood.ages.resize(count);
    wood.sways.resize(count);
}

float age_at(const TreeSkeleton& skeleton, float path_m) {
    return std::min(kGrownShare * path_m / std::max(skeleton.longest_path_m, 1.0e-3F), 1.0F);
}

std::vector<Limb::Node> with_foot(const Limb& trunk) {
    std::vector<Limb::Node> nodes = trunk.nodes;
    Limb::Node foot = nodes.front();
    const float radius_m = foot.radius_m;
    const glm::vec3 step = nodes[1].at_m - foot.at_m;
    const float length_m = std::max(glm::length(step), 1.0e-3F);
    const glm::vec3 up = step / length_m;
    const float flare_m = std::min(2.6F * radius_m, 0.6F * length_m);
    Limb::Node knee = foot;
    knee.at_m += flare_m * up;
    knee.path_m += flare_m;
    knee.radius_m = std::min(1.02F * radius_m, std::max(radius_m, nodes[1].radius_m));
    Limb::Node ankle = foot;
    ankle.at_m += 0.3F * flare_m * up;
    ankle.path_m += 0.3F * flare_m;
    ankle.radius_m = 1.18F * radius_m;
    foot.radius_m = 1.55F * radius_m;
    foot.at_m -= 0.8F * radius_m * up;  // rooted: no gap on a slope
    nodes.front() = knee;
    nodes.insert(nodes.begin(), {foot, ankle});
    return nodes;
}

scene::Wood sweep_tubes(const TreeSkeleton& skeleton, const TubeDetail& detail, std::vector<TubeRing>* rings) {
    Sweeper sweeper(skeleton, detail);
    if (detail.most_nodes == static_cast<std::size_t>(-1)) {
        for (std::uint32_t i = 0; i < skeleton.limbs.size(); ++i) sweeper.add(i);
    } else {
        for (const std::uint32_t i : strongest_limbs(skeleton, detail.most_nodes)) sweeper.add(i);
    }
    return sweeper.sweep(rings);
}

scene::Wood mesh_cylinders(const TreeSkeleton& skeleton, int sides) {
    // An internode is a limb by itself.
    TreeSkeleton cut;
    cut.longest_path_m = skeleton.longest_path_m;
    for (const Limb& limb : skeleton.limbs) {
        for (std::size_t i = 1; i < limb.nodes.size(); ++i) {
            Limb internode;
            internode.order = limb.order;
            internode.nodes = {limb.nodes[i - 1], limb.nodes[i]};
            cut.limbs.push_back(std::move(internode));
        }
    }
    TubeDetail detail;
    detail.trunk_sides = sides;
    detail.has_foot = false;
    return sweep_tubes(cut, detail);
}

}  // namespace quadrat::synthesis::trees
