// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/gardens.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string_view>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/lanes.hpp"
#include "synthesis/trees/phyllotaxis.hpp"

namespace quadrat::synthesis {
namespace {

using scene::Bedded;

constexpr std::size_t kMostGardens = 48;
constexpr float kOrchardsSeen_m = 260;
constexpr float kBedsSeen_m = 75;
constexpr float kClippedSeen_m = 180;
constexpr float kClipped_m = 1.8F;  // of clipped trees, in the mean; how high they are is the flora's to say
constexpr float kOffWalls_m = 0.8F;
constexpr float kOffLanes_m = 0.9F;
constexpr float kBetweenTrees_m = 4.4F;
constexpr float kBetweenRows_m = 1.05F;
constexpr float kInRow_m = 0.6F;
constexpr int kFlowers = 30;        // of a bed,
constexpr float kFloret_m = 0.23F;  // so far from each other

class Gardener {
  public:
    Gardener(const scene::Land& land, const scene::House& house, base::Seed seed)
        : land_(land), house_(house), half_m_(land.settlement.buildings[house.building].half_m), random_(seed) {}

    void plant(float gardens, std::vector<scene::GardenPlant>& to) {
        const float side = random_.unit_f() < 0.5F ? -1.0F : 1.0F;
        if (random_.unit_f() < 0.1F + 0.6F * gardens) plant_orchard(side, to);
        if (random_.unit_f() < 0.15F + 0.7F * gardens) plant_rows(-side, to);
        if (random_.unit_f() < 0.2F + 0.75F * gardens) plant_bed(side, to);
        if (random_.unit_f() < 0.5F * gardens) plant_bushes(-side, to);
        if (random_.unit_f() < 0.2F + 0.8F * gardens) plant_topiary(to);
    }

  private:
    // From the house's middle: x to its right seen from the street, z toward it.
    glm::vec2 place(float x, float z) const {
        const glm::vec3 p = scene::placed(house_, {x, 0, z});
        return {p.x, p.z};
    }

    void add(glm::vec2 at, Bedded what, float height_m, std::vector<scene::GardenPlant>& to) const {
        if (!is_free(at, what == Bedded::FruitTree ? 1.2F : 0.0F)) return;
        to.push_back({at, what, height_m});
    }

    void plant_orchard(float side, std::vector<scene::GardenPlant>& to) {
        const int rows = 2 + static_cast<int>(random_.below(2));
        const int columns = 2 + static_cast<int>(random_.below(3));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                const float x = side * kBetweenTrees_m * (static_cast<float>(column) - 0.3F);
                const float z = -half_m_.y - 3.4F - kBetweenTrees_m * static_cast<float>(row);
                const glm::vec2 astray{random_.between(-0.3F, 0.3F), random_.between(-0.3F, 0.3F)};
                add(place(x, z) + astray, Bedded::FruitTree, random_.between(3.0F, 4.6F), to);
            }
    }

    void plant_rows(float side, std::vector<scene::GardenPlant>& to) {
        const int rows = 3 + static_cast<int>(random_.below(3));
        for (int row = 0; row < rows; ++row) {
            const float height_m = random_.between(0.25F, 0.5F);
            const bool is_bush = random_.unit_f() < 0.25F;
            const float x = side * (1.2F + kBetweenRows_m * static_cast<float>(row));
            const int many = is_bush ? 4 : 8;
            for (int i = 0; i < many; ++i) {
                const float z = -half_m_.y - 1.6F - (is_bush ? 2 : 1) * kInRow_m * static_cast<float>(i);
                add(place(x, z), is_bush ? Bedded::Bush : Bedded::Vegetable, is_bush ? 0.8F : height_m, to);
            }
        }
    }

    void plant_bed(float side, std::vector<scene::GardenPlant>& to) {
        const float reach_m = kFloret_m * std::sqrt(static_cast<float>(kFlowers));
        const glm::vec2 middle = place(side * (half_m_.x + 0.4F + reach_m), half_m_.y - reach_m);
        for (int n = 1; n <= kFlowers; ++n)
            add(middle + trees::floret(n, kFloret_m), Bedded::Flower, random_.between(0.3F, 0.55F), to);
    }

    void plant_bushes(float side, std::vector<scene::GardenPlant>& to) {
        for (float z = -half_m_.y + 0.8F; z < half_m_.y - 0.8F; z += 1.7F)
            add(place(side * (half_m_.x + 1.3F), z), Bedded::Bush, random_.between(0.7F, 1.3F), to);
    }

    // In pairs along the way to the door.
    void plant_topiary(std::vector<scene::GardenPlant>& to) {
        const float height_m = random_.between(1.3F, 2.3F);
        const int pairs = 1 + static_cast<int>(random_.below(3));
        for (int i = 0; i < pairs; ++i)
            for (const float side : {-1.0F, 1.0F})
                add(place(1.7F * side, half_m_.y + 1.3F + 2.2F * static_cast<float>(i)), Bedded::Topiary, height_m, to);
    }

