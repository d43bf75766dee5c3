// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "scene/ground_colours.hpp"

namespace quadrat::render::passes {

inline constexpr float kGrain = 0.65F;     // how much of the ground's brightness its grain is
inline constexpr float kNearGrain = 1.5F;  // the same of what is seen only near by

// Multiplies what the ground is made of and the light baked for it, once a scene: a pixel of a frame fetches their
// product. On the processor, beside the frames: painted by a GPU it would need as many bytes brought there as the
// picture has, and keep frames waiting.
class GroundBrush {
  public:
    struct Sheet {
        const scene::GroundColours& colours;
        const mesh::Image& light;   // scene::BakedLight, from corner to corner
        const mesh::Image& kinds;   // a pixel a sample of the land: how far its grain is soft ground's, how far stone's
        const mesh::Image& relief;  // of both, tiled, lit; 0.5 is level
        float relief_tiles;         // of it, to a side of the land
        glm::vec3 water{0};         // shown, of water as deep as one wades in
        float murk = 0;             // how far it hides a bed that it looks deep over, 0 to 1
        // The land's, from corner to corner, at least 2 by 2: on steep ground stone's relief lies on the slope and is
        // not stretched down it. Nothing: all of it lies level.
        const mesh::Field* height_m = nullptr;
        float cell_m = 1;
        float withered = 0;     // scene::Cover's
        float colour_seen = 1;  // as of scene::colour_seen
    };
    // For a picture of this size: the colours', or that halved some times. The sheet's parts stay until it is painted.
    GroundBrush(const Sheet& sheet, glm::ivec2 size);

    // Of four channels: what the ground sends to the eye, shown, and how deep water over it looks. The rim is as under
    // deep water, for all beyond it repeats the rim.
    void paint(mesh::Image& picture, int row);

  private:
    // A coarser picture from corner to corner of this one, a row at a time, bilinearly.
    class Coarser {
      public:
        // The columns of image at which the first pixel lies, and each after it further on.
        Coarser(const mesh::Image& image, float first, float step, int pixels);
        // At a row of image. channels: 0 to 255 for each pixel.
        void spread(float row, std::span<std::vector<float>> channels);

      private:
        const mesh::Image* image_;
        std::vector<int> before_, after_;  // columns; a pixel each
        std::vector<float> share_;         // of the one after
        std::vector<float> mixed_;
    };
    // Of a row: how high each pixel is and how steep it is toward the east and the south, rise over run.
    struct Slopes {
        std::vector<float> height_m, east, south;
    };
    void relieve(float over_land);
    void look_at_slopes(float over_land);
    // Replaces the part of stone in level relief by what lies on slopes; 0 is level.
    float stone_on_slope(std::size_t x, float over_land, float level) const;
    float stone_at(float across_tiles, float down_tiles) const;
    void change_colours();
    void drown(std::uint8_t* pixels) const;

    Sheet sheet_;
    glm::ivec2 size_;
    int halvings_ = 0;
    Coarser light_;
    Coarser kinds_;
    // Of a row:
    std::vector<std::uint8_t> colours_;
    std::array<std::vector<float>, 4> lit_;
    std::array<std::vector<float>, 2> kind_;
    Slopes slopes_;
    std::vector<float> relieved_;  // what its light is multiplied with
};

}  // namespace quadrat::render::passes
