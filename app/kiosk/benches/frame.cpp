// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>

#include "kiosk/benches/benches.hpp"
#include "kiosk/easel.hpp"
#include "kiosk/growing.hpp"
#include "kiosk/signs.hpp"

namespace quadrat::kiosk::benches {
namespace {

// Instructions of the dearest fragment shader of a kind on a Raspberry Pi 4 (V3D 4.2), as Mesa 25.0.7 compiles it.
struct ShaderCosts {
    int leaves = 17;
    int wood = 29;
    int ground = 41;
    int water = 58;
    int sky = 47;
};

std::size_t counted(Easel& easel, render::Frame picture, bool has_plants, bool has_ground) {
    picture.measured = {has_plants, has_ground, false, false, true};
    picture.signs.clear();
    const display::Canvas canvas = easel.display().begin_frame();
    picture.framebuffer = canvas.framebuffer;
    easel.renderer().draw(picture);
    const mesh::Image pixels = easel.renderer().read_pixels(picture);
    std::size_t sum = 0;
    for (std::size_t i = 3; i < pixels.bytes.size(); i += 4) sum += pixels.bytes[i];
    easel.display().present();
    return sum;
}

// Pixels that a part of the picture changes, drawn after those before it.
std::size_t changed(Easel& easel, render::Frame picture, const render::Measured& before, const render::Measured& with) {
    picture.signs.clear();
    const auto drawn = [&](const render::Measured& what) {
        picture.measured = what;
        const display::Canvas canvas = easel.display().begin_frame();
        picture.framebuffer = canvas.framebuffer;
        easel.renderer().draw(picture);
        mesh::Image pixels = easel.renderer().read_pixels(picture);
        easel.display().present();
        return pixels;
    };
    const mesh::Image a = drawn(before);
    const mesh::Image b = drawn(with);
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.bytes.size(); i += 4)
        if (!std::equal(&a.bytes[i], &a.bytes[i] + 3, &b.bytes[i])) ++count;
    return count;
}

// Counted pixels of each kind of shader, overdraw included, times what it costs; signs left out. Half of the plants'
// pixels are taken for wood's: it is dearer.
double instructions_per_pixel(Easel& easel, const render::Frame& picture) {
    const ShaderCosts costs;
    const auto plants = static_cast<double>(counted(easel, picture, true, false));
    const auto ground = static_cast<double>(counted(easel, picture, true, true)) - plants;
    const auto water =
        static_cast<double>(changed(easel, picture, {true, true, false, false}, {true, true, true, false}));
    const auto sky = static_cast<double>(changed(easel, picture, {true, true, true, false}, {true, true, true, true}));
    const double all = plants * 0.5 * (costs.leaves + costs.wood) + ground * costs.ground + water * costs.water +
                       sky * costs.sky;
    return all / (static_cast<double>(picture.size.x) * picture.size.y);
}

// One view over the whole picture, of nothing but one part; the camera sees nothing else.
double pass_ms(Easel& easel, render::Frame picture, const render::Measured& what, float look_up) {
    picture.signs.clear();
    picture.views.resize(1);
    render::View& view = picture.views.front();
    view.viewport = {0, 0, picture.size.x, picture.size.y};
    const glm::vec3 ahead = view.camera.target_m - view.camera.eye_m;
    view.camera.target_m = view.camera.eye_m + glm::normalize(glm::vec3{ahead.x, 0, ahead.z}) + glm::vec3{0, look_up, 0};
    picture.measured = what;
    return least_ms(15, [&] {
        const display::Canvas canvas = easel.display().begin_frame();
        picture.framebuffer = canvas.framebuffer;
        easel.renderer().draw(picture);
        easel.renderer().finish();
        easel.display().present();
    });
}

}  // namespace

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
    render::Frame land = picture;
    land.views.front().camera.eye_m.y += 40;
    results.push_back({"frame.land_pass_ms", pass_ms(easel, land, {false, true, false, false}, -0.7F), "ms", cores()});
    results.push_back({"frame.sky_pass_ms", pass_ms(easel, picture, {false, false, false, true}, 0.6F), "ms", cores()});
    results.push_back({"frame.instructions_per_pixel", instructions_per_pixel(easel, picture), "", 1});
    results.push_back({"memory.peak_mb", peak_memory_mb(), "MB", cores()});
}

}  // namespace quadrat::kiosk::benches
