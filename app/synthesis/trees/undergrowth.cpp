// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/undergrowth.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "scene/colour.hpp"
#include "synthesis/trees/bare_twigs.hpp"
#include "synthesis/trees/crown_fringe.hpp"
#include "synthesis/trees/crown_mass.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/leaf_picture.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/overgrown.hpp"
#include "synthesis/trees/phyllotaxis.hpp"
#include "synthesis/trees/wood_levels.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kTurn_rad = 6.2831853F;
constexpr float kStemOfHeight = 0.06F;  // a shrub's, its radius

glm::vec3 flat_direction(float bearing_rad) { return {std::cos(bearing_rad), 0, std::sin(bearing_rad)}; }

scene::Leaves::Vertex vertex_of(const glm::vec3& colour, const glm::vec3& normal, float age, float shade) {
    scene::Leaves::Vertex v;
    v.normal = glm::normalize(normal);
    v.colour = colour;
    v.age = age;
    v.shade = shade;
    return v;
}

scene::Species herb(std::string name, float height_m, float radius_m) {
    scene::Species species;
    species.name = std::move(name);
    species.storey = scene::Storey::Herb;
    species.wood.resize(1);  // herbs have no wood
    species.height_m = height_m;
    species.crown_radius_m = radius_m;
    species.trunk_radius_m = 0.02F;
    species.treeline_m = 420;
    species.steepest_slope = 1.0F;
    return species;
}

// One triangle from a foot of the blade's width to its tip.
void add_spike(scene::Leaves& leaves, const BladeShape& b, const scene::Leaves::Vertex& common) {
    const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
    const glm::vec3 side = glm::cross(b.along, b.face);
    const glm::vec3 corners[3] = {-b.half_width_m * side, b.half_width_m * side,
                                  b.length_m * b.along + b.bow_m * b.face};
    for (int k = 0; k < 3; ++k) {
        scene::Leaves::Vertex vertex = common;
        vertex.site_m = b.site_m;
        vertex.corner_m = corners[k];
        vertex.colour *= k == 2 ? 1.18F : 0.82F;  // dark at the root
        leaves.vertices.push_back(vertex);
    }
    leaves.indices.insert(leaves.indices.end(), {first, first + 1, first + 2});
    ++leaves.blades;
}

// From a root or a fork, first up and then outward to its tip, with places for leaves along its outer part.
int add_shoot(TreeSkeleton& skeleton, const glm::vec3& from, const glm::vec3& tip, float radius_m, int parent) {
    Limb limb;
    limb.order = parent < 0 ? 0 : 1;
    limb.parent = parent;
    limb.parent_node = parent < 0 ? 0 : 1;
    const float length_m = glm::length(tip - from);
    const glm::vec3 middle = glm::mix(from, tip, 0.5F) + glm::vec3{0, 0.1F * length_m, 0};
    limb.nodes = {{from, radius_m, 0, 0}, {middle, 0.7F * radius_m, 0, 0}, {tip, 0.35F * radius_m, 0, 0}};
    const int index = static_cast<int>(skeleton.limbs.size());
    for (const float share : {0.35F, 0.6F, 0.8F, 1.0F}) {
        const bool is_outer = share > 0.5F;
        const glm::vec3& begin = is_outer ? middle : from;
        const glm::vec3& end = is_outer ? tip : middle;
        Site site;
        site.at_m = glm::mix(begin, end, 2 * share - (is_outer ? 1.0F : 0.0F));
        site.along = glm::normalize(end - begin);
        site.out = glm::normalize(glm::cross(site.along, glm::vec3{0.3F, 0.2F, 0.9F}));
        site.limb = index;
        site.node = is_outer ? 1 : 0;
        skeleton.sites.push_back(site);
    }
    skeleton.limbs.push_back(std::move(limb));
    return index;
}

