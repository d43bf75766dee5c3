// SPDX-License-Identifier: Apache-2.0
// One landscape with a settlement, full size, to be looked at:
//     settled_sheet LAND TREES SKY FILE.png [NAME=VALUE …]      by the names of archetypes; by.side=WIDTH,
//     by.height=HEIGHT,
//         by.seed=N, by.seconds=N, by.over=M and by.away=M: from so far south of the settlement and so high over it;
//         by.bearing=DEGREES: rather from there than from the south; by.last=N: of what stands about it, the N-th from
//         the end instead: bridges and fords are last; by.clipped=N: the N-th of the clipped trees, from 1
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <vector>

#include "breeding/words/described_scene.hpp"
#include "pictures/image_file.hpp"
#include "pictures/picture.hpp"
#include "pictures/weather.hpp"
#include "scene/land_parameters.hpp"
#include "stage/easel.hpp"
#include "synthesis/grow.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::tests;

void take(genome::Recipe& recipe, genome::Aspect aspect, const std::string& name) {
    for (const breeding::DescribedScene& scene : breeding::archetypes(aspect)) {
        if (scene.name != name) continue;
        for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full))
            recipe.values.set(id, scene.values[id]);
        return;
    }
    fmt::print(stderr, "no archetype is called \"{}\"\n", name);
    std::exit(2);
}

float taken(Values& values, const char* name, float otherwise) {
    const auto found = values.find(name);
    if (found == values.end()) return otherwise;
    const float value = found->second;
    values.erase(found);
    return value;
}

struct Stand {
    float away_m = 0, over_m = 12, bearing_deg = 0;
    std::size_t last = 0;
    std::size_t clipped = 0;
};

glm::vec3 middle_of(const scene::Land& land, const Stand& stand) {
    const scene::Settlement& settlement = land.settlement;
    const std::size_t last = stand.last;
    glm::vec3 middle{0};
    std::size_t clipped = 0;
    for (const scene::GardenPlant& plant : settlement.gardens)
        if (plant.what == scene::Bedded::Topiary && ++clipped == stand.clipped)
            return {plant.at_m.x, scene::ground_height_m(land, plant.at_m) - 2, plant.at_m.y};
    if (last > 0 && last <= settlement.bounds.size()) {
        const std::vector<glm::vec3>& places = settlement.bounds[settlement.bounds.size() - last].mesh.positions_m;
        for (const glm::vec3& at : places) middle += at / static_cast<float>(places.size());
        return middle;
    }
    for (const scene::House& house : settlement.houses)
        middle += house.foot_m / static_cast<float>(settlement.houses.size());
    return middle;
}

scene::Camera camera_by(const scene::Land& land, const Stand& stand) {
    const glm::vec3 middle = middle_of(land, stand);
    const float turn = stand.bearing_deg * 0.0174533F;
    glm::vec3 eye = middle + stand.away_m * glm::vec3{-std::sin(turn), 0, std::cos(turn)};
    eye.y = std::max({scene::ground_height_m(land, {eye.x, eye.z}) + 1.7F, 2.5F, middle.y + stand.over_m});
    return {eye, middle + glm::vec3{0, stand.last > 0 ? 0.0F : 3.0F, 0}, 42};
}

}  // namespace

int main(int argc, char** argv) {
    Values extra;
    const std::vector<std::string> rest = without_values(argc, argv, extra);
    if (rest.size() != 4) {
        fmt::print(stderr, "usage: settled_sheet LAND TREES SKY FILE.png [NAME=VALUE …]\n");
        return 2;
    }
    pictures::Picture picture;
    picture.width = static_cast<int>(taken(extra, "by.side", 1920));
    picture.height = static_cast<int>(taken(extra, "by.height", 1080));
    picture.seconds = taken(extra, "by.seconds", 12);
    const base::Seed seed{static_cast<std::uint64_t>(taken(extra, "by.seed", 4))};
    const Stand stand{taken(extra, "by.away", 0), taken(extra, "by.over", 12), taken(extra, "by.bearing", 0),
                      static_cast<std::size_t>(taken(extra, "by.last", 0)),
                      static_cast<std::size_t>(taken(extra, "by.clipped", 0))};
    genome::Recipe recipe;
    take(recipe, genome::Aspect::Land, rest[0]);
    take(recipe, genome::Aspect::Trees, rest[1]);
    take(recipe, genome::Aspect::Sky, rest[2]);
    for (const genome::Aspect aspect : genome::kAspects) recipe.seeds[aspect] = seed.child(name_of(aspect));
    recipe.flight = seed.child("flight");
    set_all(recipe, extra);
    const scene::Land land =
        synthesis::grow_land(scene::realise_land(recipe.values), recipe.seeds[genome::Aspect::Land]);
    fmt::print("{} houses, {} triangles, {} bounds\n", land.settlement.houses.size(), land.settlement.triangles(),
               land.settlement.bounds.size());
    picture.scenes = {recipe};
    if (stand.away_m > 0 && !land.settlement.is_empty()) picture.camera = camera_by(land, stand);
    stage::Easel easel(picture.width, picture.height);
    pictures::write_picture(rest[3], easel.draw(picture), to_json(picture));
    return 0;
}
