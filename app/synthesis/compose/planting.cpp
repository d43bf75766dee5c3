// SPDX-License-Identifier: Apache-2.0
// Competition for room, light and water, after Deussen et al., "Realistic modeling and rendering of plant ecosystems"
// (SIGGRAPH 1998). Candidates on a jittered grid each draw a species by how well it would do there, a size and a mark;
// the old come before the young, then the better mark, and each stands where those before it leave it room (simple
// sequential inhibition). Herbs see what light the crowns leave. Every number hangs on the candidate's cell and the
// last pass runs in the order of the marks, so that threads do not matter.
#include "synthesis/compose/planting.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "synthesis/compose/clearing.hpp"
#include "synthesis/compose/competition.hpp"
#include "synthesis/compose/gardens.hpp"
#include "synthesis/compose/hero_place.hpp"
#include "synthesis/compose/kinds_of_plants.hpp"
#include "synthesis/compose/lookups.hpp"
#include "synthesis/compose/most_seen.hpp"
#include "synthesis/compose/neighbours.hpp"
#include "synthesis/compose/site.hpp"
#include "synthesis/compose/storeys.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kBare = 0.05F;  // of the years to an old forest
constexpr float kHalfGrown = 0.45F;
constexpr float kGiant = 0.95F;        // of the ranks about a giant's middle
constexpr float kWidestAside = 1.15F;  // of the view, that undergrowth is planted for
constexpr float kBuried = 0.94F;       // of herbs, where snow lies
constexpr float kRingsSeen_m = 45;
constexpr float kRingRoom_m = 0.4F;  // of a group of mushrooms

class Planter {
  public:
    Planter(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight, const scene::Track& track,
            const PlantingBudget& budget, base::Seed seed)
        : land_(land),
          track_(track),
          flora_(flora),
          half_m_(0.5F * land.side_m()),
          sight_(flight, half_m_),
          vistas_(land, flight),
          clearing_(land.settlement),
          ground_(land),
          budget_(budget),
          seed_(seed),
          kinds_(by_storey(flora)) {
        if (std::ranges::any_of(kinds_.trees, [&](std::uint32_t i) { return keeps_to_a_zone(flora.species[i]); }))
            zones_.emplace(land);
    }

    std::vector<scene::Plant> plant() {
        const Gardened gardens = gardens_in_sight(land_, flora_, sight_, {budget_.trees / 6, budget_.undergrowth / 5});
        std::vector<Candidate> trees;
        if (!kinds_.trees.empty()) {
            trees = grow_trees();
            const std::size_t set = gardens.trees.size() + 3;
            keep_most_seen(sight_, trees, budget_.trees - std::min(budget_.trees, set));
            frame_view(trees);
            set_hero(trees);
            make_way(trees, gardens.trees, kOrchardRoom_m);
            grow_among_neighbours(trees, flora_);
        }
        const Shade shade(flora_, trees, half_m_);
        const Near near(trees, half_m_);
        std::vector<Candidate> shrubs = grow_shrubs(near, shade);
        keep_most_seen(sight_, shrubs, budget_.undergrowth / 5);
        std::vector<Candidate> herbs = grow_herbs(near, shade);
        make_way(shrubs, gardens.shrubs, kBedRoom_m);
        keep_most_seen(sight_, herbs,
                       budget_.undergrowth - std::min(budget_.undergrowth, shrubs.size() + gardens.herbs.size()));
        make_way(herbs, gardens.herbs, kBedRoom_m);
        const std::vector<Candidate> rings = grow_rings(near);
        herbs.insert(herbs.end(), rings.begin(), rings.end());
        std::vector<scene::Plant> plants(trees.size() + shrubs.size() + herbs.size());
        std::size_t first = 0;
        for (const auto* storey : {&trees, &shrubs, &herbs}) {
            oneapi::tbb::parallel_for(std::size_t{0}, storey->size(),
                                      [&](std::size_t i) { plants[first + i] = plant_of((*storey)[i]); });
            first += storey->size();
        }
        std::stable_sort(plants.begin(), plants.end(),
                         [](const scene::Plant& a, const scene::Plant& b) { return a.species < b.species; });
        return plants;
    }

