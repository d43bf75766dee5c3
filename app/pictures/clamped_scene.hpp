// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "pictures/picture.hpp"

namespace quadrat::pictures {

// As read_scene, but a parameter outside its range is clamped to it, with a warning in the log, instead of refused.
Picture read_scene_clamped(const std::string& scene);

}  // namespace quadrat::pictures
