// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "synthesis/trees/colonisation.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/hardship.hpp"
#include "synthesis/trees/organised_form.hpp"
#include "synthesis/trees/phyllotaxis.hpp"
#include "synthesis/trees/prune.hpp"
#include "synthesis/trees/turtle.hpp"
#include "synthesis/trees/weber_penn.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr std::size_t kMostLimbsOfStems = 3000;  // all together
constexpr float kDefaultAngle_deg = 41.25F;      // of the genes: there the book's constants are as printed
constexpr float kDefaultTrunk = 0.88F;
constexpr float kDefaultBranch = 0.74F;
constexpr float kCloseHeight = 1.12F;  // of trees that grew in a stand, to those that stand alone
constexpr float kCloseGirth = 0.8F;

// ABOP's trees a to d and the changed ones: the book's constants, moved by the genes.
TreeSkeleton grow_by_type(const Form& f, base::Seed seed) {
    struct Honda {
        float r1, r2, a0, a2;
    };
    constexpr Honda kFigure2_6[4] = {
        {0.9F, 0.6F, 45, 45}, {0.9F, 0.9F, 45, 45}, {0.9F, 0.8F, 45, 45}, {0.9F, 0.7F, 30, -30}};
    const Honda& book = kFigure2_6[f.type % 4];
    const float wider = f.branch_angle_deg / kDefaultAngle_deg;
    const float lead = 0.02F * f.leader;
    const Redefinition genes[] = {
        {"r1", std::clamp(book.r1 + f.trunk_contraction - kDefaultTrunk + lead, 0.72F, 0.96F)},
        {"r2",
         std::clamp(book.r2 + 0.8F * (f.branch_contraction - kDefaultBranch) - 2 * lead + 0.06F * (f.limb_density - 1),
                    0.38F, 0.95F)},
        {"a0", std::clamp(book.a0 * wider, 12.0F, 80.0F)},
        {"a2", std::clamp(book.a2 * wider, -70.0F, 70.0F)},
        {"d", f.divergence_deg}};
    const std::string name = std::string(f.type < 4 ? "abop-" : "changed-") + static_cast<char>('a' + f.type % 4);
    const Grammar grammar = library_grammar(name, genes);
    TurtleOptions options = options_of(grammar);
    options.gnarl_deg = (f.type < 4 ? 0.6F : 1.0F) * f.gnarl_deg;
    constexpr float kTypeRise[8] = {0, 0, 0, 0.04F, 0.03F, 0.06F, 0.10F, -0.06F};
    options.elasticity = kTypeRise[f.type] + 0.5F * f.limb_rise;
    options.tropism = {0, 1, 0};
    options.bare_below = std::pow(grammar.width_ratio, 8.4F);
    options.leafy_below = std::pow(grammar.width_ratio, 5.6F);
    DeriveOptions how;
    how.seed = seed;
    Derivation derived = derive(grammar, how);
    // The clear stem below the first limb, which the book's figures have as their first internode alone.
    Word word;
    word.add('!', {10});
    word.add('F', {std::max(0.35F + 0.9F * f.clear_stem, 0.05F)});
    const auto shift = static_cast<std::uint32_t>(word.values.size());
    for (Word::Symbol symbol : derived.word.symbols) {
        symbol.first += shift;
        word.symbols.push_back(symbol);
    }
    word.values.insert(word.values.end(), derived.word.values.begin(), derived.word.values.end());
    return interpret(word, options, seed.child("turtle"));
}

TreeSkeleton grow_ternary(const Form& f, base::Seed seed) {
    const float wider = f.branch_angle_deg / kDefaultAngle_deg;
    const Redefinition genes[] = {
        {"a", std::clamp(21.0F * wider, 10.0F, 42.0F)},
        {"d1", f.divergence_deg},
        {"d2", f.divergence_deg},
        {"lr", std::clamp(1.109F + 0.6F * (f.trunk_contraction - kDefaultTrunk), 1.05F, 1.2F)}};
    const Grammar grammar = library_grammar("ternary-b", genes);
    TurtleOptions options = options_of(grammar);
    options.elasticity = 0.14F - 0.3F * f.limb_rise;
    options.gnarl_deg = 0.5F * f.gnarl_deg;
    options.width = std::pow(1.732F, 6.0F);
    options.leafy_below = 0.2F;
    DeriveOptions how;
    how.steps = f.stems > 2 ? 5 : 6;
    return interpret(derive(grammar, how).word, options, seed.child("turtle"));
}

