// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/organised_form.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/trigonometric.hpp>

#include "synthesis/trees/phyllotaxis.hpp"

namespace quadrat::synthesis::trees {
namespace {

void move(TreeSkeleton& skeleton, const glm::vec3& by) {
    for (Limb& limb : skeleton.limbs)
        for (Limb::Node& node : limb.nodes) node.at_m += by;
    for (Site& site : skeleton.sites) site.at_m += by;
}

void to_height_1(TreeSkeleton& skeleton) {
    const float unit = 1 / std::max(skeleton.high_m.y, 1.0e-3F);
    stretch(skeleton, glm::vec3{unit}, unit);
    measure(skeleton);
}

// Stems of one root lean away from one another.
std::vector<Seedling> stems_of(const Form& f, base::Seed seed) {
    std::vector<Seedling> stems;
    for (int i = 0; i < f.stems; ++i) {
        base::RandomStream random{seed.child("stem").child(static_cast<std::uint64_t>(i))};
        const float bearing = kGoldenAngle_rad * static_cast<float>(i) + random.between(0, 6.2831853F);
        const glm::vec2 way{std::cos(bearing), std::sin(bearing)};
        const float lean_deg = f.lean_deg * random.between(0.3F, 1.0F) + (f.stems > 1 ? random.between(7, 15) : 0.0F);
        stems.push_back({(f.stems > 1 ? 0.5F : 0.0F) * way, std::tan(glm::radians(2 * lean_deg)) * way});
    }
    return stems;
}

}  // namespace

SelfOrganisation organisation_of(const Form& f) {
    const Form usual;  // there a kind grows as its file tells it
    SelfOrganisation o = kind(f.habit).growth;
    o.apical_young += 0.025F * f.leader;
    o.apical_old += 0.03F * f.leader;
    o.vigour *= 1 + 0.9F * (f.branch_contraction - usual.branch_contraction);
    o.shade.a *= std::pow(f.limb_density, -0.7F);
    o.shedding *= std::pow(f.limb_density, -0.5F);
    o.branch_angle_deg = std::clamp(o.branch_angle_deg * f.branch_angle_deg / usual.branch_angle_deg, 18.0F, 88.0F);
    if (o.laterals == 1) o.divergence_deg = f.divergence_deg;
    // Who bears shade keeps limbs alive by half of the light that others need.
    const float hunger = std::exp2(2.4F * (usual.shade_bearing - f.shade_bearing));
    o.shedding *= hunger;
    o.shade.far *= std::sqrt(hunger);
    const float from = glm::radians(f.wind_from_deg);
    o.upwind = f.wind_crown * glm::vec3{std::sin(from), 0, -std::cos(from)};
    o.light_seeking *= 0.7F + 1.5F * f.light_seeking;
    o.trunk_rise += 2 * (f.trunk_contraction - usual.trunk_contraction);
    o.limb_rise += 0.35F * (f.limb_rise - usual.limb_rise);
    o.gnarl *= 0.4F + 0.15F * f.gnarl_deg;
    const float bare = static_cast<float>(o.bare_internodes);
    o.bare_internodes = static_cast<int>(std::max(bare * (1 + f.clear_stem), 1.0F));
    if (f.stems > 1) o.most_buds /= static_cast<std::size_t>(f.stems);
    return o;
}

TreeSkeleton grow_organised(const Form& f, base::Seed seed) {
    const std::vector<Seedling> seedlings = stems_of(f, seed);
    std::vector<TreeSkeleton> stems = grow_together(organisation_of(f), seedlings, seed.child("stems"));
    for (std::size_t i = 0; i < stems.size(); ++i) move(stems[i], {seedlings[i].at.x, 0, seedlings[i].at.y});
    // The strongest is the trunk that others are measured by.
    std::ranges::stable_sort(stems, std::greater{}, [](const TreeSkeleton& stem) { return stem.limbs.size(); });
    TreeSkeleton all;
    for (TreeSkeleton& stem : stems) append(all, std::move(stem));
    measure(all);
    to_height_1(all);
    return all;
}

StandOfTwo grow_organised_stand(const Form& f, base::Seed seed) {
    const SelfOrganisation o = organisation_of(f);
    std::vector<TreeSkeleton> stand =
        grow_together(o, stand_of_seedlings(o.apart, seed.child("seedlings")), seed.child("stand"));
    constexpr std::size_t kMiddle = kStandSide * kStandSide / 2;
    StandOfTwo two{std::move(stand[kMiddle]), std::move(stand[kMiddle + kStandSide / 2])};
    to_height_1(two.middle);
    to_height_1(two.edge);
    return two;
}

}  // namespace quadrat::synthesis::trees