// Stems from one root, by the golden angle, that fork once. Their tips lie about a dome that reaches the ground, whose
// lobes keep it from being a ball: a bush is higher on one side, with bays between its boughs.
TreeSkeleton shrub_skeleton(const ShrubOptions& o, base::Seed seed) {
    TreeSkeleton skeleton;
    base::RandomStream random{seed.child("stems")};
    constexpr int kStems = 10;
    const float h = o.height_m;
    const glm::vec3 dome_m{0.5F * h * (0.45F + 0.6F * o.width), 0.86F * h, 0};
    const float turn = random.between(0, kTurn_rad);
    const auto lobes = [turn](float bearing_rad, float steep) {
        const float beside = 0.24F * std::sin(2 * bearing_rad + turn) + 0.20F * std::sin(3 * bearing_rad + 1.7F * turn);
        return 1 + (1 - 0.6F * steep) * beside - 0.06F;
    };
    const auto on_dome = [&](float bearing_rad, float steep, float reach) {
        const float flat = std::sqrt(1 - steep * steep);
        return reach * lobes(bearing_rad, steep) *
               (flat * dome_m.x * flat_direction(bearing_rad) + glm::vec3{0, steep * dome_m.y, 0});
    };
    for (int i = 0; i < kStems; ++i) {
        const float bearing = kGoldenAngle_rad * static_cast<float>(i) + random.between(-0.4F, 0.4F);
        const float steep = 1 - (static_cast<float>(i) + 0.4F) / static_cast<float>(kStems);
        const glm::vec3 tip = on_dome(bearing, steep, random.between(0.70F, 1.14F));
        const int stem = add_shoot(skeleton, {0, -0.04F * h, 0}, tip, 0.024F * h, -1);
        const float aside = random.between(0.5F, 0.9F) * (i % 2 == 0 ? 1.0F : -1.0F);
        const glm::vec3 beside = on_dome(bearing + aside, 0.85F * steep + 0.05F, random.between(0.60F, 1.06F));
        add_shoot(skeleton, skeleton.limbs[static_cast<std::size_t>(stem)].nodes[1].at_m, beside, 0.013F * h, stem);
    }
    measure(skeleton);
    return skeleton;
}

struct Stem {
    glm::vec3 top_m, along, side, face;
};

// Golden or, of a golden flower, dark.
void add_eyes(scene::Leaves& leaves, const std::vector<Stem>& stems, const glm::vec3& blossom, float head_m) {
    const bool is_golden = blossom.g > 0.4F * blossom.r && blossom.b < 0.4F * blossom.g;
    const glm::vec3 eye = scene::linear_from_srgb_hex(is_golden ? 0x5A3A1C : 0xE9B93A);
    for (const Stem& stem : stems) {
        BladeShape disc;
        disc.site_m = stem.top_m + 0.16F * head_m * stem.along;
        disc.along = stem.side;
        disc.face = stem.along;
        disc.half_width_m = 0.3F * head_m;
        disc.fold_m = 0.1F * head_m;
        disc.is_disc = true;
        add_blade(leaves, leaf_shape(LeafKind::Lance), disc,
                  vertex_of(eye, stem.along + 0.2F * stem.face, 0.92F, 1.0F));
    }
}

}  // namespace

scene::Species grass_tuft(const GrassOptions& o, base::Seed seed) {
    scene::Species species = herb("grass", o.height_m, 0.8F * o.height_m);
    constexpr int kBlades = 16;
    for (int i = 0; i < kBlades; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const glm::vec2 foot = floret(i, 0.75F * o.height_m / std::sqrt(static_cast<float>(kBlades)));
        const glm::vec3 out = flat_direction(kGoldenAngle_rad * static_cast<float>(i) + random.between(-0.5F, 0.5F));
        BladeShape blade;
        blade.site_m = {foot.x, 0, foot.y};
        blade.along = glm::normalize(random.between(0.02F, 0.25F + 1.1F * o.spread) * out + glm::vec3{0, 1, 0});
        const glm::vec3 around = flat_direction(random.between(0, kTurn_rad));
        blade.face = glm::normalize(around - glm::dot(around, blade.along) * blade.along);
        blade.length_m = o.height_m * random.between(0.55F, 1.1F);
        blade.half_width_m = 0.05F * o.height_m;
        blade.bow_m = (0.05F + 0.3F * o.spread) * blade.length_m * random.unit_f();
        const float shade = random.between(0.8F, 1.0F);
        const float age = 0.6F + 0.3F * random.unit_f();
        add_spike(species.leaves, blade,
                  vertex_of(scene::shifted_colour(o.colour, random.between(0.88F, 1.12F)),
                            glm::vec3{0, 1, 0} + 0.3F * out, age, shade));
    }
    species.shade_liking = -0.3F;
    return species;
}

