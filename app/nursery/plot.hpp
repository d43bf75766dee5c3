// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <tuple>
#include <variant>
#include <vector>

#include "genome/offer.hpp"
#include "scene/scene.hpp"
#include "synthesis/grow.hpp"

// What a scene is put together from, part by part, each with a key: equal keys grow equal things.
namespace quadrat::nursery {

// The aspect, its seed, and its own parameters.
using AspectKey = std::tuple<genome::Aspect, std::uint64_t, std::vector<float>>;
AspectKey key_of(genome::Aspect aspect, const genome::Candidate& candidate);

using Grown = std::variant<std::shared_ptr<const scene::Flora>, std::shared_ptr<const scene::Land>,
                           std::shared_ptr<const scene::Sky>>;
Grown grow_aspect(genome::Aspect aspect, const genome::ParameterValues& values, base::Seed seed,
                  const scene::Fineness& fineness);

// Trees, land, planting and flight.
using LayoutKey = std::tuple<AspectKey, AspectKey, std::uint64_t, std::uint64_t>;
LayoutKey layout_key_of(const genome::Candidate& candidate, base::Seed flight);

// And its sky.
using SceneKey = std::tuple<LayoutKey, AspectKey>;
SceneKey scene_key_of(const genome::Candidate& candidate, base::Seed flight);

// Where one scene grows, and what of it there is.
struct Plot {
    base::Seed planting;
    base::Seed flight;
    std::shared_ptr<const scene::Flora> flora;
    std::shared_ptr<const scene::Land> land;
    std::shared_ptr<const scene::Sky> sky;              // or null
    std::shared_ptr<const synthesis::Layout> layout{};  // or null
};
base::Seed planting_of(const genome::PerAspect<base::Seed>& seeds);

// What of it needs no sky, unless it is there.
void lay_out(Plot& plot);
// Needs all of it.
std::shared_ptr<const scene::Scene> illuminated(const Plot& plot, const scene::Fineness& fineness);

// Coarse, in a twentieth of the time, for who waits for it. A picture of the ground is as coarse as its light: what is
// painted first has a quarter of the pixels.
scene::Fineness first_light(const scene::Fineness& fineness);

}  // namespace quadrat::nursery
