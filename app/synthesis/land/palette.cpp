// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/land/ground.hpp"

namespace quadrat::synthesis::land {
namespace {

struct HexPalette {
    std::uint32_t lush, dry, heath, soil, scree, rock_light, rock_dark, sand, snow, shallow, deep;
};

// Chosen by eye, sRGB.
//   lush      dry       heath     soil      scree     rock light, dark      sand      snow      water
constexpr std::array<HexPalette, 6> kCountries{{
    {0x5E7F3A, 0x9A9A54, 0x7A8048, 0x7C6A4C, 0x8F8878, 0xA39C8C, 0x6E6A62, 0xCDBB92, 0xF1F3F6, 0x5FA39A,
     0x1F4F5C},  // meadow
    {0x6B7442, 0xA08C58, 0x86596B, 0x6A5646, 0x7F7A74, 0x948E88, 0x5A5756, 0xB9A98C, 0xEEF1F5, 0x5B8C8A,
     0x1E3F4A},  // heath
    {0x7C8446, 0xC2A964, 0x8C8A50, 0xA3784E, 0xB59A78, 0xCDB594, 0x96785C, 0xE2CC9C, 0xF5F3EE, 0x58B0AA,
     0x17596C},  // warm coast
    {0x547048, 0x8C8C5C, 0x6C7458, 0x726858, 0x94908A, 0xB2ABA2, 0x706A63, 0xB4AFA0, 0xF6F8FB, 0x62A4A8,
     0x1C4B63},  // alpine
    {0x8A8A4C, 0xC89A5A, 0xA87850, 0xA8623C, 0xB87850, 0xD09068, 0x8E5038, 0xE0B880, 0xF4EEE6, 0x5CA090,
     0x20525A},  // red rock
    {0x4E7A44, 0x84984C, 0x5E8A50, 0x5E4E3C, 0x7A7468, 0x8E8878, 0x54524C, 0xD8C8A0, 0xF1F3F6, 0x52B098,
     0x145868},  // green island
}};
constexpr float kAlpine = 3;

}  // namespace

Palette choose_palette(const scene::LandParameters& p, base::Seed seed) {
    base::RandomStream random{seed.child("palette")};
    const bool is_rugged = p.land_gain > 0.45F && p.land_relief_m > 120.0F;
    constexpr auto kCount = static_cast<float>(kCountries.size());
    float country = p.ground_country + p.ground_chance * random.between(0, kCount);
    if (is_rugged && random.unit() < 0.5 * static_cast<double>(p.ground_chance)) country = kAlpine;
    const float whole = std::floor(country);
    const auto first = static_cast<std::size_t>(whole) % kCountries.size();
    const HexPalette& a = kCountries[first];
    const HexPalette& b = kCountries[(first + 1) % kCountries.size()];
    const float t = std::clamp((country - whole - 0.35F) / 0.3F, 0.0F, 1.0F);
    const auto mixed = [&](std::uint32_t HexPalette::*member) {
        return scene::mix_colours(scene::linear_from_srgb_hex(a.*member), scene::linear_from_srgb_hex(b.*member), t);
    };
    const auto ground = [&](std::uint32_t HexPalette::*member) {
        return scene::shifted_colour(mixed(member), p.ground_lightness, p.ground_saturation);
    };
    Palette palette;
    palette.lush = ground(&HexPalette::lush);
    palette.dry = ground(&HexPalette::dry);
    palette.heath = ground(&HexPalette::heath);
    palette.soil = ground(&HexPalette::soil);
    palette.scree = ground(&HexPalette::scree);
    palette.rock_light = ground(&HexPalette::rock_light);
    palette.rock_dark = ground(&HexPalette::rock_dark);
    palette.sand = ground(&HexPalette::sand);
    palette.snow = mixed(&HexPalette::snow);
    const bool is_peat = p.water_hue < 0;
    const float hue = 0.75F * std::abs(p.water_hue);
    palette.shallow = scene::mix_colours(mixed(&HexPalette::shallow),
                                         scene::linear_from_srgb_hex(is_peat ? 0x6B5A38 : 0x49C4BC), hue);
    palette.deep =
        scene::mix_colours(mixed(&HexPalette::deep), scene::linear_from_srgb_hex(is_peat ? 0x2A2416 : 0x0F5A78), hue);
    const glm::vec3 milk = scene::linear_from_srgb_hex(0xA9C2BC);
    const float milky = std::max(0.5F - p.water_clarity, 0.0F);
    palette.shallow = scene::mix_colours(palette.shallow, milk, milky);
    palette.deep = scene::mix_colours(palette.deep, milk, 0.7F * milky);
    // Over a pale bed, in full light, it would come out as milk.
    palette.shallow = scene::shifted_colour(palette.shallow, 0.8F, 1.1F);
    palette.deep = scene::shifted_colour(palette.deep, 1.0F - 0.4F * std::max(p.water_clarity - 0.5F, 0.0F));
    return palette;
}

}  // namespace quadrat::synthesis::land
