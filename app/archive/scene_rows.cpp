// SPDX-License-Identifier: Apache-2.0
#include "archive/scene_rows.hpp"

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::archive {
namespace {

using nlohmann::json;

std::int64_t legend_of(Connection& connection, const std::string& names) {
    connection.prepare("INSERT OR IGNORE INTO legend(names) VALUES(?)").bind(names).run();
    Statement row = connection.prepare("SELECT id FROM legend WHERE names=?");
    return row.bind(names).step() ? row.integer(0) : 0;
}

}  // namespace

std::string scene_row(Connection& connection, const genome::Recipe& scene) {
    json row = genome::parse_json(genome::to_json(scene), "scene");
    json names = json::array();
    json values = json::array();
    for (const auto& [name, value] : row["parameters"].items()) {
        names.push_back(name);
        values.push_back(value);
    }
    row.erase("parameters");
    row["legend"] = legend_of(connection, names.dump());
    row["values"] = std::move(values);
    return row.dump();
}

SceneRows::SceneRows(const Connection& connection) {
    Statement rows = connection.prepare("SELECT id, names FROM legend");
    while (rows.step()) legends_[rows.integer(0)] = rows.text(1);
}

genome::Recipe SceneRows::scene(const std::string& row) const {
    json scene = genome::parse_json(row, "scene");
    if (!scene.is_object() || !scene.contains("legend")) return genome::from_json(row, "scene");
    const json& number = scene["legend"];
    const auto found = legends_.find(number.is_number_integer() ? number.get<std::int64_t>() : 0);
    if (found == legends_.end()) throw base::InputError("there is no such legend");
    const json names = genome::parse_json(found->second, "legend");
    const json values = scene.contains("values") ? scene["values"] : json();
    if (!names.is_array() || !values.is_array() || names.size() != values.size())
        throw base::InputError("its legend has not as many names as it has values");
    json parameters = json::object();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i].is_string()) throw base::InputError("its legend holds what is no name");
        parameters[names[i].get<std::string>()] = values[i];
    }
    scene.erase("legend");
    scene.erase("values");
    scene["parameters"] = std::move(parameters);
    return genome::from_json(scene.dump(), "scene");
}

}  // namespace quadrat::archive
