// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/image.hpp"
#include "render/choose/frustum.hpp"
#include "render/choose/reach.hpp"
#include "render/choose/view_block.hpp"
#include "scene/sward.hpp"

namespace quadrat::render::choose {

// A tuft as the GPU reads it. What is the same for all of it (air, the clouds' shadow, the wind, how many blades stand
// for all) is worked out once, on the CPU: a vertex has three times as many instructions as a blade has pixels.
struct CoverInstance {
    glm::vec3 root_m;
    glm::u16vec4 turn_size;                  // halves: cosine and sine of the yaw times the radius; height; widened
    std::array<std::uint8_t, 4> ground_lit;  // shown: what the air and the clouds leave of it
    std::array<std::uint8_t, 4> veil_gust;   // shown, of the air before it; the gust there, 1/2: none
};

// As it is kept.
struct CoverTuft {
    glm::vec3 root_m{0};
    glm::vec2 turn_m{0};  // cosine and sine of the yaw, times the radius
    float height_m = 0;
    std::array<std::uint8_t, 4> ground_lit{};  // shown, of the ground; of white
};

// A scene's cover, kept on the processor's side: what is near is sent anew each frame, a few dozen kilobytes.
struct CoverOfScene {
    std::vector<CoverTuft> tufts;  // as scene::Sward has them
    std::vector<scene::Sward::Cell> cells;
    glm::vec3 blossom{0};  // linear
    float reach_m = 1;
};

// What a kind of tuft is made of (passes/cover has their meshes): any prefix of its parts stands for all.
struct CoverParts {
    int count;
    int triangles;  // of each
    int vertices;
};
inline constexpr std::array<CoverParts, scene::kCoverKinds> kCoverParts{{
    {12, 3, 7},   // rows of grass
    {26, 1, 3},   // leaves of a cushion
    {12, 3, 7},   // stems with a flower
    {2, 13, 39},  // stones
}};

// What of a cover one view shows.
struct CoverSeen {
    struct Batch {
        scene::CoverKind kind;
        std::size_t parts;  // a prefix of the kind's: rows of blades, leaves, stems, stones
        std::size_t first;  // instances
        std::size_t count;
    };
    std::vector<Batch> batches;
    std::vector<CoverInstance> instances;
    std::size_t triangles = 0;
};

struct CoverWish {
    const ViewBlock* view = nullptr;      // never null
    const mesh::Image* clouds = nullptr;  // a shadow map; null: none
    float pixels_per_radian = 700;
    float whole = 1;     // how far tufts have all their blades, to the usual
    float drawn_to = 1;  // how far they are drawn, to all the way
    float growth = 1;    // of the landscape
    Reach reach = {};
    glm::vec3 eye_m() const { return glm::vec3{view->eye_seconds}; }
};

// Fewer parts per tuft the farther it is, and with less detail.
CoverSeen look_at_cover(const CoverOfScene& cover, const Frustum& frustum, const CoverWish& wish);

}  // namespace quadrat::render::choose
