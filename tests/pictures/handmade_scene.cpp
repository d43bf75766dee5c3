// SPDX-License-Identifier: Apache-2.0
#include "pictures/handmade_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/seed.hpp"
#include "scene/colour.hpp"

namespace quadrat::tests {
namespace {

using base::RandomStream;
using base::Seed;

constexpr float kPi = std::numbers::pi_v<float>;

std::uint8_t byte_of(float share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0F, 1.0F) * 255 + 0.5F); }

void put(mesh::Image& image, int x, int y, glm::vec3 linear, float alpha) {
    std::uint8_t* p = image.pixel(x, y);
    for (int c = 0; c < 3; ++c) p[c] = scene::srgb_byte(linear[c]);
    p[3] = byte_of(alpha);
}

float hills_m(float x, float z) {
    const float valley = 0.00022F * (x * x * 0.35F + (z + 40) * (z + 40));
    return valley * 1.6F - 7 + 9 * std::sin(x * 0.013F + 1) * std::cos(z * 0.011F) +
           3 * std::sin(x * 0.045F + z * 0.03F);
}

// A trunk of one tapering prism; enough to stand under a crown.
scene::Wood trunk(float height_m, float radius_m, int sides) {
    scene::Wood wood;
    for (int ring = 0; ring <= 4; ++ring) {
        const float up = static_cast<float>(ring) / 4;
        for (int side = 0; side < sides; ++side) {
            const float turn = 2 * kPi * static_cast<float>(side) / static_cast<float>(sides);
            const glm::vec3 out{std::cos(turn), 0, -std::sin(turn)};
            wood.mesh.positions_m.push_back(out * radius_m * (1 - 0.85F * up) + glm::vec3{0, height_m * up, 0});
            wood.mesh.normals.push_back(out);
            wood.ages.push_back(0.7F * up);
            wood.sways.push_back(0.4F * up);
        }
    }
    for (int ring = 0; ring < 4; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const auto a = static_cast<std::uint32_t>(ring * sides + side);
            const auto b = static_cast<std::uint32_t>(ring * sides + (side + 1) % sides);
            const auto up = static_cast<std::uint32_t>(sides);
            wood.mesh.indices.insert(wood.mesh.indices.end(), {a, b, a + up, a + up, b, b + up});
        }
    }
    return wood;
}

// Where on a crown a blade sits: on a ball for a broad tree, on a cone for a fir, at the root for grass.
enum class Crown { Ball, Cone, Tuft };

