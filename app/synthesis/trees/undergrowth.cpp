// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/undergrowth.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "scene/colour.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/limb_mesh.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kTurn_rad = 6.2831853F;
constexpr float kGoldenAngle_rad = 2.3999632F;

glm::vec3 flat_direction(float bearing_rad) { return {std::cos(bearing_rad), 0, std::sin(bearing_rad)}; }

scene::Leaves::Vertex vertex_of(const glm::vec3& colour, const glm::vec3& normal, float age, float shade) {
    scene::Leaves::Vertex v;
    v.normal = normal;
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
    species.treeline_m = 260;
    species.steepest_slope = 1.0F;
    return species;
}

// A stem for a bush: few limbs from one root.
TreeSkeleton bush_skeleton(float height_m, base::Seed seed) {
    TreeSkeleton skeleton;
    base::RandomStream random{seed.child("stems")};
    constexpr int kStems = 5;
    for (int i = 0; i < kStems; ++i) {
        const float bearing = kGoldenAngle_rad * static_cast<float>(i) + random.between(-0.4F, 0.4F);
        const float lean = i == 0 ? 0.1F : random.between(0.45F, 0.9F);
        const glm::vec3 along = glm::normalize(flat_direction(bearing) * lean + glm::vec3{0, 1, 0});
        const float length_m = height_m * random.between(0.62F, 0.85F);
        Limb limb;
        limb.order = 1;
        limb.parent = 0;
        limb.nodes = {{glm::vec3{0, -0.05F, 0}, 0.028F * height_m, 0},
                      {0.55F * length_m * along, 0.018F * height_m, 0.55F * length_m},
                      {length_m * along, 0.008F * height_m, length_m}};
        for (const float share : {0.35F, 0.55F, 0.72F, 0.88F, 1.0F})
            skeleton.sites.push_back({share * length_m * along, along, share * length_m});
        skeleton.longest_path_m = std::max(skeleton.longest_path_m, length_m);
        skeleton.limbs.push_back(limb);
    }
    skeleton.high_m = {height_m, height_m, height_m};
    return skeleton;
}

}  // namespace

scene::Species grass_tuft(const glm::vec3& colour, float height_m, base::Seed seed) {
    scene::Species species = herb("grass", height_m, 0.8F * height_m);
    constexpr int kBlades = 14;
    for (int i = 0; i < kBlades; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const float bearing = kGoldenAngle_rad * static_cast<float>(i) + random.between(-0.5F, 0.5F);
        const glm::vec3 out = flat_direction(bearing);
        BladeShape blade;
        blade.site_m = 0.75F * height_m * std::sqrt(random.unit_f()) * out;
        blade.along = glm::normalize(random.between(0.05F, 0.55F) * out + glm::vec3{0, 1, 0});
        const glm::vec3 around = flat_direction(random.between(0, kTurn_rad));
        blade.face = glm::normalize(around - glm::dot(around, blade.along) * blade.along);
        blade.length_m = height_m * random.between(0.5F, 1.1F);
        blade.half_width_m = 0.055F * height_m;
        blade.bow_m = 0.15F * blade.length_m * random.unit_f();
        const glm::vec3 normal = glm::normalize(glm::vec3{0, 1, 0} + 0.3F * out);
        add_spike(species.leaves, blade,
                  vertex_of(scene::shifted_colour(colour, random.between(0.9F, 1.12F)), normal,
                            0.6F + 0.3F * random.unit_f(), random.between(0.8F, 1.0F)));
    }
    return species;
}

