// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "pictures/image_file.hpp"

// What lib/quadrat/images.so offers: image_file.hpp, through OpenImageIO. Debian's brings some 250 libraries with it,
// which cost a third of a second and 100 MB at every start; most of the time no picture is read or written.
namespace quadrat::pictures {

struct PictureName {
    std::string whole;   // for messages
    std::string ending;  // in small letters, with its dot: decides the format
};

struct ImageFiles {
    std::string (*encode_picture)(const PictureName& name, const mesh::Image& pixels, const std::string& json);
    std::string (*encode_field)(const PictureName& name, const mesh::Field& field);
    std::string (*encode_heights)(const PictureName& name, const mesh::Field& field, float low, float high);
    GreyPicture (*read_grey)(std::string bytes, const std::string& name);
    mesh::Image (*read)(std::string bytes, const std::string& name);
    std::optional<std::string> (*scene_inside)(std::string bytes, const std::string& name);
};

}  // namespace quadrat::pictures

// Module and program are built together: they exchange C++ objects.
extern "C" const quadrat::pictures::ImageFiles* quadrat_image_files();