void add_blade(scene::Leaves& leaves, const scene::Species& species, Crown crown, float length_m, glm::vec3 colour,
               RandomStream& stream) {
    const float turn = 2 * kPi * stream.unit_f();
    const float h = species.height_m;
    glm::vec3 out{std::cos(turn), 0, std::sin(turn)};
    glm::vec3 site{0};
    if (crown == Crown::Ball) {
        const float y = stream.between(-1, 1);
        out = glm::normalize(glm::vec3{out.x * std::sqrt(1 - y * y), y, out.z * std::sqrt(1 - y * y)});
        site = glm::vec3{0, 0.66F * h, 0} + out * species.crown_radius_m * std::cbrt(stream.between(0.35F, 1));
    } else if (crown == Crown::Cone) {
        const float up = 1 - std::sqrt(stream.unit_f());
        site = glm::vec3{0, h * (0.12F + 0.88F * up), 0} +
               out * species.crown_radius_m * (1 - up) * stream.between(0.5F, 1);
        out = glm::normalize(out + glm::vec3{0, 0.5F, 0});
    } else {
        site = out * 0.2F * stream.unit_f();
        out = glm::normalize(out * 0.5F + glm::vec3{0, 1, 0});
    }
    const glm::vec3 along = glm::normalize(out + glm::vec3{stream.between(-0.6F, 0.6F), stream.between(-0.5F, 0.5F),
                                                           stream.between(-0.6F, 0.6F)}) *
                            length_m;
    const glm::vec3 across = glm::normalize(glm::cross(along, glm::vec3{0.3F, 1, 0.2F})) * length_m * 0.32F;
    const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
    const float age = crown == Crown::Tuft ? 0.2F : 0.55F + 0.4F * stream.unit_f();
    const float shade = crown == Crown::Tuft ? 0.9F : 0.55F + 0.45F * std::clamp(out.y * 0.5F + 0.5F, 0.0F, 1.0F);
    for (const glm::vec3 corner : {glm::vec3{0}, along * 0.5F - across, along * 0.5F + across, along})
        leaves.vertices.push_back({site, corner, out, colour * stream.between(0.85F, 1.15F), age, 0.8F, shade});
    leaves.indices.insert(leaves.indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
    ++leaves.blades;
}

scene::Species species(std::string name, Crown crown, float height_m, float crown_radius_m, int blades, float blade_m,
                       glm::vec3 leaf_colour, Seed seed) {
    scene::Species s;
    s.name = std::move(name);
    s.height_m = height_m;
    s.crown_radius_m = crown_radius_m;
    s.trunk_radius_m = 0.03F * height_m;
    s.bark_colour = {0.16F, 0.11F, 0.075F};
    if (crown != Crown::Tuft)
        s.wood = {trunk(0.8F * height_m, s.trunk_radius_m, 9), trunk(0.8F * height_m, s.trunk_radius_m, 5)};
    if (crown == Crown::Tuft) s.wood = {scene::Wood{}};
    RandomStream stream{seed};
    for (int i = 0; i < blades; ++i) add_blade(s.leaves, s, crown, blade_m, leaf_colour, stream);
    return s;
}

std::shared_ptr<scene::Flora> flora(Ground ground) {
    auto f = std::make_shared<scene::Flora>();
    const Seed seed{11};
    const bool is_green = ground == Ground::Meadow;
    const glm::vec3 broad = is_green ? glm::vec3{0.10F, 0.19F, 0.035F} : glm::vec3{0.19F, 0.16F, 0.05F};
    const glm::vec3 dark = is_green ? glm::vec3{0.035F, 0.10F, 0.045F} : glm::vec3{0.09F, 0.11F, 0.05F};
    const glm::vec3 grass = is_green ? glm::vec3{0.16F, 0.25F, 0.05F} : glm::vec3{0.42F, 0.33F, 0.15F};
    f->species.push_back(species("broad", Crown::Ball, 11, 3.6F, 2400, 0.75F, broad, seed.child("broad")));
    f->species.push_back(species("fir", Crown::Cone, 15, 2.6F, 2000, 0.85F, dark, seed.child("fir")));
    f->species.push_back(species("grass", Crown::Tuft, 0.7F, 0.4F, 26, 0.6F, grass, seed.child("grass")));
    return f;
}

std::shared_ptr<scene::Land> land(Ground ground) {
    auto l = std::make_shared<scene::Land>();
    const bool is_green = ground == Ground::Meadow;
    l->cell_m = 4;
    l->height_m = mesh::Field(129, 129);
    for (int row = 0; row < 129; ++row)
        for (int column = 0; column < 129; ++column)
            l->height_m.at(column, row) =
                hills_m(4.0F * static_cast<float>(column - 64), 4.0F * static_cast<float>(row - 64));
    l->surround_cell_m = 128;
    l->surround_m = mesh::Field(129, 129);
    for (int row = 0; row < 129; ++row) {
        for (int column = 0; column < 129; ++column) {
            const float x = 128.0F * static_cast<float>(column - 64);
            const float z = 128.0F * static_cast<float>(row - 64);
            const float out = std::max(std::abs(x), std::abs(z));
            const float far = 60 + 240 * std::abs(std::sin(x * 0.0011F + 2) * std::sin(z * 0.0013F + x * 0.0004F));
            const float near = hills_m(std::clamp(x, -256.0F, 256.0F), std::clamp(z, -256.0F, 256.0F));
            l->surround_m.at(column, row) = out < 257 ? near - 6 : std::lerp(near - 6, far, std::min(out / 4000, 1.0F));
        }
    }
    mesh::Image albedo(256, 256, 4);
    const glm::vec3 low = is_green ? glm::vec3{0.14F, 0.20F, 0.06F} : glm::vec3{0.50F, 0.33F, 0.17F};
    const glm::vec3 high = is_green ? glm::vec3{0.24F, 0.22F, 0.12F} : glm::vec3{0.44F, 0.22F, 0.12F};
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const float h = hills_m(2.0F * static_cast<float>(x - 128), 2.0F * static_cast<float>(y - 128));
            const glm::vec3 colour = scene::mix_colours(low, high, std::clamp(h / 24, 0.0F, 1.0F));
            put(albedo, x, y, h < 0.8F ? glm::vec3{0.36F, 0.30F, 0.20F} : colour, h < 0.8F ? 1.0F : 0.0F);
        }
    }
    l->albedo = scene::GroundColours(albedo);
    l->detail = mesh::Image(64, 64, 1);
    RandomStream stream{Seed{5}};
    for (std::uint8_t& b : l->detail.bytes) b = static_cast<std::uint8_t>(96 + stream.below(65));
    l->far_colour = is_green ? glm::vec3{0.15F, 0.19F, 0.10F} : glm::vec3{0.42F, 0.26F, 0.16F};
    return l;
}

struct Palette {
    float sun_elevation_deg;
    glm::vec3 sunlight, above, around, below, zenith, horizon, haze, haze_sunward, sun;
};

