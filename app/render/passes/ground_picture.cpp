// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/passes/encode.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

// The ground's grain in the light of the sun, which stands still: what faces it is brighter than level ground, what
// turns away darker.
void light_grain_row(const scene::Land& land, glm::vec3 to_sun, mesh::Image& lit, int row) {
    const glm::vec2 tilt = glm::vec2{to_sun.x, to_sun.z} / std::max(to_sun.y, 0.35F);
    const int channels = land.detail.channels;
    for (int x = 0; x < lit.width; ++x) {
        for (int kind = 0; kind < 2; ++kind) {
            float light = static_cast<float>(land.detail.pixel(x, row)[std::min(kind, channels - 1)]);
            if (!land.detail_slopes.bytes.empty()) {
                const std::uint8_t* slopes = land.detail_slopes.pixel(x, row) + 2 * kind;
                const glm::vec2 rise{static_cast<float>(slopes[0]) - 128, static_cast<float>(slopes[1]) - 128};
                light -= glm::dot(rise, tilt);
            }
            lit.pixel(x, row)[kind] = static_cast<std::uint8_t>(std::clamp(light + 0.5F, 0.0F, 255.0F));
        }
    }
}

// The grain once more, larger and turned, as a relief of metres that the ground's picture holds itself.
class CoarseRelief {
  public:
    // grain: lit.
    CoarseRelief(const scene::Land& land, const mesh::Image& grain) : land_(land), relief_(gl::halved(grain)) {}

    // Brighter and darker, by what each kind of ground has of it.
    void add_to(mesh::Image& shown, int row) const {
        const float per_px = land_.side_m() / (static_cast<float>(shown.width) * land_.detail_tile_m) * kTiles;
        const float z = (static_cast<float>(row) + 0.5F - 0.5F * static_cast<float>(shown.height)) * per_px;
        const float x0 = (0.5F - 0.5F * static_cast<float>(shown.width)) * per_px;
        const mesh::Image& kinds = land_.kinds;
        const int across = relief_.width - 1;  // a power of two
        const int down = relief_.height - 1;
        const std::uint8_t* kind_row =
            kinds.bytes.empty() ? nullptr : kinds.pixel(0, row * (kinds.height - 1) / (shown.height - 1));
        for (int x = 0; x < shown.width; ++x) {
            const float east = x0 + static_cast<float>(x) * per_px;
            const int u = static_cast<int>(std::floor((east - 0.5F * z) * static_cast<float>(relief_.width)));
            const int v = static_cast<int>(std::floor((z + 0.5F * east) * static_cast<float>(relief_.height)));
            const std::uint8_t* lit = relief_.pixel(u & across, v & down);
            const std::uint8_t* kind =
                kind_row == nullptr ? kSoft : kind_row + kinds.channels * (x * (kinds.width - 1) / (shown.width - 1));
            // In 1/65536 of the brightness.
            const int more = (((lit[0] - 128) * kind[0] + (lit[1] - 128) * kind[1]) * kStrength) >> 16;
            std::uint8_t* out = shown.pixel(x, row);
            for (int c = 0; c < 3; ++c)
                out[c] = static_cast<std::uint8_t>(std::clamp((out[c] * (65536 + more) + 32768) >> 16, 0, 255));
        }
    }

  private:
    static constexpr float kTiles = 0.107F;  // of it to one of the grain
    static constexpr int kStrength = static_cast<int>(0.5F * kGrain * 65536 / (255 * 255) * 65536);
    static constexpr std::uint8_t kSoft[2] = {255, 0};
    const scene::Land& land_;
    mesh::Image relief_;
};

// The light over one row of the ground's picture, as roots: between the rows and columns of a coarser image.
struct LightRow {
    const mesh::Image& light;
    float down;
    int upper;
    int lower;

