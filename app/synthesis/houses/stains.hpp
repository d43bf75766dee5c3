// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "mesh/image.hpp"

namespace quadrat::synthesis::houses {

// See scene::Settlement::stains. Made once, by whoever asks first.
const std::shared_ptr<const mesh::Image>& weather_stains();

}  // namespace quadrat::synthesis::houses
