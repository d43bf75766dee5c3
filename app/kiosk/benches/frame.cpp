// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>

#include "kiosk/benches/benches.hpp"
#include "kiosk/easel.hpp"
#include "kiosk/growing.hpp"
#include "kiosk/signs.hpp"

namespace quadrat::kiosk::benches {

void frame(Results& results, const Options& options, std::string& gpu) {
    const display::Size size = display::size_from(options.size, "--size");
    const auto start = std::chrono::steady_clock::now();
    Easel easel(size.width, size.height);
    Grower grower;
    grower.order(random_candidates(11), base::Seed{11});
    grower.wait();
    const Scenes scenes = *grower.take();
    gpu = easel.display().description();

    render::Frame picture;
    SignWriter writer(easel.renderer());
    picture.signs = writer.badges(size.width, size.height);
    picture.size = {size.width, size.height};
    picture.detail.alpha = options.alpha;
    const auto places = quarters(size.width, size.height);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        render::View view;
        view.scene = upload_now(easel.renderer(), scenes[i]);
        view.viewport = places[i];
        picture.views.push_back(view);
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
            picture.framebuffer = canvas.framebuffer;
            picture.seconds = seconds;
            for (std::size_t i = 0; i < scenes.size(); ++i)
                picture.views[i].camera = scene::camera_at(scenes[i]->track, seconds);
            triangles = std::max(triangles, static_cast<double>(easel.renderer().draw(picture).triangles));
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

}  // namespace quadrat::kiosk::benches
