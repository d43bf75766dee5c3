// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "synthesis/trees/self_organising.hpp"

namespace quadrat::synthesis::trees {

// One tree while it grows: internodes with a bud at their end and buds beside it.
class GrowingTree {
  public:
    GrowingTree(const SelfOrganisation& parameters, const Seedling& seedling, base::Seed seed);

    // A year, in this order. The grid stands still in both; live adds to changes what has grown and what has fallen.
    void sense(const voxels::ShadowGrid& grid);
    void live(const voxels::ShadowGrid& grid, int year, std::vector<voxels::ShadowGrid::Change>& changes);

    TreeSkeleton skeleton() const;  // about its own root
    std::size_t living_buds() const { return living_buds_; }

    struct Internode {
        glm::vec3 end;
        glm::vec3 heading;  // unit
        glm::vec3 out;      // unit, across heading: where its first lateral stands
        int parent = -1;
        int main = -1;  // what goes on from it
        int first_bud = 0, buds = 0;
        int order = 0;
        int place = 0;  // along its axis
        int born = 0;
        float light = 0;  // of the bud at its end, where nothing goes on from it
        bool is_gone = false;
    };
    struct AxilBud {
        glm::vec3 heading;
        int child = -1;
        float light = 0;
        bool is_alive = true;
    };

  private:
    struct Shoot {
        int from;
        glm::vec3 heading;
        int bud;  // beside it; -1: at its end
        float flow;
    };
    void sum_up();
    void shed(int year, std::vector<voxels::ShadowGrid::Change>& changes);
    std::vector<Shoot> share(int year);
    void grow(const Shoot& shoot, const voxels::ShadowGrid& grid, int year,
              std::vector<voxels::ShadowGrid::Change>& changes);
    void bear_buds(int index);
    glm::vec3 next_heading(const Internode& from, const Shoot& shoot, const voxels::ShadowGrid& grid) const;
    float chance(int index, int what) const;  // -1 to 1

    const SelfOrganisation& p_;
    base::Seed seed_;
    glm::vec3 root_;
    std::vector<Internode> nodes_;
    std::vector<AxilBud> buds_;
    std::vector<float> light_;  // of all buds beyond an internode and at it
    std::vector<int> size_;     // internodes beyond it and itself
    std::size_t living_buds_ = 1;
    int year_ = 0;  // in which it grew last
};

// Internodes as limbs: at a fork what bears most goes on; what has but one internode bears leaves and is no limb.
// The young internodes bear leaves, by their light.
TreeSkeleton limbs_of(const std::vector<GrowingTree::Internode>& nodes, int year);

}  // namespace quadrat::synthesis::trees
