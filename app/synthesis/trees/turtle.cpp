// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/turtle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::synthesis::trees {
namespace {

constexpr float kFarthest_m = 1.0e5F;
constexpr std::size_t kDeepest = 4096;

struct Turtle {
    glm::vec3 at_m{0};
    glm::vec3 heading{0, 1, 0};
    glm::vec3 left{-1, 0, 0};
    glm::vec3 up{0, 0, 1};
    float width = 1;
    int limb = -1;  // that an F would lengthen; -1: the next F begins one
    int bearer = -1;
    int bearer_node = 0;
    int order = 0;

    void yaw(float radians) { turn(heading, left, radians); }
    void pitch(float radians) { turn(heading, up, -radians); }
    void roll(float radians) { turn(left, up, radians); }
    void level() {
        const glm::vec3 side = glm::cross(glm::vec3{0, 1, 0}, heading);
        if (glm::dot(side, side) < 1.0e-8F) return;
        left = glm::normalize(side);
        up = glm::cross(heading, left);
    }
    void bend_toward(const glm::vec3& where, float strength) {
        const glm::vec3 axis = glm::cross(heading, where);
        const float sine = glm::length(axis);
        if (sine < 1.0e-4F) return;
        const glm::vec3 side = glm::cross(axis / sine, heading);
        const float angle = strength * sine;
        heading = glm::normalize(heading * std::cos(angle) + side * std::sin(angle));
        left = glm::normalize(left - glm::dot(left, heading) * heading);
        up = glm::cross(heading, left);
    }

  private:
    // a toward b, b away from a; kept at right angles to the third, which does not move.
    static void turn(glm::vec3& a, glm::vec3& b, float radians) {
        const float c = std::cos(radians);
        const float s = std::sin(radians);
        const glm::vec3 turned = c * a + s * b;
        b = c * b - s * a;
        a = turned;
    }
};

class Reader {
  public:
    Reader(const Word& word, const TurtleOptions& options, base::Seed seed)
        : word_(word), options_(options), seed_(seed) {
        turtle_.width = options.width;
    }

    TreeSkeleton read() {
        for (const Word::Symbol& symbol : word_.symbols) {
            if (skeleton_.limbs.size() > options_.most_limbs) break;
            obey(symbol);
        }
        measure(skeleton_);
        return std::move(skeleton_);
    }

  private:
    float argument(const Word::Symbol& symbol, float missing) const {
        return symbol.arguments == 0 ? missing : word_.values[symbol.first];
    }

