// SPDX-License-Identifier: Apache-2.0
#include "commands/plan_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::commands {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(std::string_view source, const std::string& what) {
    throw base::InputError(fmt::format("{}: {}", source, what));
}

double number_from(const json& value, std::string_view source, const std::string& place) {
    if (!value.is_number()) refuse(source, fmt::format("{} is {}; a number is meant", place, genome::brief(value)));
    return value.get<double>();
}

std::vector<glm::dvec2> loop_from(const json& value, std::string_view source, const std::string& place) {
    if (!value.is_array()) refuse(source, fmt::format("{} is a list of points, [[x, y], …]", place));
    std::vector<glm::dvec2> loop;
    for (const json& point : value) {
        const std::string name = fmt::format("point {} of {}", loop.size(), place);
        if (!point.is_array() || point.size() != 2) refuse(source, fmt::format("{} is [x, y], in metres", name));
        loop.emplace_back(number_from(point[0], source, name), number_from(point[1], source, name));
    }
    return loop;
}

mesh::Plan outlines_from(const json& value, std::string_view source) {
    mesh::Plan plan;
    plan.outer = loop_from(genome::member(value, "outer", source), source, "outer");
    if (!value.contains("holes")) return plan;
    const json& holes = value["holes"];
    if (!holes.is_array()) refuse(source, "holes is a list of loops of points");
    for (const json& hole : holes)
        plan.holes.push_back(loop_from(hole, source, fmt::format("hole {}", plan.holes.size())));
    return plan;
}

mesh::Profile profile_from(const json& value, std::string_view source, const std::string& place) {
    if (!value.is_array() || value.empty())
        refuse(source,
               fmt::format("{} is a list of courses, [{{\"slope\": 90}}, {{\"from\": 3, \"slope\": 45}}]", place));
    mesh::Profile profile;
    profile.courses.clear();
    for (const json& course : value) {
        const std::string name = fmt::format("course {} of {}", profile.courses.size(), place);
        genome::require_object(course, {"from", "slope"}, source, name);
        mesh::Profile::Course made;
        made.slope_deg = number_from(genome::member(course, "slope", source), source, name + ": slope");
        if (course.contains("from")) made.from_m = number_from(course["from"], source, name + ": from");
        profile.courses.push_back(made);
    }
    return profile;
}

std::size_t edge_from(const std::string& key, std::size_t edges, std::string_view source) {
    std::size_t edge = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), edge);
    if (error != std::errc{} || end != key.data() + key.size() || edge >= edges)
        refuse(source, fmt::format("profiles: {} is neither \"all\" nor an edge, 0 to {}", genome::brief(json(key)),
                                   edges - 1));
    return edge;
}

void read_profiles(PlanFile& file, const json& value, std::string_view source) {
    const std::size_t edges = file.plan.edge_count();
    std::vector<mesh::Profile> of_edge(edges);
    if (value.contains("weights")) {
        const json& weights = value["weights"];
        if (!weights.is_array() || weights.size() != edges)
            refuse(source, fmt::format("weights is a list of {} slopes in degrees, one an edge", edges));
        for (std::size_t i = 0; i < edges; ++i)
            of_edge[i].courses[0].slope_deg = number_from(weights[i], source, fmt::format("weight {}", i));
    }
    if (value.contains("profiles")) {
        const json& profiles = value["profiles"];
        if (!profiles.is_object())
            refuse(source, "profiles is an object: \"all\" or an edge's number, and its courses");
        if (profiles.contains("all"))
            std::fill(of_edge.begin(), of_edge.end(), profile_from(profiles["all"], source, "the profile of all"));
        for (const auto& [key, courses] : profiles.items())
            if (key != "all")
                of_edge[edge_from(key, edges, source)] = profile_from(courses, source, "the profile of edge " + key);
    }
    // What is equal is one profile, so that edges of one line may become one.
    std::map<std::vector<std::pair<double, double>>, int> known;
    file.options.profiles.clear();
    for (const mesh::Profile& profile : of_edge) {
        std::vector<std::pair<double, double>> key;
        for (const mesh::Profile::Course& course : profile.courses) key.emplace_back(course.from_m, course.slope_deg);
        const auto [it, is_new] = known.try_emplace(key, static_cast<int>(file.options.profiles.size()));
        if (is_new) file.options.profiles.push_back(profile);
        file.options.profile_of_edge.push_back(it->second);
    }
}

std::string list_of(const std::vector<std::uint32_t>& numbers) {
    std::string text = "[";
    for (const std::uint32_t n : numbers) text += fmt::format("{}{}", text.size() > 1 ? ", " : "", n);
    return text + "]";
}

}  // namespace

