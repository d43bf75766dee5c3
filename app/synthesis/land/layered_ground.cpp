// SPDX-License-Identifier: Apache-2.0
// Peytavie, Galin, Merillou & Grosjean, "Arches: a framework for modeling complex terrains", 2009: stacks of materials
// with simple tools on them, sand that is made stable, and the surface as where a box about a point is half full.
// Theirs has seven materials; ours the three that show.
#include "synthesis/land/layered_ground.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace quadrat::synthesis::land {
namespace {

constexpr float kNothing_m = 1.0e6F;
constexpr float kThinnest_m = 1.0e-4F;
constexpr std::array<std::array<int, 2>, 4> kBeside{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

}  // namespace

LayeredGround::LayeredGround(int columns, int rows, float cell_m, float bottom_m)
    : layers_(columns, rows), cell_m_(cell_m), bottom_m_(bottom_m) {
    assert(columns > 0 && rows > 0 && cell_m > 0);
}

Material LayeredGround::at(int x, int y, float height_m) const {
    if (height_m < bottom_m_) return Material::Rock;
    for (const Layer& layer : layers_.at(x, y))
        if (height_m < layer.top_m) return layer.material;
    return Material::Air;
}

void LayeredGround::fill(int x, int y, float from_m, float to_m, Material material) {
    from_m = std::max(from_m, bottom_m_);
    if (to_m - from_m < kThinnest_m) return;
    std::vector<Layer>& layers = layers_.at(x, y);
    std::vector<Layer> out;
    const auto add = [&](Material m, float top_m) {
        const float below_m = out.empty() ? bottom_m_ : out.back().top_m;
        if (top_m - below_m < kThinnest_m) return;
        if (!out.empty() && out.back().material == m)
            out.back().top_m = top_m;
        else
            out.push_back({m, top_m});
    };
    for (const Layer& layer : layers) add(layer.material, std::min(layer.top_m, from_m));
    add(Material::Air, from_m);
    add(material, to_m);
    for (const Layer& layer : layers) add(layer.material, layer.top_m);
    while (!out.empty() && out.back().material == Material::Air) out.pop_back();
    layers = std::move(out);
}

float LayeredGround::floor_m(int x, int y, float height_m) const {
    float floor_m = bottom_m_;
    float below_m = bottom_m_;
    for (const Layer& layer : layers_.at(x, y)) {
        if (below_m > height_m) break;
        if (layer.material != Material::Air) floor_m = std::min(layer.top_m, height_m);
        below_m = layer.top_m;
    }
    return floor_m;
}

float LayeredGround::ceiling_m(int x, int y, float height_m) const {
    float below_m = bottom_m_;
    for (const Layer& layer : layers_.at(x, y)) {
        if (layer.material != Material::Air && below_m >= height_m) return below_m;
        below_m = layer.top_m;
    }
    return kNothing_m;
}

double LayeredGround::volume_m3(Material material) const {
    double sum_m = 0;
    for (const std::vector<Layer>& layers : layers_.samples) {
        float below_m = bottom_m_;
        for (const Layer& layer : layers) {
            if (layer.material == material) sum_m += static_cast<double>(layer.top_m - below_m);
            below_m = layer.top_m;
        }
    }
    return sum_m * static_cast<double>(cell_m_) * static_cast<double>(cell_m_);
}

// All sand with air under it comes down onto what lies below.
void LayeredGround::drop_sand(int x, int y) {
    std::vector<Layer>& layers = layers_.at(x, y);
    for (std::size_t i = 1; i < layers.size(); ++i) {
        if (layers[i].material != Material::Sand || layers[i - 1].material != Material::Air) continue;
        const float below_m = i > 1 ? layers[i - 2].top_m : bottom_m_;
        const float top_m = layers[i].top_m;
        const float thick_m = top_m - layers[i - 1].top_m;
        fill(x, y, layers[i - 1].top_m, top_m, Material::Air);
        fill(x, y, below_m, below_m + thick_m, Material::Sand);
        i = 0;
    }
}

void LayeredGround::slide_from(int x, int y, float slope) {
    // The topmost of each sand that has air over it; sliding changes the column, so its layers are copied.
    const std::vector<Layer> layers = layers_.at(x, y);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool is_open = i + 1 == layers.size() || layers[i + 1].material == Material::Air;
        if (layers[i].material != Material::Sand || !is_open) continue;
        float top_m = layers[i].top_m;
        const float under_m = i > 0 ? layers[i - 1].top_m : bottom_m_;
        for (const auto& [dx, dy] : kBeside) {
            const int nx = x + dx;
            const int ny = y + dy;
            if (!layers_.is_inside(nx, ny) || at(nx, ny, top_m - kThinnest_m) != Material::Air) continue;
            const float floor_m = this->floor_m(nx, ny, top_m);
            const float room_m = std::min(top_m, ceiling_m(nx, ny, floor_m)) - floor_m;
            const float over_m = top_m - floor_m - slope * cell_m_;
            const float moved_m = std::min({0.5F * over_m, top_m - under_m, room_m});
            if (moved_m < 2 * kThinnest_m) continue;
            fill(x, y, top_m - moved_m, top_m, Material::Air);
            fill(nx, ny, floor_m, floor_m + moved_m, Material::Sand);
            top_m -= moved_m;
        }
    }
}

