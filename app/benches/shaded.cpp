// SPDX-License-Identifier: Apache-2.0
#include "benches/shaded.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quadrat::benches {
namespace {

constexpr std::size_t at(render::Kind kind) { return static_cast<std::size_t>(kind); }

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
    double lanes_per_s;      // instructions times lanes
    double triangles_per_s;  // nobody has published it: what is planned for, 250,000 at 60 a second
    double bytes_per_s;      // of the memory's peak, a share
};
constexpr double kHz = 60;
constexpr double kBusy = 0.7;  // of the processors' cycles: four threads hide most fetches, not all

// Two slices of four processors, each an instruction on sixteen lanes every four cycles, at 500 MHz. The Pi 5's are
// taken for twice as fast: glmark2 has it so.
const Chip kChips[] = {{"pi4", &kPi4Costs, &kPi4Dome, 16e9, 15e6, 0.35 * 12.8e9},
                       {"pi5", &kPi5Costs, &kPi5Dome, 32e9, 30e6, 0.35 * 17e9}};

// Pixels come in squares of four: those of a small triangle's rim are shaded beside it.
double beside(render::Kind kind) { return kind <= render::Kind::Wood ? 1.6 : 1.1; }

// What each shader takes on that chip, as its own compiler counts.
void add_costs(Results& results, const Chip& chip) {
    const auto add = [&](const ShaderCosts& costs) {
        const std::string row = std::string("detail.") + chip.name + "_instructions." + costs.shader;
        results.push_back({row, static_cast<double>(costs.fragment),
                           fmt::format("a pixel; a vertex {}, in binning {}", costs.vertex, costs.binning), 1});
    };
    for (const ShaderCosts& costs : *chip.costs) add(costs);
    add(*chip.dome);
}

}  // namespace

const ChipCosts kPi4Costs{{{"leaves.frag", 17, 172, 101},
                           {"wood.frag", 29, 183, 71},
                           {"cover.vert", 8, 93, 73},
                           {"near_ground.frag", 28, 191, 81},
                           {"water.frag", 54, 346, 45},
                           {"held_sky.frag", 14, 158, 146},
                           {"falling.frag", 15, 170, 155}}};
const ChipCosts kPi5Costs{{{"leaves.frag", 18, 150, 93},
                           {"wood.frag", 29, 161, 64},
                           {"cover.vert", 8, 83, 60},
                           {"near_ground.frag", 28, 174, 73},
                           {"water.frag", 53, 336, 40},
                           {"held_sky.frag", 14, 133, 123},
                           {"falling.frag", 12, 132, 141}}};
const ShaderCosts kPi4Dome{"sky.frag", 48, 158, 57};
const ShaderCosts kPi5Dome{"sky.frag", 44, 149, 50};

ShadedPixels shaded_pixels(stage::Easel& easel, const render::Frame& picture) {
    using render::Kind;
    constexpr render::Measured kLeaves{true, false, false, false, false};
    constexpr render::Measured kPlants{true, true, false, false, false};
    constexpr render::Measured kSolid{true, true, true, false, false};
    constexpr render::Measured kWet{true, true, true, true, false};
    constexpr render::Measured kAll{true, true, true, true, true};
    ShadedPixels pixels{};
    pixels[at(Kind::Leaves)] = counted(easel, picture, kLeaves);
    const double plants = counted(easel, picture, kPlants);
    pixels[at(Kind::Wood)] = plants - pixels[at(Kind::Leaves)];
    // The cover's pixels are among them, at what the ground's take, which is more.
    pixels[at(Kind::Ground)] = counted(easel, picture, kSolid) - plants;
    pixels[at(Kind::Water)] = changed(easel, picture, kSolid, kWet);
    pixels[at(Kind::Sky)] = changed(easel, picture, kWet, kAll);  // and what falls before it
    return pixels;
}

void estimate(Results& results, const std::string& profile, stage::Easel& easel, const render::Frame& picture) {
    const Chip& chip = *std::ranges::find(kChips, profile, &Chip::name);
    const ShadedPixels pixels = shaded_pixels(easel, picture);
    const display::Canvas canvas = easel.display().begin_frame();
    render::Frame whole = picture;
    whole.framebuffer = canvas.framebuffer;
    const render::Drawn work = easel.renderer().draw(whole);
    easel.display().present();
    double shading = 0;
    double vertices = 0;
    double shaded = 0;
    double vertex_count = 0;
    for (std::size_t kind = 0; kind < render::kKinds; ++kind) {
        const ShaderCosts& costs = (*chip.costs)[kind];
        shaded += pixels[kind];
        shading += pixels[kind] * beside(static_cast<render::Kind>(kind)) * costs.fragment;
        const auto count = static_cast<double>(work.of[kind].vertices);
        vertex_count += count;
        vertices += count * (costs.vertex + costs.binning);
    }
    const double size_px = static_cast<double>(picture.size.x) * picture.size.y;
    const double dome_px = size_px * render::kSkyDrawnAnew;
    shaded += dome_px;
    shading += dome_px * chip.dome->fragment;
    // Colour is written once (and once more what of the sky is for later) and scanned out once; a vertex is read twice,
    // some 24 bytes of it; a fetch that misses brings about a texel for each pixel.
    const double bytes =
        8 * size_px + 4 * dome_px + 2 * 24 * vertex_count + 4 * shaded + static_cast<double>(work.sent_bytes);
    const double shading_ms = 1e3 * shading / (kBusy * chip.lanes_per_s);
    const double vertices_ms = 1e3 * vertices / (kBusy * chip.lanes_per_s);
    const double triangles_ms = 1e3 * static_cast<double>(work.triangles) / chip.triangles_per_s;
    const double memory_ms = 1e3 * bytes / chip.bytes_per_s;
    const double frame_ms = std::max({shading_ms + vertices_ms, triangles_ms, memory_ms});
    const std::string row = "detail." + profile + "_";
    const auto add = [&](const char* name, double value, const char* unit) {
        results.push_back({row + name, value, unit, 1});
    };
    add("alpha", picture.detail.alpha, "detail");
    add("scale", picture.detail.scale, "of a side");
    add("triangles", static_cast<double>(work.triangles), "triangles");
    add("vertices", vertex_count, "vertices");
    add("shaded_pixels", shaded, "pixels, drawn over ones too");
    add("draws", static_cast<double>(work.draws), "draws");
    add("sent_kb", static_cast<double>(work.sent_bytes) / 1e3, "KB new every frame");
    add("moved_mb", bytes / 1e6, "MB a frame, estimated");
    add("shading_ms", shading_ms, "ms");
    add("vertices_ms", vertices_ms, "ms");
    add("triangles_ms", triangles_ms, "ms");
    add("memory_ms", memory_ms, "ms");
    add("frame_ms", frame_ms, "ms: the longest of shading and vertices, triangles, memory");
    add("assumed_busy", kBusy, "of the processors' cycles");
    add("assumed_lanes", chip.lanes_per_s / 1e9, "G instructions times lanes a second");
    add("assumed_triangles", chip.triangles_per_s / 1e6, "M triangles a second");
    add("assumed_memory", chip.bytes_per_s / 1e9, "GB/s for the GPU");
    add("assumed_beside", beside(render::Kind::Leaves), "pixels shaded for each of a plant's");
    add("assumed_signs_ms", 0, "ms: letters and frames are left out");
    add("assumed_spread_ms", 0, "ms: spreading views that are drawn smaller is left out");
    add("busy_for_60hz", kHz * (shading + vertices) / chip.lanes_per_s, "of the cycles would be enough for 60 Hz");
    add_costs(results, chip);
}

}  // namespace quadrat::benches
