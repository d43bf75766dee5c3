// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "mesh/image.hpp"

namespace quadrat::kiosk {

// A PNG as opaque RGBA, without the library of pictures (image_file.hpp): loading that takes longer than the exhibit
// may take to its first frame. Throws InputError naming the file.
mesh::Image read_png_quickly(const std::filesystem::path& path);

}  // namespace quadrat::kiosk