Palette palette(Hour hour) {
    switch (hour) {
        case Hour::Sunset:
            return {7,
                    {1.25F, 0.62F, 0.26F},
                    {0.26F, 0.27F, 0.40F},
                    {0.34F, 0.26F, 0.24F},
                    {0.12F, 0.10F, 0.09F},
                    {0.10F, 0.16F, 0.34F},
                    {0.85F, 0.46F, 0.26F},
                    {0.50F, 0.36F, 0.36F},
                    {1.0F, 0.58F, 0.26F},
                    {1.0F, 0.62F, 0.28F}};
        case Hour::Night:
            return {35,
                    {0.09F, 0.11F, 0.17F},
                    {0.035F, 0.045F, 0.08F},
                    {0.03F, 0.035F, 0.06F},
                    {0.01F, 0.012F, 0.02F},
                    {0.008F, 0.014F, 0.035F},
                    {0.05F, 0.06F, 0.10F},
                    {0.04F, 0.05F, 0.085F},
                    {0.06F, 0.07F, 0.10F},
                    {0.5F, 0.55F, 0.65F}};
        case Hour::Storm:
        case Hour::Snow:
            return {30,
                    {0.22F, 0.22F, 0.22F},
                    {0.42F, 0.43F, 0.46F},
                    {0.34F, 0.35F, 0.38F},
                    {0.12F, 0.12F, 0.11F},
                    {0.38F, 0.40F, 0.44F},
                    {0.42F, 0.43F, 0.45F},
                    {0.42F, 0.43F, 0.45F},
                    {0.46F, 0.46F, 0.46F},
                    {0.6F, 0.6F, 0.6F}};
        case Hour::Fog:
        case Hour::Noon:
        default:
            return {46,
                    {1.15F, 1.08F, 0.94F},
                    {0.30F, 0.38F, 0.52F},
                    {0.30F, 0.33F, 0.36F},
                    {0.13F, 0.13F, 0.10F},
                    {0.10F, 0.25F, 0.62F},
                    {0.55F, 0.68F, 0.80F},
                    {0.52F, 0.63F, 0.74F},
                    {0.80F, 0.82F, 0.82F},
                    {1.0F, 0.95F, 0.85F}};
    }
}

// Blobs of sines put through a cover filter; the sun's side of a blob is the lit one.
scene::CloudLayer clouds(float tile_m, float height_m, float cover, const Palette& p) {
    scene::CloudLayer layer;
    layer.tile_m = tile_m;
    layer.height_m = height_m;
    layer.density = mesh::Image(128, 128, 1);
    layer.lit = mesh::Image(128, 128, 1);
    const auto blob = [](int x, int y) {
        const float u = 2 * kPi * static_cast<float>(x) / 128;
        const float v = 2 * kPi * static_cast<float>(y) / 128;
        return 0.5F + 0.22F * std::sin(u * 2 + std::sin(v * 3)) * std::cos(v * 2 + 1) +
               0.16F * std::sin(u * 5 + v * 3) + 0.10F * std::sin(v * 9 - u * 7 + 2 * std::sin(u * 3));
    };
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) {
            *layer.density.pixel(x, y) = byte_of((blob(x, y) - cover) * 4);
            *layer.lit.pixel(x, y) = byte_of(0.6F + 6 * (blob(x, y) - blob(x + 3, y + 2)));
        }
    }
    layer.sunlit = glm::min(p.sunlight * 0.85F + p.above * 0.3F, glm::vec3{1});
    layer.shaded = p.above * 0.8F + p.around * 0.6F;
    layer.opacity = 0.9F;
    return layer;
}

mesh::Image disc() {
    mesh::Image picture(32, 32, 2);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            *picture.pixel(x, y) =
                byte_of((14 - std::hypot(static_cast<float>(x) - 15.5F, static_cast<float>(y) - 15.5F)) / 2);
    return picture;
}

void add_weather(scene::Sky& sky, Hour hour) {
    using Kind = scene::Precipitation::Kind;
    if (hour == Hour::Storm) {
        sky.precipitation = {Kind::Rain, 1, {6, -9.5F, 2}, 0.006F, 0.08F, {0.5F, 0.5F, 0.52F}, 0.3F};
        sky.clouds[0].density.bytes.assign(sky.clouds[0].density.bytes.size(), 250);
        sky.haze_distance_m = 1100;
    }
    if (hour == Hour::Snow) {
        sky.precipitation = {Kind::Snow, 1, {1, -1.2F, 0.4F}, 0.03F, 0, {0.9F, 0.9F, 0.95F}, 0.85F};
        sky.haze_distance_m = 900;
    }
    if (hour == Hour::Fog) sky.mist = {0.012F, 6, 9};
    if (hour == Hour::Night) {
        RandomStream stream{Seed{41}};
        for (int i = 0; i < 500; ++i) {
            const float turn = 2 * kPi * stream.unit_f();
            const float y = stream.unit_f();
            const float flat = std::sqrt(1 - y * y);
            const float light = stream.unit_f();
            sky.stars.push_back({{flat * std::cos(turn), y, flat * std::sin(turn)}, light * light});
        }
    }
    // A bow opposite a low sun.
    if (hour == Hour::Sunset) sky.bow = 1;
}

