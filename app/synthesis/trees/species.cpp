// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/species.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "synthesis/trees/bare_twigs.hpp"
#include "synthesis/trees/bark.hpp"
#include "synthesis/trees/crown_fringe.hpp"
#include "synthesis/trees/crown_mass.hpp"
#include "synthesis/trees/inhibition.hpp"
#include "synthesis/trees/leaf_picture.hpp"
#include "synthesis/trees/overgrown.hpp"
#include "synthesis/trees/wood_levels.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kBarkSide = 128;

// Sprays that stand for more of them are larger, but never boards.
float larger_for(float wanted) {
    constexpr float kAll = 2.2F;
    constexpr float kBeyond = 0.4F;  // of what is wanted beyond that
    return wanted < kAll ? wanted : kAll + kBeyond * (wanted - kAll);
}

FoliageOptions foliage_of(const Form& f, const scene::Species& species) {
    const Kind& k = kind(f.habit);
    const LeafShape& shape = spray_shape(f.leaf);
    FoliageOptions o;
    o.kind = f.leaf;
    // Leaves of a large tree are seen from farther away: sprays of them.
    o.length_m = 0.68F * k.leaf * f.leaf_length_m * std::sqrt(std::clamp(species.height_m / 13.0F, 0.45F, 1.6F));
    o.width = f.leaf_width;
    o.inhibition = inhibition_of(f.leaf_inhibition);
    o.fold = f.leaf_fold;
    o.scatter_m = 0.7F * k.scatter * species.height_m * (1 - 0.75F * f.bareness);
    o.clumping = f.leaf_clumping;
    o.droop = f.leaf_droop + k.droop;
    o.spread = k.spread;
    o.outward = k.outward;
    // Before the leaves come, clusters of flowers are all that there is of a crown.
    const float before_leaves = std::clamp(1 - 5 * f.season, 0.0F, 1.0F);
    o.flower_m = std::max(0.55F * o.length_m, 0.16F) * (1 + 0.4F * before_leaves);
    o.fruit_m = f.fruit_m;
    o.colours = f.colours;
    const std::size_t most = kMostLeafTriangles * 3 / shape.triangles.size();
    if (k.is_rosette) {
        o.length_m = 0.30F * species.height_m * std::pow(6.0F / std::max(species.height_m, 6.0F), 0.4F) *
                     (0.6F + 0.9F * f.leaf_length_m);
        o.blades = static_cast<std::size_t>(static_cast<float>(30 * f.stems) * f.leaf_density);
        o.clumping = 0;
        o.scatter_m = 0;
        o.is_rosette = true;
    } else {
        // Small leaves are many and large ones few, so that both make a crown; a narrow crown has most of its leaves on
        // its mantle.
        const float r = species.crown_radius_m;
        const float crown_m2 = r * r + 0.4F * r * species.height_m;
        const float blade_m2 = o.length_m * o.length_m * shape.width * f.leaf_width;
        const float wanted = 15.0F * k.cover * f.leaf_density * crown_m2 / blade_m2;
        o.blades = static_cast<std::size_t>(std::clamp(wanted, 160.0F, static_cast<float>(most)));
        // What the budget denies in number is given in size.
        const float missing = wanted / static_cast<float>(o.blades);
        if (missing > 1) o.length_m *= larger_for(std::sqrt(missing));
    }
    o.blades = std::min(o.blades, most);
    // What still hangs on a bare tree are single leaves, not sprays of them.
    o.blades = static_cast<std::size_t>(static_cast<float>(o.blades) * (1 - 0.88F * f.bareness));
    o.length_m *= 1 - 0.5F * f.bareness;
    return o;
}

// How far from the stem the crown's mass reaches: a twig that stands out does not count.
float crown_radius(const TreeSkeleton& skeleton) {
    std::vector<float> reach;
    for (const Site& site : skeleton.sites) reach.push_back(std::hypot(site.at_m.x, site.at_m.z));
    if (reach.size() < 8)
        return std::max(0.25F * (skeleton.high_m.x - skeleton.low_m.x + skeleton.high_m.z - skeleton.low_m.z), 0.3F);
    const auto most = reach.begin() + static_cast<std::ptrdiff_t>(reach.size() * 9 / 10);
    std::nth_element(reach.begin(), most, reach.end());
    return std::max(*most, 0.3F);
}

