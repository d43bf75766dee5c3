// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "mesh/image.hpp"
#include "mesh/mesh.hpp"

namespace quadrat::scene {

// What a surface is covered with: its pattern, see shaders/houses.frag, which counts them the same way.
enum class Cladding : std::uint8_t { Plain, Plaster, Boards, Planks, Rubble, Tiles, Slates, Thatch, Leaves };

// A building's faces, flat: quads and triangles of corners of their own. Its front looks along +z, y is up, the ground
// lies at y = 0; what is below it reaches into the ground.
struct Masses {
    mesh::Mesh mesh;                  // texcoords: metres along and up the surface
    std::vector<glm::vec3> colours;   // a vertex, linear
    std::vector<Cladding> claddings;  // a vertex
    std::vector<float> lamps;         // a vertex: 0 no window; to 1 the later in the evening a light goes on behind it
};

// A building as it is made once and stands several times.
struct Building {
    std::vector<Masses> levels;  // finest first
    glm::vec2 half_m{4, 4};      // of its walls, east and south of its middle
    float height_m = 6;          // to the ridge
    std::vector<glm::vec3> chimneys_m;
    float wear = 0;  // 0 as new to 1: how strong the stains are on its walls, the crusts on its roof
};

// Smoke from one of a house's chimneys.
struct Plume {
    float strength = 0;  // how dense it is: 0 none to 1
    float width = 1;     // factors of the usual
    float rise = 1;
    float phase = 0;    // 0 to 1: how far its puffs are ahead of another's
    float chimney = 0;  // 0 to 1: which of them, in their order

    friend bool operator==(const Plume&, const Plume&) = default;
};

struct House {
    std::uint32_t building = 0;
    glm::vec3 foot_m{0};
    float yaw_rad = 0;       // about y, counter-clockwise seen from above
    glm::vec3 wall_tint{1};  // factors
    glm::vec3 roof_tint{1};
    float evening = 0;  // 0 to 1: added to its lamps, so that no two houses wake alike
    Plume plume;
};

// What people have planted by their houses; which of a flora's kinds it is follows from that.
enum class Bedded : std::uint8_t { FruitTree, Bush, Flower, Vegetable, Topiary };
struct GardenPlant {
    glm::vec2 at_m{0};
    Bedded what = Bedded::FruitTree;
    float height_m = 4;

    friend bool operator==(const GardenPlant&, const GardenPlant&) = default;
};

// Land that is tilled or mown.
enum class Crop : std::uint8_t { Meadow, MownMeadow, YoungCorn, RipeCorn, Stubble, Ploughed, Roots };
inline constexpr std::size_t kCrops = 7;
struct FieldPlot {
    std::vector<glm::vec2> outline_m;  // convex, either way round
    glm::vec2 along{1, 0};             // of its rows, unit
    Crop crop = Crop::Meadow;
    glm::vec3 colour{0.5F};  // sRGB
    float rows = 0;          // how much they show, 0 to 1
    bool has_hedge = false;

    friend bool operator==(const FieldPlot&, const FieldPlot&) = default;
};

inline constexpr float kStainsTile_m = 4;

// What people have built on a land.
struct Settlement {
    std::vector<Building> buildings;
    std::vector<House> houses;   // in the order they were built: a younger settlement has the first of them
    std::vector<Masses> bounds;  // fences, walls, hedges along plots and fields, a piece a plot, where they stand
    std::vector<FieldPlot> fields;
    std::vector<GardenPlant> gardens;
    float lit_share = 0.5F;  // how many windows are lit on a dark night, 0 to 1: see lamps.hpp
    // How far weather has stained walls and roofs, one channel, tileable: kStainsTile_m wide. The same for all
    // settlements, shared by them; none: no stains.
    std::shared_ptr<const mesh::Image> stains;

    bool is_empty() const { return houses.empty(); }
    Settlement without_masses() const;  // its houses where they stand: neither bounds nor what is planted
    std::size_t triangles() const;      // of the finest level of all
};

// The corners of a house's walls on the ground, counter-clockwise seen from above; grown by so much on all sides.
std::vector<glm::vec2> outline_m(const Building& building, const House& house, float grown_m = 0);

// Places along that outline, no more than so far apart.
std::vector<glm::vec2> along_outline_m(const Building& building, const House& house, float grown_m, float apart_m);

// A house as it stands, to ask of many places.
class HouseFrame {
  public:
    HouseFrame(const Building& building, const House& house);
    float away_m(glm::vec2 at_m) const;  // from its walls; 0 within them
    // A place from its foot, and a direction, on the map and in its own directions.
    glm::vec2 in_house_m(glm::vec2 at_m) const { return in_house(at_m - foot_m_); }
    glm::vec2 in_house(glm::vec2 direction) const {
        return {cos_ * direction.x - sin_ * direction.y, sin_ * direction.x + cos_ * direction.y};
    }

  private:
    glm::vec2 foot_m_, half_m_;
    float cos_, sin_;
};

// How far a place lies from a house's walls; 0 within them.
float to_house_m(const Building& building, const House& house, glm::vec2 at_m);

// A point of the building where the house has it.
glm::vec3 placed(const House& house, const glm::vec3& in_building_m);
glm::vec3 turned(const House& house, const glm::vec3& direction);

}  // namespace quadrat::scene
