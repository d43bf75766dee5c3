// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/turtle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::synthesis::trees {
namespace {

struct Turtle {
    glm::vec3 at_m{0};
    glm::vec3 heading{0, 1, 0};
    glm::vec3 left{-1, 0, 0};
    glm::vec3 up{0, 0, 1};
    float width = 1;
    float path_m = 0;
    int limb = -1;  // index into the limbs; -1: the next F begins one
    int bearer = -1;
    int order = 0;

    void turn(const glm::vec3& axis, float radians) {
        const glm::quat q = glm::angleAxis(radians, axis);
        heading = glm::normalize(q * heading);
        left = glm::normalize(q * left);
        up = glm::cross(heading, left);
    }
    void level() {
        const glm::vec3 side = glm::cross(glm::vec3{0, 1, 0}, heading);
        if (glm::length(side) < 1.0e-4F) return;
        left = glm::normalize(side);
        up = glm::cross(heading, left);
    }
    void bend_toward(const glm::vec3& where, float strength) {
        const glm::vec3 axis = glm::cross(heading, where);
        const float sine = glm::length(axis);
        if (sine > 1.0e-4F) turn(axis / sine, strength * sine);
    }
};

class Reader {
  public:
    Reader(const TurtleOptions& options, base::Seed seed) : options_(options), seed_(seed) {}

    void read(const Module& m) {
        const float angle = glm::radians(m.values[0]);
        switch (m.letter) {
            case 'F':
                forward(m.values[0]);
                break;
            case '!':
                set_width(m.values[0]);
                break;
            case '+':
                turtle_.turn(turtle_.up, angle);
                break;
            case '-':
                turtle_.turn(turtle_.up, -angle);
                break;
            case '&':
                turtle_.turn(turtle_.left, angle);
                break;
            case '^':
                turtle_.turn(turtle_.left, -angle);
                break;
            case '/':
                turtle_.turn(turtle_.heading, angle);
                break;
            case '\\':
                turtle_.turn(turtle_.heading, -angle);
                break;
            case '$':
                turtle_.level();
                break;
            case '[':
                push();
                break;
            case ']':
                pop();
                break;
            default:
                break;
        }
    }

    TreeSkeleton finish() {
        for (const Limb& limb : skeleton_.limbs)
            for (const Limb::Node& node : limb.nodes) reach(node.at_m, node.path_m);
        for (const LeafSite& site : skeleton_.sites) reach(site.at_m, site.path_m);
        return std::move(skeleton_);
    }

  private:
    void reach(const glm::vec3& at, float path_m) {
        skeleton_.low_m = glm::min(skeleton_.low_m, at);
        skeleton_.high_m = glm::max(skeleton_.high_m, at);
        skeleton_.longest_path_m = std::max(skeleton_.longest_path_m, path_m);
    }

    void set_width(float width) {
        if (first_width_ <= 0) first_width_ = width;
        turtle_.width = width;
    }

    int generation() const {
        const float share = turtle_.width / std::max(first_width_, 1.0e-6F);
        return share >= 1 ? 0 : static_cast<int>(std::lround(std::log(share) / std::log(options_.width_ratio)));
    }

    float radius_m() const {
        return std::max(options_.trunk_radius_m * turtle_.width / std::max(first_width_, 1.0e-6F),
                        options_.least_radius_m);
    }

    void push() {
        stack_.push_back(turtle_);
        turtle_.bearer = turtle_.limb >= 0 ? turtle_.limb : turtle_.bearer;
        turtle_.limb = -1;
        ++turtle_.order;
    }

    void pop() {
        if (stack_.empty()) return;
        turtle_ = stack_.back();
        stack_.pop_back();
    }

    void forward(float length) {
        base::RandomStream random{seed_.child(internode_++)};
        const float sway_a = random.normal();
        const float sway_b = random.normal();
        const float gnarl = glm::radians(options_.gnarl_deg);
        if (turtle_.path_m > 0) {
            turtle_.turn(turtle_.left, gnarl * sway_a);
            turtle_.turn(turtle_.up, gnarl * sway_b);
            turtle_.bend_toward(options_.tropism, options_.tropism_strength);
        }
        const float step_m = length * options_.internode_m * (1.0F + 0.004F * options_.gnarl_deg * random.normal());
        const Limb::Node start{turtle_.at_m, radius_m(), turtle_.path_m};
        turtle_.at_m += step_m * turtle_.heading;
        turtle_.path_m += step_m;
        const int made = generation();
        if (made < options_.bare_from) {
            if (turtle_.limb < 0) {
                turtle_.limb = static_cast<int>(skeleton_.limbs.size());
                skeleton_.limbs.push_back({{start}, turtle_.order, made, turtle_.bearer});
            }
            auto& nodes = skeleton_.limbs[turtle_.limb].nodes;
            nodes.back().radius_m = std::min(nodes.back().radius_m, start.radius_m);
            nodes.push_back({turtle_.at_m, radius_m() * options_.width_ratio, turtle_.path_m});
        }
        if (made >= options_.leafy_from) {
            skeleton_.sites.push_back({turtle_.at_m, turtle_.heading, turtle_.path_m});
            skeleton_.sites.push_back(
                {turtle_.at_m - 0.5F * step_m * turtle_.heading, turtle_.heading, turtle_.path_m - 0.5F * step_m});
        }
    }

    TurtleOptions options_;
    base::Seed seed_;
    Turtle turtle_;
    std::vector<Turtle> stack_;
    TreeSkeleton skeleton_;
    float first_width_ = 0;
    std::uint64_t internode_ = 0;
};

}  // namespace

TreeSkeleton interpret(std::span<const Module> word, const TurtleOptions& options, base::Seed seed) {
    Reader reader(options, seed);
    for (const Module& m : word) reader.read(m);
    return reader.finish();
}

}  // namespace quadrat::synthesis::trees
