// SPDX-License-Identifier: Apache-2.0
#include "kiosk/commands/calibrate.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/error.hpp"
#include "exhibit/archive.hpp"
#include "kiosk/detail/calibration.hpp"
#include "kiosk/detail/memory.hpp"
#include "kiosk/easel.hpp"
#include "kiosk/growing.hpp"
#include "kiosk/measurement.hpp"
#include "kiosk/screen.hpp"

namespace quadrat::kiosk::commands {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{1500};  // for each way to draw
constexpr std::size_t kMostFrames = 60;
constexpr int kCoarseLand = 129;  // grows in a tenth of the time, and draws nearly as many triangles
constexpr double kUsualPeriod_ms = 1000.0 / 60;

double ms_since(Clock::time_point began) {
    return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

// The median, without waiting for a screen.
FrameCost measured(display::Display& screen, render::Renderer& renderer, render::Frame frame, render::Detail detail) {
    frame.detail = detail;
    FrameCost cost{detail.alpha, detail.scale};
    std::vector<double> took;
    const auto began = Clock::now();
    // The first one compiles what it needs.
    for (std::size_t n = 0; n <= kMostFrames && (took.size() < 5 || Clock::now() - began < kPatience); ++n) {
        frame.framebuffer = screen.canvas().framebuffer;
        const auto from = Clock::now();
        cost.triangles = static_cast<double>(renderer.draw(frame).triangles);
        renderer.finish();
        if (n > 0) took.push_back(ms_since(from));
    }
    cost.ms = percentile(took, 0.5);
    return cost;
}

std::string per_second(double rate) {
    return std::isfinite(rate) ? fmt::format("{:.0f} million/s", rate / 1e6) : "free";
}

}  // namespace

int calibrate(const Configuration& configuration, const std::filesystem::path& state) {
    const auto screen = display::open_display(display_options(configuration));
    const display::Canvas canvas = screen->begin_frame();
    if (canvas.context == 0) throw base::InputError("calibrate: there is no GPU to measure: " + screen->description());
    render::Renderer renderer;
    std::printf("%s\n", screen->description().c_str());

    render::Frame frame;
    frame.is_one_of_many = true;  // as the exhibit's are
    frame.size = {canvas.size.width, canvas.size.height};
    const auto places = quarters(frame.size.x, frame.size.y);
    double upload_ms = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto scene = grow(genome::random_recipe(base::Seed{11}.child(i)), fineness_of(kCoarseLand));
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
    const double pixels = static_cast<double>(frame.size.x) * frame.size.y;
    const FrameCost much = measured(*screen, renderer, frame, {1, 1});
    const FrameCost little = measured(*screen, renderer, frame, {0.1F, 1});
    const FrameCost small = measured(*screen, renderer, frame, {0.1F, 0.5F});
    screen->present();
    const GpuProfile profile = profile_of(much, little, small, pixels);
    const auto most = static_cast<float>(configuration.picture.alpha);
    const GovernorOptions start = start_for(profile, most, kUsualPeriod_ms);
    for (const FrameCost& cost : {much, little, small})
        std::printf("detail %.2f at scale %.1f: %6.1f ms, %.0f triangles\n", cost.alpha, cost.scale, cost.ms,
                    cost.triangles);
    std::printf("triangles %s, pixels %s, always %.1f ms; a landscape is on the GPU in %.0f ms\n",
                per_second(profile.triangles_per_s).c_str(), per_second(profile.pixels_per_s).c_str(),
                profile.always_ms, upload_ms);
    std::printf("the exhibit starts with detail %.2f, a frame in %d of the screen's periods\n", start.start,
                start.periods);
    const DetailGovernor governor(start);
    exhibit::Archive archive =
        exhibit::Archive::open(
            state, std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now()))
            .archive;
    if (const auto trouble = archive.remember("detail", to_text(governor, *screen))) {
        std::printf("this could not be kept: %s\n", trouble->c_str());
        return 3;
    }
    return 0;
}

}  // namespace quadrat::kiosk::commands