// A crown of which the usual mass would hold but a little has a thinner one: curtains of a willow.
std::vector<scene::CrownMass> masses_of(const scene::Leaves& leaves) {
    constexpr float kEnough = 0.4F;  // of the leaves
    std::vector<scene::CrownMass> masses = crown_masses(leaves);
    return masses.empty() || masses.front().share < kEnough ? crown_masses(leaves, kThinCrown) : masses;
}

std::size_t most_blades(const Form& f) { return kMostLeafTriangles * 3 / spray_shape(f.leaf).triangles.size(); }

// Up the trunk; not on what has no bark to hold on to, nor in needles, whose leaves would be needles too.
scene::Leaves climber_on(const Form& f, const scene::Species& species, const FoliageOptions& foliage, base::Seed seed) {
    const bool is_bare = f.leaf == LeafKind::Needles || f.leaf == LeafKind::Spines || kind(f.habit).is_rosette;
    if (f.climbers <= 0 || is_bare) return {};
    const float high_m = (0.15F + 0.5F * f.climbers) * species.height_m;
    const auto most = static_cast<std::size_t>(60 + 200 * f.climbers);
    return climber_leaves(species.wood.front(), species.trunk_radius_m, high_m, shape_of(foliage), most, seed);
}

// Of a crown on limbs, what is drawn of those; it borrows that, until the species has more levels.
std::optional<mesh::Nearness> wood_of(const Form& f, const scene::Species& species) {
    const mesh::Mesh& finest = species.wood.front().mesh;
    if (kind(f.habit).is_rosette || finest.indices.empty()) return std::nullopt;
    return std::make_optional<mesh::Nearness>(finest);
}

// Where leaves have fallen, but for what has needles, whose twigs are never bare.
scene::Leaves twigs_on(const TreeSkeleton& skeleton, const Form& f, const BareCrown& crown, std::size_t most,
                       base::Seed seed) {
    if (f.leaf == LeafKind::Needles || f.leaf == LeafKind::Spines || kind(f.habit).is_rosette) return {};
    return bare_twigs(skeleton, crown, spray_shape(f.leaf), most, seed);
}

void give_crown(const TreeSkeleton& skeleton, const Form& f, FoliageOptions& foliage, scene::Species& species,
                base::Seed seed) {
    const Kind& k = kind(f.habit);
    const scene::Leaves climber = climber_on(f, species, foliage, seed.child("climber"));
    const std::optional<mesh::Nearness> wood = wood_of(f, species);
    foliage.wood = wood ? &*wood : nullptr;
    const BareCrown bare{species.crown_radius_m, f.bark, foliage.wood};
    const scene::Leaves twigs = twigs_on(skeleton, f, bare, most_blades(f) - climber.blades, seed.child("twigs"));
    foliage.blades = std::min(foliage.blades, most_blades(f) - climber.blades - twigs.blades);
    foliage.reach_m = farthest_leaf_m(species.height_m);
    species.leaves = make_foliage(skeleton, foliage, seed.child("leaves"));
    const bool has_spines = k.own_leaf == LeafKind::Spines;  // its limbs are what is seen of it
    if (!k.is_rosette && !has_spines) species.masses = masses_of(species.leaves);
    add_fringe(species.masses);
    if (k.is_rosette)
        add_column(species.wood, skeleton.limbs.front());
    else if (species.leaves.blades > 0 && !has_spines)
        add_spindle(species.wood, species.height_m, species.trunk_radius_m);
    set_coarser(species.wood, species.trunk_radius_m);
    mix_in(species.leaves, climber);
    mix_in(species.leaves, twigs);
}

// Of its leaves, those that are not there: the rest would float about it from afar.
constexpr float kLeafless = 0.8F;
constexpr float kDead = 0.5F;  // and not because of the season

