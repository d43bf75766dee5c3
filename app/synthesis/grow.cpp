// SPDX-License-Identifier: Apache-2.0
#include "synthesis/grow.hpp"

#include "scene/land_parameters.hpp"
#include "scene/night_eye.hpp"
#include "scene/sky_parameters.hpp"
#include "scene/tree_parameters.hpp"
#include "synthesis/compose/exposure.hpp"
#include "synthesis/compose/light.hpp"
#include "synthesis/compose/low_ground.hpp"
#include "synthesis/compose/mirror.hpp"
#include "synthesis/compose/near_shade.hpp"
#include "synthesis/compose/openness.hpp"
#include "synthesis/compose/planting.hpp"
#include "synthesis/compose/settlers.hpp"
#include "synthesis/compose/sward.hpp"
#include "synthesis/compose/track.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/land/country.hpp"
#include "synthesis/sky/firmament.hpp"
#include "synthesis/trees/flora.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kLeastRange = 0.44F;  // of values: the rays' few, so a little more than a picture is to have
constexpr float kLeastByNight = 0.40F;
constexpr int kShadesAgain = 3;
constexpr int kShadesAgainByNight = 2;

// The mean over its houses, at the height of their eaves.
float sun_on(const scene::Settlement& settlement, const LandShadow& shadow) {
    if (settlement.is_empty()) return 1;
    float sum = 0;
    for (const scene::House& house : settlement.houses) sum += shadow.sun_at(house.foot_m + glm::vec3{0, 4, 0});
    return sum / static_cast<float>(settlement.houses.size());
}

}  // namespace

scene::Flora grow_trees(const scene::TreeParameters& parameters, base::Seed seed) {
    return trees::make_flora(parameters, seed);
}

scene::Land grow_land(const scene::LandParameters& parameters, base::Seed seed, const scene::Fineness& fineness) {
    HouseBuilders builders(parameters, seed.child("settlement"));
    return land::make_land(parameters, seed, fineness, parameters.settle_age >= 0 ? &builders : nullptr);
}

scene::Sky grow_sky(const scene::SkyParameters& parameters, base::Seed seed) { return sky::make_sky(parameters, seed); }

Layout lay_out(const scene::Flora& flora, const scene::Land& land, base::Seed planting, base::Seed flight) {
    const Lookout lookout(land);
    const FlightPlan plan = fitted_to(lookout, plan_flight(flight));
    scene::Track track = fly(plan, lookout, flight);
    std::vector<scene::Plant> plants = plant_land(land, flora, plan, track, planting);
    return {std::move(track), std::move(plants), lay_sward(land, flora, plan, planting.child("sward")),
            openness_of(land)};
}

scene::Scene illuminate(std::shared_ptr<const scene::Flora> flora, std::shared_ptr<const scene::Land> land,
                        std::shared_ptr<const scene::Sky> sky, Layout layout, const scene::Fineness& fineness) {
    scene::Scene scene;
    scene.track = std::move(layout.track);
    scene.plants = std::move(layout.plants);
    const LandShadow shadow(*land, sky->sun_direction, sky->shadow_softness);
    light_plants(scene.plants, *flora, *sky, shadow);
    scene.light = bake_light(*land, layout.openness, *sky, *flora, scene.plants, shadow, fineness.light_px);
    const float left = sky->is_night ? kLeftByNight : kLeftByDay;
    shade_what_is_near(scene.light, scene.plants, *flora, scene.track, land->side_m(), left);
    const int shades = sky->is_night ? kShadesAgainByNight : kShadesAgain;
    const float least = sky->is_night ? kLeastByNight : kLeastRange;
    for (int again = 0; again < shades && value_range(*land, *sky, scene.light, scene.track) < least; ++again)
        shade_what_is_near(scene.light, scene.plants, *flora, scene.track, land->side_m(), kLeftAgain);
    scene.sward = std::move(layout.sward);
    light_sward(scene.sward, *land, flora->cover, scene.light, scene::colour_seen(sky->darkness));
    scene.houses_sun = sun_on(land->settlement, shadow);
    scene.floor_m = low_ground_m(*land, scene.track);
    scene.exposure = exposure_for(*land, *sky, scene.light, scene.track);
    scene.flora = std::move(flora);
    scene.land = std::move(land);
    scene.sky = std::move(sky);
    scene.mirror = hold_up_mirror(scene);
    return scene;
}

scene::Scene compose(std::shared_ptr<const scene::Flora> flora, std::shared_ptr<const scene::Land> land,
                     std::shared_ptr<const scene::Sky> sky, base::Seed planting, base::Seed flight,
                     const scene::Fineness& fineness) {
    Layout layout = lay_out(*flora, *land, planting, flight);
    return illuminate(std::move(flora), std::move(land), std::move(sky), std::move(layout), fineness);
}

}  // namespace quadrat::synthesis
