// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <string_view>

#include "synthesis/land/tile_examples.hpp"

namespace quadrat::synthesis::land {
namespace {

using noise::Tiles;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kThick = 0.36F;  // of a wall, to a tile
constexpr int kCourses = 3;      // of stone in a storey

bool is_one_of(char tile, std::string_view kinds) { return kinds.find(tile) != std::string_view::npos; }
bool runs_east(char tile) { return is_one_of(tile, "-Awe7913"); }
bool runs_south(char tile) { return is_one_of(tile, "|HNS7913"); }

// One tile's facets, in the tile's own measure: x along it from -0.5 to 0.5, y up from 0 to 1, z across.
class TileMason {
  public:
    TileMason(std::vector<TileFacet>& out, const TileShape& shape, glm::vec3 foot_m, base::RandomStream& random)
        : out_(out), shape_(shape), foot_m_(foot_m), random_(random) {}

    bool is_turned = false;  // it runs south instead of east

    void quad(const std::array<glm::vec3, 4>& corners, float tint) {
        std::array<glm::vec3, 4> at{};
        for (std::size_t i = 0; i < 4; ++i) at[i] = placed(corners[i]);
        out_.push_back({{at[0], at[1], at[2]}, tint});
        out_.push_back({{at[0], at[2], at[3]}, tint});
    }
    // Courses of stone between two heights, each a shade of its own and not quite even with the others.
    void wall(float x0, float x1, float y0, float y1, float half_z, bool has_left, bool has_right) {
        const int courses = std::max(1, static_cast<int>(std::lround((y1 - y0) * kCourses)));
        float top_z = half_z;
        for (int i = 0; i < courses; ++i) {
            const float low = y0 + (y1 - y0) * static_cast<float>(i) / static_cast<float>(courses);
            const float high = y0 + (y1 - y0) * static_cast<float>(i + 1) / static_cast<float>(courses);
            const float z = half_z * random_.between(0.9F, 1.06F);
            const float middle = x0 + (x1 - x0) * random_.between(0.3F, 0.7F);
            for (const auto& [a, b] : {std::pair{x0, middle}, std::pair{middle, x1}}) {
                const float tint = random_.between(0.84F, 1.12F);
                quad({{{a, low, z}, {b, low, z}, {b, high, z}, {a, high, z}}}, tint);
                quad({{{b, low, -z}, {a, low, -z}, {a, high, -z}, {b, high, -z}}}, tint);
            }
            const float tint = random_.between(0.8F, 1.0F);
            if (has_left) quad({{{x0, low, -z}, {x0, low, z}, {x0, high, z}, {x0, high, -z}}}, tint);
            if (has_right) quad({{{x1, low, z}, {x1, low, -z}, {x1, high, -z}, {x1, high, z}}}, tint);
            top_z = z;
        }
        quad({{{x0, y1, top_z}, {x1, y1, top_z}, {x1, y1, -top_z}, {x0, y1, -top_z}}}, random_.between(0.95F, 1.1F));
    }
    // Stones left of a wall that ran on: lower toward where it has fallen. toward: -1 or 1.
    void broken_wall(int toward) {
        for (int i = 0; i < 3; ++i) {
            const float x0 = -0.5F + static_cast<float>(i) / 3;
            const float away = static_cast<float>(toward > 0 ? i : 2 - i) / 2;
            const float up = std::clamp(0.9F - 0.75F * away + random_.between(-0.16F, 0.12F), 0.08F, 0.95F);
            wall(x0, x0 + 1.0F / 3, floor(), up, kThick / 2, true, true);
        }
    }
    void arch() {
        constexpr float kJamb = 0.17F;
        constexpr float kSpring = 0.45F;
        constexpr int kStones = 7;
        const float half_z = kThick / 2;
        wall(-0.5F, -0.5F + kJamb, floor(), kSpring, half_z, false, true);
        wall(0.5F - kJamb, 0.5F, floor(), kSpring, half_z, true, false);
        const float radius = 0.5F - kJamb;
        const auto on_arc = [&](int i) {
            const float turn = kPi * static_cast<float>(i) / kStones;
            return glm::vec2{-radius * std::cos(turn), kSpring + 0.4F * std::sin(turn)};
        };
        // Over the arc the wall goes on, out to its ends.
        for (int i = 0; i < kStones; ++i) {
            const glm::vec2 a = on_arc(i);
            const glm::vec2 b = on_arc(i + 1);
            const float x0 = i == 0 ? -0.5F : a.x;
            const float x1 = i + 1 == kStones ? 0.5F : b.x;
            const float tint = random_.between(0.86F, 1.14F);
            quad({{{x0, a.y, half_z}, {x1, b.y, half_z}, {x1, 1, half_z}, {x0, 1, half_z}}}, tint);
            quad({{{x1, b.y, -half_z}, {x0, a.y, -half_z}, {x0, 1, -half_z}, {x1, 1, -half_z}}}, tint);
            quad({{{a.x, a.y, -half_z}, {b.x, b.y, -half_z}, {b.x, b.y, half_z}, {a.x, a.y, half_z}}}, 0.7F);
        }
        quad({{{-0.5F, 1, half_z}, {0.5F, 1, half_z}, {0.5F, 1, -half_z}, {-0.5F, 1, -half_z}}}, 1);
    }
    void column(float up) {
        constexpr int kSides = 8;
        constexpr std::array<std::array<float, 2>, 4> kRings{{{0, 0.27F}, {0.06F, 0.27F}, {0.07F, 0.21F}, {1, 0.18F}}};
        const auto at = [](float turn, float r, float y) {
            return glm::vec3{r * std::cos(turn), y, r * std::sin(turn)};
        };
        const float tint = random_.between(0.92F, 1.12F);
        for (int i = 0; i < kSides; ++i) {
            const float a = 2 * kPi * static_cast<float>(i) / kSides;
            const float b = 2 * kPi * static_cast<float>(i + 1) / kSides;
            for (std::size_t k = 0; k + 1 < kRings.size(); ++k) {
                const float low = k == 0 ? floor() : up * kRings[k][0];
                const float high = up * kRings[k + 1][0];
                const auto [r0, r1] = std::pair{kRings[k][1], kRings[k + 1][1]};
                quad({{at(b, r0, low), at(a, r0, low), at(a, r1, high), at(b, r1, high)}}, tint);
            }
            const float rough = up - 0.06F * random_.unit_f();
            quad({{at(b, 0.18F, up), at(a, 0.18F, up), {0, rough, 0}, {0, rough, 0}}}, tint);
        }
    }
    void slab() {
        const float tint = random_.between(0.82F, 1.05F);
        const float tilt = random_.between(-0.02F, 0.02F);
        const float h = random_.between(0.03F, 0.06F);
        block({-0.47F, floor(), -0.47F}, {0.47F, h, 0.47F}, tint, tilt);
    }
    void rubble() {
        for (int i = 0; i < 5; ++i) {
            const glm::vec2 at{random_.between(-0.4F, 0.4F), random_.between(-0.4F, 0.4F)};
            const float r = random_.between(0.06F, 0.2F);
            block({at.x - r, floor(), at.y - 0.8F * r}, {at.x + r, random_.between(0.5F, 1.3F) * r, at.y + 0.8F * r},
                  random_.between(0.85F, 1.1F), random_.between(-0.05F, 0.05F));
        }
    }
    void block(glm::vec3 a, glm::vec3 b, float tint, float tilt = 0) {
        const float l = b.y - tilt;
        const float r = b.y + tilt;
        quad({{{a.x, l, b.z}, {b.x, r, b.z}, {b.x, r, a.z}, {a.x, l, a.z}}}, 1.05F * tint);
        quad({{{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, r, b.z}, {a.x, l, b.z}}}, tint);
        quad({{{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, l, a.z}, {b.x, r, a.z}}}, tint);
        quad({{{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, l, b.z}, {a.x, l, a.z}}}, tint);
        quad({{{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, r, a.z}, {b.x, r, b.z}}}, tint);
    }
    bool stands_on_ground = false;

