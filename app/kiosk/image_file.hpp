// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/field.hpp"
#include "mesh/image.hpp"

// Pictures on disk, through OpenImageIO. Every failure is an InputError naming the file.
namespace quadrat::kiosk {

// To `path`, in the format of its ending, with the JSON inside unless it is empty. `name` is what errors call the file.
void write_image_file(const std::filesystem::path& path, const std::string& name, const mesh::Image& pixels,
                      const std::string& json);

// Heights as 32-bit floats (.exr, .tif), one channel.
void write_field_file(const std::filesystem::path& path, const std::string& name, const mesh::Field& field);

// Heights as 16-bit grey (.png), low to high over the whole of it; what lies beyond is cut. Returns how many samples
// did.
std::size_t write_height_picture(const std::filesystem::path& path, const std::string& name, const mesh::Field& field,
                                 float low, float high);

// A grey picture, PNG, TIFF, EXR or PNM, of any size to 8193: 0 black to 1 white; floats as they are. Of colours the
// mean. Anything else is refused by its name.
mesh::Field read_mask_file(const std::filesystem::path& path);

mesh::Image read_image_file(const std::filesystem::path& path);  // RGBA

bool is_image_file(std::string_view bytes);  // PNG or EXR, by its first bytes
std::optional<std::string> scene_inside(const std::filesystem::path& path);

}  // namespace quadrat::kiosk
