// SPDX-License-Identifier: Apache-2.0
// Archetypes of one aspect, each with the same of the other two, to be looked at:
//     archetype_sheet ASPECT FIRST COUNT FILE.png [NAME=VALUE …]    by their order in app/breeding/archetypes
//     archetype_sheet ASPECT - FILE.png PART [NAME=VALUE …]         those whose name has this part
// Columns are three; the name stands over each; a line for each says its values and what it breaks.
#include <fmt/core.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "breeding/words/described_scene.hpp"
#include "pictures/picture.hpp"
#include "pictures/weather.hpp"
#include "stage/easel.hpp"
#include "support/values.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::tests;

constexpr int kWidth = 480;
// What the other two aspects are: nothing that draws the eye.
constexpr genome::PerAspect<const char*> kOthers{{"old limes", "rolling meadow", "crisp autumn day"}};

void take(genome::Recipe& recipe, const breeding::DescribedScene& scene) {
    for (const genome::ParameterId id : parameters_of(scene.aspect, genome::Genome::Full))
        recipe.values.set(id, scene.values[id]);
}

genome::Recipe recipe_of(const breeding::DescribedScene& scene, const Values& extra) {
    genome::Recipe recipe;
    for (const genome::Aspect aspect : genome::kAspects) {
        recipe.seeds[aspect] = base::Seed{4}.child(name_of(aspect));
        for (const breeding::DescribedScene& other : breeding::archetypes(aspect))
            if (other.name == kOthers[aspect]) take(recipe, other);
    }
    take(recipe, scene);
    recipe.seeds[scene.aspect] = base::Seed{4}.child(scene.name);
    recipe.flight = base::Seed{4}.child("flight");
    set_all(recipe, extra);
    return recipe;
}

pictures::SheetEntry drawn(stage::Easel& easel, const breeding::DescribedScene& scene, const Values& extra) {
    pictures::Picture picture;
    picture.scenes = {recipe_of(scene, extra)};
    picture.width = 2 * kWidth;
    picture.height = 540;
    picture.seconds = 12;
    const mesh::Image image = easel.draw(picture);
    const ValueRange values = values_of(image);
    fmt::print("{:32} range {:.2f}  p95 {:.2f}  mean {:.2f}  flat {:.2f}\n", scene.name, values.range(), values.light,
               values.mean, flat_share(image));
    return {pictures::scaled_to(image, kWidth), scene.name};
}

}  // namespace

int main(int argc, char** argv) {
    Values extra;
    const std::vector<std::string> rest = without_values(argc, argv, extra);
    const auto aspect = rest.size() == 4 ? genome::aspect_named(rest[0]) : std::nullopt;
    if (!aspect) {
        fmt::print(stderr, "usage: archetype_sheet trees|land|sky FIRST COUNT FILE.png, or - FILE.png PART\n");
        return 2;
    }
    try {
        stage::Easel easel(2 * kWidth, 540);
        std::vector<pictures::SheetEntry> entries;
        const auto& all = breeding::archetypes(*aspect);
        const bool is_by_name = rest[1] == "-";
        const std::size_t first = is_by_name ? 0 : std::strtoull(rest[1].c_str(), nullptr, 10);
        const std::size_t count = is_by_name ? all.size() : std::strtoull(rest[2].c_str(), nullptr, 10);
        for (std::size_t i = first; i < std::min(first + count, all.size()); ++i)
            if (!is_by_name || all[i].name.find(rest[3]) != std::string::npos)
                entries.push_back(drawn(easel, all[i], extra));
        pictures::write_image(is_by_name ? rest[2] : rest[3], pictures::contact_sheet(entries, 3, kWidth));
    } catch (const std::exception& error) {
        fmt::print(stderr, "archetype_sheet: {}\n", error.what());
        return 2;
    }
    return 0;
}
