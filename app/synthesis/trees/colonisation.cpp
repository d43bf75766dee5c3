// SPDX-License-Identifier: Apache-2.0
// Ours keeps the nearest node of every point from step to step instead of searching for it anew, and draws points from
// a crown's outline with most of them near its outside, where the light is.
#include "synthesis/trees/colonisation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::synthesis::trees {
namespace {

struct Point {
    glm::vec3 at;
    int nearest = -1;
    float distance2 = 0;
};

struct Bud {
    glm::vec3 at;
    int parent;
    int children = 0;
    int descendants = 1;
};

class Coloniser {
  public:
    Coloniser(const Colonisation& p, base::Seed seed) : p_(p), seed_(seed) {}

    TreeSkeleton grow() {
        scatter();
        raise_trunk();
        for (Point& point : points_) look_for(point, 0);
        for (int step = 0; step < 300 && !points_.empty() && buds_.size() < p_.most_nodes; ++step)
            if (!advance()) break;
        return skeleton();
    }

  private:
    float outline(float up) const {
        const float half =
            up < p_.widest ? 1 - up / std::max(p_.widest, 0.02F) : (up - p_.widest) / std::max(1 - p_.widest, 0.02F);
        return std::pow(std::max(1 - std::pow(half, p_.roundness), 0.0F), 1 / p_.roundness);
    }

    bool is_lit(const glm::vec3& at) const {
        if (at.y < glm::dot(p_.slope, {at.x, at.z}) + p_.clearance) return false;
        for (const glm::vec4& n : p_.neighbours)
            if (glm::length(at - glm::vec3(n)) < n.w) return false;
        return true;
    }

    void scatter() {
        for (int i = 0; i < p_.points; ++i) {
            base::RandomStream random{seed_.child("point").child(static_cast<std::uint64_t>(i))};
            const float turn = random.between(0, 6.2831853F);
            const float up = random.unit_f();
            // The share of the radius that a uniform disc has, pushed outward.
            const float out = std::pow(random.unit_f(), 0.5F / (1 + 3 * p_.hollow));
            const float r = p_.crown_radius * outline(up) * out;
            const glm::vec3 at{r * std::cos(turn), p_.crown_base + (1 - p_.crown_base) * up, r * std::sin(turn)};
            if (is_lit(at)) points_.push_back({at, -1, 0});
        }
    }

    void raise_trunk() {
        base::RandomStream random{seed_.child("trunk")};
        glm::vec3 at{0};
        glm::vec3 heading{0, 1, 0};
        buds_.push_back({at, -1});
        const float top = p_.crown_base + 0.1F * (1 - p_.crown_base);
        while (at.y < top) {
            heading = glm::normalize(heading + p_.gnarl * glm::vec3{random.normal(), 0, random.normal()} * 0.5F +
                                     glm::vec3{0, 0.25F, 0});
            at += p_.step * heading;
            add(at, static_cast<int>(buds_.size()) - 1);
        }
    }

    void add(const glm::vec3& at, int parent) {
        ++buds_[parent].children;
        buds_.push_back({at, parent});
    }

    void look_for(Point& point, std::size_t first) const {
        for (std::size_t i = first; i < buds_.size(); ++i) {
            const glm::vec3 d = point.at - buds_[i].at;
            const float distance2 = glm::dot(d, d);
            if (point.nearest >= 0 && distance2 >= point.distance2) continue;
            point.nearest = static_cast<int>(i);
            point.distance2 = distance2;
        }
    }

