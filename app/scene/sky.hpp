// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "scene/irradiance.hpp"

namespace quadrat::scene {

// Colours are linear and already exposed: 1 is paper white; a sky may be brighter.
struct CloudLayer {
    mesh::Image density;       // one channel, tileable: opacity after the cover and sharpness filter
    mesh::Image lit;           // one channel, tileable, the same size: 0 shaded to 255 sunlit; empty: sunlit
    float tile_m = 6000;       // across the drift
    float stretch = 1;         // of the tile along it
    glm::vec2 along{0, -1};    // unit, east and south: the way it is stretched
    float height_m = 900;      // above the sea
    glm::vec2 wind_m_s{6, 2};  // x east, y south
    glm::vec3 sunlit{1};
    glm::vec3 shaded{0.6F};
    float opacity = 1;
    float mean_density = 0;  // of the images, 0 to 1
    float mean_lit = 0;      // weighted by density
    friend bool operator==(const CloudLayer&, const CloudLayer&) = default;
};

// Texture coordinates in a layer's images of a place, or of a way, in metres east and south.
glm::vec2 tile_at(const CloudLayer& layer, const glm::vec2& m);

// A ray meets a layer of cloud where its height over its length, with this added, would have it: so layers bend down to
// the horizon as the earth's do (shaders/common/cloud_tiles.glsl).
inline constexpr float kBendsDown = 0.045F;

// Clouds as they are seen from the land: two channels, opacity and how much of it is sunlit, by direction as
// cloudscape_at() has it; rows from the horizon upward. What is sunlit beyond its opacity is light in clear air: beams.
using Cloudscape = mesh::Image;

// Texture coordinates in a cloudscape: across once around, in the middle north, where it is finest; 0 at the horizon to
// 1 overhead. direction: unit.
glm::vec2 cloudscape_at(const glm::vec3& direction);
glm::vec3 cloudscape_direction(const glm::vec2& at);  // the other way round; unit

// What a flat layer would look like there, seen from the sea's height. An empty one: no picture.
Cloudscape cloudscape_of(const CloudLayer& flat, int width, int height);

// How far clouds that are seen so have drifted, rad clockwise from above: to and fro, as the flights go. It never goes
// so far that the sun would light them from the wrong side.
float cloudscape_drift_rad(const CloudLayer& layer, float seconds);

// The light of the clear sky by direction, without sun, moon and clouds. Owns a table of 73 bearings by 37 heights;
// rows stand closer toward the horizon. Under the horizon: the horizon's.
class Dome {
  public:
    static constexpr int kColumns = 73;  // bearings; the last is the first again
    static constexpr int kRows = 37;     // from the zenith down to the horizon

    Dome() : table_(kColumns, kRows) {}
    static glm::vec3 direction(int column, int row);  // unit
    glm::vec3& at(int column, int row) { return table_.at(column, row); }
    glm::vec3 radiance(const glm::vec3& direction) const;  // unit; bilinear
    friend bool operator==(const Dome&, const Dome&) = default;

  private:
    mesh::Grid<glm::vec3> table_;
};

// The sun's disc, or the moon's.
struct Disc {
    mesh::Image picture;  // r: light; g: how much of the sky behind it it hides; both 0 outside the disc
    glm::vec3 colour{1};
    float radius_rad = 0.0105F;  // of the picture's half side
    friend bool operator==(const Disc&, const Disc&) = default;
};

struct Star {
    glm::vec3 direction;  // unit
    float light;          // 1: as bright as a star may be
    friend bool operator==(const Star&, const Star&) = default;
};

// What falls, in a box about the eye.
struct Precipitation {
    enum class Kind { None, Rain, Snow };
    Kind kind = Kind::None;
    float amount = 0;        // 0 to 1, of the drops drawn
    glm::vec3 speed_m_s{0};  // east, up, south
    float width_m = 0.01F;
    float streak_s = 0;  // a drop is drawn as long as it falls in this time
    glm::vec3 colour{0.5F};
    float opacity = 0.3F;
    friend bool operator==(const Precipitation&, const Precipitation&) = default;
};

// A second, low layer of air: at its thickest up to level_m, thinner above by exp(-(h - level_m) / depth_m); h is above
// the floor of the scene that it lies in.
struct Mist {
    float per_m = 0;  // extinction at its thickest; 0: none
    float level_m = 0;
    float depth_m = 10;
    friend bool operator==(const Mist&, const Mist&) = default;
};

struct Sky {
    glm::vec3 sun_direction{0, 1, 0};   // toward the sun, by night the moon: what casts the shadows; unit
    glm::vec3 glow_direction{0, 1, 0};  // where the sky is brightest: the sun, also when it has set; unit
    glm::vec3 sunlight{1};              // irradiance / pi on a surface facing that light
    Irradiance ambient;                 // of the sky, its clouds and the ground below
    glm::vec3 light_below{0.15F};       // radiance of sunlit ground as the sky's light knows it
    Dome dome;
    Disc disc;
    glm::vec3 glare{0};  // about the disc
    std::vector<Star> stars;
    std::array<CloudLayer, 2> clouds;  // lower, upper
    Cloudscape cloudscape;             // of the lower; empty: cloudscape_of() them
    float silver = 0.8F;               // brightness of thin cloud before the sun
    float cloud_shadow = 0.5F;         // share of the light on the ground that a dense cloud takes
    glm::vec3 haze_colour{0.7F};       // looking across the glow
    glm::vec3 haze_sunward{0.9F};      // looking toward the glow
    float haze_distance_m = 1700;      // transmittance exp(-d / haze_distance_m)
    float haze_height_m = 500;         // density falls with height by exp(-h / haze_height_m)
    Mist mist;
    Precipitation precipitation;
    float bow = 0;              // strength of a rainbow opposite the sun
    float shadow_softness = 1;  // of shadows' edges, to the usual
    float bounce = 1;           // of light from the ground, to the usual
    float occlusion = 1;        // of hollows, to the usual
    bool is_night = false;
    float darkness = 0;  // of a night: 0 at nightfall to 1 where nothing of the sun's light is left
    friend bool operator==(const Sky&, const Sky&) = default;
};

// The sky with its clouds as their mean, as the land's light sees it.
glm::vec3 mean_radiance(const Sky& sky, const glm::vec3& direction);

}  // namespace quadrat::scene
