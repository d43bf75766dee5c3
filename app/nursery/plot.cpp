// SPDX-License-Identifier: Apache-2.0
#include "nursery/plot.hpp"

#include <algorithm>

#include "scene/parameters.hpp"

namespace quadrat::nursery {

using genome::Aspect;

AspectKey key_of(Aspect aspect, const genome::Candidate& candidate) {
    std::vector<float> own;
    for (const auto id : genome::parameters_of(aspect, genome::Genome::Full)) own.push_back(candidate.values[id]);
    return {aspect, candidate.seeds[aspect].value, std::move(own)};
}

Grown grow_aspect(Aspect aspect, const genome::ParameterValues& values, base::Seed seed,
                  const scene::Fineness& fineness) {
    const scene::SceneParameters parameters = scene::realise(values);
    switch (aspect) {
        case Aspect::Trees:
            return std::make_shared<const scene::Flora>(synthesis::grow_trees(parameters.trees, seed));
        case Aspect::Land:
            return std::make_shared<const scene::Land>(synthesis::grow_land(parameters.land, seed, fineness));
        case Aspect::Sky:
            break;
    }
    return std::make_shared<const scene::Sky>(synthesis::grow_sky(parameters.sky, seed));
}

base::Seed planting_of(const genome::PerAspect<base::Seed>& seeds) { return seeds[Aspect::Trees].child("planting"); }

LayoutKey layout_key_of(const genome::Candidate& candidate, base::Seed flight) {
    return {key_of(Aspect::Trees, candidate), key_of(Aspect::Land, candidate), planting_of(candidate.seeds).value,
            flight.value};
}

SceneKey scene_key_of(const genome::Candidate& candidate, base::Seed flight) {
    return {layout_key_of(candidate, flight), key_of(Aspect::Sky, candidate)};
}

void lay_out(Plot& plot) {
    if (plot.layout) return;
    plot.layout = std::make_shared<const synthesis::Layout>(
        synthesis::lay_out(*plot.flora, *plot.land, plot.planting, plot.flight));
}

std::shared_ptr<const scene::Scene> illuminated(const Plot& plot, const scene::Fineness& fineness) {
    return std::make_shared<const scene::Scene>(
        synthesis::illuminate(plot.flora, plot.land, plot.sky, *plot.layout, fineness));
}

scene::Fineness first_light(const scene::Fineness& fineness) {
    constexpr int kFirst_px = 128;
    scene::Fineness first = fineness;
    first.light_px = std::min(fineness.light_px, kFirst_px);
    return first;
}

}  // namespace quadrat::nursery