scene::Species reeds(const GrassOptions& o, base::Seed seed) {
    scene::Species species = herb("reed", o.height_m, 0.35F * o.height_m);
    constexpr int kBlades = 12;
    const glm::vec3 head = scene::linear_from_srgb_hex(0x7A5636);
    for (int i = 0; i < kBlades; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const glm::vec2 foot = floret(i, 0.09F * o.height_m);
        const glm::vec3 out = flat_direction(kGoldenAngle_rad * static_cast<float>(i));
        BladeShape blade;
        blade.site_m = {foot.x, 0, foot.y};
        blade.along = glm::normalize(random.between(0.0F, 0.22F) * out + glm::vec3{0, 1, 0});
        const glm::vec3 around = flat_direction(random.between(0, kTurn_rad));
        blade.face = glm::normalize(around - glm::dot(around, blade.along) * blade.along);
        const bool is_head = i % 4 == 3;
        blade.length_m = o.height_m * (is_head ? 0.26F : random.between(0.6F, 1.05F));
        blade.half_width_m = (is_head ? 0.028F : 0.02F) * o.height_m;
        blade.bow_m = is_head ? 0.0F : 0.12F * blade.length_m * random.unit_f();
        if (is_head) blade.site_m += 0.82F * o.height_m * blade.along;
        const float shade = random.between(0.8F, 1.0F);
        const float age = 0.5F + 0.4F * random.unit_f();
        add_spike(species.leaves, blade,
                  vertex_of(is_head ? head : scene::shifted_colour(o.colour, random.between(0.85F, 1.1F)),
                            glm::vec3{0, 1, 0} + 0.4F * out, age, shade));
    }
    species.moisture = 1;
    species.moisture_width = 0.35F;
    species.lowest_m = 0.45F;
    species.steepest_slope = 0.35F;
    species.treeline_m = 260;
    return species;
}

scene::Species fern(const glm::vec3& colour, float height_m, base::Seed seed) {
    scene::Species species = herb("fern", height_m, height_m);
    constexpr int kFronds = 11;
    for (int i = 0; i < kFronds; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const glm::vec3 out = flat_direction(kGoldenAngle_rad * static_cast<float>(i) + random.between(-0.2F, 0.2F));
        BladeShape blade;
        blade.along = glm::normalize(out + glm::vec3{0, random.between(0.7F, 1.5F), 0});
        blade.face = glm::normalize(glm::vec3{0, 1, 0} - blade.along.y * blade.along);
        blade.length_m = 1.15F * height_m * random.between(0.85F, 1.1F);
        blade.half_width_m = 0.19F * height_m;
        blade.fold_m = -0.02F * height_m;
        blade.bow_m = -0.5F * height_m;
        const float shade = random.between(0.75F, 1.0F);
        const float age = 0.5F + 0.4F * random.unit_f();
        add_blade(
            species.leaves, leaf_shape(LeafKind::Frond), blade,
            vertex_of(scene::shifted_colour(colour, random.between(0.9F, 1.1F)), blade.face + 0.4F * out, age, shade));
    }
    species.shade_liking = 0.9F;
    species.moisture = 0.75F;
    species.moisture_width = 0.6F;
    species.lowest_m = 1.5F;
    return species;
}