    bool is_free(glm::vec2 at, float room_m) const {
        if (!houses::is_buildable(land_, at)) return false;
        for (const scene::House& other : land_.settlement.houses) {
            const glm::vec2 off = at - glm::vec2{other.foot_m.x, other.foot_m.z};
            if (glm::dot(off, off) > 900) continue;
            if (scene::to_house_m(land_.settlement.buildings[other.building], other, at) < kOffWalls_m + room_m)
                return false;
        }
        for (const scene::Road& road : land_.roads)
            for (std::size_t i = 0; i + 1 < road.line_m.size(); ++i) {
                const glm::vec2 a{road.line_m[i].x, road.line_m[i].z};
                if (glm::distance(a, at) > 24) continue;
                const glm::vec2 d = glm::vec2{road.line_m[i + 1].x, road.line_m[i + 1].z} - a;
                const float t = std::clamp(glm::dot(at - a, d) / std::max(glm::dot(d, d), 1.0e-6F), 0.0F, 1.0F);
                if (glm::distance(at, a + t * d) < 0.5F * road.width_m + kOffLanes_m + room_m) return false;
            }
        return true;
    }

    const scene::Land& land_;
    const scene::House& house_;
    glm::vec2 half_m_;
    base::RandomStream random_;
};

}  // namespace

std::vector<scene::GardenPlant> lay_gardens(const scene::Land& land, const scene::LandParameters& parameters,
                                            base::Seed seed) {
    std::vector<scene::GardenPlant> plants;
    const scene::Settlement& settlement = land.settlement;
    const std::size_t count = std::min(kMostGardens, settlement.houses.size());
    for (std::size_t i = 0; i < count; ++i) {
        base::RandomStream random{seed.child(i)};
        if (random.unit_f() > 0.15F + parameters.settle_gardens) continue;
        std::vector<scene::GardenPlant> own;
        Gardener(land, settlement.houses[i], seed.child(i).child("plants")).plant(parameters.settle_gardens, own);
        // Two orchards back to back are one, with its trees apart.
        for (const scene::GardenPlant& plant : own) {
            const float apart_m = plant.what == Bedded::FruitTree ? 3.2F : 0.15F;
            const bool has_room = std::none_of(plants.begin(), plants.end(), [&](const scene::GardenPlant& other) {
                return glm::distance(other.at_m, plant.at_m) < apart_m;
            });
            if (has_room) plants.push_back(plant);
        }
    }
    return plants;
}

std::size_t kind_for(const scene::Flora& flora, Bedded what) {
    const std::size_t none = flora.species.size();
    const auto first_named = [&](std::string_view name) {
        for (std::size_t i = 0; i < none; ++i)
            if (flora.species[i].name == name) return i;
        return none;
    };
    const auto best_of = [&](scene::Storey storey, const auto& wish) {
        std::size_t best = none;
        for (std::size_t i = 0; i < none; ++i)
            if (flora.species[i].storey == storey &&
                (best == none || wish(flora.species[i]) > wish(flora.species[best])))
                best = i;
        return best;
    };
    if (what == Bedded::FruitTree)  // the roundest crown
        return best_of(scene::Storey::Tree, [](const scene::Species& s) { return s.crown_radius_m / s.height_m; });
    if (what == Bedded::Bush) return best_of(scene::Storey::Shrub, [](const scene::Species& s) { return s.share; });
    if (what == Bedded::Topiary) return first_named("topiary");
    const std::size_t named = first_named(what == Bedded::Flower ? "flower" : "fern");
    if (named < none) return named;
    return best_of(scene::Storey::Herb, [](const scene::Species& s) { return -s.height_m; });
}

Gardened gardens_in_sight(const scene::Land& land, const scene::Flora& flora, const Sight& sight,
                          const GardenBudget& budget) {
    Gardened seen;
    const auto add = [](std::vector<Candidate>& to, const Candidate& c, std::size_t most) {
        if (to.size() < most) to.push_back(c);
    };
    for (const scene::GardenPlant& plant : land.settlement.gardens) {
        const std::size_t kind = kind_for(flora, plant.what);
        const View view = sight.view_of(plant.at_m);
        const bool is_tree = plant.what == Bedded::FruitTree;
        if (kind >= flora.species.size() || view.along_m <= 0) continue;
        const bool is_clipped = plant.what == Bedded::Topiary;
        if (view.to_way_m > (is_tree ? kOrchardsSeen_m : is_clipped ? kClippedSeen_m : kBedsSeen_m)) continue;
        if (sight.is_in_the_way(plant.at_m, is_tree ? 2.0F : 0.3F)) continue;
        Candidate c;
        c.at_m = plant.at_m;
        c.mark = 0;
        c.species = static_cast<std::uint32_t>(kind);
        c.scale = plant.height_m / (is_clipped ? kClipped_m : std::max(flora.species[kind].height_m, 0.05F));
        if (is_tree)
            add(seen.trees, c, budget.trees);
        else if (plant.what == Bedded::Bush || is_clipped)
            add(seen.shrubs, c, budget.undergrowth / 5);
        else
            add(seen.herbs, c, budget.undergrowth);
    }
    return seen;
}

void make_way(std::vector<Candidate>& wild, const std::vector<Candidate>& planted, float room_m) {
    if (planted.empty()) return;
    std::vector<Candidate> rest;
    for (const Candidate& c : planted) {
        const bool is_taken = std::any_of(wild.begin(), wild.end(), [&](const Candidate& other) {
            return other.mark <= 0 && glm::distance(other.at_m, c.at_m) < room_m;
        });
        if (!is_taken) rest.push_back(c);
    }
    std::erase_if(wild, [&](const Candidate& c) {
        return c.mark > 0 && std::any_of(rest.begin(), rest.end(),
                                         [&](const Candidate& p) { return glm::distance(p.at_m, c.at_m) < room_m; });
    });
    wild.insert(wild.end(), rest.begin(), rest.end());
}

}  // namespace quadrat::synthesis
