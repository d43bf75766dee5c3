// SPDX-License-Identifier: Apache-2.0
#include "pictures/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "breeding/seeded_scene.hpp"
#include "genome/scene_code.hpp"
#include "pictures/image_file.hpp"

namespace quadrat::pictures {
namespace {

using nlohmann::ordered_json;
constexpr int kVersion = 1;
constexpr int kLargestSide = 4096;

[[noreturn]] void refuse(const std::string& source, const std::string& what) {
    throw base::InputError(fmt::format("{}: {}", source, what));
}

ordered_json vector_json(const glm::vec3& v) { return {v.x, v.y, v.z}; }

float number_in(const ordered_json& object, const char* key, float low, float high, float standard,
                const std::string& source) {
    if (!object.contains(key)) return standard;
    const ordered_json& value = object[key];
    if (!value.is_number()) refuse(source, fmt::format("{} is not a number", key));
    const auto number = value.get<float>();
    if (!(number >= low && number <= high))
        refuse(source, fmt::format("{} is {}; it must lie between {} and {}", key, number, low, high));
    return number;
}

glm::vec3 vector_in(const ordered_json& object, const char* key, const std::string& source) {
    if (!object.contains(key) || !object[key].is_array() || object[key].size() != 3)
        refuse(source, fmt::format("camera.{} must be three numbers", key));
    glm::vec3 v{0};
    for (int i = 0; i < 3; ++i) {
        const ordered_json& number = object[key][static_cast<std::size_t>(i)];
        if (!number.is_number()) refuse(source, fmt::format("camera.{} must be three numbers", key));
        v[i] = number.get<float>();
    }
    return v;
}

std::optional<scene::Camera> camera_in(const ordered_json& object, const std::string& source) {
    if (!object.contains("camera")) return std::nullopt;
    const ordered_json& camera = object["camera"];
    if (!camera.is_object()) refuse(source, "camera must be an object with eye and target");
    return scene::Camera{vector_in(camera, "eye", source), vector_in(camera, "target", source),
                         number_in(camera, "fov_deg", 5, 120, scene::Camera{}.vertical_fov_deg, source)};
}

Picture picture_in(const ordered_json& object, const std::string& source) {
    if (object.value("version", 0) != kVersion)
        refuse(source, fmt::format("picture version {} is not the one this program reads, {}",
                                   object.contains("version") ? object["version"].dump() : "none", kVersion));
    Picture picture;
    if (!object.contains("scenes") || !object["scenes"].is_array() ||
        (object["scenes"].size() != 1 && object["scenes"].size() != genome::kCandidates))
        refuse(source, "scenes must be a list of one scene or four");
    for (const ordered_json& one : object["scenes"]) picture.scenes.push_back(genome::from_json(one.dump(), source));
    picture.width = static_cast<int>(number_in(object, "width", 16, kLargestSide, 1280, source));
    picture.height = static_cast<int>(number_in(object, "height", 16, kLargestSide, 720, source));
    picture.seconds = number_in(object, "seconds", 0, 1e6F, 0, source);
    picture.growth = number_in(object, "growth", 0, 1, 1, source);
    picture.alpha = number_in(object, "alpha", 0.01F, 100, 1, source);
    picture.scale = number_in(object, "scale", 0.25F, 1, 1, source);
    picture.land_samples = static_cast<int>(number_in(object, "land_samples", 65, 1025, 513, source));
    picture.samples = static_cast<int>(number_in(object, "samples", 1, 4, 1, source));
    if (picture.samples != 1 && picture.samples != 4)
        refuse(source, fmt::format("samples is {}; it must be 1 or 4", picture.samples));
    if (!std::has_single_bit(static_cast<unsigned>(picture.land_samples - 1)))
        refuse(source, fmt::format("land_samples is {}; it must be 65, 129, 257, 513 or 1025", picture.land_samples));
    if (const auto wires = object.find("wires"); wires != object.end()) {
        if (!wires->is_boolean()) refuse(source, "wires is neither true nor false");
        picture.has_wires = wires->get<bool>();
    }
    if (const auto ground = object.find("ground"); ground != object.end()) {
        if (!ground->is_string() || !render::has_ground(ground->get<std::string>()))
            refuse(source, fmt::format("ground is {}; it must be blocks or roam", ground->dump()));
        picture.ground = render::ground_named(ground->get<std::string>());
    }
    picture.camera = camera_in(object, source);
    return picture;
}

std::optional<std::uint64_t> seed_number(const std::string& scene) {
    constexpr std::string_view kPrefix = "seed:";
    if (!scene.starts_with(kPrefix)) return std::nullopt;
    std::uint64_t number = 0;
    const char* end = scene.data() + scene.size();
    const auto [stop, error] = std::from_chars(scene.data() + kPrefix.size(), end, number);
    if (error != std::errc{} || stop != end)
        refuse(scene, "after seed: comes a whole number from 0 to 18446744073709551615");
    return number;
}

}  // namespace

scene::Fineness fineness_of(int land_samples) {
    const int cells = land_samples - 1;
    return {land_samples, cells, 2 * cells};
}

bool operator==(const Picture& a, const Picture& b) { return to_json(a) == to_json(b); }

std::string to_json(const Picture& picture) {
    ordered_json json{{"quadrat", "picture"},       {"version", kVersion},
                      {"width", picture.width},     {"height", picture.height},
                      {"seconds", picture.seconds}, {"growth", picture.growth},
                      {"alpha", picture.alpha},     {"land_samples", picture.land_samples}};
    if (picture.camera)
        json["camera"] = {{"eye", vector_json(picture.camera->eye_m)},
                          {"target", vector_json(picture.camera->target_m)},
                          {"fov_deg", picture.camera->vertical_fov_deg}};
    if (picture.scale < 1) json["scale"] = picture.scale;
    if (picture.samples > 1) json["samples"] = picture.samples;
    if (picture.has_wires) json["wires"] = true;
    if (picture.ground != render::GroundBy::Blocks) json["ground"] = render::name_of(picture.ground);
    json["scenes"] = ordered_json::array();
    for (const genome::Recipe& recipe : picture.scenes)
        json["scenes"].push_back(ordered_json::parse(genome::to_json(recipe)));
    return json.dump();
}

Picture picture_from_json(const std::string& json, const std::string& source) {
    const ordered_json object = ordered_json::parse(json, nullptr, false);
    if (object.is_object() && object.value("quadrat", ordered_json{}) == "picture") {
        try {
            return picture_in(object, source);
        } catch (const nlohmann::json::exception& error) {
            refuse(source, fmt::format("the picture inside is not as this program writes it ({})", error.what()));
        }
    }
    Picture picture;  // anything else must be a scene, whose reader says best what is wrong with it
    picture.scenes.push_back(genome::from_json(json, source));
    return picture;
}

void check_picture_name(const std::filesystem::path& path) {
    base::require_ending(path, {".png", ".exr"}, "a picture");
}

void write_picture(const std::filesystem::path& path, const mesh::Image& pixels, const std::string& json) {
    check_picture_name(path);
    base::write_file(path, encoded_picture(path, pixels, json));
}

void write_image(const std::filesystem::path& path, const mesh::Image& pixels) { write_picture(path, pixels, {}); }

Picture read_scene(const std::string& scene) {
    if (const auto number = seed_number(scene)) {
        Picture picture;
        picture.scenes.push_back(breeding::seeded_scene(breeding::default_word_map(), base::Seed{*number}));
        return picture;
    }
    std::error_code too_long;  // for the name of a file, which a code is
    if (genome::has_code(scene) && !std::filesystem::exists(scene, too_long)) {
        Picture picture;
        picture.scenes.push_back(genome::recipe_of_code(scene, "the code"));
        return picture;
    }
    std::string bytes = base::read_file(scene);
    if (!is_image_file(bytes))
        return picture_from_json(base::text_from(std::move(bytes), scene, base::kJsonLimits), scene);
    const std::optional<std::string> json = scene_inside(scene);
    if (!json) refuse(scene, "this picture carries no scene; take one that quadrat wrote, a scene file, or seed:N");
    return picture_from_json(*json, scene);
}

}  // namespace quadrat::pictures
