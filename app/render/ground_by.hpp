// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::render {

// Which triangles a land's square is drawn from; the country around it is always made of blocks.
enum class GroundBy {
    Blocks,  // squares at powers of two, whose vertices move from level to level (choose/blocks)
    Roam     // triangles halved where the ground is rough for its distance, as it is (mesh/roam)
};

// What the command line, the configuration and pictures call them.
std::vector<std::string> ground_names();
std::string_view name_of(GroundBy ground);
bool has_ground(std::string_view name);
GroundBy ground_named(std::string_view name);  // has_ground(name)

}  // namespace quadrat::render
