// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/field.hpp"
#include "mesh/image.hpp"

// Pictures on disk, through OpenImageIO. Every failure is an InputError naming the file.
namespace quadrat::pictures {

// Whole files, for base::write_file: the name's ending decides the format, and nothing in them depends on the time of
// day. They are looked at before they are returned.

// .png or .exr, with the JSON inside unless it is empty.
std::string encoded_picture(const std::filesystem::path& name, const mesh::Image& pixels, const std::string& json);

// Heights as 32-bit floats (.exr, .tif), one channel.
std::string encoded_field(const std::filesystem::path& name, const mesh::Field& field);

// Heights as 16-bit grey (.png), low to high over the whole of it; what lies beyond is cut.
std::string encoded_heights(const std::filesystem::path& name, const mesh::Field& field, float low, float high);

// PNG, TIFF, EXR or PNM of any size to 16384; of colours the mean. Anything else is refused by its name.
struct GreyPicture {
    mesh::Field samples;               // in the file's own numbers; floats may be infinite, or none
    std::optional<float> white;        // of whole numbers without a sign: the largest. Others may mean anything.
    std::optional<float> nodata = {};  // what the file itself says stands for a hole: a TIFF's GDAL_NODATA
};
GreyPicture read_grey_picture(const std::filesystem::path& path);

mesh::Image read_image_file(const std::filesystem::path& path);  // RGBA

bool is_image_file(std::string_view bytes);  // PNG or EXR, by its first bytes
std::optional<std::string> scene_inside(const std::filesystem::path& path);

}  // namespace quadrat::pictures
