// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/seed.hpp"
#include "mesh/mesh.hpp"

// Plants that grow along other things, in voxels (Greene, "Voxel space automata: modeling with stochastic growth
// processes in voxel space", SIGGRAPH 1989): a shoot tries steps by chance, and takes the best of those that keep to
// what it clings to, off what it must not cover, and out of one another's way. Light comes from the grid that
// self-organising trees compete in.
namespace quadrat::synthesis::voxels {

// What there is to grow on, within a box: y is up.
class Surroundings {
  public:
    Surroundings(const glm::vec3& low_m, const glm::vec3& high_m, float cell_m);

    enum class Kind : std::uint8_t { Air, Hold, Bare };  // Bare: glass, doors, eaves; nothing grows beside it either
    // A face whose corners are counter-clockwise from where one can grow on it. What lies outside the box is left out.
    void add_face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Kind kind);

    float cell_m() const { return cell_m_; }
    glm::vec3 low_m() const { return low_m_; }
    glm::ivec3 cells() const { return cells_; }
    glm::ivec3 cell_of(const glm::vec3& at_m) const;
    Kind at(const glm::ivec3& cell) const;
    // The nearest place that holds, of the cells about it; false: there is none, or it is Bare there.
    struct Hold {
        glm::vec3 at_m{0};
        glm::vec3 out{0, 1, 0};  // unit
    };
    bool find_hold(const glm::vec3& at_m, Hold& hold) const;

  private:
    std::size_t flat(const glm::ivec3& c) const {
        return (static_cast<std::size_t>(c.y) * static_cast<std::size_t>(cells_.z) + static_cast<std::size_t>(c.z)) *
                   static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(c.x);
    }
    bool is_inside(const glm::ivec3& c) const;
    bool holds_at(const glm::vec3& at_m, const glm::vec3& out) const;

    glm::vec3 low_m_;
    float cell_m_;
    glm::ivec3 cells_;
    std::vector<Kind> kinds_;
    std::vector<Hold> holds_;
};

struct Climber {
    float high_m = 5;        // no farther up than that over where it is rooted
    std::size_t most = 160;  // nodes of all its shoots
    float branching = 0.35F;
    float upward = 0.6F;  // against chance and light
};

// A node of a shoot, on what it clings to.
struct Tendril {
    glm::vec3 at_m{0};
    glm::vec3 out{0, 1, 0};  // away from that, unit
    glm::vec3 way{0, 1, 0};  // it came, unit
    int before = -1;         // index of the node it grew from; -1: a root
};
// Roots are the places nearest to those given that hold; none: no tendrils.
std::vector<Tendril> climb(const Surroundings& around, std::span<const glm::vec3> roots_m, const Climber& climber,
                           base::Seed seed);

// Of a climber's leaves, linear: ivy, or with such a chance a creeper that has turned red.
glm::vec3 climber_colour(float redness, base::Seed seed);

}  // namespace quadrat::synthesis::voxels
