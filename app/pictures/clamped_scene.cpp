// SPDX-License-Identifier: Apache-2.0
#include "pictures/clamped_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text_file.hpp"
#include "pictures/image_file.hpp"

namespace quadrat::pictures {
namespace {

using nlohmann::ordered_json;

void clamp_parameters(ordered_json& scene, const std::string& source) {
    if (!scene.is_object() || !scene.contains("parameters") || !scene["parameters"].is_object()) return;
    for (auto& [name, value] : scene["parameters"].items()) {
        const auto id = genome::parameter_named(name);
        if (!id || !value.is_number()) continue;
        const genome::Parameter& p = genome::parameter(*id);
        const double wished = value.get<double>();
        const double had = std::clamp(wished, static_cast<double>(p.min), static_cast<double>(p.max));
        if (had == wished) continue;
        base::log::warn("{}: {} is {}, which no scene can have; taken as {}", source, name, wished, had);
        value = had;
    }
}

}  // namespace

Picture read_scene_clamped(const std::string& scene) {
    if (!std::filesystem::exists(scene)) return read_scene(scene);
    std::string bytes = base::read_file(scene);
    if (is_image_file(bytes)) return read_scene(scene);
    ordered_json json =
        ordered_json::parse(base::text_from(std::move(bytes), scene, base::kJsonLimits), nullptr, false);
    if (!json.is_object()) return read_scene(scene);  // its reader says what is wrong
    clamp_parameters(json, scene);
    if (json.contains("scenes") && json["scenes"].is_array())
        for (ordered_json& one : json["scenes"]) clamp_parameters(one, scene);
    return picture_from_json(json.dump(), scene);
}

}  // namespace quadrat::pictures