    void obey(const Word::Symbol& symbol) {
        const auto angle = [&] { return glm::radians(argument(symbol, options_.angle_deg)); };
        switch (static_cast<char>(symbol.letter)) {
            case 'F':
                forward(argument(symbol, options_.length));
                break;
            case 'f':
                jump(argument(symbol, options_.length));
                break;
            case '!':
                turtle_.width = std::max(argument(symbol, turtle_.width * options_.width_ratio), 0.0F);
                break;
            case '+':
                turtle_.yaw(angle());
                break;
            case '-':
                turtle_.yaw(-angle());
                break;
            case '&':
                turtle_.pitch(angle());
                break;
            case '^':
                turtle_.pitch(-angle());
                break;
            case '/':
                turtle_.roll(-angle());
                break;
            case '\\':
                turtle_.roll(angle());
                break;
            case '|':
                turtle_.yaw(glm::pi<float>());
                break;
            case '$':
                turtle_.level();
                break;
            case 'L':
            case '~':
                if (!options_.no_organs[symbol.letter]) bear(Organ::Leaf);
                break;
            case 'K':
                if (!options_.no_organs[symbol.letter]) bear(Organ::Flower);
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

    float share() const { return turtle_.width / std::max(options_.width, 1.0e-9F); }

    void push() {
        if (stack_.size() >= kDeepest) return;
        stack_.push_back(turtle_);
        if (turtle_.limb >= 0) {
            turtle_.bearer = turtle_.limb;
            turtle_.bearer_node = static_cast<int>(skeleton_.limbs[turtle_.limb].nodes.size()) - 1;
        }
        turtle_.limb = -1;
        ++turtle_.order;
    }

    void pop() {
        if (stack_.empty()) return;
        turtle_ = stack_.back();
        stack_.pop_back();
    }

    void jump(float length) {
        move(length);
        turtle_.limb = -1;
        turtle_.bearer = -1;
    }

    void move(float length) {
        turtle_.at_m = glm::clamp(turtle_.at_m + length * turtle_.heading, -kFarthest_m, kFarthest_m);
    }

    void forward(float length) {
        if (!skeleton_.limbs.empty()) deviate();
        const glm::vec3 from_m = turtle_.at_m;
        move(length);
        const float radius_m = std::max(options_.radius_per_width * turtle_.width, options_.least_radius_m);
        if (share() >= options_.bare_below || skeleton_.limbs.empty()) lengthen(from_m, radius_m);
        if (share() < options_.leafy_below) {
            const std::size_t first = skeleton_.sites.size();
            bear(Organ::Leaf);
            if (skeleton_.sites.size() > first) skeleton_.sites.back().at_m = 0.5F * (from_m + turtle_.at_m);
            bear(Organ::Leaf);
            // A word may make many short shoots in one place and few long ones in another: leaves go with the room.
            for (std::size_t i = first; i < skeleton_.sites.size(); ++i)
                skeleton_.sites[i].weight = std::max(std::pow(std::abs(length), 1.7F), 1.0e-4F);
        }
    }

    void lengthen(const glm::vec3& from_m, float radius_m) {
        if (turtle_.limb < 0) {
            Limb limb;
            limb.order = turtle_.order;
            limb.parent = turtle_.bearer;
            limb.parent_node = turtle_.bearer_node;
            limb.nodes.reserve(8);
            limb.nodes.push_back({from_m, radius_m, 0, 0});
            turtle_.limb = static_cast<int>(skeleton_.limbs.size());
            skeleton_.limbs.push_back(std::move(limb));
        }
        auto& nodes = skeleton_.limbs[turtle_.limb].nodes;
        nodes.back().radius_m = std::min(nodes.back().radius_m, radius_m);
        nodes.push_back({turtle_.at_m, radius_m * options_.width_ratio, 0, 0});
    }

    // Two uniform numbers an internode; their sum bell-shaped enough.
    void deviate() {
        if (options_.gnarl_deg > 0) {
            const std::uint64_t hash = base::hash_of(seed_, internode_++, 0);
            const auto part = [hash](unsigned shift) {
                return static_cast<float>((hash >> shift) & 0xFFFFU) / 32768.0F - 1.0F;
            };
            const float gnarl = 1.2F * glm::radians(options_.gnarl_deg);
            turtle_.pitch(gnarl * (part(0) + part(16)));
            turtle_.yaw(gnarl * (part(32) + part(48)));
            left_right_angled();
        }
        if (options_.elasticity != 0) turtle_.bend_toward(options_.tropism, options_.elasticity);
    }

    void left_right_angled() {
        turtle_.heading = glm::normalize(turtle_.heading);
        turtle_.left = glm::normalize(turtle_.left - glm::dot(turtle_.left, turtle_.heading) * turtle_.heading);
        turtle_.up = glm::cross(turtle_.heading, turtle_.left);
    }

    void bear(Organ organ) {
        const int limb = turtle_.limb >= 0 ? turtle_.limb : turtle_.bearer;
        Site site;
        site.at_m = turtle_.at_m;
        site.along = turtle_.heading;
        site.out = turtle_.up;
        site.limb = std::max(limb, 0);
        site.organ = organ;
        if (skeleton_.limbs.empty()) return;
        const int last = static_cast<int>(skeleton_.limbs[site.limb].nodes.size()) - 1;
        site.node = turtle_.limb >= 0 ? last : std::min(turtle_.bearer_node, last);
        skeleton_.sites.push_back(site);
    }

    const Word& word_;
    TurtleOptions options_;
    base::Seed seed_;
    Turtle turtle_;
    std::vector<Turtle> stack_;
    TreeSkeleton skeleton_;
    std::int64_t internode_ = 0;
};

}  // namespace

TurtleOptions options_of(const Grammar& grammar) {
    TurtleOptions options;
    options.length = grammar.length;
    options.angle_deg = grammar.angle_deg;
    options.width = grammar.width;
    options.width_ratio = grammar.width_ratio;
    options.tropism = grammar.tropism;
    options.elasticity = grammar.elasticity;
    for (const Production& production : grammar.productions) options.no_organs.set(production.predecessor.letter);
    options.no_organs &= ~grammar.organs;
    return options;
}

TreeSkeleton interpret(const Word& word, const TurtleOptions& options, base::Seed seed) {
    return Reader(word, options, seed).read();
}

}  // namespace quadrat::synthesis::trees