  private:
    scene::Plant plant_of(const Candidate& c) const {
        base::RandomStream random{
            base::Seed{base::hash_of(seed_, std::lround(c.at_m.x * 64), std::lround(c.at_m.y * 64))}};
        scene::Plant plant;
        plant.species = c.species;
        plant.root_m = {c.at_m.x, scene::ground_height_m(land_, c.at_m), c.at_m.y};
        plant.yaw_rad = random.between(0, glm::radians(360.0F) * flora_.species[c.species].turn);
        if (c.yaw_rad) plant.yaw_rad = *c.yaw_rad;
        plant.scale = c.scale;
        plant.tint = random.between(-1, 1);
        plant.delay = random.unit_f();
        return plant;
    }

    float crown_m(const Candidate& c) const { return flora_.species[c.species].crown_radius_m * c.scale; }
    float trunk_m(const Candidate& c) const { return flora_.species[c.species].trunk_radius_m * c.scale; }

    // On a rock little broader than its crown a tree is a parasol.
    bool overhangs(const Candidate& c) const {
        constexpr int kWays = 8;
        const float reach_m = 1.5F * crown_m(c);
        const float root_m = scene::ground_height_m(land_, c.at_m);
        int falling = 0;
        for (int i = 0; i < kWays; ++i) {
            const float turn = glm::radians(360.0F / kWays) * static_cast<float>(i);
            const glm::vec2 rim_m = c.at_m + reach_m * glm::vec2{std::cos(turn), std::sin(turn)};
            falling += scene::ground_height_m(land_, rim_m) < root_m - 0.8F * reach_m;
        }
        return falling > kWays / 2;
    }

    std::vector<Candidate> grow_trees() {
        const scene::Stand& stand = flora_.stand;
        const glm::vec2 low{-half_m_};
        const glm::vec2 high{half_m_};
        const NoiseMap groves(seed_.child("groves"), low, high, stand.grove_m, 3);
        const Glades clearings(stand, half_m_, seed_);
        const EvenMap giants(stand.giants, 0.8F * stand.grove_m, seed_.child("giants"));
        std::vector<NoiseMap> stands;
        for (const std::uint32_t kind : kinds_.trees)
            stands.emplace_back(seed_.child("stands").child(kind), low, high, 0.6F * stand.grove_m, 2);
        const StandAges ages(stand.fires, half_m_, seed_.child("fires"));
        const float cell_m = std::max(0.55F * flora_.spacing_m, 2.2F);
        // Wide spacing is open country: groves thin out with it.
        const float openness = std::clamp((flora_.spacing_m - 4.0F) / 18.0F, 0.0F, 1.0F);
        const float bare_below = stand.clearings < 0.01F ? -9.0F : quantile(stand.clearings);
        const auto draw = [&](Candidate& c, base::RandomStream& random) {
            if (!ground_.is_on_land(c.at_m) || clearings.at(c.at_m, groves) < bare_below) return;
            const float mark = random.unit_f();
            const float kind = random.unit_f();
            const float stay = random.unit_f();
            const float size = random.between(-1, 1);
            // Where it has burnt lately nothing stands, then saplings do, all of an age.
            const float age = ages.at(c.at_m);
            if (age < kBare) return;
            c.is_young = random.unit_f() < stand.young_share || age < kHalfGrown;
            const float grove = groves.at(c.at_m);
            const float density =
                std::clamp(0.62F - 0.25F * openness + 5.2F * stand.grove_contrast * grove, 0.03F, 1.0F);
            const float left = clearing_.left_at(c.at_m);
            if (stay > density * left || !ground_.is_free(c.at_m, 1.0F)) return;
            const Soil soil = ground_.soil(c.at_m);
            const Zone zone = zones_ ? zones_->at(c.at_m) : Zone{};
            float well = 0;
            // Kinds keep company: each has its own ground within a grove.
            c.species = choose_species(
                flora_, kinds_.trees, kind,
                [&](std::uint32_t i, std::size_t place) {
                    return welfare(flora_.species[i], soil) * std::exp2(7.0F * stands[place].at(c.at_m));
                },
                well, zones_ ? &zone : nullptr);
            if (stay > density * std::min(well * 2.0F, 1.0F)) return;
            c.scale = c.is_young && age >= kHalfGrown ? 0.46F + 0.16F * size : 1.0F + stand.size_spread * size;
            c.scale *= 0.24F + 0.76F * age;
            if (sight_.is_in_the_way(c.at_m, crown_m(c)) || vistas_.are_closed_by(c.at_m, crown_m(c))) return;
            if (overhangs(c)) return;
            c.mark = mark + (c.is_young ? 1.0F : 0.0F);
            if (giants.is_empty() || giants.at(c.at_m) < kGiant) return;
            c.scale = std::max(c.scale, 1.0F) * (1 + 0.7F * stand.giants);
            c.mark = 0.05F * mark;
        };
        const float reach_m = std::max(0.55F * flora_.spacing_m, 2.0F) + 4.0F;
        return compete(draw_candidates(
                           {-half_m_, -half_m_}, {half_m_, half_m_}, cell_m, seed_.child("trees"),
                           [](glm::vec2) { return true; }, draw),
                       reach_m, [&](const Candidate& a, const Candidate& b) { return apart_m(a, b); });
    }