    // Where it begins: what stands on the ground goes on under it.
    float floor() const { return stands_on_ground ? -shape_.sunk_m / shape_.storey_m : 0.0F; }

  private:
    glm::vec3 placed(glm::vec3 at) const {
        if (is_turned) at = {-at.z, at.y, at.x};
        return foot_m_ + glm::vec3{at.x * shape_.side_m, at.y * shape_.storey_m, at.z * shape_.side_m};
    }
    std::vector<TileFacet>& out_;
    const TileShape& shape_;
    glm::vec3 foot_m_;
    base::RandomStream& random_;
};

void add_corner(TileMason& mason, const Tiles& tiles, glm::ivec3 at) {
    constexpr float kHalf = 0.55F * kThick;
    mason.wall(-kHalf, kHalf, mason.floor(), 1, kHalf, true, true);
    const auto arms = [&](bool is_turned, glm::ivec3 along) {
        const auto goes_on = [&](char tile) { return is_turned ? runs_south(tile) : runs_east(tile); };
        mason.is_turned = is_turned;
        if (goes_on(tiles.at(at + along))) mason.wall(kHalf, 0.5F, mason.floor(), 1, kThick / 2, false, false);
        if (goes_on(tiles.at(at - along))) mason.wall(-0.5F, -kHalf, mason.floor(), 1, kThick / 2, false, false);
    };
    arms(false, {1, 0, 0});
    arms(true, {0, 1, 0});
}

void add_tile(TileMason& mason, const Tiles& tiles, glm::ivec3 at, base::RandomStream& random) {
    const char tile = tiles.at(at);
    mason.is_turned = is_one_of(tile, "|HNS");
    const glm::ivec3 along = mason.is_turned ? glm::ivec3{0, 1, 0} : glm::ivec3{1, 0, 0};
    const auto ends = [&](glm::ivec3 beside) {
        return mason.is_turned ? !runs_south(tiles.at(beside)) : !runs_east(tiles.at(beside));
    };
    switch (tile) {
        case Tiles::kAir:
            return;
        case '-':
        case '|':
            return mason.wall(-0.5F, 0.5F, mason.floor(), 1, kThick / 2, ends(at - along), ends(at + along));
        case 'A':
        case 'H':
            return mason.arch();
        case 'w':
        case 'N':
            return mason.broken_wall(-1);
        case 'e':
        case 'S':
            return mason.broken_wall(1);
        case '7':
        case '9':
        case '1':
        case '3':
            return add_corner(mason, tiles, at);
        case 'o':
            return mason.column(1);
        case 'c':
            return mason.column(random.between(0.25F, 0.7F));
        case ',':
            return random.unit() < 0.85 ? mason.slab() : void();
        case 'r':
            return mason.rubble();
        default:
            return mason.block({-0.5F, mason.floor(), -0.5F}, {0.5F, 1, 0.5F}, random.between(0.9F, 1.1F));
    }
}

}  // namespace

std::vector<TileFacet> facets_of(const noise::Tiles& tiles, const TileShape& shape, base::Seed seed) {
    std::vector<TileFacet> facets;
    const glm::vec2 middle =
        0.5F * glm::vec2{static_cast<float>(tiles.size.x - 1), static_cast<float>(tiles.size.y - 1)};
    for (int z = 0; z < tiles.size.z; ++z)
        for (int y = 0; y < tiles.size.y; ++y)
            for (int x = 0; x < tiles.size.x; ++x) {
                base::RandomStream random{base::Seed{base::hash_of(seed, x, y, z)}};
                const glm::vec2 at = shape.side_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - middle);
                TileMason mason(facets, shape, {at.x, shape.storey_m * static_cast<float>(z), at.y}, random);
                mason.stands_on_ground = z == 0;
                add_tile(mason, tiles, {x, y, z}, random);
            }
    std::erase_if(facets, [](const TileFacet& f) {
        const glm::vec3 across = glm::cross(f.corners[1] - f.corners[0], f.corners[2] - f.corners[0]);
        return glm::dot(across, across) < 1.0e-12F;
    });
    return facets;
}

}  // namespace quadrat::synthesis::land