std::shared_ptr<scene::Sky> sky(Hour hour) {
    auto s = std::make_shared<scene::Sky>();
    const Palette p = palette(hour);
    const float up = p.sun_elevation_deg / 180 * kPi;
    s->sun_direction = {std::cos(up) * 0.5F, std::sin(up), -std::cos(up) * 0.8660254F};
    s->sunlight = p.sunlight;
    s->glow_direction = s->sun_direction;
    s->light_below = p.below;
    constexpr int kPieces = 24;
    for (int i = 0; i < kPieces; ++i) {
        const float y = -1 + 2 * (static_cast<float>(i) + 0.5F) / kPieces;
        const glm::vec3 light = glm::mix(p.around, y > 0 ? p.above : p.below, std::abs(y));
        for (int k = 0; k < kPieces; ++k) {
            const float turn = 2 * kPi * static_cast<float>(k) / kPieces;
            const float flat = std::sqrt(1 - y * y);
            s->ambient.add({flat * std::cos(turn), y, flat * std::sin(turn)}, light, 4 * kPi / (kPieces * kPieces));
        }
    }
    for (int row = 0; row < scene::Dome::kRows; ++row) {
        const float height = std::asin(scene::Dome::direction(0, row).y) / (0.5F * kPi);
        for (int column = 0; column < scene::Dome::kColumns; ++column)
            s->dome.at(column, row) = scene::mix_colours(p.zenith, p.horizon, std::pow(1 - height, 2.5F));
    }
    s->disc = {disc(), p.sun, 0.0105F};
    s->glare = 0.25F * p.sun;
    s->clouds = {clouds(5200, 700, 0.52F, p), clouds(14000, 2600, 0.6F, p)};
    s->haze_colour = p.haze;
    s->haze_sunward = p.haze_sunward;
    s->haze_distance_m = 2400;
    add_weather(*s, hour);
    return s;
}

void plant(scene::Scene& scene) {
    const Seed seed{23};
    const float spacing_m[3] = {17, 15, 5};
    for (std::uint32_t kind = 0; kind < 3; ++kind) {
        const int side = static_cast<int>(500 / spacing_m[kind]);
        for (int i = 0; i < side * side; ++i) {
            RandomStream stream{seed.child(kind).child(static_cast<std::uint64_t>(i))};
            const float x = (static_cast<float>(i % side) + stream.unit_f()) * spacing_m[kind] - 250;
            const float z = (static_cast<float>(i / side) + stream.unit_f()) * spacing_m[kind] - 250;
            const float h = scene::ground_height_m(*scene.land, {x, z});
            const bool is_low = std::sin(x * 0.017F) + std::cos(z * 0.021F) > 0.4F;
            if (h < 1 || (kind < 2 && (is_low != (kind == 0) || stream.unit_f() < 0.45F))) continue;
            scene.plants.push_back({kind,
                                    {x, h - 0.1F, z},
                                    stream.between(0, 6.28F),
                                    stream.between(0.75F, 1.25F),
                                    stream.between(0.6F, 1),
                                    stream.between(-1, 1),
                                    stream.unit_f()});
        }
    }
}

void bake(scene::Scene& scene) {
    const scene::Sky& s = *scene.sky;
    scene.light.ground = mesh::Image(256, 256, 4);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const glm::vec2 at{2.0F * (static_cast<float>(x) - 127.5F), 2.0F * (static_cast<float>(y) - 127.5F)};
            const glm::vec3 normal = scene::ground_normal(*scene.land, at);
            const glm::vec3 light =
                s.sunlight * std::max(glm::dot(normal, s.sun_direction), 0.0F) + 0.95F * s.ambient.on({0, 1, 0});
            std::uint8_t* p = scene.light.ground.pixel(x, y);
            for (int c = 0; c < 3; ++c) p[c] = byte_of(light[c] / 2);
            p[3] = byte_of(-scene::ground_height_m(*scene.land, at) / 24);
        }
    }
}

}  // namespace

std::shared_ptr<const scene::Scene> handmade_scene(Hour hour, Ground ground) {
    auto scene = std::make_shared<scene::Scene>();
    scene->flora = flora(ground);
    const auto country = land(ground);
    if (hour == Hour::Snow) country->snow_line_m = 0;  // above it snow falls
    scene->land = country;
    scene->sky = sky(hour);
    plant(*scene);
    bake(*scene);
    scene->track.cameras = {{{-70, hills_m(-70, 150) + 9, 150}, {20, 6, -60}, 42}};
    return scene;
}

}  // namespace quadrat::tests
