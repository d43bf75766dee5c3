// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <iostream>
#include <set>
#include <thread>

#include "base/error.hpp"
#include "kiosk/commands/commands.hpp"
#include "kiosk/easel.hpp"
#include "kiosk/growing.hpp"
#include "kiosk/measurement.hpp"
#include "kiosk/signs.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::kiosk::commands {
namespace {

using Results = std::vector<Measurement>;

struct Options {
    std::string group = "all";
    bool is_json = false;
    std::string size = "1280x720";
    int frames = 120;
    float alpha = 1;
};

double milliseconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

int cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

// The median over different scenes: one landscape says little about the next.
double median_over_scenes(int scenes, const std::function<void(const genome::Recipe&)>& work) {
    std::vector<double> samples;
    for (int i = 0; i < scenes; ++i) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{static_cast<std::uint64_t>(i) + 1});
        samples.push_back(milliseconds_of([&] { work(recipe); }));
    }
    return percentile(samples, 0.5);
}

void measure_growing(Results& results, const std::string& aspect) {
    constexpr int kScenes = 9;
    const std::map<std::string, std::function<void(const genome::Recipe&)>> growers{
        {"trees",
         [](const genome::Recipe& r) {
             synthesis::grow_trees(scene::realise(r.values).trees, r.seeds[genome::Aspect::Trees]);
         }},
        {"land",
         [](const genome::Recipe& r) {
             synthesis::grow_land(scene::realise(r.values).land, r.seeds[genome::Aspect::Land]);
         }},
        {"sky", [](const genome::Recipe& r) {
             synthesis::grow_sky(scene::realise(r.values).sky, r.seeds[genome::Aspect::Sky]);
         }}};
    for (const int threads : {1, cores()}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        results.push_back({aspect + ".scene_ms", median_over_scenes(kScenes, growers.at(aspect)), "ms", threads});
        if (threads == cores()) break;
    }
}

std::vector<genome::Candidate> random_candidates(std::uint64_t seed) {
    std::vector<genome::Candidate> candidates(genome::kCandidates);
    for (std::size_t i = 0; i < genome::kCandidates; ++i) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed}.child(i));
        candidates[i].values = recipe.values;
        candidates[i].seeds = recipe.seeds;
    }
    return candidates;
}

void measure_generation(Results& results) {
    std::vector<double> samples;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        samples.push_back(milliseconds_of([&] {
            Grower grower;
            grower.order(random_candidates(seed), base::Seed{seed});
            grower.wait();
        }));
    }
    results.push_back({"generation.cold_ms", percentile(samples, 0.5), "ms", cores()});
}

void measure_frames(Results& results, const Options& options, std::string& gpu) {
    const display::Size size = display::size_from(options.size, "--size");
    const auto start = std::chrono::steady_clock::now();
    Easel easel(size.width, size.height);
    Grower grower;
    grower.order(random_candidates(11), base::Seed{11});
    grower.wait();
    const Scenes generation = *grower.take();
    gpu = easel.display().description();

    render::Frame frame;
    SignWriter writer(easel.renderer());
    frame.signs = writer.badges(size.width, size.height);
    frame.size = {size.width, size.height};
    frame.detail.alpha = options.alpha;
    const auto places = quarters(size.width, size.height);
    for (std::size_t i = 0; i < generation.size(); ++i) {
        render::View view;
        view.scene = upload_now(easel.renderer(), generation[i]);
        view.viewport = places[i];
        frame.views.push_back(view);
    }
    std::vector<double> wall;
    double triangles = 0;
    double cpu_before = 0;
    constexpr int kWarmUp = 5;
    for (int n = -kWarmUp; n < options.frames; ++n) {
        if (n == 0) cpu_before = cpu_seconds();
        const float seconds = static_cast<float>(std::max(0, n)) * 0.25F;
        const double ms = milliseconds_of([&] {
            const display::Canvas canvas = easel.display().begin_frame();
            frame.framebuffer = canvas.framebuffer;
            frame.seconds = seconds;
            for (std::size_t i = 0; i < generation.size(); ++i)
                frame.views[i].camera = scene::camera_at(generation[i]->track, seconds);
            triangles = std::max(triangles, static_cast<double>(easel.renderer().draw(frame).triangles));
            easel.renderer().finish();
            easel.display().present();
        });
        if (n == -kWarmUp) {
            const auto first = std::chrono::steady_clock::now() - start;
            results.push_back(
                {"start.first_frame_ms", std::chrono::duration<double, std::milli>(first).count(), "ms", cores()});
        }
        if (n >= 0) wall.push_back(ms);
    }
    const double cpu_ms = (cpu_seconds() - cpu_before) * 1e3 / options.frames;
    results.push_back({"frame.median_ms", percentile(wall, 0.5), "ms", cores()});
    results.push_back({"frame.p95_ms", percentile(wall, 0.95), "ms", cores()});
    results.push_back({"frame.p99_ms", percentile(wall, 0.99), "ms", cores()});
    results.push_back({"frame.cpu_ms", cpu_ms, "ms", cores()});
    results.push_back({"frame.triangles", triangles, "triangles", cores()});
    results.push_back({"memory.peak_mb", peak_memory_mb(), "MB", cores()});
}

int bench(const Options& options) {
    static const std::vector<std::string> kGroups{"frame", "generation", "trees", "land", "sky"};
    Results results;
    std::string gpu;
    // Frames first: the peak of memory is then the exhibit's and not that of a group before it.
    for (const std::string& group : kGroups) {
        if (options.group != "all" && options.group != group) continue;
        std::cerr << "measuring " << group << " …\n";
        if (group == "frame")
            measure_frames(results, options, gpu);
        else if (group == "generation")
            measure_generation(results);
        else
            measure_growing(results, group);
    }
    if (options.is_json)
        std::cout << json_of(results, gpu) << '\n';
    else
        std::cout << machine_description() << (gpu.empty() ? "" : "; " + gpu) << "\n\n" << table_of(results);
    return 0;
}

}  // namespace

void add_bench(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("bench", "Measure this machine: growing, frames, memory");
    command->add_option("group", options->group, "all, frame, generation, trees, land or sky")
        ->check(CLI::IsMember({"all", "frame", "generation", "trees", "land", "sky"}))
        ->capture_default_str();
    command->add_flag("--json", options->is_json, "One JSON object instead of a table");
    command->add_option("--size", options->size, "Pixels of the frames")->capture_default_str();
    command->add_option("--frames", options->frames, "How many are timed")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--alpha", options->alpha, "Detail: 1 is standard")
        ->check(CLI::Range(0.01F, 100.0F))
        ->capture_default_str();
    command->callback([options, &chosen] { chosen = [options] { return bench(*options); }; });
}

}  // namespace quadrat::kiosk::commands