mesh::Plan region_from(std::string_view text, std::string_view source) {
    const json value = genome::parse_json(text, source);
    genome::require_object(value, {"outer", "holes"}, source, "a region");
    return outlines_from(value, source);
}

PlanFile plan_from(std::string_view text, std::string_view source) {
    const json value = genome::parse_json(text, source);
    genome::require_object(value, {"outer", "holes", "weights", "profiles", "height", "ambiguity"}, source, "a plan");
    PlanFile file;
    file.plan = outlines_from(value, source);
    if (file.plan.edge_count() == 0) refuse(source, "outer has no points");
    read_profiles(file, value, source);
    if (value.contains("height")) file.options.height_m = number_from(value["height"], source, "height");
    if (value.contains("ambiguity")) {
        const json& which = value["ambiguity"];
        if (which != "least" && which != "most")
            refuse(source, "ambiguity is \"least\" or \"most\": the volume where parallel edges of two slopes meet");
        file.options.ambiguity = which == "most" ? mesh::Ambiguity::MostVolume : mesh::Ambiguity::LeastVolume;
    }
    return file;
}

std::string json_of(const mesh::Roof& roof) {
    std::string text = "{\"vertices\": [";
    for (std::size_t i = 0; i < roof.vertices.size(); ++i) {
        const glm::dvec3& v = roof.vertices[i];
        text += fmt::format("{}[{}, {}, {}]", i == 0 ? "" : ",\n  ", genome::shortest(v.x), genome::shortest(v.y),
                            genome::shortest(v.z));
    }
    text += "],\n \"faces\": [";
    for (std::size_t i = 0; i < roof.faces.size(); ++i) {
        const mesh::RoofFace& face = roof.faces[i];
        text += fmt::format("{}{{\"edge\": {}, \"course\": {}, \"vertices\": {}", i == 0 ? "" : ",\n  ", face.edge,
                            face.course, list_of(face.outline));
        for (std::size_t h = 0; h < face.holes.size(); ++h)
            text += (h == 0 ? ", \"holes\": [" : ", ") + list_of(face.holes[h]);
        text += face.holes.empty() ? "}" : "]}";
    }
    text += "],\n \"tops\": [";
    for (std::size_t i = 0; i < roof.tops.size(); ++i) text += (i == 0 ? "" : ", ") + list_of(roof.tops[i]);
    return text + "]}\n";
}

std::string svg_of(const mesh::Roof& roof) {
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const glm::dvec3& v : roof.vertices) {
        low = glm::min(low, glm::dvec2(v));
        high = glm::max(high, glm::dvec2(v));
    }
    const double scale = 920 / std::max({high.x - low.x, high.y - low.y, 1.0e-9});
    const auto path = [&](const std::vector<std::uint32_t>& loop) {
        std::string d;
        for (const std::uint32_t v : loop)
            d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : "L", 40 + scale * (roof.vertices[v].x - low.x),
                             40 + scale * (high.y - roof.vertices[v].y));
        return d + "Z";
    };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n<rect width=\"100%\" "
        "height=\"100%\" "
        "fill=\"#f6f3ea\"/>\n<g stroke=\"#3b3a36\" stroke-width=\"1.5\" stroke-linejoin=\"round\" "
        "fill-rule=\"evenodd\">\n",
        80 + scale * (high.x - low.x), 80 + scale * (high.y - low.y));
    for (const mesh::RoofFace& face : roof.faces) {
        glm::dvec3 normal(0);
        for (std::size_t i = 1; i + 1 < face.outline.size(); ++i)
            normal += glm::cross(roof.vertices[face.outline[i]] - roof.vertices[face.outline[0]],
                                 roof.vertices[face.outline[i + 1]] - roof.vertices[face.outline[0]]);
        const double length = glm::length(normal);
        if (!(length > 0) || normal.z <= 1.0e-9 * length) continue;
        normal /= length;
        const double light = std::clamp(0.55 + 0.45 * (-0.75 * normal.x + 0.5 * normal.y + 0.2 * normal.z), 0.2, 1.0);
        std::string d = path(face.outline);
        for (const auto& hole : face.holes) d += path(hole);
        svg += fmt::format("<path d=\"{}\" fill=\"rgb({:.0f},{:.0f},{:.0f})\"/>\n", d, 214 * light, 158 * light,
                           122 * light);
    }
    std::string tops;
    for (const auto& top : roof.tops) tops += path(top);
    if (!tops.empty()) svg += fmt::format("<path d=\"{}\" fill=\"#e9e4d4\"/>\n", tops);
    return svg + "</g>\n</svg>\n";
}

}  // namespace quadrat::commands