    // The room that two trees leave each other. The more they thin themselves, the more room the old keep among each
    // other and the less they mind the young.
    float apart_m(const Candidate& a, const Candidate& b) const {
        const float thin = flora_.stand.self_thinning;
        const float trunks = 3.0F * (trunk_m(a) + trunk_m(b)) + 0.3F;
        const float crowns = crown_m(a) + crown_m(b);
        if (a.is_young != b.is_young)
            return std::max({trunks, (0.36F - 0.22F * thin) * crowns, (0.4F - 0.2F * thin) * flora_.spacing_m});
        if (a.is_young) return std::max({trunks, 0.42F * crowns, 0.32F * flora_.spacing_m});
        return std::max({trunks, (0.34F + 0.16F * thin) * crowns, 0.55F * flora_.spacing_m});
    }

    // Of a tree that is set for the picture's sake: the first species, but for the one whose zone this is.
    std::uint32_t species_at(glm::vec2 at_m) const {
        if (!zones_) return kinds_.trees.front();
        const Zone zone = zones_->at(at_m);
        const auto weight = [&](std::uint32_t i) { return flora_.species[i].share * at_home(flora_.species[i], zone); };
        return *std::ranges::max_element(kinds_.trees, {}, weight);
    }

    // A tree at each side of the picture, where the land allows it.
    void frame_view(std::vector<Candidate>& trees) const {
        const FlightPlan& flight = sight_.flight();
        const FlightPlan::Station& middle = flight.stations[flight.stations.size() / 2];
        const glm::vec2 aside{-middle.ahead.y, middle.ahead.x};
        for (const float side : {-1.0F, 1.0F}) {
            base::RandomStream random{seed_.child("frame").child(side > 0 ? 1U : 0U)};
            for (int attempt = 0; attempt < 24; ++attempt) {
                Candidate c;
                const float along_m = random.between(20.0F, 52.0F);
                const float wide_m = along_m * random.between(0.48F, 0.72F);
                const float aside_m = side * (wide_m + random.between(6.0F, 16.0F));
                c.at_m = middle.at_m + along_m * middle.ahead + aside_m * aside;
                c.scale = random.between(0.95F, 1.22F);
                c.species = species_at(c.at_m);
                c.mark = 0;
                const scene::Species& species = flora_.species[c.species];
                if (!ground_.is_on_land(c.at_m) || sight_.is_in_the_way(c.at_m, 0.8F * crown_m(c))) continue;
                if (vistas_.are_closed_by(c.at_m, 0.8F * crown_m(c))) continue;
                if (!ground_.is_free(c.at_m, 1.0F) || welfare(species, ground_.soil(c.at_m)) <= 0.2F) continue;
                const float apart = std::max(0.6F * crown_m(c), 2.5F);
                std::erase_if(trees, [&](const Candidate& t) {
                    return t.mark > 0 && glm::length(t.at_m - c.at_m) < std::max(apart + 2.0F, apart_m(t, c));
                });
                const bool has_room = std::ranges::none_of(
                    trees, [&](const Candidate& t) { return glm::length(t.at_m - c.at_m) < apart_m(t, c); });
                if (!has_room) continue;
                trees.push_back(c);
                break;
            }
        }
    }