    LightRow(const mesh::Image& light_, int row, int rows) : light(light_) {
        const float at =
            (static_cast<float>(row) + 0.5F) * static_cast<float>(light.height) / static_cast<float>(rows) - 0.5F;
        const int above = static_cast<int>(std::floor(at));
        down = at - static_cast<float>(above);
        upper = std::clamp(above, 0, light.height - 1);
        lower = std::clamp(above + 1, 0, light.height - 1);
    }
    float at(int column, int channel) const {
        const float a = light.pixel(column, upper)[channel];
        const float b = light.pixel(column, lower)[channel];
        return a + (b - a) * down;
    }
};

// Depth of water as the eye takes it: what light is lost on the way down and up. The rim is deep: all beyond it repeats
// the rim.
std::array<std::uint8_t, 256> deepness_of_depth() {
    std::array<std::uint8_t, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = unsigned_byte(1 - std::exp(-0.35F * 24.0F * static_cast<float>(i) / 255));
    return table;
}

// What is shown for the root of a light; entry i: root i / 4 / 255, to the root of two.
std::array<std::uint8_t, 1445> shown_by_root() {
    std::array<std::uint8_t, 1445> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = unsigned_byte(encode_root(static_cast<float>(i) / (4 * 255)));
    return table;
}

void light_row(const mesh::Image& albedo, const mesh::Image& light, mesh::Image& lit, int row) {
    static const auto deepness = deepness_of_depth();
    static const auto shown = shown_by_root();
    const LightRow over(light, row, lit.height);
    std::vector<float> smooth(static_cast<std::size_t>(light.width + 1) * 4);
    for (int column = 0; column <= light.width; ++column)
        for (int c = 0; c < 4; ++c)
            smooth[static_cast<std::size_t>(4 * column + c)] = over.at(std::min(column, light.width - 1), c);
    const float step = static_cast<float>(light.width) / static_cast<float>(lit.width);
    for (int x = 0; x < lit.width; ++x) {
        const float at = std::max((static_cast<float>(x) + 0.5F) * step - 0.5F, 0.0F);
        const auto left = static_cast<int>(at);
        const float aside = at - static_cast<float>(left);
        const float* from = &smooth[static_cast<std::size_t>(4 * left)];
        const std::uint8_t* colour = albedo.pixel(x, row);
        std::uint8_t* out = lit.pixel(x, row);
        for (int c = 0; c < 3; ++c) {
            const float halved_light = from[c] + (from[c + 4] - from[c]) * aside;
            const float root = static_cast<float>(gl::root_of_srgb(colour[c])) * std::sqrt(halved_light * (2.0F / 255));
            out[c] = shown[static_cast<std::size_t>(4 * root + 0.5F)];
        }
        const bool is_rim = row == 0 || x == 0 || row == lit.height - 1 || x == lit.width - 1;
        out[3] = is_rim ? std::uint8_t{255}
                        : deepness[static_cast<std::size_t>(from[3] + (from[7] - from[3]) * aside + 0.5F)];
    }
}

}  // namespace

void add_ground_picture(gl::Slices& slices, gl::Texture2D& lit, gl::Texture2D& grain,
                        const std::shared_ptr<const scene::Scene>& scene) {
    const scene::Land& source = *scene->land;
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = source.detail.width;
    tiled.height = source.detail.height;
    tiled.channels = 2;
    const auto lit_grain = gl::add_painting(slices, grain, tiled, [scene](mesh::Image& picture, int row) {
        light_grain_row(*scene->land, scene->sky->sun_direction, picture, row);
    });
    gl::TextureShape shape;
    shape.width = source.albedo.width;
    shape.height = source.albedo.height;
    const auto coarse = std::make_shared<std::optional<CoarseRelief>>();
    slices.prepare([coarse, scene, lit_grain] { coarse->emplace(*scene->land, *lit_grain); });
    gl::add_painting(slices, lit, shape, [scene, coarse](mesh::Image& picture, int row) {
        light_row(scene->land->albedo, scene->light.ground, picture, row);
        (*coarse)->add_to(picture, row);
    });
}

}  // namespace quadrat::render::passes
