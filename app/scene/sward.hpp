// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace quadrat::scene {

// What covers the ground where it is near enough to be seen blade by blade.
enum class CoverKind : std::uint8_t { Grass, Cushion, Flower, Stone };
inline constexpr std::size_t kCoverKinds = 4;

// A handful of blades, leaves or stones about one root.
struct Tuft {
    glm::vec3 root_m{0};
    float yaw_rad = 0;
    float radius_m = 0.4F;
    float height_m = 0.3F;
    glm::vec3 tint{1};  // its colour to that of the ground under it
    glm::vec3 sent{0};  // linear light that it sends to the eye: the ground's own, tinted; baked with the scene's light
    float lit = 0;      // light that falls on it, as a luminance: for what has a colour of its own
    CoverKind kind = CoverKind::Grass;
};

// The tufts about the camera's flight. The tufts of a cell lie side by side, kind by kind, in shuffled order: any
// prefix of them is a thinner cover.
struct Sward {
    struct Cell {
        glm::vec3 low_m{0}, high_m{0};  // the box about its tufts
        std::size_t first = 0;          // of tufts
        std::array<std::uint32_t, kCoverKinds> counts{};
    };
    std::vector<Tuft> tufts;
    std::vector<Cell> cells;
    glm::vec3 blossom{0.8F};  // linear, of its flowers
    float reach_m = 1;        // from the eye, beyond which nothing is planted
};

// What a flora lets the ground be covered with.
struct Cover {
    float density = 0.8F;  // 0 bare to 1 closed, on ground that bears it
    float height_m = 0.4F;
    float spread = 0.4F;                // 0 upright to 1 lying
    float cushions = 0.2F;              // of tufts: low, broad leaves
    float flowers = 0.1F;               // of tufts, where flowers gather
    float patch_m = 11;                 // across a patch of one kind
    glm::vec3 grass{0.2F, 0.3F, 0.1F};  // linear: what the ground's colour leans toward
    glm::vec3 blossom{0.8F};
    float withered = 0;  // of what is green of the ground itself, by the season: 0 to 1
    friend bool operator==(const Cover&, const Cover&) = default;
};

}  // namespace quadrat::scene
