// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "scene/colour.hpp"
#include "scene/tree_parameters.hpp"

namespace quadrat::synthesis::trees {
namespace {

// Colours chosen together by eye, sRGB: leaf, second leaf, bark, grass, blossom (the accent).
struct Dress {
    std::uint32_t leaf, second, bark, grass, blossom;
};
constexpr std::array<Dress, 10> kDresses{{
    {0x6E9440, 0xA3B557, 0x6A5744, 0x8FA354, 0xE9DCC0},  // spring
    {0x4C7038, 0x7C9448, 0x5A4A3C, 0x7F9A4A, 0xE8C25A},  // summer oak
    {0x3E6248, 0x5F8458, 0x6C4F3C, 0x7A9458, 0xDFA6B8},  // deep green
    {0x7F8A58, 0xA3A878, 0x7C7064, 0xA7A468, 0xB59AC8},  // olive
    {0xD2963C, 0xCB6434, 0x54463C, 0xA89E58, 0xC8573F},  // autumn
    {0xD0A94A, 0xA7AE52, 0xC9C2B4, 0x9DA058, 0xE3B04B},  // birch
    {0x557463, 0x809C84, 0x6A5A50, 0x8A9A68, 0xD8D4E6},  // blue conifer
    {0x5E8C3E, 0x8FB048, 0x8A6A50, 0x88AC48, 0xE2604A},  // bright south
    {0x93A65C, 0xE3B9C2, 0x5E4A42, 0x90A860, 0xF0CDD4},  // blossom
    {0xA8603E, 0xC48A4C, 0x5C4C44, 0x94985C, 0xD9C46A},  // copper
}};

int choice(float gene, int count) { return std::clamp(static_cast<int>(std::lround(gene)), 0, count - 1); }

glm::vec3 between(const std::array<std::uint32_t, 6>& hexes, float hue) {
    const float at = std::clamp(hue, 0.0F, 1.0F) * 5.0F;
    const auto i = std::min(static_cast<std::size_t>(at), std::size_t{4});
    return scene::mix_colours(scene::linear_from_srgb_hex(hexes[i]), scene::linear_from_srgb_hex(hexes[i + 1]),
                              at - static_cast<float>(i));
}

glm::vec3 fruit_colour(float hue) { return between({0x9AA84A, 0xE0B43E, 0xE07A2E, 0xC23A2C, 0x7A3458, 0x44508A}, hue); }

// What is as green as grass is as yellow as that too: a bright teal is no leaf's. Both are OKLab's a and b.
float least_yellow(float green) { return 1.1F * -green - 0.02F; }

glm::vec3 without_teal(const glm::vec3& colour) {
    glm::vec3 lab = scene::oklab_from_linear(colour);
    lab.z = std::max(lab.z, least_yellow(lab.y));
    return glm::max(scene::linear_from_oklab(lab), glm::vec3{0});
}

glm::vec3 warmer(const glm::vec3& colour, float by) {
    glm::vec3 lab = scene::oklab_from_linear(colour);
    lab.z += 0.022F * by;
    lab.y += 0.016F * std::max(by, -0.4F);  // no bark is violet
    return glm::max(scene::linear_from_oklab(lab), glm::vec3{0});
}

// The reddest bark is a pine's: redder trunks look painted.
glm::vec3 no_redder(const glm::vec3& bark) {
    constexpr float kMostChroma = 0.055F;
    glm::vec3 lab = scene::oklab_from_linear(bark);
    const float chroma = std::hypot(lab.y, lab.z);
    if (chroma > kMostChroma) lab = {lab.x, lab.y * kMostChroma / chroma, lab.z * kMostChroma / chroma};
    return glm::max(scene::linear_from_oklab(lab), glm::vec3{0});
}

constexpr float kPalm_m = 6;  // high; of a taller one the trunk is not that much thicker

// What sends back more of the light takes its colour: such leaves are white by day, and blue by night.
constexpr float kLightestLeaf = 0.36F;
glm::vec3 no_lighter(const glm::vec3& colour, float most) {
    const float light = scene::luminance(colour);
    return glm::max(light > most ? colour * (most / light) : colour, glm::vec3{0});
}

// The hue and lightness that go with a kind, whatever the palette: firs are darker, cacti bluer.
glm::vec3 tinted(const glm::vec3& colour, const Tint& tint) {
    const glm::vec3 other = scene::linear_from_srgb_hex(tint.srgb);
    const glm::vec3 mixed = tint.share <= 0   ? colour
                            : tint.share >= 1 ? other
                                              : scene::mix_colours(colour, other, tint.share);
    return tint.lightness == 1 ? mixed : scene::shifted_colour(mixed, tint.lightness);
}

// Blossom, fruit and autumn are seasons: half of the range is without, and a whole crown of them is rare.
float festive(float gene) {
    const float t = std::max(2 * gene - 1, 0.0F);
    return t * (0.35F + 0.65F * t);
}

void set_shared(Form& f, const scene::TreeParameters& p) {
    f.type = choice(p.tree_type, 8);
    f.branch_angle_deg = p.tree_branch_angle_deg;
    f.trunk_contraction = p.tree_trunk_contraction;
    f.branch_contraction = p.tree_branch_contraction;
    f.clear_stem = p.tree_clear_stem;
    f.girth = p.tree_girth;
    f.taper = p.tree_taper;
    f.stems = std::max(choice(p.tree_stems, 4), 1);
    f.lean_deg = p.tree_lean_deg;
    f.divergence_deg = p.tree_divergence_deg;
    f.limb_rise = p.tree_limb_rise;
    f.leader = p.tree_leader;
    f.sag = p.tree_sag;
    f.light_seeking = p.tree_light_seeking;
    f.wind_lean = p.tree_wind_lean;
    f.wind_from_deg = p.tree_wind_from_deg;
    f.crowding = p.tree_crowding;
    f.shade_bearing = p.tree_shade_bearing;
    f.wind_crown = p.tree_wind_crown;
    f.straightening = p.tree_straightening;
    f.root_flare = p.tree_root_flare;
    f.bareness = std::pow(p.tree_bareness, 3.0F);
    f.leaf_width = p.tree_leaf_width;
    f.leaf_fold = p.tree_leaf_fold;
    f.leaf_droop = p.tree_leaf_droop;
    f.leaf_clumping = p.tree_leaf_clumping;
    f.leaf_inhibition = p.tree_leaf_inhibition;
    f.fruit = festive(p.tree_fruit);
    f.fruit_m = p.tree_fruit_m;
    f.season = p.tree_season;
    f.climbers = std::max(2 * p.tree_climbers - 1, 0.0F);
    f.bark_kind = choice(p.tree_bark_kind, 4);
    f.bark_depth = p.tree_bark_depth;
    f.bark_tile_m = p.tree_bark_tile_m;
}

// The rows that each species has for itself.
struct Own {
    int habit;
    float height_m, crown_width, gnarl_deg, limb_density, leaf_length_m, leaf_shape, leaf_density, yellowness,
        lightness, autumn, blossom, bark_lightness;
};

// What the second and the third species have of their own, against the first: the same names after their rank.
#define QUADRAT_COMPANION(rank)                                                                                    \
    Own {                                                                                                          \
        companion(p.rank##_companion), p.rank##_height *p.tree_height_m, p.rank##_crown_width, p.rank##_gnarl_deg, \
            p.rank##_limb_density, p.rank##_leaf_length_m, p.rank##_leaf_shape, p.rank##_leaf_density,             \
            p.tree_leaf_yellowness + p.rank##_leaf_yellowness, p.tree_leaf_lightness *p.rank##_leaf_lightness,     \
            p.rank##_autumn, p.rank##_blossom, p.rank##_bark_lightness                                             \
    }
Own own_of(const scene::TreeParameters& p, Rank rank) {
    const int first = choice(p.tree_habit, kind_count());
    const auto companion = [&](float gene) { return habit_named(kind(first).companions[choice(gene, 8)]); };
    switch (rank) {
        case Rank::First:
            return {first,
                    p.tree_height_m,
                    p.tree_crown_width,
                    p.tree_gnarl_deg,
                    p.tree_limb_density,
                    p.tree_leaf_length_m,
                    p.tree_leaf_shape,
                    p.tree_leaf_density,
                    p.tree_leaf_yellowness,
                    p.tree_leaf_lightness,
                    p.tree_autumn,
                    p.tree_blossom,
                    p.tree_bark_lightness};
        case Rank::Second:
            return QUADRAT_COMPANION(second);
        case Rank::Third:
            return QUADRAT_COMPANION(third);
    }
    return {};
}
#undef QUADRAT_COMPANION

}  // namespace

glm::vec3 blossom_colour(float hue) {
    return between({0xF4EEE6, 0xEFB9C6, 0xD0463E, 0xE8853A, 0xF0CB50, 0x9A7CC0}, hue);
}

glm::vec3 cap_colour(float hue) { return between({0xE8DFCB, 0xCBA87C, 0xB98A56, 0xD9B36A, 0xC8723A, 0xB23A2A}, hue); }

glm::vec3 turned_colour(float red) {
    return between({0xE2BE48, 0xE0A83C, 0xD88A34, 0xC8662E, 0xB0442C, 0x8E3030}, red);
}

Year year_of(const Form& f) {
    constexpr float kNeedlesShed = 0.1F;
    const Kind& k = kind(f.habit);
    Year year;
    year.season = f.season;
    year.sheds = k.is_rosette ? 0 : f.leaf == LeafKind::Needles ? std::min(k.sheds, kNeedlesShed) : k.sheds;
    if (k.blossom > 0) year.flowers = std::max(k.spring_blossom, k.blossom * f.blossom);
    return year;
}

// Toward yellow or toward blue in OKLab; the bluest leaf is a spruce's. One that has turned does not go back toward
// blue, nor grey: it would look mouldy.
glm::vec3 yellower(const glm::vec3& colour, float by) {
    constexpr float kBluest = 0.006F;
    constexpr float kLeastChroma = 0.075F;  // of a leaf that is red
    constexpr float kMostChroma = 0.165F;
    glm::vec3 lab = scene::oklab_from_linear(colour);
    const float turned = glm::smoothstep(-0.02F, 0.03F, lab.y);
    if (by < 0) by *= 1 - 0.8F * turned;
    lab.z = std::max(lab.z + 0.045F * by, std::min(lab.z, kBluest));
    lab.y += 0.012F * by;
    const float grey = std::max(std::hypot(lab.y, lab.z), 1e-4F);
    const float brighter = std::max(kLeastChroma / grey, 1.0F);
    lab = {lab.x, lab.y * (1 + turned * (brighter - 1)), lab.z * (1 + turned * (brighter - 1))};
    lab.z = std::max(lab.z, least_yellow(lab.y));
    // A yellow palette and the yellowest gene together would be garish.
    const float chroma = std::hypot(lab.y, lab.z);
    if (chroma > kMostChroma) lab = {lab.x, lab.y * kMostChroma / chroma, lab.z * kMostChroma / chroma};
    return glm::max(scene::linear_from_oklab(lab), glm::vec3{0});
}

Wear wear_of(const scene::TreeParameters& p) {
    const Dress& d = kDresses[choice(p.tree_palette, 10)];
    const auto colour = [](std::uint32_t hex) { return scene::linear_from_srgb_hex(hex); };
    const auto leaf = [&](std::uint32_t hex) {
        return without_teal(scene::shifted_colour(colour(hex), 1, p.tree_leaf_chroma));
    };
    const glm::vec3 dry = scene::linear_from_srgb_hex(0xC2AE72);
    const float dryness = std::clamp(p.grass_dryness + meadow_in(p.tree_season).dryness, 0.0F, 1.0F);
    return {leaf(d.leaf), leaf(d.second), warmer(colour(d.bark), p.tree_bark_warmth),
            scene::mix_colours(colour(d.grass), dry, 0.85F * dryness), colour(d.blossom)};
}

Form form_of(const scene::TreeParameters& p, Rank rank) {
    Form f;
    set_shared(f, p);
    const Own own = own_of(p, rank);
    f.habit = own.habit;
    const Kind& k = kind(f.habit);
    f.stems = std::min(f.stems, k.most_stems);
    // Such a tree has no limbs: without its tuft it is a pole.
    if (k.is_rosette) f.bareness = std::min(f.bareness, 0.25F);
    f.height_m = std::clamp(own.height_m, 2.5F, 30.0F) * k.height;
    // A tall palm is not thicker for it, as it grows no wood.
    if (k.is_rosette) f.girth *= std::sqrt(kPalm_m / std::max(f.height_m, kPalm_m));
    f.crown_width = own.crown_width;
    f.gnarl_deg = own.gnarl_deg;
    f.limb_density = own.limb_density;
    f.leaf_length_m = own.leaf_length_m;
    f.leaf = k.own_leaf.value_or(static_cast<LeafKind>(choice(own.leaf_shape, 8)));
    f.leaf_density = own.leaf_density;
    f.blossom = festive(own.blossom);
    const Wear wear = wear_of(p);
    const auto dress = [&](const glm::vec3& colour) {
        const glm::vec3 shifted =
            scene::shifted_colour(tinted(colour, k.leaf_tint), std::clamp(own.lightness, 0.65F, 1.35F));
        return no_lighter(yellower(shifted, std::clamp(own.yellowness, -1.2F, 1.2F)), kLightestLeaf);
    };
    f.colours.leaf = dress(wear.leaf);
    f.colours.second = dress(wear.second);
    f.colours.variety = p.tree_leaf_variety;
    f.colours.turned = turned_colour(p.tree_autumn_red);
    f.colours.autumn = festive(own.autumn);
    f.colours.blossom = blossom_colour(p.tree_blossom_hue);
    f.colours.fruit = fruit_colour(p.tree_fruit_hue);
    // What has a skin of its own colour keeps it: as light as a birch, or as grey as barks are, a cactus is a ghost.
    const bool is_own = k.bark_tint.share >= 1;
    const float bark_lightness = is_own ? std::clamp(own.bark_lightness, 0.7F, 1.1F) : own.bark_lightness;
    const glm::vec3 bark = scene::shifted_colour(tinted(wear.bark, k.bark_tint), bark_lightness);
    f.bark = no_lighter(is_own ? bark : no_redder(bark), k.lightest_bark);
    return f;
}

}  // namespace quadrat::synthesis::trees
