// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "benches/benches.hpp"
#include "benches/four_views.hpp"
#include "benches/passes.hpp"
#include "benches/settled.hpp"
#include "benches/shaded.hpp"
#include "machine/heap.hpp"
#include "render/choose/frustum.hpp"
#include "stage/signs.hpp"

namespace quadrat::benches {
namespace {

constexpr std::array<const char*, render::kDrawnKinds> kTrianglesOf{
    // by render::DrawnKind
    "frame.leaf_triangles",  "frame.wood_triangles", "frame.cover_triangles",  "frame.ground_triangles",
    "frame.water_triangles", "frame.sky_triangles",  "frame.falling_triangles"};

// Thirty a second of a flight at its mean speed: how far a view has moved from one frame to the next decides what of it
// can be held.
float seconds_at(int frame) { return 10 + static_cast<float>(frame) / 30; }

// Counted pixels of each kind of shader, overdraw included, times what it costs on a Raspberry Pi 4; signs left out.
double instructions_per_pixel(stage::Easel& easel, const render::Frame& picture) {
    const ShadedPixels pixels = shaded_pixels(easel, picture);
    const double size_px = static_cast<double>(picture.size.x) * picture.size.y;
    double all = size_px * render::kSkyDrawnAnew * kPi4Dome.fragment;
    for (std::size_t kind = 0; kind < pixels.size(); ++kind) all += pixels[kind] * kPi4Costs[kind].fragment;
    return all / size_px;
}

void passes(Results& results, stage::Easel& easel, const render::Frame& picture) {
    constexpr int kTurns = 12;
    const PassTurns land = land_pass(easel, picture, 16, kTurns);
    const int as_many = static_cast<int>(std::lround(std::sqrt(static_cast<double>(land.triangles) / 2)));
    const PassTurns mesh = land_pass(easel, picture, std::max(as_many, 1), kTurns);
    const PassTurns sky = sky_pass(easel, picture, kTurns);
    const auto add = [&](const char* name, double value, const char* unit) {
        results.push_back({name, value, unit, cores()});
    };
    add("frame.land_pass_ms", std::ranges::min(land.ours_ms), "ms");
    add("frame.plain_ground_ms", std::ranges::min(land.plain_ms), "ms");
    add("frame.land_pass_ratio", ratio_of(land), "of it");
    add("frame.plain_mesh_ms", std::ranges::min(mesh.plain_ms), "ms");
    add("frame.land_mesh_ratio", ratio_of(mesh), "of it");
    add("frame.sky_pass_ms", std::ranges::min(sky.ours_ms), "ms");
    add("frame.plain_sky_ms", std::ranges::min(sky.plain_ms), "ms");
    add("frame.sky_pass_ratio", ratio_of(sky), "of it");
}

std::size_t trees_in_sight(const scene::Scene& scene, const scene::Camera& camera, float aspect) {
    const render::choose::Frustum frustum(scene::clip_from_view(camera, aspect) * scene::view_from_world(camera));
    return static_cast<std::size_t>(std::ranges::count_if(scene.plants, [&](const scene::Plant& plant) {
        const scene::Species& species = scene.flora->species[plant.species];
        const float half_m = 0.5F * species.height_m * plant.scale;
        const float radius_m = std::hypot(half_m, species.crown_radius_m * plant.scale);
        return species.storey == scene::Storey::Tree &&
               frustum.may_see_sphere(plant.root_m + glm::vec3{0, half_m, 0}, radius_m);
    }));
}

// Of the view that has fewest, in any of the frames.
std::size_t fewest_trees(FourViews& views, int frames) {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (int n = 0; n < frames; ++n) {
        views.look(seconds_at(n));
        for (std::size_t i = 0; i < views.scenes.size(); ++i) {
            const render::View& view = views.picture.views[i];
            const float aspect = static_cast<float>(view.viewport.width) / static_cast<float>(view.viewport.height);
            least = std::min(least, trees_in_sight(*views.scenes[i], view.camera, aspect));
        }
    }
    return least;
}

// Frames of a flight with what is far held, and drawn anew, in turns.
void held(Results& results, FourViews& views) {
    constexpr int kFrames = 12;  // in which each view has its turn three times
    constexpr int kTurns = 8;
    std::vector<double> ratios;
    std::vector<double> held_ms;
    std::vector<double> anew_ms;
    double held_triangles = 0;
    double anew_triangles = 0;
    double split_m = 0;
    for (int turn = 0; turn < kTurns; ++turn) {
        const auto fly = [&](bool holds, double& triangles) {
            views.picture.holds_distance = holds;
            double cpu = 0;
            for (int n = -kFrames; n < kFrames; ++n) {
                if (n == 0) cpu = machine::cpu_seconds();
                views.look(seconds_at(turn * kFrames + n));
                const render::Drawn drawn = views.draw();
                if (n >= 0) triangles += static_cast<double>(drawn.triangles) / (kTurns * kFrames);
                if (n >= 0 && holds) split_m += drawn.held_from_m / (kTurns * kFrames);
            }
            return 1e3 * (machine::cpu_seconds() - cpu) / kFrames;
        };
        held_ms.push_back(fly(true, held_triangles));
        anew_ms.push_back(fly(false, anew_triangles));
        ratios.push_back(held_ms.back() / anew_ms.back());
    }
    views.picture.holds_distance = true;
    results.push_back(
        {"frame.held_cpu_ms", machine::percentile(held_ms, 0.5), "ms of all cores, what is far held", cores()});
    results.push_back(
        {"frame.anew_cpu_ms", machine::percentile(anew_ms, 0.5), "ms of all cores, all drawn anew", cores()});
    results.push_back({"frame.held_ratio", machine::percentile(ratios, 0.5), "of it", cores()});
    results.push_back({"frame.held_triangles", held_triangles, "triangles in the mean", cores()});
    results.push_back({"frame.anew_triangles", anew_triangles, "triangles in the mean", cores()});
    results.push_back({"frame.held_from_m", split_m, "m: what is farther is held", cores()});
}

}  // namespace

void frame(Results& results, const Options& options) {
    machine::hold_memory();  // as quadrat run does
    const auto start = std::chrono::steady_clock::now();
    FourViews views(options);
    const std::chrono::duration<double, std::milli> first = views.first_seen - start;
    results.push_back({"start.first_frame_ms", first.count(), "ms, in first light", cores()});
    stage::Easel& easel = views.easel;
    render::Frame& picture = views.picture;
    results.gpu = easel.display().description();
    stage::SignWriter writer(easel.renderer());
    picture.signs = writer.badges(picture.size.x, picture.size.y);
    std::vector<double> wall;
    render::Drawn most;
    double cpu_before = 0;
    constexpr int kWarmUp = 5;
    for (int n = -kWarmUp; n < options.frames; ++n) {
        if (n == 0) cpu_before = machine::cpu_seconds();
        const double ms = milliseconds_of([&] {
            views.look(seconds_at(n));
            const render::Drawn drawn = views.draw();
            if (drawn.triangles > most.triangles) most = drawn;
        });
        if (n == -kWarmUp) {
            const std::chrono::duration<double, std::milli> refined = std::chrono::steady_clock::now() - start;
            results.push_back({"start.own_light_ms", refined.count(), "ms, the first frame in it", cores()});
        }
        if (n >= 0) wall.push_back(ms);
    }
    const double cpu_ms = (machine::cpu_seconds() - cpu_before) * 1e3 / options.frames;
    results.push_back({"frame.median_ms", machine::percentile(wall, 0.5), "ms", cores()});
    results.push_back({"frame.p95_ms", machine::percentile(wall, 0.95), "ms", cores()});
    results.push_back({"frame.p99_ms", machine::percentile(wall, 0.99), "ms", cores()});
    results.push_back({"frame.cpu_ms", cpu_ms, "ms", cores()});
    results.push_back({"frame.triangles", static_cast<double>(most.triangles), "triangles", cores()});
    for (std::size_t kind = 0; kind < render::kDrawnKinds; ++kind)
        results.push_back({kTrianglesOf[kind], static_cast<double>(most.of[kind].triangles), "of them", cores()});
    results.push_back({"frame.alpha", picture.detail.alpha, "detail", cores()});
    results.push_back({"frame.trees_least", static_cast<double>(fewest_trees(views, options.frames)),
                       "trees in the view that has fewest", 1});
    held(results, views);
    passes(results, easel, picture);
    const render::Frame shown = picture;
    const nursery::Scenes scenes = views.scenes;
    settled(results, views);
    views.scenes = scenes;
    picture = shown;
    results.push_back({"frame.instructions_per_pixel", instructions_per_pixel(easel, picture), "", 1});
    results.push_back({"memory.peak_mb", machine::peak_memory_mb(), "MB", cores()});
}

}  // namespace quadrat::benches
