// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "mesh/field.hpp"
#include "mesh/image.hpp"

// What lib/quadrat/images.so offers: image_file.hpp, through OpenImageIO. Debian's brings some 250 libraries with it,
// which cost a third of a second and 100 MB at every start; most of the time no picture is read or written.
namespace quadrat::kiosk {

struct ImageFiles {
    void (*write)(const std::filesystem::path& path, const std::string& name, const mesh::Image& pixels,
                  const std::string& json);
    void (*write_field)(const std::filesystem::path& path, const std::string& name, const mesh::Field& field);
    std::size_t (*write_heights)(const std::filesystem::path& path, const std::string& name, const mesh::Field& field,
                                 float low, float high);
    mesh::Field (*read_mask)(const std::filesystem::path& path);
    mesh::Image (*read)(const std::filesystem::path& path);
    std::optional<std::string> (*scene_inside)(const std::filesystem::path& path);
};

}  // namespace quadrat::kiosk

// Module and program are built together: they exchange C++ objects.
extern "C" const quadrat::kiosk::ImageFiles* quadrat_image_files();