    // One grown tree on a third of the picture as the flight begins, with room about it: what the eye comes to rest on.
    // Where its kind would not do well it is smaller, and where the ground is wet it stands on what is dry of it.
    void set_hero(std::vector<Candidate>& trees) const {
        base::RandomStream random{seed_.child("hero")};
        const float side = random.unit_f() < 0.5F ? -1.0F : 1.0F;
        constexpr std::array<HeroGround, 3> kGrounds{
            {{kShore_m, 0.2F, 1.25F}, {kShore_m, 0.02F, 1.0F}, {0.1F, 0, 0.9F}}};
        for (const HeroGround& asked : kGrounds) {
            for (int attempt = 0; attempt < 30; ++attempt) {
                const float turn = attempt < 15 ? side : -side;
                const std::optional<Candidate> c = hero(turn, asked.least_scale, random);
                if (!c || !is_hero_ground(*c, asked)) continue;
                std::erase_if(trees, [&](const Candidate& t) {
                    return glm::length(t.at_m - c->at_m) < 1.15F * crown_m(*c) + 0.6F * crown_m(t);
                });
                trees.push_back(*c);
                return set_beside(trees, *c, random);
            }
        }
    }

    // Two smaller ones of its kind beside a narrow one, which alone would be a post: one close by, one apart.
    void set_beside(std::vector<Candidate>& trees, const Candidate& hero, base::RandomStream& random) const {
        if (crown_m(hero) > 0.16F * flora_.species[hero.species].height_m * hero.scale) return;
        for (const float apart : {1.3F, 3.6F}) {
            Candidate c = hero;
            c.scale *= random.between(0.55F, 0.85F);
            const float turn = random.between(0, glm::radians(360.0F));
            c.at_m += (crown_m(hero) + apart * crown_m(c)) * glm::vec2{std::cos(turn), std::sin(turn)};
            if (!is_hero_ground(c, {0.1F, 0, 0})) continue;
            std::erase_if(trees, [&](const Candidate& t) {
                return t.mark > 0 && glm::length(t.at_m - c.at_m) < crown_m(c) + 0.5F * crown_m(t);
            });
            trees.push_back(c);
        }
    }

    struct HeroGround {
        float least_height_m, least_welfare, least_scale;
    };

    std::optional<Candidate> hero(float side, float least_scale, base::RandomStream& random) const {
        Candidate c;
        c.scale = least_scale * random.between(1.0F, 1.2F);
        c.species = kinds_.trees.front();
        c.mark = 0;
        const base::RandomStream place = random;
        const auto stand = [&] {
            random = place;
            const float high_m = flora_.species[c.species].height_m * c.scale;
            const auto at_m = hero_place(land_, sight_.flight(), track_, high_m, side, random);
            c.at_m = at_m.value_or(c.at_m);
            return at_m.has_value();
        };
        if (!stand()) return {};
        // What grows there may be of another height.
        c.species = species_at(c.at_m);
        return stand() ? std::optional(c) : std::nullopt;
    }

    bool is_hero_ground(const Candidate& c, const HeroGround& asked) const {
        if (!ground_.is_on_land(c.at_m) || !ground_.is_free(c.at_m, 1.5F, asked.least_height_m)) return false;
        if (asked.least_welfare > 0 && vistas_.are_closed_by(c.at_m, 0.8F * crown_m(c))) return false;
        const bool does_well =
            asked.least_welfare <= 0 || welfare(flora_.species[c.species], ground_.soil(c.at_m)) > asked.least_welfare;
        return does_well && std::ranges::none_of(sight_.flight().stations, [&](const FlightPlan::Station& station) {
                   return glm::length(station.at_m - c.at_m) < crown_m(c) + 6.0F;
               });
    }

