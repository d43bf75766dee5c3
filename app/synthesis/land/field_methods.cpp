// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/field_methods.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

using noise::Basis;
using noise::Mix;
using noise::Window;

Window window_of(const FieldRequest& r) { return r.window.columns > 0 ? r.window : Window{0, 0, r.size, r.size}; }

// A field a row at a time: us and vs are places in waves of the first octave, out the row.
template <typename Row>
mesh::Field by_rows(const FieldRequest& r, const Row& row) {
    const Window w = window_of(r);
    mesh::Field field(w.columns, w.rows);
    const float scale = r.features / static_cast<float>(r.size - 1);
    const auto width = static_cast<std::size_t>(w.columns);
    std::vector<float> us(width);
    for (int i = 0; i < w.columns; ++i) us[i] = static_cast<float>(w.column + i) * scale;
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, w.rows, 8), [&](const auto& rows) {
        std::vector<float> vs(width);
        for (int y = rows.begin(); y != rows.end(); ++y) {
            std::fill(vs.begin(), vs.end(), static_cast<float>(w.row + y) * scale);
            row(us, vs, std::span(field.samples).subspan(field.index(0, y), width));
        }
    });
    return field;
}

mesh::Field of_pictures(const FieldRequest& r, const noise::Octaves& octaves) {
    const noise::Key key(r.seed.child("field"));
    const float step = r.features / static_cast<float>(r.size - 1);
    return by_rows(r, [&](std::span<const float> us, std::span<const float> vs, std::span<float> out) {
        for (std::size_t i = 0; i < us.size(); ++i) out[i] = r.pictures->fbm(key, us[i], vs[i], step, octaves);
    });
}

template <Basis B, Mix M, bool OneOctave = false>
mesh::Field noise_field(const FieldRequest& r) {
    const noise::Key key(r.seed.child("field"));
    const noise::Octaves octaves{.count = OneOctave ? 1 : r.octaves, .gain = r.gain, .basis = B, .mix = M};
    if (r.pictures) return of_pictures(r, octaves);
    return by_rows(r, [&](std::span<const float> us, std::span<const float> vs, std::span<float> out) {
        noise::fbm(key, us, vs, out, octaves);
    });
}

constexpr float kBendOfPictures = 0.15F;

// I. Quilez's warping: the place is moved by noise before the height is asked for.
mesh::Field warped_field(const FieldRequest& r) {
    const noise::Key key(r.seed.child("field"));
    const noise::Key east(r.seed.child("east"));
    const noise::Key south(r.seed.child("south"));
    const noise::Octaves octaves{.count = r.octaves, .gain = r.gain};
    const noise::Octaves bends{.count = std::min(r.octaves, 4), .gain = r.gain};
    return by_rows(r, [&](std::span<const float> us, std::span<const float> vs, std::span<float> out) {
        std::vector<float> warped_u(us.size());
        std::vector<float> warped_v(us.size());
        noise::fbm(east, us, vs, warped_u, bends);
        noise::fbm(south, us, vs, warped_v, bends);
        for (std::size_t i = 0; i < us.size(); ++i) {
            warped_u[i] = us[i] + 1.4F * warped_u[i];
            warped_v[i] = vs[i] + 1.4F * warped_v[i];
        }
        if (!r.pictures) return noise::fbm(key, warped_u, warped_v, out, octaves);
        // Once across the whole the picture is wide: a bend is a smaller share of it.
        const float step = r.features / static_cast<float>(r.size - 1);
        for (std::size_t i = 0; i < us.size(); ++i) {
            const float u = us[i] + kBendOfPictures * (warped_u[i] - us[i]);
            const float v = vs[i] + kBendOfPictures * (warped_v[i] - vs[i]);
            out[i] = r.pictures->fbm(key, u, v, step, octaves);
        }
    });
}

// A round hill a cell, its place, height and width its own.
float hills_at(base::Seed seed, float u, float v) {
    const int cu = static_cast<int>(std::floor(u));
    const int cv = static_cast<int>(std::floor(v));
    float sum = 0;
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            const std::uint64_t h = base::hash_of(seed, cu + i, cv + j);
            const float du = u - (static_cast<float>(cu + i) + base::unit_of(h));
            const float dv = v - (static_cast<float>(cv + j) + base::unit_of(h << 16U));
            const float width = 0.35F + 0.30F * base::unit_of(h << 32U);
            const float height = 0.2F + 0.8F * base::unit_of(h << 40U);
            sum += height * std::exp(-(du * du + dv * dv) / (width * width));
        }
    }
    return sum;
}

mesh::Field gaussian_hills(const FieldRequest& r) {
    const base::Seed seed = r.seed.child("hills");
    return by_rows(r, [&](std::span<const float> us, std::span<const float> vs, std::span<float> out) {
        for (std::size_t i = 0; i < us.size(); ++i) out[i] = 1.1F * hills_at(seed, us[i], vs[i]) - 0.9F;
    });
}

// Hills and noise under a mask that falls to the sea toward the edges, its coast frayed by noise; the sea at 0.
mesh::Field island(const FieldRequest& r) {
    const base::Seed hills = r.seed.child("hills");
    const noise::Key coast(r.seed.child("coast"));
    const noise::Key key(r.seed.child("field"));
    const float half = 0.5F * r.features;
    return by_rows(r, [&](std::span<const float> us, std::span<const float> vs, std::span<float> out) {
        std::vector<float> fray(us.size());
        noise::fbm(coast, us, vs, fray, {.count = std::min(r.octaves, 6), .gain = r.gain});
        noise::fbm(key, us, vs, out, {.count = r.octaves, .gain = r.gain});
        for (std::size_t i = 0; i < us.size(); ++i) {
            const float x = (us[i] - half) / half;
            const float y = (vs[i] - half) / half;
            const float inside = 0.72F + 0.55F * fray[i] - std::sqrt(x * x + y * y);
            const float mask = std::clamp(inside / 0.45F, -1.0F, 1.0F);
            const float rise = mask > 0 ? mask * mask * (3.0F - 2.0F * mask) : mask;
            out[i] = mask > 0 ? rise * (0.12F + 0.45F * hills_at(hills, us[i], vs[i]) + 0.5F * std::abs(out[i]))
                              : 0.5F * rise;
        }
    });
}

