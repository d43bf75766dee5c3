// SPDX-License-Identifier: Apache-2.0
// "Genetic selection of parametric scenes", 2003, section 4.2: limbs as tapered cylinders with conical ends. Ours share
// one frame along a limb (parallel transport), so that no ring is twisted against the next.
#include "synthesis/trees/limb_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace quadrat::synthesis::trees {
namespace {

constexpr float kGrownShare = 0.9F;  // of a tree's arrival, by when its wood is there

struct Frame {
    glm::vec3 along, side, up;
};

Frame frame_along(const glm::vec3& along) {
    const glm::vec3 other = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    const glm::vec3 side = glm::normalize(glm::cross(other, along));
    return {along, side, glm::cross(along, side)};
}

Frame transported(const Frame& before, const glm::vec3& along) {
    const glm::vec3 side = before.side - glm::dot(before.side, along) * along;
    const float length = glm::length(side);
    if (length < 1.0e-3F) return frame_along(along);
    return {along, side / length, glm::cross(along, side / length)};
}

std::vector<Limb::Node> rings_of(const Limb& limb, int stride, bool is_trunk) {
    std::vector<Limb::Node> nodes;
    const auto count = static_cast<int>(limb.nodes.size());
    for (int i = 0; i < count; ++i)
        if (i % stride == 0 || i + 1 == count) nodes.push_back(limb.nodes[i]);
    if (!is_trunk) return nodes;
    // The foot: the trunk widens into the ground over a short way.
    Limb::Node foot = nodes.front();
    const float radius_m = foot.radius_m;
    const glm::vec3 up = nodes[1].at_m - foot.at_m;
    const float length_m = std::max(glm::length(up), 1.0e-3F);
    const float flare_m = std::min(2.6F * radius_m, 0.6F * length_m);
    Limb::Node knee = foot;
    knee.at_m += up * (flare_m / length_m);
    knee.path_m += flare_m;
    knee.radius_m = 1.02F * radius_m;
    Limb::Node ankle = foot;
    ankle.at_m += up * (0.3F * flare_m / length_m);
    ankle.path_m += 0.3F * flare_m;
    ankle.radius_m = 1.22F * radius_m;
    foot.radius_m = 1.75F * radius_m;
    foot.at_m -= up * (0.8F * radius_m / length_m);  // rooted: no gap on a slope
    nodes.front() = knee;
    nodes.insert(nodes.begin(), {foot, ankle});
    return nodes;
}

class Builder {
  public:
    explicit Builder(const TreeSkeleton& skeleton) : longest_m_(std::max(skeleton.longest_path_m, 1.0e-3F)) {}

    void add_limb(const std::vector<Limb::Node>& nodes, int sides) {
        const auto first = vertex_count();
        const glm::vec3 start = direction(nodes, 0);
        const float base_radius_m = nodes.front().radius_m;
        add_vertex(nodes.front().at_m - 0.5F * base_radius_m * start, -start, nodes.front().path_m, {0.5F, 0});
        Frame frame = frame_along(start);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            frame = transported(frame, direction(nodes, i));
            add_ring(nodes, i, frame, sides);
        }
        const Limb::Node& last = nodes.back();
        const float cone_m = std::max(2.0F * last.radius_m, 0.02F);
        add_vertex(last.at_m + cone_m * frame.along, frame.along, last.path_m + cone_m, {0.5F, last.path_m});
        add_faces(first, static_cast<std::uint32_t>(nodes.size()), static_cast<std::uint32_t>(sides));
    }

    scene::Wood finish() { return std::move(wood_); }

  private:
    std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(wood_.mesh.positions_m.size()); }

    static glm::vec3 direction(const std::vector<Limb::Node>& nodes, std::size_t i) {
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = std::min(i + 1, nodes.size() - 1);
        const glm::vec3 d = nodes[b].at_m - nodes[a].at_m;
        const float length = glm::length(d);
        return length > 1.0e-6F ? d / length : glm::vec3{0, 1, 0};
    }

    void add_vertex(const glm::vec3& at_m, const glm::vec3& normal, float path_m, const glm::vec2& texcoord) {
        const float share = std::min(path_m / longest_m_, 1.0F);
        wood_.mesh.positions_m.push_back(at_m);
        wood_.mesh.normals.push_back(normal);
        wood_.mesh.texcoords.push_back(texcoord);
        wood_.ages.push_back(kGrownShare * share);
        wood_.sways.push_back(share * std::sqrt(share));
    }

    void add_ring(const std::vector<Limb::Node>& nodes, std::size_t i, const Frame& frame, int sides) {
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = std::min(i + 1, nodes.size() - 1);
        const float run_m = std::max(glm::length(nodes[b].at_m - nodes[a].at_m), 1.0e-4F);
        const float taper = std::clamp((nodes[a].radius_m - nodes[b].radius_m) / run_m, -1.0F, 1.0F);
        for (int k = 0; k < sides; ++k) {
            const float turn = static_cast<float>(k) / static_cast<float>(sides);
            const glm::vec3 out = std::cos(6.2831853F * turn) * frame.side + std::sin(6.2831853F * turn) * frame.up;
            add_vertex(nodes[i].at_m + nodes[i].radius_m * out, glm::normalize(out + taper * frame.along),
                       nodes[i].path_m, {turn, nodes[i].path_m});
        }
    }

    void add_faces(std::uint32_t first, std::uint32_t rings, std::uint32_t sides) {
        auto& indices = wood_.mesh.indices;
        const std::uint32_t tip = first + 1 + rings * sides;
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t next = (k + 1) % sides;
            indices.insert(indices.end(), {first, first + 1 + next, first + 1 + k});
            for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
                const std::uint32_t low = first + 1 + ring * sides;
                const std::uint32_t high = low + sides;
                indices.insert(indices.end(), {low + k, low + next, high + next, low + k, high + next, high + k});
            }
            const std::uint32_t last = first + 1 + (rings - 1) * sides;
            indices.insert(indices.end(), {last + k, last + next, tip});
        }
    }

    float longest_m_;
    scene::Wood wood_;
};

}  // namespace

scene::Wood mesh_limbs(const TreeSkeleton& skeleton, const LimbDetail& detail) {
    Builder builder(skeleton);
    for (const Limb& limb : skeleton.limbs) {
        if (limb.generation > detail.last_generation || limb.nodes.size() < 2) continue;
        const bool is_trunk = limb.parent < 0;
        const int sides = is_trunk ? detail.trunk_sides : std::max(3, detail.limb_sides - 2 * (limb.order - 1));
        builder.add_limb(rings_of(limb, detail.node_stride, is_trunk), sides);
    }
    return builder.finish();
}

}  // namespace quadrat::synthesis::trees
