// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "mesh/image.hpp"

namespace quadrat::pictures {

// PNG without the library of pictures (image_file.hpp): loading that takes longer than the exhibit may take to its
// first frame, and 70 MB that stay. Both throw InputError naming the file.

// As opaque RGBA.
mesh::Image read_png_quickly(const std::filesystem::path& path);

// RGBA, taken for opaque; replaces the file whole or not at all.
void write_png_quickly(const std::filesystem::path& path, const mesh::Image& image);

}  // namespace quadrat::pictures