    bool is_clear_of_trunks(std::span<const Candidate> trees, const Candidate& c) const {
        return std::ranges::none_of(trees, [&](const Candidate& tree) {
            const glm::vec2 d = tree.at_m - c.at_m;
            const float apart = 2.0F * trunk_m(tree) + 0.35F * crown_m(c);
            return glm::dot(d, d) < apart * apart;
        });
    }

    // Shrubs gather: along the edges of groves, in thickets, rarely alone.
    std::vector<Candidate> grow_shrubs(const Near& near, const Shade& shade) {
        if (kinds_.shrubs.empty()) return {};
        const float reach_m = budget_.reach_m * 3.75F;
        const auto [low, high] = sight_.window(reach_m);
        const Sight::Region region = sight_.region(kWidestAside, reach_m);
        const auto may = [&region](glm::vec2 at) { return region.may_hold(at); };
        const NoiseMap thickets(seed_.child("thickets"), low, high, 17, 3);
        const auto draw = [&](Candidate& c, base::RandomStream& random) {
            if (!ground_.is_on_land(c.at_m)) return;
            const View view = sight_.view_of(c.at_m);
            if (view.along_m < 1.0F || view.aside > kWidestAside || view.to_way_m > reach_m || view.to_way_m < 3.0F)
                return;
            const float mark = random.unit_f();
            const float kind = random.unit_f();
            const float stay = random.unit_f();
            const float size = random.unit_f();
            const float thicket = thickets.at(c.at_m);
            const float cover = shade.at(c.at_m);
            const float edge = 4.0F * cover * (1 - cover);  // the rim of a crown
            const float wish = std::clamp(7.0F * (thicket - 0.15F), 0.0F, 1.0F) + 0.13F * edge;
            if (stay > wish) return;
            if (!ground_.is_free(c.at_m, 0.5F)) return;
            const Soil soil = ground_.soil(c.at_m);
            float well = 0;
            c.species = choose_species(
                flora_, kinds_.shrubs, kind,
                [&](std::uint32_t i, std::size_t) { return welfare(flora_.species[i], soil); }, well);
            if (stay > wish * well * flora_.species[c.species].density * 1.4F) return;
            // Many small ones beside a few large, which stand in the midst of a thicket.
            c.scale = 0.38F + (0.55F + 0.55F * std::clamp(5.0F * (thicket - 0.2F), 0.0F, 1.0F)) * size * size * size;
            if (sight_.is_in_the_way(c.at_m, 0.2F * crown_m(c)) && view.to_way_m < 14.0F) return;
            c.mark = mark + 1.0F - std::min(c.scale, 1.0F);
        };
        std::vector<Candidate> shrubs =
            compete(draw_candidates(low, high, 1.9F, seed_.child("shrubs"), may, draw), 3.0F,
                    [&](const Candidate& a, const Candidate& b) { return 0.30F * (crown_m(a) + crown_m(b)); });
        std::erase_if(shrubs, [&](const Candidate& c) { return !is_clear_of_trunks(near.around(c.at_m), c); });
        return shrubs;
    }

