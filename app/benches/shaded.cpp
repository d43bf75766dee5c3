// SPDX-License-Identifier: Apache-2.0
#include "benches/shaded.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quadrat::benches {
namespace {

constexpr std::size_t at(render::DrawnKind kind) { return static_cast<std::size_t>(kind); }

mesh::Image drawn(stage::Easel& easel, render::Frame picture, const render::Measured& what) {
    picture.signs.clear();
    picture.measured = what;
    const display::Canvas canvas = easel.display().begin_frame();
    picture.framebuffer = canvas.framebuffer;
    easel.renderer().draw(picture);
    mesh::Image pixels = easel.renderer().read_pixels(picture);
    easel.display().present();
    return pixels;
}

double counted(stage::Easel& easel, const render::Frame& picture, render::Measured what) {
    what.is_counted = true;
    const mesh::Image pixels = drawn(easel, picture, what);
    double sum = 0;
    for (std::size_t i = 3; i < pixels.bytes.size(); i += 4) sum += pixels.bytes[i];
    return sum;
}

// Pixels that a part of the picture changes, drawn after those before it.
double changed(stage::Easel& easel, const render::Frame& picture, const render::Measured& before,
               const render::Measured& with) {
    const mesh::Image a = drawn(easel, picture, before);
    const mesh::Image b = drawn(easel, picture, with);
    double count = 0;
    for (std::size_t i = 0; i < a.bytes.size(); i += 4)
        if (!std::equal(&a.bytes[i], &a.bytes[i] + 3, &b.bytes[i])) ++count;
    return count;
}

// A Raspberry Pi's GPU as numbers.
struct Chip {
    const char* name;
    const ChipCosts* costs;
    const ShaderCosts* dome;
    const ShaderCosts* distance;
    double lanes_per_s;      // instructions times lanes
    double triangles_per_s;  // nobody has published it: what is planned for, 250,000 at 60 a second
    double bytes_per_s;      // of the memory's peak, a share
};
constexpr double kHz = 60;
constexpr double kBusy = 0.7;  // of the processors' cycles: four threads hide most fetches, not all

// Two slices of four processors, each an instruction on sixteen lanes every four cycles, at 500 MHz. The Pi 5's are
// taken for twice as fast: glmark2 has it so.
const Chip kChips[] = {{"pi4", &kPi4Costs, &kPi4Dome, &kPi4Distance, 16e9, 15e6, 0.35 * 12.8e9},
                       {"pi5", &kPi5Costs, &kPi5Dome, &kPi5Distance, 32e9, 30e6, 0.35 * 17e9}};

// Pixels come in squares of four: those of a small triangle's rim are shaded beside it.
double beside(render::DrawnKind kind) { return kind <= render::DrawnKind::Wood ? 1.6 : 1.1; }

// What each shader takes on that chip, as its own compiler counts.
void add_costs(Results& results, const Chip& chip) {
    const auto add = [&](const ShaderCosts& costs) {
        const std::string row = std::string("detail.") + chip.name + "_instructions." + costs.shader;
        results.push_back({row, static_cast<double>(costs.fragment),
                           fmt::format("a pixel; a vertex {}, in binning {}", costs.vertex, costs.binning), 1});
    };
    for (const ShaderCosts& costs : *chip.costs) add(costs);
    add(*chip.dome);
    add(*chip.distance);
}

}  // namespace

const ChipCosts kPi4Costs{{{"leaves.frag", 19, 202, 113},
                           {"wood.frag", 30, 192, 71},
                           {"cover.vert", 8, 97, 73},
                           {"near_ground.frag", 42, 222, 81},
                           {"water.frag", 58, 415, 45},
                           {"held_sky.frag", 14, 158, 146},
                           {"falling.frag", 15, 185, 160}}};
const ChipCosts kPi5Costs{{{"leaves.frag", 20, 177, 103},
                           {"wood.frag", 30, 169, 64},
                           {"cover.vert", 8, 84, 60},
                           {"near_ground.frag", 39, 199, 73},
                           {"water.frag", 53, 409, 40},
                           {"held_sky.frag", 14, 133, 123},
                           {"falling.frag", 12, 147, 143}}};
