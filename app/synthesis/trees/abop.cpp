// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/abop.hpp"

#include <algorithm>
#include <array>

namespace quadrat::synthesis::trees {
namespace {

constexpr std::array<HondaTree, 4> kFigure2_6{{
    {0.9F, 0.6F, 45, 45, 137.5F, 0.707F},   // a
    {0.9F, 0.9F, 45, 45, 137.5F, 0.707F},   // b
    {0.9F, 0.8F, 45, 45, 137.5F, 0.707F},   // c
    {0.9F, 0.7F, 30, -30, 137.5F, 0.707F},  // d
}};

constexpr float kDefaultAngle_deg = 41.25F;
constexpr float kDefaultTrunk = 0.88F;
constexpr float kDefaultBranch = 0.74F;

}  // namespace

HondaTree book_tree(int type) { return kFigure2_6[static_cast<std::size_t>(std::clamp(type, 0, 3))]; }

HondaTree gene_tree(const scene::TreeParameters& p) {
    HondaTree tree = book_tree(p.type % 4);
    tree.is_less_flat = p.type >= 4;
    const float wider = p.branch_angle_deg / kDefaultAngle_deg;
    tree.a0 = std::clamp(tree.a0 * wider, 12.0F, 80.0F);
    tree.a2 = std::clamp(tree.a2 * wider, -70.0F, 70.0F);
    tree.r1 = std::clamp(tree.r1 + p.trunk_contraction - kDefaultTrunk, 0.7F, 0.97F);
    tree.r2 = std::clamp(tree.r2 + 0.8F * (p.branch_contraction - kDefaultBranch), 0.35F, 0.95F);
    return tree;
}

Grammar honda_grammar(const HondaTree& t) {
    // p2 and p3 of the book level each lateral with $; the changed ones roll it about its bearer instead.
    const auto lateral = [t](char turn, char becomes) {
        return [t, turn, becomes](const Module& self, Word& next) {
            const float l = self.values[0];
            const float w = self.values[1];
            next.insert(next.end(), {module('!', w), module('F', l), module('['), module(turn, t.a2)});
            next.push_back(t.is_less_flat ? module('/', 90.0F) : module('$'));
            next.insert(next.end(), {module(becomes, l * t.r2, w * t.wr), module(']')});
            if (t.is_less_flat) next.push_back(module('/', t.d));
            next.push_back(module(becomes, l * t.r1, w * t.wr));
        };
    };
    Grammar grammar;
    grammar.axiom = {module('A', 1, 10)};
    grammar.productions = {
        {'A',
         [t](const Module& self, Word& next) {
             const float l = self.values[0];
             const float w = self.values[1];
             next.insert(next.end(), {module('!', w), module('F', l), module('['), module('&', t.a0),
                                      module('B', l * t.r2, w * t.wr), module(']'), module('/', t.d),
                                      module('A', l * t.r1, w * t.wr)});
         }},
        {'B', lateral('-', 'C')},
        {'C', lateral('+', 'B')},
    };
    return grammar;
}

}  // namespace quadrat::synthesis::trees