TreeSkeleton grow_preset(const Form& f, base::Seed seed) {
    WeberPenn p = weber_penn(kind(f.habit).preset);
    const bool has_boughs = kind(f.habit).has_boughs;
    const float wider = f.branch_angle_deg / kDefaultAngle_deg;
    if (has_boughs) {
        p.base_size = std::clamp(p.base_size + (f.clear_stem < 0 ? p.base_size : 0.35F) * f.clear_stem, 0.02F, 0.7F);
        p.attraction_up += 3.0F * f.limb_rise;
        if (f.leader < -0.5F) p.base_splits += 1;
        if (f.leader > 0.5F) p.base_splits = 0;
    }
    p.level[0].curve_v += 4.0F * f.gnarl_deg;
    for (std::size_t l = 1; l < 3; ++l) {
        WeberPenn::Level& level = p.level[l];
        if (has_boughs) level.down_angle = std::clamp(level.down_angle * (0.5F + 0.5F * wider), 12.0F, 110.0F);
        level.branches *= l == 1 ? f.limb_density : 0.6F + 0.4F * f.limb_density;
        level.length *= std::clamp(1.0F + 1.2F * (f.branch_contraction - kDefaultBranch), 0.7F, 1.25F);
        level.curve_v += 5.0F * (f.gnarl_deg - 4.0F);
        if (level.rotate > 100) level.rotate = f.divergence_deg;
    }
    return grow_weber_penn(p, seed, kMostLimbsOfStems / static_cast<std::size_t>(std::max(f.stems, 2)));
}

TreeSkeleton grow_colonised(const Form& f, base::Seed seed) {
    const bool is_umbrella = kind(f.habit).is_umbrella;
    Colonisation c;
    c.crown_base = std::clamp((is_umbrella ? 0.55F : 0.22F) + 0.22F * f.clear_stem, 0.06F, 0.75F);
    c.crown_radius = is_umbrella ? 0.46F : 0.36F;
    c.widest = is_umbrella ? 0.62F : std::clamp(0.42F - 0.25F * f.leader, 0.15F, 0.8F);
    c.roundness = is_umbrella ? 2.6F : 2.1F;
    // Room all through the crown: were the middle empty, limbs would run around its outside, as the bars of a cage.
    c.hollow = 0.0F;
    c.points = static_cast<int>((is_umbrella ? 420.0F : 560.0F) * f.limb_density);
    c.rise = std::max(0.25F + 1.2F * f.limb_rise, 0.12F) + (is_umbrella ? 0.2F : 0.0F);
    c.gnarl = 0.03F + 0.018F * f.gnarl_deg;
    // Neighbours take the light of the sides, the more the more it is crowded.
    std::vector<glm::vec4> neighbours;
    for (int i = 0; i < 3 && f.crowding > 0.05F; ++i) {
        base::RandomStream random{seed.child("neighbour").child(static_cast<std::uint64_t>(i))};
        const float turn = random.between(0, 6.2831853F);
        const float away = 1.05F - 0.45F * f.crowding * random.between(0.6F, 1.0F);
        neighbours.emplace_back(away * std::cos(turn), random.between(0.25F, 0.5F), away * std::sin(turn), 0.5F);
    }
    c.neighbours = neighbours;
    return colonise(c, seed);
}

TreeSkeleton grow_stem(const Form& f, base::Seed seed) {
    switch (kind(f.habit).grower) {
        case Grower::ByType:
            return grow_by_type(f, seed);
        case Grower::Ternary:
            return grow_ternary(f, seed);
        case Grower::Colonised:
            return grow_colonised(f, seed);
        case Grower::WeberPenn:
        case Grower::SelfOrganised:  // all stems together
            break;
    }
    return grow_preset(f, seed);
}

// Neighbours shade the sides: of the low limbs some have died.
void crowd(TreeSkeleton& skeleton, const Form& f, base::Seed seed) {
    const Kind& k = kind(f.habit);
    if (!k.has_boughs) return;
    const float dead_below = 0.55F * f.crowding * skeleton.high_m.y;
    prune(skeleton, [&](const Limb& limb, std::size_t i) {
        if (limb.order != 1) return true;
        if (k.grower == Grower::ByType &&
            base::unit_of(base::hash_of(seed, static_cast<std::int64_t>(i), 5)) > f.limb_density)
            return false;
        const float alive = limb.nodes.front().at_m.y / std::max(dead_below, 1.0e-3F);
        return alive > 0.45F + 0.5F * base::unit_of(base::hash_of(seed, static_cast<std::int64_t>(i), 3));
    });
}

