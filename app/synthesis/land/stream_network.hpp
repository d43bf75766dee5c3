// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::synthesis::land {

struct StreamOptions {
    float spacing = 0.25F;  // between the first tributaries, in sides of the land; halved with each level
    int levels = 4;         // of tributaries, 0 (one river alone) to 6
    float flank = 1.0F;  // rise over run of the ground beside a stream, which is the steepest a bed may be, more than 0
    float fall = 0.1F;   // of the first river's bed, in flanks; a tributary's is steeper, 0.02 to 0.5
    float wander = 0.2F;  // how far beds swing aside, in their length, 0 to 0.3
    float floor = 0.3F;   // breadth of a valley's flat floor, in the finest spacing, 0 and more
};

// Streams first: a network in the unit square, and the ground that is fitted to it. Its river leaves the square at the
// south edge (y is 1) at height 0. Every bed falls toward its mouth, and the ground meets it there: no stream is cut
// into by another's valley.
class StreamNetwork {
  public:
    struct Node {
        glm::vec2 at{0};
        float bed = 0;
        int down = -1;  // the node that it drains to; of the outlet none
        int level = 0;  // 0 the river, 1 its first tributaries …
    };

    StreamNetwork(const StreamOptions& options, base::Seed seed);

    std::span<const Node> nodes() const { return nodes_; }

    struct Ground {
        float height = 0;
        float to_stream = 0;  // distance
    };
    // Anywhere; beyond the square the ground goes on rising. On a bed its height is the bed's.
    Ground ground(glm::vec2 at) const;
    float highest() const { return highest_; }  // of the ground within the square, about

  private:
    // A piece of bed from its lower end.
    struct Link {
        glm::vec2 foot{0};
        glm::vec2 along{1, 0};
        float length = 0;
        float bed = 0;    // at the foot
        float rise = 0;   // over its run
        float shift = 0;  // how far along a slope that passes beside it stands off, to how far it passes

        float stand(glm::vec2 at, float toward, float& beside) const;
        float over(glm::vec2 at, float k) const;
        float under(glm::vec2 at, float k) const;
        float distance(glm::vec2 at) const;
        bool is_beyond(glm::vec2 at, float far) const;
    };
    struct Lowest;
    void add_node(const Node& node);
    Link link_from(glm::vec2 foot, float foot_bed, glm::vec2 head, float head_bed) const;
    void link(int node);
    void add_river(base::RandomStream& random);
    void add_tributaries(int level, base::Seed seed);
    bool add_tributary(glm::vec2 source, const Lowest& mouth, int level, base::RandomStream& random);
    Lowest moved_to_a_node(Lowest mouth) const;
    int split(const Lowest& mouth);
    std::vector<glm::vec2> course(glm::vec2 from, glm::vec2 to, int pieces, float swing,
                                  base::RandomStream& random) const;
    bool is_clear(std::span<const glm::vec2> course) const;
    std::vector<float> beds(std::span<const glm::vec2> course, float mouth, float fall) const;
    Lowest lowest(glm::vec2 at) const;
    float least_bed(glm::vec2 at) const;
    const Link& link_of(int node) const { return links_[static_cast<std::size_t>(node)]; }
    void sort_into_squares();

    StreamOptions options_;
    std::vector<Node> nodes_;
    std::vector<Link> links_;  // of each node the one to where it drains; the outlet's is none
    float highest_ = 0;
    std::vector<std::vector<int>> squares_;  // of each square the nodes whose links may be lowest or nearest within
};

}  // namespace quadrat::synthesis::land