const ShaderCosts kPi4Dome{"sky.frag", 48, 158, 57};
const ShaderCosts kPi5Dome{"sky.frag", 44, 149, 50};
const ShaderCosts kPi4Distance{"held_distance.frag", 24, 206, 162};
const ShaderCosts kPi5Distance{"held_distance.frag", 24, 179, 140};

ShadedPixels shaded_pixels(stage::Easel& easel, const render::Frame& picture, render::choose::Reach::Part part,
                           float split_m) {
    using Kind = render::DrawnKind;
    const auto of = [&](bool leaves, bool wood, bool ground, bool water, bool sky) {
        return render::Measured{leaves, wood, ground, water, sky, false, part, split_m};
    };
    ShadedPixels pixels{};
    pixels[at(Kind::Leaves)] = counted(easel, picture, of(true, false, false, false, false));
    const double plants = counted(easel, picture, of(true, true, false, false, false));
    pixels[at(Kind::Wood)] = plants - pixels[at(Kind::Leaves)];
    const render::Measured solid = of(true, true, true, false, false);
    const render::Measured wet = of(true, true, true, true, false);
    // The cover's pixels are among them, at what the ground's take, which is more.
    pixels[at(Kind::Ground)] = counted(easel, picture, solid) - plants;
    pixels[at(Kind::Water)] = changed(easel, picture, solid, wet);
    // And what falls before it.
    pixels[at(Kind::Sky)] = changed(easel, picture, wet, of(true, true, true, true, true));
    return pixels;
}

namespace {

// What a frame asks of a chip.
struct Load {
    double shading = 0;  // instructions times pixels
    double vertices = 0;
    double shaded = 0;  // pixels
    double vertex_count = 0;
    double triangles = 0;
    double moved = 0;  // bytes, beside those of vertices and fetches
    double draws = 0;
    double sent = 0;

    void shade(double pixels, double instructions, double beside = 1) {
        shaded += pixels;
        shading += pixels * beside * instructions;
    }
    double bytes() const { return moved + sent + 2 * 24 * vertex_count + 4 * shaded; }
};

struct Times {
    double shading_ms, vertices_ms, triangles_ms, memory_ms;
    double frame_ms() const { return std::max({shading_ms + vertices_ms, triangles_ms, memory_ms}); }
};

Times times_of(const Load& load, const Chip& chip) {
    return {1e3 * load.shading / (kBusy * chip.lanes_per_s), 1e3 * load.vertices / (kBusy * chip.lanes_per_s),
            1e3 * load.triangles / chip.triangles_per_s, 1e3 * load.bytes() / chip.bytes_per_s};
}

// Colour is written once (and once more what of the sky is for later) and scanned out once; a vertex is read twice,
// some 24 bytes of it; a fetch that misses brings about a texel for each pixel.
void ask(Load& load, const render::Drawn& work, double size_px, const Chip& chip) {
    for (std::size_t kind = 0; kind < render::kDrawnKinds; ++kind) {
        const auto count = static_cast<double>(work.of[kind].vertices);
        load.vertex_count += count;
        load.vertices += count * ((*chip.costs)[kind].vertex + (*chip.costs)[kind].binning);
    }
    load.triangles = static_cast<double>(work.triangles);
    load.draws = static_cast<double>(work.draws);
    load.sent = static_cast<double>(work.sent_bytes);
    const double dome_px = size_px * render::kSkyDrawnAnew;
    load.shade(dome_px, chip.dome->fragment);
    load.moved = 8 * size_px + 4 * dome_px;
}

void shade(Load& load, const ShadedPixels& pixels, double share, const Chip& chip) {
    for (std::size_t kind = 0; kind < pixels.size(); ++kind)
        load.shade(share * pixels[kind], (*chip.costs)[kind].fragment, beside(static_cast<render::DrawnKind>(kind)));
}

// As a flight goes on: of the frames in which each view has its turn, the one that asks for most.
struct Steady {
    render::Drawn most;
    float split_m = 0;
};
Steady steady_frame(FourViews& views, bool holds) {
    constexpr float kAt_s = 10;  // at its mean speed
    constexpr int kFrames = 16;
    views.picture.holds_distance = holds;
    Steady steady;
    for (int n = 0; n < kFrames; ++n) {
        views.look(kAt_s + static_cast<float>(n) / static_cast<float>(kHz));
        const render::Drawn drawn = views.draw();
        if (n < kFrames / 2) continue;
        if (drawn.triangles >= steady.most.triangles) steady.most = drawn;
        steady.split_m = drawn.held_from_m;
    }
    return steady;
}

Load load_of(FourViews& views, bool holds, const Chip& chip, float& split_m) {
    using Part = render::choose::Reach::Part;
    const Steady steady = steady_frame(views, holds);
    const double size_px = static_cast<double>(views.picture.size.x) * views.picture.size.y;
    Load load;
    ask(load, steady.most, size_px, chip);
    split_m = steady.split_m;
    if (steady.most.held_views == 0) {
        shade(load, shaded_pixels(views.easel, views.picture), 1, chip);
        return load;
    }
    ShadedPixels near = shaded_pixels(views.easel, views.picture, Part::Near, split_m);
    ShadedPixels far = shaded_pixels(views.easel, views.picture, Part::Far, split_m);
    // What is held is shown where nothing near is and over near ground that lies beyond the split, which is drawn for
    // what stands on it.
    const ShadedPixels before =
        shaded_pixels(views.easel, views.picture, Part::Near, split_m - render::choose::Reach::kUnderCrowns_m);
    load.shade(before[at(render::DrawnKind::Sky)], chip.distance->fragment);
    near[at(render::DrawnKind::Sky)] = far[at(render::DrawnKind::Sky)] = 0;
    shade(load, near, 1, chip);
    shade(load, far, render::kDistanceDrawnAnew, chip);
    // Written, and read for its copy, and written there.
    load.moved += 3 * 4 * size_px * render::kDistanceDrawnAnew;
    return load;
}

}  // namespace

