// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/flora.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "scene/colour.hpp"
#include "scene/tree_parameters.hpp"
#include "synthesis/trees/species.hpp"
#include "synthesis/trees/topiary.hpp"
#include "synthesis/trees/undergrowth.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kLeastShare = 1.0F / 16.0F;

struct Wanted {
    Form form;
    float share;
};

void add_trees(scene::Flora& flora, const scene::TreeParameters& p, base::Seed seed) {
    std::vector<Wanted> wanted{{form_of(p, Rank::First), 1}};
    if (p.second_share >= kLeastShare) wanted.push_back({form_of(p, Rank::Second), p.second_share});
    if (p.third_share >= kLeastShare) wanted.push_back({form_of(p, Rank::Third), p.third_share});
    std::vector<std::size_t> in_stands;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (grows_in_stands(wanted[i].form)) in_stands.push_back(i);
    flora.species.resize(wanted.size() + 2 * in_stands.size());
    oneapi::tbb::parallel_for(std::size_t{0}, wanted.size() + in_stands.size(), [&](std::size_t task) {
        if (task < wanted.size()) {
            flora.species[task] = make_species(wanted[task].form, seed_of_species(seed, task));
            return;
        }
        const std::size_t i = in_stands[task - wanted.size()];
        StandSpecies made = make_stand_species(wanted[i].form, seed_of_species(seed, i));
        const std::size_t first = wanted.size() + 2 * (task - wanted.size());
        flora.species[first] = std::move(made.middle);
        flora.species[first + 1] = std::move(made.edge);
    });
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Kind& k = kind(wanted[i].form.habit);
        scene::Species& species = flora.species[i];
        species.share = wanted[i].share;
        species.treeline_m = k.treeline * p.stand_treeline_m;
        species.steepest_slope = k.steepness * p.stand_slope_limit;
        species.moisture = std::clamp(species.moisture + 0.35F * p.stand_moisture_liking, 0.0F, 1.0F);
    }
    for (std::size_t i = 0; i < in_stands.size(); ++i) {
        scene::Species& species = flora.species[in_stands[i]];
        species.in_stand = static_cast<int>(wanted.size() + 2 * i);
        species.at_edge = species.in_stand + 1;
    }
}

void add_shrubs(scene::Flora& flora, const scene::TreeParameters& p, const Wear& wear, base::Seed seed) {
    ShrubOptions o;
    o.leaf = yellower(scene::mix_colours(wear.leaf, wear.grass, 0.5F), p.shrub_yellowness);
    o.second = yellower(wear.second, p.shrub_yellowness);
    o.bark = wear.bark;
    o.blossom = blossom_colour(p.shrub_blossom_hue);
    o.height_m = p.shrub_height_m;
    o.width = p.shrub_width;
    o.leaf_m = p.shrub_leaf_m;
    o.blossoms = p.shrub_blossom * p.shrub_blossom * p.shrub_blossom;
    o.turned = turned_colour(p.tree_autumn_red);
    o.year = {p.tree_season, 0.85F, std::max(0.2F, o.blossoms)};
    scene::Species species = shrub(o, seed.child("shrub"));
    species.density = p.shrub_density;
    flora.species.push_back(std::move(species));
}