    bool advance() {
        const std::size_t count = buds_.size();
        std::vector<glm::vec3> pull(count, glm::vec3{0});
        std::vector<int> pulled(count, 0);
        // While nothing is in sight the trunk grows on toward what is nearest.
        float sight2 = p_.influence * p_.influence;
        float closest2 = 1.0e9F;
        for (const Point& point : points_) closest2 = std::min(closest2, point.distance2);
        sight2 = std::max(sight2, 1.05F * closest2);
        for (const Point& point : points_) {
            if (point.distance2 > sight2) continue;
            pull[point.nearest] += (point.at - buds_[point.nearest].at) / std::sqrt(std::max(point.distance2, 1.0e-9F));
            ++pulled[point.nearest];
        }
        for (std::size_t i = 0; i < count && buds_.size() < p_.most_nodes; ++i) {
            if (pulled[i] == 0 || buds_[i].children > 3) continue;
            base::RandomStream random{seed_.child("bud").child(i).child(static_cast<std::uint64_t>(buds_[i].children))};
            const glm::vec3 chance{random.normal(), random.normal(), random.normal()};
            glm::vec3 way =
                pull[i] / static_cast<float>(pulled[i]) + glm::vec3{0, p_.rise, 0} + 0.6F * p_.gnarl * chance;
            if (glm::length(way) < 1.0e-3F) continue;
            way = buds_[i].at + p_.step * glm::normalize(way);
            // Two points that pull one bud to and fro would have it grow over itself for ever.
            if (!is_free(way, static_cast<int>(i))) continue;
            add(way, static_cast<int>(i));
        }
        if (buds_.size() == count) return false;
        const float kill2 = p_.kill * p_.kill;
        for (Point& point : points_) look_for(point, count);
        std::erase_if(points_, [kill2](const Point& point) { return point.distance2 < kill2; });
        return true;
    }

    bool is_free(const glm::vec3& at, int parent) const {
        if (buds_[parent].children == 0) return true;
        for (std::size_t k = static_cast<std::size_t>(parent) + 1; k < buds_.size(); ++k)
            if (buds_[k].parent == parent && glm::length(buds_[k].at - at) < 0.3F * p_.step) return false;
        return true;
    }

    // Chains of buds become limbs: at a fork the child with most beyond it goes on.
    TreeSkeleton skeleton() {
        std::vector<int> heir(buds_.size(), -1);
        for (std::size_t i = buds_.size(); i-- > 1;) {
            const int parent = buds_[i].parent;
            buds_[parent].descendants += buds_[i].descendants;
            if (heir[parent] < 0 || buds_[heir[parent]].descendants <= buds_[i].descendants)
                heir[parent] = static_cast<int>(i);
        }
        TreeSkeleton made;
        std::vector<int> limb_of(buds_.size(), -1);
        std::vector<int> node_of(buds_.size(), 0);
        for (std::size_t i = 0; i < buds_.size(); ++i) {
            const int parent = buds_[i].parent;
            if (parent >= 0 && heir[parent] == static_cast<int>(i)) continue;  // belongs to its parent's limb
            if (parent < 0 && heir[i] < 0) continue;
            Limb limb;
            if (parent >= 0) {
                limb.parent = limb_of[parent];
                limb.parent_node = node_of[parent];
                limb.order = made.limbs[limb.parent].order + 1;
                limb.nodes.push_back({buds_[parent].at, 0.01F, 0, 0});
            }
            for (int k = static_cast<int>(i); k >= 0; k = heir[k]) {
                limb_of[k] = static_cast<int>(made.limbs.size());
                node_of[k] = static_cast<int>(limb.nodes.size());
                limb.nodes.push_back({buds_[k].at, 0.01F, 0, 0});
            }
            made.limbs.push_back(std::move(limb));
        }
        for (std::size_t l = 0; l < made.limbs.size(); ++l) bear_leaves(made, static_cast<int>(l));
        measure(made);
        return made;
    }

    void bear_leaves(TreeSkeleton& made, int index) const {
        const Limb& limb = made.limbs[index];
        const int count = static_cast<int>(limb.nodes.size());
        for (int k = std::max(1, count - 6); k < count; ++k) {
            const glm::vec3 d = limb.nodes[k].at_m - limb.nodes[k - 1].at_m;
            Site site;
            site.at_m = limb.nodes[k].at_m;
            site.along = glm::normalize(d);
            const glm::vec3 other = std::abs(site.along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
            site.out = glm::normalize(glm::cross(site.along, other));
            site.limb = index;
            site.node = k;
            made.sites.push_back(site);
        }
    }

    const Colonisation& p_;
    base::Seed seed_;
    std::vector<Point> points_;
    std::vector<Bud> buds_;
};

}  // namespace

TreeSkeleton colonise(const Colonisation& parameters, base::Seed seed) { return Coloniser(parameters, seed).grow(); }

}  // namespace quadrat::synthesis::trees