scene::Species fern(const glm::vec3& colour, float height_m, base::Seed seed) {
    scene::Species species = herb("fern", height_m, height_m);
    constexpr int kFronds = 7;
    for (int i = 0; i < kFronds; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const glm::vec3 out =
            flat_direction(kTurn_rad * (static_cast<float>(i) + random.between(-0.3F, 0.3F)) / kFronds);
        const glm::vec3 along = glm::normalize(out + glm::vec3{0, random.between(0.65F, 1.3F), 0});
        const glm::vec3 face = glm::normalize(glm::vec3{0, 1, 0} - along.y * along);
        // Two blades a frond: the second droops from the first one's tip.
        BladeShape blade{glm::vec3{0},     along, face, 0.62F * height_m, 0.10F * height_m, -0.02F * height_m,
                         -0.10F * height_m};
        const scene::Leaves::Vertex vertex =
            vertex_of(scene::shifted_colour(colour, random.between(0.9F, 1.1F)), glm::normalize(face + 0.4F * out),
                      0.5F + 0.4F * random.unit_f(), random.between(0.7F, 1.0F));
        add_blade(species.leaves, blade, vertex);
        blade.site_m = 0.40F * height_m * along;
        blade.along = glm::normalize(along + glm::vec3{0, -0.55F, 0});
        blade.face = glm::normalize(glm::vec3{0, 1, 0} - blade.along.y * blade.along);
        add_blade(species.leaves, blade, vertex);
    }
    return species;
}

scene::Species flower(const glm::vec3& leaf, const glm::vec3& blossom, float height_m, base::Seed seed) {
    scene::Species species = herb("flower", height_m, 0.4F * height_m);
    constexpr int kStems = 3;
    for (int i = 0; i < kStems; ++i) {
        base::RandomStream random{seed.child(static_cast<std::uint64_t>(i))};
        const glm::vec3 out = flat_direction(kGoldenAngle_rad * static_cast<float>(i));
        const glm::vec3 along = glm::normalize(random.between(0.1F, 0.4F) * out + glm::vec3{0, 1, 0});
        const glm::vec3 face = glm::normalize(out - glm::dot(out, along) * along);
        const float stem_m = height_m * random.between(0.7F, 1.0F);
        BladeShape stem{glm::vec3{0}, along, face, stem_m, 0.03F * height_m, 0.01F * height_m, 0};
        add_blade(species.leaves, stem, vertex_of(leaf, glm::vec3{0, 1, 0}, 0.6F, 0.85F));
        const glm::vec3 side = glm::cross(along, face);
        // Head: two blades crossed, seen from above and aside.
        for (const glm::vec3& spread : {face, side}) {
            BladeShape petal{stem_m * along - 0.14F * height_m * spread,
                             spread,
                             along,
                             0.28F * height_m,
                             0.13F * height_m,
                             0.04F * height_m,
                             0};
            add_blade(species.leaves, petal,
                      vertex_of(scene::shifted_colour(blossom, random.between(0.94F, 1.06F)),
                                glm::normalize(along + 0.2F * out), 0.92F, 1.0F));
        }
    }
    return species;
}

scene::Species bush(const glm::vec3& leaf, const glm::vec3& second, const glm::vec3& bark, float height_m,
                    base::Seed seed) {
    const TreeSkeleton skeleton = bush_skeleton(height_m, seed);
    scene::Species species;
    species.name = "bush";
    species.storey = scene::Storey::Shrub;
    species.wood.push_back(mesh_limbs(skeleton, {.trunk_sides = 3, .limb_sides = 3}));
    species.wood.push_back(mesh_limbs(skeleton, {.trunk_sides = 3, .limb_sides = 3, .node_stride = 2}));
    species.leaves = make_foliage(skeleton,
                                  {.blades = 230,
                                   .length_m = 0.15F * height_m,
                                   .width = 0.55F,
                                   .scatter_m = 0.3F * height_m,
                                   .droop = 0.05F,
                                   .colour = leaf,
                                   .second = second},
                                  seed.child("leaves"));
    species.bark_colour = bark;
    species.height_m = height_m;
    species.crown_radius_m = 0.6F * height_m;
    species.trunk_radius_m = 0.06F * height_m;
    species.treeline_m = 220;
    species.steepest_slope = 0.85F;
    return species;
}

}  // namespace quadrat::synthesis::trees
