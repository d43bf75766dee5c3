// SPDX-License-Identifier: Apache-2.0
// The room `pictures`: pictures as files. What decides their pixels, reading, writing, sheets and exported trees.
// Nothing here draws on a GPU (stage) or knows of visits.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "genome/recipe.hpp"
#include "mesh/image.hpp"
#include "render/renderer.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace quadrat::pictures {

// Everything that decides a picture's pixels: it is kept inside the picture, which can so be drawn again.
struct Picture {
    std::vector<genome::Recipe> scenes;  // 1, full size, or 4, a quarter each, lettered
    int width = 1280;
    int height = 720;
    float seconds = 0;                    // into the flight, and of wind, water and clouds
    float growth = 1;                     // 0 seedlings, 1 grown
    float alpha = 1;                      // detail
    float scale = 1;                      // of each side, drawn smaller and spread: 0.25 to 1
    int samples = 1;                      // a pixel: 1, or 4 for smooth edges
    int land_samples = 513;               // how finely its scenes are grown, see fineness_of
    std::optional<scene::Camera> camera;  // instead of the flight's
    bool has_wires = false;               // the edges of its triangles, coloured by level
    render::GroundBy ground = render::GroundBy::Blocks;
    friend bool operator==(const Picture& a, const Picture& b);
};

// How finely everything is grown beside a land of so many samples a side.
scene::Fineness fineness_of(int land_samples);

std::string to_json(const Picture& picture);
// A picture's or a scene's JSON. Throws InputError naming source and what is wrong.
Picture picture_from_json(const std::string& json, const std::string& source);

// Throws InputError unless a picture can be written under this name: to be asked before it is drawn.
void check_picture_name(const std::filesystem::path& path);
// PNG or EXR by the name's ending, with the JSON inside; whole or not at all. Throws InputError naming the file.
void write_picture(const std::filesystem::path& path, const mesh::Image& pixels, const std::string& json);
// Without a scene inside.
void write_image(const std::filesystem::path& path, const mesh::Image& pixels);

// A SCENE as people name it: seed:N, a scene file, a picture that carries one, or a scene code, alone or at the end of
// an address. Throws InputError.
Picture read_scene(const std::string& scene);

// Several pictures as one sheet, each with a line of text under it; all of the size of the first.
struct SheetEntry {
    mesh::Image pixels;
    std::string caption;
};
// The picture, smaller: each pixel the mean of those it stands for.
mesh::Image scaled_to(const mesh::Image& pixels, int width_px);
mesh::Image contact_sheet(const std::vector<SheetEntry>& entries, int columns, int entry_width_px);

}  // namespace quadrat::pictures
