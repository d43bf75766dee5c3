// SPDX-License-Identifier: Apache-2.0
// A contact sheet of every kind of tree at three ages and four levels of detail, to be looked at:
//     species_sheet OUT.png [SEED] [habits=N,N,…] [columns=N] [zoom=N] [PARAMETER=VALUE …] [size=WxH]
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "genome/parameter_ids.hpp"
#include "pictures/picture.hpp"
#include "scene/parameters.hpp"
#include "stage/easel.hpp"
#include "synthesis/compose/light.hpp"
#include "synthesis/compose/openness.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/trees/form.hpp"

namespace {

using namespace quadrat;

std::shared_ptr<scene::Land> lawn() {
    auto land = std::make_shared<scene::Land>();
    land->cell_m = 2;
    land->height_m = mesh::Field(129, 129, 2.0F);
    land->surround_cell_m = 64;
    land->surround_m = mesh::Field(129, 129, 1.0F);
    mesh::Image grass(64, 64, 4);
    for (std::size_t i = 0; i < grass.bytes.size(); i += 4) {
        grass.bytes[i] = 132;
        grass.bytes[i + 1] = 150;
        grass.bytes[i + 2] = 84;
        grass.bytes[i + 3] = 0;
    }
    land->albedo = scene::GroundColours(grass);
    land->detail = mesh::Image(16, 16, 1);
    for (auto& byte : land->detail.bytes) byte = 128;
    land->far_colour = {0.2F, 0.26F, 0.1F};
    return land;
}

std::shared_ptr<const scene::Scene> stand_alone(const genome::ParameterValues& values, base::Seed seed,
                                                std::uint32_t form) {
    auto made = std::make_shared<scene::Scene>();
    const scene::SceneParameters p = scene::realise(values);
    auto flora = std::make_shared<scene::Flora>(synthesis::grow_trees(p.trees, seed));
    made->land = lawn();
    made->sky = std::make_shared<scene::Sky>(synthesis::grow_sky(p.sky, base::Seed{4}));
    scene::Plant plant;
    plant.root_m = {0, 2, 0};
    plant.species = form;
    made->plants.push_back(plant);
    made->flora = flora;
    const synthesis::LandShadow shadow(*made->land, made->sky->sun_direction);
    made->light = synthesis::bake_light(*made->land, synthesis::openness_of(*made->land), *made->sky, *flora,
                                        made->plants, shadow, 256);
    return made;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    genome::ParameterValues values;
    values.set(genome::ParameterId::sun_azimuth_deg, 215);
    values.set(genome::ParameterId::sun_elevation_deg, 38);
    std::uint64_t seed = 1;
    std::string only;  // ",2,5,": these habits, grown, at their finest
    int columns = 12;
    float zoom = 1;  // onto the trunk's middle
    int width = 360;
    int height = 400;
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i];
        const auto equals = word.find('=');
        if (equals == std::string::npos) {
            seed = std::strtoull(word.c_str(), nullptr, 10);
        } else if (word.starts_with("habits=")) {
            only = fmt::format(",{},", word.substr(7));
        } else if (word.starts_with("zoom=")) {
            zoom = std::strtof(word.c_str() + 5, nullptr);
        } else if (word.starts_with("columns=")) {
            columns = std::atoi(word.c_str() + 8);
        } else if (word.starts_with("size=")) {
            width = std::atoi(word.c_str() + 5);
            height = std::atoi(word.c_str() + word.find('x') + 1);
        } else if (const auto id = genome::parameter_named(word.substr(0, equals))) {
            values.set(*id, std::strtof(word.c_str() + equals + 1, nullptr));
        } else {
            fmt::print(stderr, "species_sheet: {} is not a parameter\n", word.substr(0, equals));
            return 2;
        }
    }
    stage::Easel easel(width, height);
    std::vector<pictures::SheetEntry> entries;
    struct Shot {
        float growth, alpha;
    };
    constexpr Shot kShots[] = {{0.35F, 1}, {0.65F, 1}, {1, 8}, {1, 0.4F}, {1, 0.08F}, {1, 0.015F}};
    for (int habit = 0; habit < synthesis::trees::kind_count(); ++habit) {
        if (!only.empty() && only.find(fmt::format(",{},", habit)) == std::string::npos) continue;
        values.set(genome::ParameterId::tree_habit, static_cast<float>(habit));
        const auto alone = stand_alone(values, base::Seed{seed}, 0);
        std::vector<std::pair<int, const char*>> forms{{0, ""}};
        if (const int i = alone->flora->species.front().in_stand; i >= 0)
            forms.insert(forms.end(), {{i, ", in a stand"}, {i + 1, ", at its edge"}});
        for (const Shot& shot : kShots) {
            for (const auto& [form, where] : forms) {
                const auto scene =
                    form == 0 ? alone : stand_alone(values, base::Seed{seed}, static_cast<std::uint32_t>(form));
                const scene::Species& species = scene->flora->species[static_cast<std::size_t>(form)];
                if (!only.empty() && (shot.growth < 1 || shot.alpha < 1)) continue;
                pictures::Picture picture;
                picture.width = width;
                picture.height = height;
                picture.growth = shot.growth;
                picture.alpha = shot.alpha;
                const float h = species.height_m;
                const float reach = std::max(
                    1.1F * h, 2.3F * species.crown_radius_m * static_cast<float>(height) / static_cast<float>(width));
                picture.camera =
                    scene::Camera{{0.35F * reach, 2 + 0.30F * h, 1.36F * reach}, {0, 2 + 0.47F * h, 0}, 46};
                if (zoom > 1)
                    picture.camera =
                        scene::Camera{{0.3F * h / zoom, 2 + 0.18F * h, 1.5F * h / zoom}, {0, 2 + 0.16F * h, 0}, 46};
                entries.push_back({easel.draw(picture, {scene}), fmt::format("{}{} · age {} · alpha {}", species.name,
                                                                             where, shot.growth, shot.alpha)});
            }
        }
    }
    if (entries.size() == 1) {
        pictures::write_image(argv[1], entries.front().pixels);
        return 0;
    }
    pictures::write_image(argv[1], pictures::contact_sheet(entries, columns, width));
    return 0;
}
