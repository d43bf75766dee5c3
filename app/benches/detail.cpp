// SPDX-License-Identifier: Apache-2.0
// Levels of detail: chains of meshes, and the ground by blocks against the ground by ROAM.
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "benches/benches.hpp"
#include "benches/four_views.hpp"
#include "benches/shaded.hpp"
#include "mesh/displaced_sphere.hpp"
#include "mesh/nearness.hpp"
#include "mesh/progressive.hpp"
#include "mesh/roam.hpp"
#include "render/choose/blocks.hpp"
#include "render/choose/hold.hpp"
#include "render/passes/ground.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/compose/track.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::benches {
namespace {

double cpu_ms_of(const std::function<void()>& work) {
    const double before = machine::cpu_seconds();
    work();
    return 1e3 * (machine::cpu_seconds() - before);
}

// A sphere of 101,126 vertices down to about sixty. Others: meshoptimizer 1.2 with update, on one core of this class.
void chains(Results& results) {
    const mesh::Mesh sphere = mesh::displaced_sphere(159, base::Seed{1});
    mesh::Progressive progressive;
    double least = 1e30;
    for (int run = 0; run < 9; ++run)
        least = std::min(least, cpu_ms_of([&] { progressive = mesh::make_progressive(sphere); }));
    results.push_back({"detail.chain_ms", least, "ms", 1, "meshoptimizer 126-134; CGAL 2046; OpenMesh 4128"});
    const char* const others[] = {"", "8.7", "", "27.8", "", "68.0", "", "156", "", "336", "476"};
    for (std::size_t i = 1; i < progressive.levels.size() && i < std::size(others); ++i) {
        const mesh::Mesh& level = progressive.levels[i].mesh;
        const double rms = mesh::deviation_of(level, sphere).rms_m / mesh::diagonal_m(sphere);
        const std::string name = "detail.chain_rms_1e5." + std::to_string(level.positions_m.size());
        results.push_back({name, 1e5 * rms, "of the diagonal", 1,
                           *others[i] == '\0' ? "" : std::string("meshoptimizer ") + others[i]});
    }
}

// The views of a flight over one land, sixty a second, of a quarter of a full HD screen.
struct Flight {
    std::vector<render::choose::Frustum> frusta;
    std::vector<render::choose::Frustum> wider;
    std::vector<scene::Camera> cameras;
    float pixels_per_radian = 0;
};

Flight flight_over(const scene::Land& land, base::Seed seed) {
    constexpr int kFrames = 1200;
    const scene::Track track = synthesis::fly(synthesis::plan_flight(seed), synthesis::Lookout(land), seed);
    Flight flight;
    for (int i = 0; i < kFrames; ++i) {
        const scene::Camera camera = scene::camera_at(track, static_cast<float>(i) / 60);
        const glm::mat4 clip_from_world = scene::clip_from_view(camera, 16.0F / 9) * scene::view_from_world(camera);
        flight.frusta.emplace_back(clip_from_world);
        flight.wider.push_back(render::choose::Hold::wider(clip_from_world));
        flight.cameras.push_back(camera);
        flight.pixels_per_radian = 270 / std::tan(glm::radians(camera.vertical_fov_deg) / 2);
    }
    return flight;
}

// Both choose what lies within 1.3 pixels of the ground, without a budget, and leave out what cannot be seen.
void ground(Results& results) {
    const genome::Recipe r = genome::random_recipe(base::Seed{1});
    const scene::Land land = synthesis::grow_land(scene::realise_land(r.values), r.seeds[genome::Aspect::Land]);
    const Flight flight = flight_over(land, r.flight);
    const auto frames = static_cast<double>(flight.frusta.size());
    std::vector<std::uint32_t> indices;
    const auto fly = [&](const auto& choose) {
        std::size_t triangles = 0;
        const double ms = cpu_ms_of([&] {
            for (std::size_t i = 0; i < flight.frusta.size(); ++i) {
                triangles += choose(i);
            }
        });
        return std::pair{1e3 * ms / frames, static_cast<double>(triangles) / frames};
    };
    constexpr float kError_px = 1.3F;
    const render::choose::Blocks blocks(land.height_m, land.cell_m, render::passes::kLandBlock);
    mesh::Roam roam(land.height_m, land.cell_m);
    render::choose::Hold hold;  // as the renderer does
    render::choose::Hold sight{render::choose::Horizon::kMoved_m, render::choose::Horizon::kTurned_rad};
    render::choose::Horizon horizon;
    std::vector<std::uint8_t> hidden;
    const auto by_blocks = [&](std::size_t i) {
        if (i == 0) hold.drop();
        const glm::vec3 eye_m = flight.cameras[i].eye_m;
        if (hold.serves(flight.cameras[i])) return indices.size() / 3;
        hold.choose(flight.cameras[i]);
        if (!sight.serves(flight.cameras[i])) {
            sight.choose(flight.cameras[i]);
            horizon.begin(eye_m, render::choose::Horizon::kMoved_m + hold.kMoved_m);
            hidden = blocks.hidden(flight.wider[i], eye_m, horizon);
        }
        indices.clear();
        return blocks
            .select(flight.wider[i], {eye_m, flight.pixels_per_radian, kError_px, std::size_t{1} << 40, 0, hidden},
                    indices)
            .triangles;
    };
    const auto by_roam = [&](std::size_t i) {
        indices.clear();
        roam.update({flight.cameras[i].eye_m, flight.pixels_per_radian, kError_px});
        return roam.append_indices(flight.frusta[i].planes(), indices);
    };
    // By turns, so that what else the machine does meets both. The first flight of each also makes what is kept:
    // patterns and triangles.
    auto [blocks_us, blocks_triangles] = fly(by_blocks);
    auto [roam_us, roam_triangles] = fly(by_roam);
    for (int run = 0; run < 8; ++run) {
        blocks_us = std::min(blocks_us, fly(by_blocks).first);
        roam_us = std::min(roam_us, fly(by_roam).first);
    }
    results.push_back({"detail.blocks_us", blocks_us, "us a frame", 1});
    results.push_back({"detail.blocks_triangles", blocks_triangles, "triangles", 1});
    results.push_back({"detail.roam_us", roam_us, "us a frame", 1});
    results.push_back({"detail.roam_triangles", roam_triangles, "triangles", 1});
    results.push_back({"detail.roam_ratio", roam_us / blocks_us, "times blocks", 1});
}

// What a Raspberry Pi would draw: full HD, as many triangles as its estimate has room for at 60 Hz with what is far
// held, unless something else is asked for.
void as_on(Results& results, Options options) {
    if (options.size == Options{}.size) options.size = "1920x1080";
    if (options.triangles == 0) options.triangles = options.profile == "pi4" ? 325'000 : 400'000;
    FourViews views(options);
    estimate(results, options.profile, views);
}

}  // namespace

void detail(Results& results, const Options& options) {
    if (!options.profile.empty()) {
        as_on(results, options);
        return;
    }
    chains(results);
    ground(results);
}

}  // namespace quadrat::benches