void estimate(Results& results, const std::string& profile, FourViews& views) {
    const Chip& chip = *std::ranges::find(kChips, profile, &Chip::name);
    float split_m = 0;
    const double anew_ms = times_of(load_of(views, false, chip, split_m), chip).frame_ms();
    const Load load = load_of(views, true, chip, split_m);
    const Times times = times_of(load, chip);
    const std::string row = "detail." + profile + "_";
    const auto add = [&](const char* name, double value, const char* unit) {
        results.push_back({row + name, value, unit, 1});
    };
    add("alpha", views.picture.detail.alpha, "detail");
    add("scale", views.picture.detail.scale, "of a side");
    add("triangles", load.triangles, "triangles");
    add("vertices", load.vertex_count, "vertices");
    add("shaded_pixels", load.shaded, "pixels, drawn over ones too");
    add("draws", load.draws, "draws");
    add("sent_kb", load.sent / 1e3, "KB new every frame");
    add("moved_mb", load.bytes() / 1e6, "MB a frame, estimated");
    add("shading_ms", times.shading_ms, "ms");
    add("vertices_ms", times.vertices_ms, "ms");
    add("triangles_ms", times.triangles_ms, "ms");
    add("memory_ms", times.memory_ms, "ms");
    add("frame_ms", times.frame_ms(), "ms: the longest of shading and vertices, triangles, memory");
    add("held_from_m", split_m, "m: what is farther is drawn for one view in a frame");
    add("anew_ms", anew_ms, "ms: the frame, if nothing far were held");
    add("assumed_busy", kBusy, "of the processors' cycles");
    add("assumed_lanes", chip.lanes_per_s / 1e9, "G instructions times lanes a second");
    add("assumed_triangles", chip.triangles_per_s / 1e6, "M triangles a second");
    add("assumed_memory", chip.bytes_per_s / 1e9, "GB/s for the GPU");
    add("assumed_beside", beside(render::DrawnKind::Leaves), "pixels shaded for each of a plant's");
    add("assumed_signs_ms", 0, "ms: letters and frames are left out");
    add("assumed_spread_ms", 0, "ms: spreading views that are drawn smaller is left out");
    add("busy_for_60hz", kHz * (load.shading + load.vertices) / chip.lanes_per_s,
        "of the cycles would be enough for 60 Hz");
    add_costs(results, chip);
}

}  // namespace quadrat::benches
