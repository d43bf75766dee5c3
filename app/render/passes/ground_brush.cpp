// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_brush.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "render/gl/texture.hpp"
#include "render/passes/encode.hpp"
#include "scene/night_eye.hpp"
#include "scene/withering.hpp"

namespace quadrat::render::passes {
namespace {

std::size_t index(int n) { return static_cast<std::size_t>(n); }

std::uint8_t byte_of(float share) { return static_cast<std::uint8_t>(255 * std::clamp(share, 0.0F, 1.0F) + 0.5F); }

// How deep water looks that is so deep, 1 is 24 m: what light is lost on the way down and up.
float depth_shown(float depth) {
    constexpr float kDeepest_m = 24;
    constexpr float kLostPerM = 0.35F;
    return 1 - std::exp(-kLostPerM * kDeepest_m * depth);
}

// Of a byte, and of one more.
const std::array<float, 257>& depths_shown() {
    static const std::array<float, 257> table = [] {
        std::array<float, 257> shown{};
        for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = depth_shown(static_cast<float>(i) / 255);
        return shown;
    }();
    return table;
}

struct Between {
    int before, after;
    float share;
};

Between between(float place, int count) {
    const float inside = std::clamp(place, 0.0F, static_cast<float>(count - 1));
    const int before = static_cast<int>(inside);
    return {before, std::min(before + 1, count - 1), inside - static_cast<float>(before)};
}

// std::lerp() takes care of more than is asked of it here.
float mix(float a, float b, float share) { return a + share * (b - a); }

}  // namespace

GroundBrush::Coarser::Coarser(const mesh::Image& image, float first, float step, int pixels)
    : image_(&image), mixed_(index(image.width * image.channels)) {
    for (int x = 0; x < pixels; ++x) {
        const Between at = between(first + step * static_cast<float>(x), image.width);
        before_.push_back(at.before);
        after_.push_back(at.after);
        share_.push_back(at.share);
    }
}

void GroundBrush::Coarser::spread(float row, std::span<std::vector<float>> channels) {
    const Between rows = between(row, image_->height);
    const std::uint8_t* above = image_->pixel(0, rows.before);
    const std::uint8_t* below = image_->pixel(0, rows.after);
    for (std::size_t i = 0; i < mixed_.size(); ++i)
        mixed_[i] = mix(static_cast<float>(above[i]), static_cast<float>(below[i]), rows.share);
    const std::size_t stride = channels.size();
    for (std::size_t c = 0; c < stride; ++c) {
        const float* mixed = mixed_.data() + c;
        float* to = channels[c].data();
        for (std::size_t x = 0; x < share_.size(); ++x)
            to[x] = mix(mixed[stride * index(before_[x])], mixed[stride * index(after_[x])], share_[x]);
    }
}

GroundBrush::GroundBrush(const Sheet& sheet, glm::ivec2 size)
    : sheet_(sheet),
      size_(size),
      light_(sheet.light, 0.5F * static_cast<float>(sheet.light.width) / static_cast<float>(size.x) - 0.5F,
             static_cast<float>(sheet.light.width) / static_cast<float>(size.x), size.x),
      kinds_(sheet.kinds, 0.5F * static_cast<float>(sheet.kinds.width - 1) / static_cast<float>(size.x),
             static_cast<float>(sheet.kinds.width - 1) / static_cast<float>(size.x), size.x),
      colours_(4 * index(size.x)),
      relieved_(index(size.x)) {
    assert(sheet.light.channels == 4 && sheet.kinds.channels == 2 && sheet.relief.channels == 2);
    while (sheet.colours.width() >> halvings_ > size.x) ++halvings_;
    for (auto& channel : lit_) channel.resize(index(size.x));
    for (auto& channel : kind_) channel.resize(index(size.x));
    for (auto* values : {&slopes_.height_m, &slopes_.east, &slopes_.south}) values->resize(index(size.x));
}

// Turned, so that its tiles are not seen to lie in rows.
void GroundBrush::relieve(float over_land) {
    const mesh::Image& relief = sheet_.relief;
    const auto columns = static_cast<std::uint64_t>(relief.width);
    const auto rows = static_cast<std::uint64_t>(relief.height);
    // Tiles, of which no more than the fraction counts, from the middle of one texel to that of the next: it wraps
    // around by itself.
    const auto turned = [](double tiles) {
        return static_cast<std::uint32_t>(std::llround(std::ldexp(tiles - std::floor(tiles), 32)));
    };
    const double tiles = sheet_.relief_tiles;
    const double step = tiles / size_.x;
    const double south = (static_cast<double>(over_land) - 0.5) * tiles;
    const double east = 0.5 * step - 0.5 * tiles;
    std::uint32_t across = turned(east - 0.5 * south - 0.5 / relief.width);
    std::uint32_t down = turned(south + 0.5 * east - 0.5 / relief.height);
    const std::uint32_t step_across = turned(step);
    const std::uint32_t step_down = turned(0.5 * step);
    const std::uint8_t* texels = relief.bytes.data();
    const auto fraction = [](std::uint64_t place) { return static_cast<float>((place >> 8U) & 0xFFFFFFU) * 0x1p-24F; };
    constexpr float kOfByte = 0.5F * kGrain / (255.0F * 255.0F);
    for (std::size_t x = 0; x < relieved_.size(); ++x, across += step_across, down += step_down) {
        const std::uint64_t column = across * columns;
        const std::uint64_t row = down * rows;
        const std::size_t left = column >> 32U;
        const std::size_t upper = row >> 32U;
        const std::size_t right = left + 1 == columns ? 0 : left + 1;
        const std::size_t lower = upper + 1 == rows ? 0 : upper + 1;
        const std::uint8_t* of_upper = texels + 2 * upper * columns;
        const std::uint8_t* of_lower = texels + 2 * lower * columns;
        const float to_right = fraction(column);
        const float to_lower = fraction(row);
        std::array<float, 2> rises;
        for (std::size_t c = 0; c < 2; ++c) {
            const float high = mix(of_upper[2 * left + c], of_upper[2 * right + c], to_right);
            const float low = mix(of_lower[2 * left + c], of_lower[2 * right + c], to_right);
            rises[c] = mix(high, low, to_lower) - 127.5F;
        }
        if (sheet_.height_m != nullptr && kind_[1][x] > 0) rises[1] = stone_on_slope(x, over_land, rises[1]);
        relieved_[x] = 1 + kOfByte * (rises[0] * kind_[0][x] + rises[1] * kind_[1][x]);
    }
}

void GroundBrush::look_at_slopes(float over_land) {
    const mesh::Field& field = *sheet_.height_m;
    const Between rows = between(over_land * static_cast<float>(field.rows - 1), field.rows);
    const auto height = [&](int column) {
        return mix(field.at(column, rows.before), field.at(column, rows.after), rows.share);
    };
    const float columns_per_px = static_cast<float>(field.columns - 1) / static_cast<float>(size_.x);
    for (std::size_t x = 0; x < index(size_.x); ++x) {
        const Between at = between((static_cast<float>(x) + 0.5F) * columns_per_px, field.columns);
        const float left_m = height(at.before);
        const float right_m = height(at.after);
        slopes_.height_m[x] = mix(left_m, right_m, at.share);
        slopes_.east[x] = (right_m - left_m) / sheet_.cell_m;
        slopes_.south[x] = (field.at(at.before, rows.after) - field.at(at.before, rows.before)) / sheet_.cell_m;
    }
}

float GroundBrush::stone_at(float across_tiles, float down_tiles) const {
    const mesh::Image& relief = sheet_.relief;
    const auto wrapped = [](float tiles, int size) {
        const float place = (tiles - std::floor(tiles)) * static_cast<float>(size);
        const int before = std::min(static_cast<int>(place), size - 1);
        return Between{before, before + 1 == size ? 0 : before + 1, place - static_cast<float>(before)};
    };
    const Between x = wrapped(across_tiles, relief.width);
    const Between y = wrapped(down_tiles, relief.height);
    const auto texel = [&](int column, int row) { return static_cast<float>(relief.pixel(column, row)[1]); };
    return mix(mix(texel(x.before, y.before), texel(x.after, y.before), x.share),
               mix(texel(x.before, y.after), texel(x.after, y.after), x.share), y.share) -
           127.5F;
}

// From the side that the slope faces most, as far as it is steep.
float GroundBrush::stone_on_slope(std::size_t x, float over_land, float level) const {
    const float east = slopes_.east[x];
    const float south = slopes_.south[x];
    const float steep2 = east * east + south * south;
    constexpr float kFrom2 = 0.25F;  // squares of rise over run
    constexpr float kWhole2 = 0.9F;
    if (steep2 <= kFrom2) return level;
    const float tiles_per_m = sheet_.relief_tiles / (sheet_.cell_m * static_cast<float>(sheet_.height_m->columns - 1));
    const float up = slopes_.height_m[x] * tiles_per_m;
    const float along_x = (static_cast<float>(x) + 0.5F) / static_cast<float>(size_.x) * sheet_.relief_tiles;
    const float along_z = over_land * sheet_.relief_tiles;
    const float faces_east = east * east / steep2;
    float side = 0;
    const float share = std::clamp(3 * (faces_east - 0.5F) + 0.5F, 0.0F, 1.0F);
    if (share > 0) side += share * stone_at(along_z, up);
    if (share < 1) side += (1 - share) * stone_at(along_x, up + 0.37F);
    return mix(level, side, std::min((steep2 - kFrom2) / (kWhole2 - kFrom2), 1.0F));
}

void GroundBrush::change_colours() {
    for (std::size_t x = 0; x < index(size_.x); ++x) {
        std::uint8_t* const pixel = colours_.data() + 4 * x;
        if (sheet_.colour_seen >= 1 && pixel[1] <= pixel[2]) continue;
        // Near enough to sRGB for that.
        const glm::vec3 root = glm::vec3{pixel[0], pixel[1], pixel[2]} / 255.0F;
        const glm::vec3 own = root * root;
        const glm::vec3 seen =
            scene::seen_by_night(own * scene::withering_of(own, sheet_.withered), sheet_.colour_seen);
        for (int c = 0; c < 3; ++c) pixel[c] = byte_of(std::sqrt(seen[c]));
    }
}

// What lies under water is seen through it.
void GroundBrush::drown(std::uint8_t* pixels) const {
    for (std::size_t x = 0; x < index(size_.x); ++x) {
        std::uint8_t* pixel = pixels + 4 * x;
        if (pixel[3] == 0) continue;
        const float hidden = sheet_.murk * std::min(1.5F * static_cast<float>(pixel[3]) / 255, 1.0F);
        for (int c = 0; c < 3; ++c) {
            const float shown = static_cast<float>(pixel[c]) / 255;
            pixel[c] = byte_of(mix(shown, sheet_.water[c], hidden));
        }
    }
}

void GroundBrush::paint(mesh::Image& picture, int row) {
    assert(picture.width == size_.x && picture.height == size_.y && picture.channels == 4);
    const float over_land = (static_cast<float>(row) + 0.5F) / static_cast<float>(size_.y);
    sheet_.colours.mean_row(halvings_, row, colours_);
    if (sheet_.withered > 0 || sheet_.colour_seen < 1) change_colours();
    light_.spread(over_land * static_cast<float>(sheet_.light.height) - 0.5F, lit_);
    kinds_.spread(over_land * static_cast<float>(sheet_.kinds.height - 1), kind_);
    if (sheet_.height_m != nullptr) look_at_slopes(over_land);
    relieve(over_land);
    const auto& root_of = gl::roots_of_srgb();
    const auto& depths = depths_shown();
    std::uint8_t* pixels = picture.pixel(0, row);
    const std::size_t width = index(size_.x);
    for (std::size_t c = 0; c < 3; ++c) {
        float* lit = lit_[c].data();
        for (std::size_t x = 0; x < width; ++x) lit[x] = std::sqrt(lit[x] * (2.0F / 255)) * (1.0F / 255);
        for (std::size_t x = 0; x < width; ++x) lit[x] *= static_cast<float>(root_of[colours_[4 * x + c]]);
        for (std::size_t x = 0; x < width; ++x) lit[x] = encode_root(lit[x]) * relieved_[x];
        for (std::size_t x = 0; x < width; ++x) pixels[4 * x + c] = byte_of(lit[x]);
    }
    for (std::size_t x = 0; x < width; ++x) {
        const float depth = lit_[3][x];
        const auto before = static_cast<std::size_t>(depth);
        pixels[4 * x + 3] =
            byte_of(depths[before] + (depth - static_cast<float>(before)) * (depths[before + 1] - depths[before]));
    }
    if (sheet_.murk > 0) drown(pixels);
    const bool is_rim = row == 0 || row == size_.y - 1;
    for (std::size_t x = 0; x < width; x += is_rim ? 1 : std::max<std::size_t>(width - 1, 1)) pixels[4 * x + 3] = 255;
}

}  // namespace quadrat::render::passes
