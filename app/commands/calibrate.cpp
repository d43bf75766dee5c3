// SPDX-License-Identifier: Apache-2.0
#include "commands/calibrate.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "archive/archive.hpp"
#include "backup/state_hold.hpp"
#include "base/error.hpp"
#include "nursery/growing.hpp"
#include "site/screen.hpp"
#include "stage/easel.hpp"
#include "stage/gpu_benchmark.hpp"
#include "tempo/calibration.hpp"
#include "tempo/memory.hpp"

namespace quadrat::commands {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kCoarseLand = 129;  // grows in a tenth of the time, and draws nearly as many triangles
constexpr double kUsualPeriod_ms = 1000.0 / 60;

double ms_since(Clock::time_point began) {
    return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

}  // namespace

int calibrate(const site::Configuration& configuration, const std::filesystem::path& state) {
    std::error_code ignored;  // where it cannot be made, the lock says so
    std::filesystem::create_directories(state, ignored);
    const auto lock = backup::hold_state(state, "quadrat doctor --calibrate");
    const auto screen = display::open_display(site::display_options(configuration));
    const display::Canvas canvas = screen->begin_frame();
    if (canvas.context == 0) throw base::InputError("calibrate: there is no GPU to measure: " + screen->description());
    render::Renderer renderer(render::ground_named(configuration.picture.ground));
    std::printf("%s\n", screen->description().c_str());

    render::Frame frame;
    frame.is_one_of_many = true;  // as the exhibit's are
    frame.size = {canvas.size.width, canvas.size.height};
    const auto places = stage::quarters(frame.size.x, frame.size.y);
    double upload_ms = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto scene =
            nursery::grow(genome::random_recipe(base::Seed{11}.child(i)), pictures::fineness_of(kCoarseLand));
        const auto upload = renderer.begin_upload(scene);
        upload->prepare();
        const auto began = Clock::now();
        while (!upload->advance(static_cast<std::size_t>(-1))) {
        }
        renderer.finish();
        upload_ms += ms_since(began) / static_cast<double>(places.size());
        render::View view;
        view.scene = upload->take();
        view.viewport = places[i];
        view.camera = scene::camera_at(scene->track, 0);
        frame.views.push_back(view);
    }
    frame.framebuffer = canvas.framebuffer;
    stage::GpuBenchmark benchmark(std::min(configuration.picture.samples, renderer.most_samples()));
    while (!benchmark.is_over()) benchmark.step(renderer, frame);
    screen->present();
    const tempo::GpuProfile profile = benchmark.profile(renderer, static_cast<double>(frame.size.x) * frame.size.y);
    const auto most = static_cast<float>(configuration.picture.alpha);
    const tempo::GovernorOptions start = tempo::start_for(profile, most, kUsualPeriod_ms);
    for (const tempo::FrameCost& cost : benchmark.costs())
        std::printf("detail %.2f at scale %.1f, samples %d: %6.1f ms, %.0f triangles\n", cost.alpha, cost.scale,
                    cost.samples, cost.ms, cost.triangles);
    std::printf("%s; a landscape is on it in %.0f ms\n", to_text(profile).c_str(), upload_ms);
    std::printf("the exhibit starts with detail %.2f%s, a frame in %d of the screen's periods\n", start.start,
                start.samples > 1 ? " and smooth edges" : "", start.periods);
    const tempo::DetailGovernor governor(start);
    archive::Archive archive =
        archive::Archive::open(
            state, std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now()))
            .archive;
    for (const auto& [name, text] :
         {std::pair{"detail", to_text(governor, screen->renderer())}, {"gpu", to_text(profile, screen->renderer())}}) {
        const auto trouble = archive.remember(name, text);
        if (!trouble) continue;
        std::printf("this could not be kept: %s\n", trouble->c_str());
        return 3;
    }
    return 0;
}

}  // namespace quadrat::commands