scene::Species flower(const FlowerOptions& o, base::Seed seed) {
    scene::Species species = herb("flower", o.height_m, 0.4F * o.height_m);
    constexpr int kStems = 3;
    const bool is_umbel = o.petals >= 10;
    const float head_m = 0.15F * o.height_m;
    std::vector<Stem> stems;
    for (int i = 0; i < kStems; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const glm::vec3 out = flat_direction(kGoldenAngle_rad * static_cast<float>(i));
        Stem stem;
        stem.along = glm::normalize(random.between(0.1F, 0.45F) * out + glm::vec3{0, 1, 0});
        stem.face = glm::normalize(out - glm::dot(out, stem.along) * stem.along);
        stem.side = glm::cross(stem.along, stem.face);
        const float stem_m = o.height_m * random.between(0.7F, 1.0F);
        stem.top_m = stem_m * stem.along;
        add_blade(species.leaves, leaf_shape(LeafKind::Lance),
                  {glm::vec3{0}, stem.along, stem.face, stem_m, 0.025F * o.height_m, 0.01F * o.height_m, 0, false},
                  vertex_of(o.leaf, {0, 1, 0}, 0.6F, 0.85F));
        stems.push_back(stem);
    }
    const int parts = is_umbel ? 9 : o.petals;
    for (int part = 0; part < parts; ++part) {
        for (int i = 0; i < kStems; ++i) {
            const Stem& stem = stems[i];
            base::RandomStream random{seed.child("petal").child(static_cast<std::uint64_t>(part * kStems + i))};
            BladeShape petal;
            petal.site_m = stem.top_m;
            const glm::vec3 normal = stem.along + 0.2F * stem.face;
            if (is_umbel) {
                const glm::vec2 at = floret(part, 0.42F * head_m);
                petal.site_m += at.x * stem.side + at.y * stem.face - 0.18F * glm::length(at) * stem.along;
                petal.is_disc = true;
                petal.along = stem.side;
                petal.face = stem.along;
                petal.half_width_m = 0.42F * head_m;
                petal.fold_m = 0.1F * head_m;
            } else {
                const float turn = kTurn_rad * static_cast<float>(part) / static_cast<float>(parts);
                petal.along =
                    glm::normalize(std::cos(turn) * stem.side + std::sin(turn) * stem.face + 0.5F * stem.along);
                petal.face = glm::normalize(stem.along - glm::dot(stem.along, petal.along) * petal.along);
                petal.length_m = head_m * random.between(0.95F, 1.15F);
                petal.half_width_m = 0.38F * head_m;
                petal.fold_m = 0.05F * head_m;
            }
            add_blade(species.leaves, leaf_shape(LeafKind::Lance), petal,
                      vertex_of(scene::shifted_colour(o.blossom, random.between(0.94F, 1.06F)), normal, 0.92F, 1.0F));
        }
    }
    if (!is_umbel) add_eyes(species.leaves, stems, o.blossom, head_m);
    species.shade_liking = -0.5F;
    return species;
}