void stand_leafless(const TreeSkeleton& skeleton, const Form& f, scene::Species& species, base::Seed seed) {
    constexpr std::size_t kMost = 1600;
    const std::optional<mesh::Nearness> wood = wood_of(f, species);
    const BareCrown bare{species.crown_radius_m, f.bark, wood ? &*wood : nullptr};
    species.leaves = leafless_crown(skeleton, bare, kMost, seed.child("twigs"));
    species.masses = leafless_masses(skeleton, bare, seed.child("strokes"));
    add_spindle(species.wood, species.height_m, species.trunk_radius_m);
    set_coarser(species.wood, species.trunk_radius_m);
}

scene::Species species_of(TreeSkeleton skeleton, const Form& f, base::Seed seed) {
    const Kind& k = kind(f.habit);
    if (k.blossom > 0) set_organs(skeleton, k.blossom * f.blossom, 0.2F * f.fruit, seed.child("organs"));
    const float bareness = std::max(f.bareness, pass_year(skeleton, year_of(f), seed.child("year")));
    scene::Species species;
    species.name = k.name;
    species.height_m = skeleton.high_m.y;
    species.crown_radius_m = k.is_rosette ? 0.28F * skeleton.high_m.y : crown_radius(skeleton);
    species.trunk_radius_m = skeleton.limbs.front().nodes.front().radius_m * (f.stems > 1 ? 2.2F : 1.0F);
    species.wood = wood_levels(skeleton, k.is_rosette ? 0 : bareness);
    FoliageOptions foliage = foliage_of(f, species);
    const bool has_leaves = bareness <= kLeafless && f.bareness <= kDead;
    if (!has_leaves && !k.is_rosette && k.own_leaf != LeafKind::Spines)
        stand_leafless(skeleton, f, species, seed);
    else
        give_crown(skeleton, f, foliage, species, seed);
    // Twigs are all the crown that a bare tree has, and arms a cactus': they are left out later.
    const bool is_all_limbs = k.own_leaf == LeafKind::Spines;
    constexpr float kArmless = 20;  // a cactus without them is a post among its spines
    for (scene::Wood& wood : species.wood) wood.left_out_m *= is_all_limbs ? kArmless : 1 + 2.5F * bareness;
    if (k.is_rosette) {
        species.crown_radius_m = std::max(species.crown_radius_m, 0.8F * foliage.length_m);
        species.height_m += 0.3F * foliage.length_m;
    }
    species.bark_colour = f.bark;
    const Bark bark = k.own_bark.value_or(static_cast<Bark>(f.bark_kind));
    species.bark = bark_picture(bark_relief(bark, seed.child("bark"), kBarkSide), f.bark_depth);
    if (species.leaves.blades > 0) species.leaf = leaf_picture(f.leaf, seed.child("leaf"));
    if (species.leaves.blades > 0) species.foliage = foliage_picture(f.leaf, seed.child("leaf"));
    species.bark_tile_m = f.bark_tile_m * std::clamp(species.trunk_radius_m / 0.28F, 0.5F, 1.6F);
    species.lowest_m = k.lowest_m;
    if (k.has_boughs) species.turn = std::clamp(1.3F - 1.5F * f.wind_crown, 0.06F, 1.0F);
    species.is_tender = k.is_tender;
    species.shore_liking = k.shore_liking;
    species.arid_liking = k.arid_liking;
    species.moisture = k.moisture;
    species.moisture_width = k.moisture_width;
    return species;
}

}  // namespace

float farthest_leaf_m(float height_m) { return 0.2F + 0.02F * height_m; }

base::Seed seed_of_species(base::Seed flora, std::size_t index) { return flora.child("species").child(index); }

TreeSkeleton skeleton_of_species(const Form& form, base::Seed seed) {
    return grow_skeleton(form, seed.child("skeleton"));
}

scene::Species make_species(const Form& f, base::Seed seed) {
    return species_of(skeleton_of_species(f, seed), f, seed);
}

StandSpecies make_stand_species(const Form& f, base::Seed seed) {
    StandSkeletons two = grow_stand_skeletons(f, seed.child("stand"));
    StandSpecies made{species_of(std::move(two.middle), f, seed), species_of(std::move(two.edge), f, seed)};
    made.middle.is_form = made.edge.is_form = true;
    made.middle.share = made.edge.share = 0;
    return made;
}

}  // namespace quadrat::synthesis::trees