void add_herbs(scene::Flora& flora, const scene::TreeParameters& p, const Wear& wear, base::Seed seed) {
    const Meadow meadow = meadow_in(p.tree_season);
    const glm::vec3 grass = scene::shifted_colour(wear.grass, 0.86F, 0.78F);
    const auto withered = [&](const glm::vec3& green) {
        return scene::mix_colours(green, scene::linear_from_srgb_hex(0x8C6A40), meadow.withered);
    };
    scene::Species ferns = fern(withered(scene::shifted_colour(scene::mix_colours(wear.leaf, wear.grass, 0.6F), 0.86F)),
                                meadow.height * p.fern_height_m, seed.child("fern"));
    ferns.share = p.fern_share;
    FlowerOptions o;
    o.leaf = wear.grass;
    o.blossom = scene::mix_colours(blossom_colour(p.flower_hue), wear.blossom, 0.2F);
    o.height_m = meadow.height * p.flower_height_m;
    o.petals = static_cast<int>(std::lround(p.flower_petals));
    scene::Species flowers = flower(o, seed.child("flower"));
    flowers.share = 0.7F * meadow.flowers * p.flower_share;
    scene::Species reed =
        reeds({withered(scene::mix_colours(grass, wear.leaf, 0.3F)), p.reed_height_m, 0.2F}, seed.child("reed"));
    reed.share = 2.5F * p.reed_share;
    for (scene::Species* species : {&ferns, &flowers, &reed}) {
        species->density = p.herb_density;
        species->shade_liking *= 2 * p.herb_shade;
        if (species->share > 0) flora.species.push_back(std::move(*species));
    }
}

// Neither grows where it likes: gardens have the one, rings the other.
void add_set_plants(scene::Flora& flora, const scene::TreeParameters& p, const Wear& wear, base::Seed seed) {
    TopiaryOptions clipped;
    clipped.shape = static_cast<TopiaryShape>(std::clamp(static_cast<int>(std::lround(p.topiary_shape)), 0, 4));
    clipped.leaf =
        scene::shifted_colour(scene::mix_colours(wear.leaf, scene::linear_from_srgb_hex(0x2F4A2A), 0.6F), 0.9F);
    clipped.bark = wear.bark;
    clipped.height_m = p.topiary_height_m;
    if (clipped.shape != TopiaryShape::None) flora.species.push_back(topiary(clipped, seed.child("topiary")));
    if (flora.stand.rings > 0)
        flora.species.push_back(mushrooms({cap_colour(p.mushroom_hue)}, seed.child("mushrooms")));
}

// Grass is no species among others: it covers the ground between all of them.
scene::Cover cover_of(const scene::TreeParameters& p, const Wear& wear) {
    const Meadow meadow = meadow_in(p.tree_season);
    scene::Cover cover;
    cover.density = std::clamp(0.25F + 0.85F * p.grass_share, 0.0F, 1.0F);
    cover.height_m = meadow.height * (0.45F + 1.1F * p.grass_height_m);
    cover.spread = p.grass_spread;
    cover.cushions = std::clamp(0.45F * (1.2F - p.grass_share), 0.05F, 0.5F);
    cover.flowers = std::min(0.35F * meadow.flowers * p.flower_share, 0.35F);
    cover.patch_m = p.herb_patch_m;
    cover.grass = wear.grass;
    cover.blossom = scene::mix_colours(blossom_colour(p.flower_hue), wear.blossom, 0.2F);
    cover.withered = std::clamp(1.5F * meadow.dryness, 0.0F, 1.0F);
    return cover;
}

}  // namespace

scene::Flora make_flora(const scene::TreeParameters& p, base::Seed seed) {
    scene::Flora flora;
    flora.spacing_m = p.tree_spacing_m;
    flora.stand = {p.stand_grove_m,
                   p.stand_grove_contrast,
                   p.stand_clearings,
                   p.tree_young_share,
                   p.tree_size_spread,
                   p.stand_self_thinning,
                   p.herb_patch_m,
                   std::max(1.5F * p.stand_fires - 0.5F, 0.0F),
                   p.stand_even_clearings,
                   p.stand_giants,
                   std::max(2 * p.mushroom_rings - 1, 0.0F)};
    const Wear wear = wear_of(p);
    add_trees(flora, p, seed);
    add_shrubs(flora, p, wear, seed);
    add_herbs(flora, p, wear, seed);
    add_set_plants(flora, p, wear, seed);
    flora.cover = cover_of(p, wear);
    return flora;
}

}  // namespace quadrat::synthesis::trees