// Limbs end where they would come to the ground.
void keep_above_ground(TreeSkeleton& skeleton, float clearance_m) {
    std::vector<int> ends(skeleton.limbs.size());
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
        Limb& limb = skeleton.limbs[i];
        auto end = limb.nodes.size();
        for (std::size_t k = 1; k < limb.nodes.size() && limb.parent >= 0; ++k) {
            if (limb.nodes[k].at_m.y >= clearance_m) continue;
            end = k;
            break;
        }
        ends[i] = static_cast<int>(end);
        limb.nodes.resize(end);
    }
    std::erase_if(skeleton.sites,
                  [&](const Site& site) { return site.node >= ends[site.limb] || site.at_m.y < clearance_m; });
    std::vector<bool> is_gone(skeleton.limbs.size(), false);
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
        const Limb& limb = skeleton.limbs[i];
        is_gone[i] = limb.nodes.size() < 2 ||
                     (limb.parent >= 0 && (is_gone[limb.parent] || limb.parent_node >= ends[limb.parent]));
    }
    prune(skeleton, [&](const Limb&, std::size_t i) { return !is_gone[i]; });
}

void turn(TreeSkeleton& skeleton, const glm::quat& q, const glm::vec3& shift) {
    for (Limb& limb : skeleton.limbs)
        for (Limb::Node& node : limb.nodes) node.at_m = q * node.at_m + shift;
    for (Site& site : skeleton.sites) {
        site.at_m = q * site.at_m + shift;
        site.along = q * site.along;
        site.out = q * site.out;
    }
}

constexpr std::size_t kFewestEnds = 60;  // of a tree that lives

// Several stems lean away from one another.
TreeSkeleton grow_stems(const Form& f, base::Seed seed) {
    if (kind(f.habit).grower == Grower::SelfOrganised) {
        TreeSkeleton all = grow_organised(f, seed);
        crowd(all, f, seed.child("crowding"));
        // Where wind and hunger killed it, it grows once more where it has less of both.
        Form kinder = f;
        for (int again = 0; all.sites.size() < kFewestEnds && again < 4; ++again) {
            kinder.wind_crown *= 0.5F;
            kinder.wind_lean *= 0.5F;
            kinder.shade_bearing = 0.5F * (1 + kinder.shade_bearing);
            all = grow_organised(kinder, seed);
            crowd(all, kinder, seed.child("crowding"));
        }
        set_leaves_by_light(all, 2 * f.shade_bearing - 1);
        return all;
    }
    TreeSkeleton all;
    for (int i = 0; i < f.stems; ++i) {
        base::RandomStream random{seed.child("stem").child(static_cast<std::uint64_t>(i))};
        TreeSkeleton one = grow_stem(f, f.stems == 1 ? seed : seed.child(static_cast<std::uint64_t>(i)));
        if (one.limbs.empty()) continue;
        crowd(one, f, seed.child("crowding"));
        const float unit = 1.0F / std::max(one.high_m.y, 1.0e-3F);
        stretch(one, glm::vec3{unit}, unit);
        if (kind(f.habit).has_boughs) {
            shed_shaded(one, 1.7F * (0.5F - f.shade_bearing));
            set_leaves_by_light(one, 2 * f.shade_bearing - 1);
        }
        const float bearing = kGoldenAngle_rad * static_cast<float>(i) + random.between(0, 6.28F);
        const float own_lean_deg = f.lean_deg * random.between(0.3F, 1.0F);
        const float lean_deg = own_lean_deg + (f.stems > 1 ? random.between(7, 15) : 0.0F);
        const glm::vec3 axis{std::cos(bearing), 0, std::sin(bearing)};
        const float apart = f.stems > 1 ? 0.018F : 0.0F;
        if (f.stems > 1) stretch(one, glm::vec3{i == 0 ? 1.0F : random.between(0.72F, 0.98F)}, 1);
        turn(one, glm::angleAxis(glm::radians(lean_deg), axis), apart * glm::vec3{-axis.z, 0, axis.x});
        append(all, std::move(one));
    }
    measure(all);
    return all;
}