void LayeredGround::settle(float slope, int rounds) {
    const auto each = [&](const auto& visit) {
        for (int y = 0; y < rows(); ++y)
            for (int x = 0; x < columns(); ++x) visit(x, y);
    };
    each([&](int x, int y) { drop_sand(x, y); });
    for (int round = 0; round < rounds; ++round) each([&](int x, int y) { slide_from(x, y, slope); });
}

double LayeredGround::drop_loose_rock_m3(float step_m) {
    float top_m = bottom_m_;
    for (const std::vector<Layer>& layers : layers_.samples)
        if (!layers.empty()) top_m = std::max(top_m, layers.back().top_m);
    const int levels = static_cast<int>(std::ceil((top_m - bottom_m_) / step_m));
    if (levels < 1) return 0;
    const auto height_m = [&](int level) { return bottom_m_ + step_m * (static_cast<float>(level) + 0.5F); };
    const auto index = [&](int x, int y, int level) {
        return static_cast<std::size_t>(level) * layers_.samples.size() + layers_.index(x, y);
    };
    std::vector<std::uint8_t> is_held(static_cast<std::size_t>(levels) * layers_.samples.size(), 0);
    std::vector<std::array<int, 3>> waiting;
    const auto hold = [&](int x, int y, int level) {
        if (!layers_.is_inside(x, y) || level < 0 || level >= levels) return;
        if (is_held[index(x, y, level)] != 0 || at(x, y, height_m(level)) != Material::Rock) return;
        is_held[index(x, y, level)] = 1;
        waiting.push_back({x, y, level});
    };
    for (int y = 0; y < rows(); ++y)
        for (int x = 0; x < columns(); ++x) hold(x, y, 0);
    while (!waiting.empty()) {
        const auto [x, y, level] = waiting.back();
        waiting.pop_back();
        for (const auto& [dx, dy] : kBeside) hold(x + dx, y + dy, level);
        hold(x, y, level + 1);
        hold(x, y, level - 1);
    }
    const double before = volume_m3(Material::Rock);
    for (int y = 0; y < rows(); ++y)
        for (int x = 0; x < columns(); ++x)
            for (int level = 0; level < levels; ++level)
                if (is_held[index(x, y, level)] == 0 && at(x, y, height_m(level)) == Material::Rock)
                    fill(x, y, height_m(level) - 0.5F * step_m, height_m(level) + 0.5F * step_m, Material::Sand);
    return before - volume_m3(Material::Rock);
}

// How much of a height is not air.
double LayeredGround::solid_m(int x, int y, float from_m, float to_m) const {
    double sum_m = static_cast<double>(std::max(0.0F, std::min(to_m, bottom_m_) - from_m));
    float below_m = bottom_m_;
    for (const Layer& layer : layers_.at(x, y)) {
        if (layer.material != Material::Air)
            sum_m += static_cast<double>(std::max(0.0F, std::min(to_m, layer.top_m) - std::max(from_m, below_m)));
        below_m = layer.top_m;
    }
    return sum_m;
}

mesh::Surface LayeredGround::surface() const {
    constexpr int kSide = mesh::SparseField::kSide;
    constexpr int kMargin = 3;  // samples of air about it
    float top_m = bottom_m_;
    for (const std::vector<Layer>& layers : layers_.samples)
        if (!layers.empty()) top_m = std::max(top_m, layers.back().top_m);
    const int levels = static_cast<int>(std::ceil((top_m - bottom_m_) / cell_m_));
    const auto blocks = [](int samples) { return (samples + 2 * kMargin + kSide - 1) / kSide; };
    const glm::ivec3 size{blocks(columns()), blocks(levels), blocks(rows())};
    mesh::SparseField field(size);
    // The share of a box of two cells that is full, less a half; beyond the columns and under the bottom there is air.
    const auto fullness = [&](glm::ivec3 sample) {
        const glm::ivec3 at = sample - kMargin;
        const float middle_m = bottom_m_ + cell_m_ * static_cast<float>(at.y);
        double sum = 0;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                if (!layers_.is_inside(at.x + i, at.z + j)) continue;
                const double weight = (i == 0 ? 0.5 : 0.25) * (j == 0 ? 0.5 : 0.25);
                const float from_m = std::max(middle_m - cell_m_, bottom_m_);
                sum += weight * solid_m(at.x + i, at.z + j, from_m, middle_m + cell_m_) /
                       (2 * static_cast<double>(cell_m_));
            }
        // Never a half to the last digit: a corner on the surface would have a facet without area.
        return static_cast<float>(sum) - 0.4999F;
    };
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const int number = field.make({x, y, z});
                auto& block = field.block(static_cast<std::size_t>(number));
                for (int i = 0; i < mesh::SparseField::kSamples; ++i)
                    block[static_cast<std::size_t>(i)] = fullness(
                        kSide * glm::ivec3{x, y, z} + glm::ivec3{i % kSide, i / kSide % kSide, i / kSide / kSide});
            }
    mesh::Surface surface = mesh::polygonise(field);
    const glm::vec3 middle{0.5F * static_cast<float>(columns() - 1), 0, 0.5F * static_cast<float>(rows() - 1)};
    for (glm::vec3& at : surface.positions)
        at = cell_m_ * (at - static_cast<float>(kMargin) - middle) + glm::vec3{0, bottom_m_, 0};
    return surface;
}

}  // namespace quadrat::synthesis::land