    std::vector<Candidate> grow_herbs(const Near& near, const Shade& shade) {
        if (kinds_.herbs.empty()) return {};
        const auto [low, high] = sight_.window(budget_.reach_m);
        const Sight::Region region = sight_.region(kWidestAside, budget_.reach_m);
        const auto may = [&region](glm::vec2 at) { return region.may_hold(at); };
        std::vector<NoiseMap> patches;
        for (const std::uint32_t kind : kinds_.herbs)
            patches.emplace_back(seed_.child("patches").child(kind), low, high, flora_.stand.herb_patch_m, 2);
        const auto draw = [&](Candidate& c, base::RandomStream& random) {
            if (!ground_.is_on_land(c.at_m)) return;
            const View view = sight_.view_of(c.at_m);
            if (view.along_m < 1.0F || view.aside > kWidestAside || view.to_way_m > budget_.reach_m ||
                view.to_way_m < 2.2F)
                return;
            const float mark = random.unit_f();
            const float kind = random.unit_f();
            const float stay = random.unit_f();
            const float wish = 1.3F * std::clamp(1.0F - view.to_way_m / budget_.reach_m, 0.0F, 1.0F);
            if (stay > wish) return;
            c.scale = random.between(0.65F, 1.3F);
            if (!ground_.is_free(c.at_m, 0.1F)) return;
            const Soil soil = ground_.soil(c.at_m);
            const float cover = shade.at(c.at_m);
            float well = 0;
            c.species = choose_species(
                flora_, kinds_.herbs, kind,
                [&](std::uint32_t i, std::size_t place) {
                    const scene::Species& species = flora_.species[i];
                    const float own = patches[place].at(c.at_m);
                    const float light = std::clamp(1.0F + species.shade_liking * (2.0F * cover - 1.0F), 0.0F, 1.6F);
                    return welfare(species, soil) * light * species.density * std::exp2(8.0F * own) * 1.6F;
                },
                well);
            const float buried = kBuried * snow_at(land_, {c.at_m.x, soil.height_m, c.at_m.y});
            if (stay > wish * std::min(well, 1.0F) * (1 - buried)) return;
            c.mark = mark;
        };
        std::vector<Candidate> herbs =
            compete(draw_candidates(low, high, budget_.herb_m, seed_.child("herbs"), may, draw), 0.6F * budget_.herb_m,
                    [this](const Candidate&, const Candidate&) { return 0.5F * budget_.herb_m; });
        std::erase_if(herbs, [&](const Candidate& c) { return !is_clear_of_trunks(near.around(c.at_m), c); });
        return herbs;
    }

    // Mushrooms, where a fungus in the ground has got to.
    std::vector<Candidate> grow_rings(const Near& near) {
        const auto kind = std::ranges::find(flora_.species, std::string_view("mushroom"), &scene::Species::name);
        if (flora_.stand.rings <= 0 || kind == flora_.species.end()) return {};
        const float reach_m = std::min(budget_.reach_m, kRingsSeen_m);
        const auto [low, high] = sight_.window(reach_m);
        const Sight::Region region = sight_.region(kWidestAside, reach_m);
        const auto may = [&region](glm::vec2 at) { return region.may_hold(at); };
        const RingMap rings(seed_.child("rings"));
        const NoiseMap places(seed_.child("ring places"), low, high, 30, 2);
        const float least = quantile(1 - 0.9F * flora_.stand.rings);
        const auto draw = [&](Candidate& c, base::RandomStream& random) {
            if (!rings.has_any(c.at_m) || places.at(c.at_m) < least || !ground_.is_on_land(c.at_m)) return;
            const View view = sight_.view_of(c.at_m);
            if (view.along_m < 1.0F || view.aside > kWidestAside || view.to_way_m > reach_m) return;
            if (!ground_.is_free(c.at_m, 0.1F)) return;
            c.species = static_cast<std::uint32_t>(kind - flora_.species.begin());
            c.scale = random.between(0.7F, 1.4F);
            c.mark = random.unit_f();
        };
        std::vector<Candidate> found =
            compete(draw_candidates(low, high, kRingRoom_m, seed_.child("mushrooms"), may, draw), kRingRoom_m,
                    [](const Candidate&, const Candidate&) { return 0.6F * kRingRoom_m; });
        std::erase_if(found, [&](const Candidate& c) { return !is_clear_of_trunks(near.around(c.at_m), c); });
        keep_most_seen(sight_, found, budget_.undergrowth / 10);
        return found;
    }

    const scene::Land& land_;
    const scene::Track& track_;
    const scene::Flora& flora_;
    float half_m_;
    Sight sight_;
    Vistas vistas_;
    Clearing clearing_;
    Ground ground_;
    PlantingBudget budget_;
    base::Seed seed_;
    Storeyed kinds_;
    std::optional<Zones> zones_;  // where some tree keeps to one
};

}  // namespace

std::vector<scene::Plant> plant_land(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight,
                                     const scene::Track& track, base::Seed seed, const PlantingBudget& budget) {
    return Planter(land, flora, flight, track, budget, seed).plant();
}

}  // namespace quadrat::synthesis