std::shared_ptr<const StreamNetwork> streams_of(const FieldRequest& r) {
    StreamOptions options;
    options.spacing = std::clamp(1.0F / r.features, 0.02F, 1.0F);
    // No finer than a 32nd of the land: there the slopes' own roughness begins.
    options.levels =
        std::clamp(static_cast<int>(std::floor(std::log2(32.0F * options.spacing))) + 1, 0, std::min(r.octaves, 6));
    return std::make_shared<const StreamNetwork>(options, r.seed.child("streams"));
}

// The ground that a network of streams asks for. Away from its beds it is bent and rough, so that no crest is drawn
// with a ruler; on them it is theirs.
mesh::Field streams(const FieldRequest& r) {
    const auto network = r.streams ? r.streams : streams_of(r);
    const noise::Key east(r.seed.child("east"));
    const noise::Key south(r.seed.child("south"));
    const noise::Key rough(r.seed.child("rough"));
    const noise::Octaves octaves{.count = std::max(1, r.octaves - 3), .gain = r.gain};
    return by_rows(r, [&](std::span<const float> us, std::span<const float> vs, std::span<float> out) {
        std::vector<float> xs(us.size());
        std::vector<float> ys(us.size());
        std::array<std::vector<float>, 3> chance;
        for (std::size_t i = 0; i < us.size(); ++i) {
            xs[i] = 4 * us[i];
            ys[i] = 4 * vs[i];
        }
        for (std::size_t c = 0; c < 3; ++c) {
            chance[c].resize(us.size());
            noise::fbm(c == 0 ? east : c == 1 ? south : rough, xs, ys, chance[c], octaves);
        }
        for (std::size_t i = 0; i < us.size(); ++i) {
            const glm::vec2 at = glm::vec2{us[i], vs[i]} / r.features;
            const float free = std::min(network->ground(at).to_stream, 0.1F);
            const StreamNetwork::Ground g = network->ground(at + 0.9F * free * glm::vec2{chance[0][i], chance[1][i]});
            const float height = g.height + 0.7F * free * chance[2][i];
            out[i] = 2.0F * height / network->highest() - 1.0F;
        }
    });
}

template <noise::Scheme S>
mesh::Field subdivided(const FieldRequest& r) {
    const float hurst = std::clamp(-std::log2(std::clamp(r.gain, 0.01F, 1.0F)), 0.0F, 1.5F);
    return noise::subdivide({.scheme = S, .size = r.size, .hurst = hurst}, window_of(r), r.seed.child("field"));
}

constexpr std::array<FieldMethod, 18> kMethods{{
    {"perlin", "one octave of gradient noise", noise_field<Basis::Gradient, Mix::Sum, true>, true},
    {"simplex", "one octave of simplex noise", noise_field<Basis::Simplex, Mix::Sum, true>},
    {"value", "one octave of value noise", noise_field<Basis::Value, Mix::Sum, true>},
    {"cell", "one octave of Worley's cell noise", noise_field<Basis::Cells, Mix::Sum, true>},
    {"cracks", "distance between the nearest two points of cell noise", noise_field<Basis::Cracks, Mix::Sum, true>},
    {"fbm", "fractional Brownian motion of gradient noise", noise_field<Basis::Gradient, Mix::Sum>, true},
    {"fbm-simplex", "fractional Brownian motion of simplex noise", noise_field<Basis::Simplex, Mix::Sum>},
    {"ridged", "Musgrave's ridged multifractal", noise_field<Basis::Gradient, Mix::Ridged>, true},
    {"hybrid", "Musgrave's hybrid multifractal", noise_field<Basis::Gradient, Mix::Hybrid>, true},
    {"hetero", "Musgrave's heterogeneous terrain", noise_field<Basis::Gradient, Mix::Hetero>, true},
    {"warp", "fBm in space warped by fBm", warped_field, true},
    {"gaussian-hills", "round hills of chance heights", gaussian_hills},
    {"island", "hills and noise under an island's mask", island},
    {"streams", "a network of streams, and the land fitted to it", streams},
    {"triangle-edge", "triangular edge subdivision (Fournier, Fussell & Carpenter)",
     subdivided<noise::Scheme::TriangleEdge>},
    {"diamond-square", "diamond-square subdivision (Fournier, Fussell & Carpenter)",
     subdivided<noise::Scheme::DiamondSquare>},
    {"square-square", "square-square subdivision (Miller)", subdivided<noise::Scheme::SquareSquare>},
    {"bin-split", "longest-side bisection (Chen & Shi)", subdivided<noise::Scheme::BinSplit>},
}};

}  // namespace

FieldRequest prepared(const FieldMethod& method, FieldRequest request) {
    if (method.make == streams) request.streams = streams_of(request);
    return request;
}

std::span<const FieldMethod> field_methods() { return kMethods; }

const FieldMethod* field_method(std::string_view name) {
    const auto found =
        std::find_if(kMethods.begin(), kMethods.end(), [&](const FieldMethod& m) { return m.name == name; });
    return found == kMethods.end() ? nullptr : &*found;
}

}  // namespace quadrat::synthesis::land