scene::Species mushrooms(const MushroomOptions& o, base::Seed seed) {
    scene::Species species = herb("mushroom", o.height_m, 0.6F * o.height_m);
    species.density = species.share = 0;
    base::RandomStream random{seed};
    const glm::vec3 stem_colour = scene::linear_from_srgb_hex(0xE6DECB);
    constexpr int kBodies = 4;
    const LeafShape& shape = leaf_shape(LeafKind::Lance);
    for (int i = 0; i < kBodies; ++i) {
        const glm::vec2 foot = floret(i + 1, 0.42F * o.height_m);
        const glm::vec3 out = flat_direction(random.between(0, kTurn_rad));
        const float high_m = o.height_m * random.between(0.5F, 1.0F);
        BladeShape stem;
        stem.site_m = {foot.x, 0, foot.y};
        stem.along = glm::normalize(glm::vec3{0, 1, 0} + 0.12F * out);
        stem.face = glm::normalize(out - glm::dot(out, stem.along) * stem.along);
        stem.length_m = 1.05F * high_m;
        stem.half_width_m = 0.12F * high_m;
        stem.fold_m = 0.05F * high_m;
        const std::size_t first = species.leaves.vertices.size();
        add_blade(species.leaves, shape, stem, vertex_of(stem_colour, stem.face, 0.7F, 0.8F));
        // Two discs: the rim, and the crown of the cap over it.
        for (const bool is_rim : {true, false}) {
            BladeShape cap;
            cap.site_m = stem.site_m + (is_rim ? 0.92F : 1.06F) * high_m * stem.along;
            cap.along = stem.face;
            cap.face = stem.along;
            cap.is_disc = true;
            cap.half_width_m = (is_rim ? 0.5F : 0.31F) * high_m;
            cap.fold_m = 0.24F * high_m;
            add_blade(species.leaves, shape, cap,
                      vertex_of(scene::shifted_colour(o.cap, is_rim ? 0.92F : 1.06F), stem.along, 0.8F, 1.0F));
        }
        // From afar a few blades are enlarged about their sites: a mushroom stays whole if they are all its foot.
        for (std::size_t v = first; v < species.leaves.vertices.size(); ++v) {
            scene::Leaves::Vertex& vertex = species.leaves.vertices[v];
            vertex.corner_m += vertex.site_m - stem.site_m;
            vertex.site_m = stem.site_m;
        }
    }
    return species;
}

scene::Species shrub(const ShrubOptions& o, base::Seed seed) {
    TreeSkeleton skeleton = shrub_skeleton(o, seed);
    set_organs(skeleton, 0.8F * o.blossoms, 0, seed.child("organs"));
    pass_year(skeleton, o.year, seed.child("year"));
    scene::Species species;
    species.name = "shrub";
    species.storey = scene::Storey::Shrub;
    TubeDetail near;
    near.trunk_sides = 3;
    near.has_foot = false;
    TubeDetail far = near;
    far.most_nodes = 18;
    far.flattest = 2;
    species.wood = {sweep_tubes(skeleton, near), sweep_tubes(skeleton, far)};
    species.wood.back().left_out_m = thickest_left_out_m(skeleton, far.most_nodes);
    set_coarser(species.wood, kStemOfHeight * o.height_m);
    FoliageOptions foliage;
    foliage.kind = LeafKind::Ovate;
    const float ratio = o.height_m * o.height_m / (o.leaf_m * o.leaf_m);
    foliage.blades = static_cast<std::size_t>(std::clamp(5.0F * ratio * (0.6F + 0.4F * o.width), 120.0F, 420.0F));
    foliage.length_m = o.leaf_m;
    foliage.width = 1.15F;
    foliage.scatter_m = 0.19F * o.height_m;
    foliage.clumping = 0.35F;
    foliage.droop = 0.05F;
    foliage.flower_m = 0.75F * o.leaf_m;
    foliage.colours.leaf = o.leaf;
    foliage.colours.second = o.second;
    foliage.colours.blossom = o.blossom;
    foliage.colours.turned = o.turned;
    species.leaves = make_foliage(skeleton, foliage, seed.child("leaves"));
    species.masses = crown_masses(species.leaves, kThinCrown);
    add_fringe(species.masses);
    species.height_m = o.height_m;
    species.crown_radius_m = 0.55F * o.height_m * (0.4F + 0.6F * o.width);
    mix_in(species.leaves, bare_twigs(skeleton, {species.crown_radius_m, o.bark}, shape_of(foliage), foliage.blades / 2,
                                      seed.child("twigs")));
    species.leaf = leaf_picture(foliage.kind, seed.child("leaf"));
    species.foliage = foliage_picture(foliage.kind, seed.child("leaf"));
    species.bark_colour = o.bark;
    species.trunk_radius_m = kStemOfHeight * o.height_m;
    species.treeline_m = 300;
    species.steepest_slope = 0.9F;
    return species;
}

}  // namespace quadrat::synthesis::trees
