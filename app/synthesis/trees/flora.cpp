// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/flora.hpp"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/colour.hpp"
#include "synthesis/trees/abop.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/turtle.hpp"
#include "synthesis/trees/undergrowth.hpp"

namespace quadrat::synthesis::trees {
namespace {

// Colours chosen together by eye, sRGB: leaf, second leaf, bark, grass, blossom (the accent).
struct Dress {
    std::uint32_t leaf, second, bark, grass, blossom;
};
constexpr std::array<Dress, 10> kDresses{{
    {0x6E9440, 0xA3B557, 0x6A5744, 0x8FA354, 0xE9DCC0},  // spring
    {0x4C7038, 0x7C9448, 0x5A4A3C, 0x7F9A4A, 0xE8C25A},  // summer oak
    {0x3E6248, 0x5F8458, 0x6C4F3C, 0x7A9458, 0xDFA6B8},  // deep green
    {0x7F8A58, 0xA3A878, 0x7C7064, 0xA7A468, 0xB59AC8},  // olive
    {0xC88A3C, 0xB9552F, 0x54463C, 0xB09A58, 0xC8573F},  // autumn
    {0xD0A94A, 0xA7AE52, 0xC9C2B4, 0x9DA058, 0xE3B04B},  // birch
    {0x4F7470, 0x7A9A8C, 0x6A5A50, 0x8A9A68, 0xD8D4E6},  // blue conifer
    {0x5E8C3E, 0x8FB048, 0x8A6A50, 0x88AC48, 0xE2604A},  // bright south
    {0x93A65C, 0xE3B9C2, 0x5E4A42, 0x90A860, 0xF0CDD4},  // blossom
    {0x8C4A3A, 0xA86A44, 0x5C4C44, 0x94985C, 0xD9C46A},  // copper
}};

struct Wear {
    glm::vec3 leaf, second, bark, grass, blossom;
};

Wear choose_wear(base::Seed seed) {
    base::RandomStream random{seed.child("dress")};
    const Dress& d = kDresses[random.below(kDresses.size())];
    const auto colour = [](std::uint32_t hex) { return scene::linear_from_srgb_hex(hex); };
    return {colour(d.leaf), colour(d.second), colour(d.bark), colour(d.grass), colour(d.blossom)};
}

// What a type is beyond the book's constants, 0 to 7.
struct Habit {
    float tropism;       // more than 0: limbs rise; less: they hang
    float trunk_radius;  // to the height
    float droop;         // of leaves
    float blade_width;
    float bare_share;  // of the first internode's length added as bare stem
};
constexpr std::array<Habit, 8> kHabits{{
    {0.00F, 0.020F, 0.10F, 0.34F, 0.2F},
    {0.00F, 0.024F, 0.12F, 0.52F, 0.5F},
    {0.00F, 0.023F, 0.12F, 0.48F, 0.4F},
    {0.05F, 0.022F, 0.08F, 0.42F, 0.3F},
    {0.05F, 0.024F, 0.14F, 0.46F, 0.3F},
    {0.09F, 0.028F, 0.18F, 0.56F, 0.7F},
    {0.16F, 0.022F, 0.10F, 0.46F, 0.3F},
    {-0.10F, 0.023F, 0.42F, 0.26F, 0.6F},
}};

constexpr int kSteps = 10;

TreeSkeleton grow_skeleton(const scene::TreeParameters& p, float size, int steps, base::Seed seed) {
    base::RandomStream random{seed.child("habit")};
    const Habit& habit = kHabits[static_cast<std::size_t>(std::clamp(p.type, 0, 7))];
    const HondaTree tree = gene_tree(p);
    Grammar grammar = honda_grammar(tree);
    // The clear stem below the first limb, which the book's figures have as their first internode alone.
    grammar.axiom.insert(grammar.axiom.begin(), {module('!', 10), module('F', habit.bare_share)});
    const Word word = derive(grammar, steps);

    TurtleOptions options;
    options.internode_m = size * random.between(1.75F, 2.25F);
    float internodes = habit.bare_share;
    for (int i = 0; i < steps; ++i) internodes += std::pow(tree.r1, static_cast<float>(i));
    const float height_m = options.internode_m * internodes;
    options.trunk_radius_m = habit.trunk_radius * height_m * random.between(0.9F, 1.15F);
    options.least_radius_m = 0.0012F * height_m;
    options.width_ratio = tree.wr;
    options.tropism_strength = habit.tropism;
    options.gnarl_deg = p.type < 4 ? 2.5F : random.between(3.0F, 7.0F);
    options.leafy_from = steps - 3;
    options.bare_from = steps - 2;
    return interpret(word, options, seed.child("turtle"));
}

scene::Species tree_species(const scene::TreeParameters& p, const Wear& wear, float size, int steps, base::Seed seed) {
    const Habit& habit = kHabits[static_cast<std::size_t>(std::clamp(p.type, 0, 7))];
    const TreeSkeleton skeleton = grow_skeleton(p, size, steps, seed);
    scene::Species species;
    species.name = "tree " + std::string(1, static_cast<char>('a' + p.type));
    const int thinnest = steps - 3;
    species.wood = {
        mesh_limbs(skeleton, {.trunk_sides = 9, .limb_sides = 6, .last_generation = thinnest}),
        mesh_limbs(skeleton, {.trunk_sides = 6, .limb_sides = 4, .last_generation = thinnest - 2}),
        mesh_limbs(skeleton, {.trunk_sides = 4, .limb_sides = 3, .last_generation = thinnest - 4, .node_stride = 3}),
        mesh_limbs(skeleton, {.trunk_sides = 3, .limb_sides = 3, .last_generation = 0, .node_stride = 6}),
    };
    species.height_m = skeleton.high_m.y;
    species.crown_radius_m = 0.25F * (skeleton.high_m.x - skeleton.low_m.x + skeleton.high_m.z - skeleton.low_m.z);
    species.trunk_radius_m = skeleton.limbs.front().nodes.front().radius_m;
    // Small leaves are many and large ones few, so that both make a crown.
    const float length_m = 1.15F * p.leaf_length_m * std::sqrt(size);
    const float crown_m2 =
        species.crown_radius_m * species.crown_radius_m + 0.4F * species.crown_radius_m * species.height_m;
    const float wanted = 5.2F * crown_m2 / (length_m * length_m * habit.blade_width);
    species.leaves = make_foliage(skeleton,
                                  {.blades = static_cast<std::size_t>(std::clamp(wanted, 700.0F, 2100.0F)),
                                   .length_m = length_m,
                                   .width = habit.blade_width,
                                   .scatter_m = 0.055F * species.height_m,
                                   .droop = habit.droop,
                                   .colour = wear.leaf,
                                   .second = wear.second},
                                  seed.child("leaves"));
    species.bark_colour = wear.bark;
    return species;
}

}  // namespace

scene::Flora make_flora(const scene::TreeParameters& p, base::Seed seed) {
    scene::Flora flora;
    flora.spacing_m = p.spacing_m;
    const Wear wear = choose_wear(seed);
    base::RandomStream random{seed.child("flora")};
    const float size = random.between(0.85F, 1.2F);
    scene::TreeParameters slighter = p;
    slighter.branch_angle_deg *= 0.9F;
    const float herb_m = random.between(0.30F, 0.55F);
    scene::Species main;
    scene::Species young;
    oneapi::tbb::parallel_invoke(
        [&] { main = tree_species(p, wear, size, kSteps, seed.child("main")); },
        [&] { young = tree_species(slighter, wear, 0.62F * size, kSteps - 1, seed.child("young")); });
    main.share = 0.68F;
    young.share = 0.32F;
    young.name += ", young";
    young.steepest_slope = 0.95F;
    young.treeline_m *= 1.1F;
    flora.species = {std::move(main), std::move(young)};

    const Wear other = choose_wear(seed.child("bush"));
    scene::Species shrub = bush(scene::mix_colours(wear.leaf, other.leaf, 0.35F), wear.second, wear.bark,
                                random.between(1.1F, 1.9F), seed.child("bush"));
    scene::Species grass = grass_tuft(scene::shifted_colour(wear.grass, 0.86F, 0.78F), herb_m, seed.child("grass"));
    scene::Species ferns = fern(scene::mix_colours(wear.leaf, wear.grass, 0.5F), 1.15F * herb_m, seed.child("fern"));
    scene::Species flowers = flower(wear.grass, wear.blossom, 0.95F * herb_m, seed.child("flower"));
    grass.share = 0.72F;
    ferns.share = 0.16F;
    flowers.share = 0.12F;
    ferns.lowest_m = 1.5F;
    for (auto* species : {&shrub, &grass, &ferns, &flowers}) flora.species.push_back(std::move(*species));
    return flora;
}

}  // namespace quadrat::synthesis::trees
