// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mesh/image.hpp"
#include "render/choose/closeness.hpp"
#include "render/choose/frustum.hpp"
#include "render/choose/horizon.hpp"
#include "render/choose/reach.hpp"
#include "render/choose/view_block.hpp"
#include "scene/flora.hpp"

namespace quadrat::render::choose {

// A plant as the vertex shaders read it: the mirror of shaders/common/instance.glsl.
struct Instance {
    glm::vec4 root_scale;
    glm::vec4 turn_grown_share;
    glm::vec4 wind_sun_through;
    glm::u8vec4 air;
    glm::u8vec4 half_tint_enlarged;
    glm::u8vec4 becoming;
};

struct Batch {
    std::uint32_t species = 0;
    enum class Part { Wood, Leaves, Mass } part = Part::Wood;
    std::size_t level = 0;   // of the wood, of the mass
    std::size_t blades = 0;  // of the leaves: the prefix to draw
    bool is_plain = false;   // its blades in their plain form
    std::size_t copy = 0;    // of the leaves: 0 the blades themselves, else the number of a copy
    std::size_t first = 0;   // instance
    std::size_t count = 0;
};

struct Gathering {
    ViewBlock view;                       // its eye, sun, air and time
    const mesh::Image* clouds = nullptr;  // whose shadow falls on the plants (cloud_light.hpp); null: none
    float pixels_per_radian = 500;        // as shown
    float scale = 1;    // of the sides of the picture it is drawn in, if that is smaller: it needs less
    glm::vec3 tint{1};  // of every plant: by moonlight eyes see less of leaves' green
    float growth = 1;
    float fineness = 1;                // asked for: 1 is the standard
    const Horizon* horizon = nullptr;  // of the ground before them; null: none
    Reach reach = {};
};

// The plants that are seen, and how large.
struct Sight {
    struct Seen {
        std::uint32_t plant;
        std::uint32_t species;
        float height_px;      // as shown
        float worth_px;       // as high is a plant that deserves as many triangles: less where it is behind others
        float shown;          // 1, or less while it fades with distance
        float looked_at = 0;  // 1 for the subjects of the picture: a few plants that stand out by their size
    };
    std::vector<Seen> seen;
    std::size_t hidden = 0;  // plants that are in sight but for the ground
};

// Culls, and finds what stands behind the crowns of others: hidden ones are left out.
Sight look(std::span<const scene::Plant> plants, std::span<const PlantKind> kinds, const Frustum& frustum,
           const Gathering& gathering);

// Of the fineness that is asked for, in kSteps: what a budget leaves of it.
inline constexpr int kSteps = 512;

// One view's, where several share a budget.
struct Crowding {
    std::span<const PlantKind> kinds;
    const Gathering* gathering;
    const Sight* sight;
    float share = 1;  // of its triangles, those that count
};
// The most steps with which all of them are within so many triangles; 0 where nothing is. All get the same fineness,
// so that one more triangle would do as much in each of them. guess: of the frame before; found sooner, the same is
// found.
int affordable_step(std::span<const Crowding> views, std::size_t triangle_budget, std::optional<int> guess = {});

struct Crowd {
    std::vector<Batch> batches;  // near ones before far ones within a species
    std::size_t triangles = 0;
    float fineness = 1;  // it was drawn with
};

// Chooses detail for what is seen, sorts front to back, appends to instances. plants are sorted by species.
Crowd gather(std::span<const scene::Plant> plants, std::span<const PlantKind> kinds, Sight sight, int step,
             const Gathering& gathering, std::vector<Instance>& instances);

// 0 seed to 1 grown: each plant takes its turn within the generation's arrival. Reaches 1 for all at growth 1.
float grown(float growth, float delay);

}  // namespace quadrat::render::choose
