// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>

#include "archive/sqlite.hpp"
#include "genome/recipe.hpp"

namespace quadrat::archive {

// A scene as a row holds it: its numbers alone, and which legend names them. The names are two thirds of a scene, and
// the same for all that a program writes. Adds the legend where it is not there yet. Throws SqliteError.
std::string scene_row(Connection& connection, const genome::Recipe& scene);

// Reads such rows, and whole scenes, as older programs wrote them.
class SceneRows {
  public:
    explicit SceneRows(const Connection& connection);  // with the legends of now
    // Throws InputError when the row is not whole.
    genome::Recipe scene(const std::string& row) const;

  private:
    std::map<std::int64_t, std::string> legends_;
};

}  // namespace quadrat::archive