// Roots that run out into the ground; with meta-tubes they join the trunk smoothly.
void add_roots(TreeSkeleton& skeleton, const Form& f, base::Seed seed) {
    if (f.root_flare < 0.12F || !kind(f.habit).has_boughs) return;
    const std::size_t stems = skeleton.limbs.size();
    for (std::size_t s = 0; s < stems; ++s) {
        if (skeleton.limbs[s].parent >= 0) continue;
        const Limb::Node foot = skeleton.limbs[s].nodes.front();
        const float r = foot.radius_m;
        const int count = f.stems > 1 ? 3 : 5;
        for (int i = 0; i < count; ++i) {
            base::RandomStream random{seed.child(s).child(static_cast<std::uint64_t>(i))};
            const float bearing =
                6.2831853F * (static_cast<float>(i) + random.between(-0.3F, 0.3F)) / static_cast<float>(count);
            const glm::vec3 out{std::cos(bearing), 0, std::sin(bearing)};
            const float reach = (1.2F + 1.6F * f.root_flare) * random.between(0.8F, 1.25F);
            Limb root;
            root.order = 1;
            root.parent = static_cast<int>(s);
            const float up = 1.1F + 0.7F * f.root_flare;
            root.nodes = {{foot.at_m + r * (0.35F * out + glm::vec3{0, up, 0}), 0.52F * r, 0, 0},
                          {foot.at_m + r * (0.95F * out + glm::vec3{0, 0.45F * up, 0}), 0.44F * r, 0, 0},
                          {foot.at_m + r * (reach * out + glm::vec3{0, 0.02F, 0}), 0.34F * r, 0, 0},
                          {foot.at_m + r * (1.5F * reach * out - glm::vec3{0, 0.45F, 0}), 0.22F * r, 0, 0}};
            skeleton.limbs.push_back(std::move(root));
        }
    }
}

// From a plant of any size to a tree in metres, with what wind, weight and ground make of it.
TreeSkeleton finished(TreeSkeleton skeleton, const Form& f, base::Seed seed) {
    const Kind& k = kind(f.habit);
    const float size = f.height_m / std::max(skeleton.high_m.y, 0.2F);
    const float wide = k.has_boughs ? f.crown_width : 1;
    stretch(skeleton, {size * wide, size, size * wide}, size * f.girth);
    if (!k.keeps_radii) {
        PipeModel pipes;
        pipes.exponent = f.taper;
        pipes.trunk_radius_m = k.trunk * f.girth * f.height_m / std::sqrt(static_cast<float>(f.stems));
        pipes.least_radius_m = 0.0011F * f.height_m;
        set_pipe_radii(skeleton, pipes);
    }
    measure(skeleton);
    const float from = glm::radians(f.wind_from_deg);
    const glm::vec3 upwind{std::sin(from), 0, -std::cos(from)};  // clockwise from north, which is -z
    if (k.has_boughs) face_wind(skeleton, -f.wind_crown * upwind, seed.child("breaks"));
    base::RandomStream random{seed.child("light")};
    const float bearing = random.between(0, 6.2831853F);
    constexpr float kMostLean = 0.6F;  // beyond it a crown lies beside its stem
    Forces forces;
    forces.sag = k.sags ? f.sag : 0;
    forces.straightening = f.straightening;
    forces.wind = -kMostLean * f.wind_lean * upwind;
    forces.light = f.light_seeking * glm::normalize(glm::vec3{0.6F * std::cos(bearing), 1, 0.6F * std::sin(bearing)});
    bend(skeleton, forces);
    keep_above_ground(skeleton, 0.035F * f.height_m);
    std::vector<Site> left;
    for (std::size_t i = 0; i < skeleton.sites.size(); ++i)
        if (base::unit_of(base::hash_of(seed, static_cast<std::int64_t>(i), 17)) >= f.bareness)
            left.push_back(skeleton.sites[i]);
    skeleton.sites = std::move(left);
    add_roots(skeleton, f, seed.child("roots"));
    measure(skeleton);
    return skeleton;
}

}  // namespace

TreeSkeleton grow_skeleton(const Form& f, base::Seed seed) { return finished(grow_stems(f, seed), f, seed); }

bool grows_in_stands(const Form& f) { return kind(f.habit).grower == Grower::SelfOrganised; }

StandSkeletons grow_stand_skeletons(const Form& f, base::Seed seed) {
    Form one = f;
    one.stems = 1;
    // They shelter one another, and one at the edge is turned to where it is open.
    one.wind_crown = one.wind_lean = 0;
    one.height_m *= kCloseHeight;
    one.girth *= kCloseGirth;
    StandOfTwo two = grow_organised_stand(one, seed);
    return {finished(std::move(two.middle), one, seed.child("middle")),
            finished(std::move(two.edge), one, seed.child("edge"))};
}

}  // namespace quadrat::synthesis::trees
