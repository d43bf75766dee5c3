// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/sward.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "scene/colour.hpp"
#include "scene/night_eye.hpp"
#include "scene/withering.hpp"
#include "synthesis/compose/crops.hpp"
#include "synthesis/compose/lookups.hpp"
#include "synthesis/compose/site.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kReach_m = 130;
constexpr float kAll_m = 26;           // from the way: to here a tuft stands at each place that bears one
constexpr float kWidest = 2.6F;        // a tuft that stands for many, to one that stands for itself
constexpr float kPebble_m = 0.12F;     // high at most
constexpr float kLowest_m = 0.15F;     // above the sea: sand is bare by itself, and marshes are green
constexpr float kMown = 0.4F;          // to the height of what grows as it likes
constexpr float kMown_m = 0.22F;       // at most
constexpr float kWidestAside = 0.95F;  // of the view; a flight turns its eyes a little
constexpr float kSpacing_m = 0.58F;    // between tufts where cover is closed
constexpr int kSide = 8;               // places of a cell
constexpr float kCell_m = kSide * kSpacing_m;
constexpr float kLean = 0.6F;  // of the ground's colour toward the grass's, near by

bool is_green(const glm::vec3& linear) { return linear.g > 1.05F * linear.r && linear.g > 1.2F * linear.b; }

// How far the ground is soft, which bears plants, and how far stone. Each 0 to 1.
glm::vec2 material_at(const scene::Land& land, glm::vec2 at_m) {
    if (land.kinds.bytes.empty()) return {1, 0};
    const auto px = [&](float m, int size) {
        return std::clamp(static_cast<int>((m / land.side_m() + 0.5F) * static_cast<float>(size)), 0, size - 1);
    };
    const std::uint8_t* kinds = land.kinds.pixel(px(at_m.x, land.kinds.width), px(at_m.y, land.kinds.height));
    return glm::vec2{kinds[0], land.kinds.channels > 1 ? kinds[1] : 0} / 255.0F;
}

class Sower {
  public:
    Sower(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight, base::Seed seed)
        : land_(land),
          cover_(flora.cover),
          half_m_(0.5F * land.side_m()),
          seed_(seed),
          sight_(flight, half_m_),
          ground_(land),
          crops_(land.settlement.fields),
          region_(sight_.region(kWidestAside, kReach_m)) {
        const Sight::Window window = sight_.window(kReach_m);
        low_ = window.low_m;
        high_ = window.high_m;
    }

    scene::Sward sow() const {
        scene::Sward sward;
        sward.blossom = cover_.blossom;
        sward.reach_m = kReach_m;
        if (low_.x >= high_.x || low_.y >= high_.y) return sward;
        const Maps maps{{seed_.child("thin"), low_, high_, 1.6F * cover_.patch_m, 3},
                        {seed_.child("kinds"), low_, high_, cover_.patch_m, 2},
                        {seed_.child("blossoms"), low_, high_, 0.8F * cover_.patch_m, 2}};
        const int columns = static_cast<int>((high_.x - low_.x) / kCell_m) + 1;
        const int rows = static_cast<int>((high_.y - low_.y) / kCell_m) + 1;
        std::vector<std::vector<scene::Tuft>> cells(static_cast<std::size_t>(columns * rows));
        oneapi::tbb::parallel_for(0, columns * rows, [&](int i) {
            const glm::vec2 corner = low_ + kCell_m * glm::vec2{i % columns, i / columns};
            cells[static_cast<std::size_t>(i)] = cell(corner, maps);
        });
        for (const std::vector<scene::Tuft>& cell : cells)
            if (!cell.empty()) add(sward, cell);
        return sward;
    }

  private:
    struct Patches {
        float thin, kinds, blossoms;
    };
    struct Maps {
        NoiseMap thin, kinds, blossoms;
        Patches at(glm::vec2 at_m) const { return {thin.at(at_m), kinds.at(at_m), blossoms.at(at_m)}; }
    };

    std::vector<scene::Tuft> cell(glm::vec2 corner, const Maps& maps) const {
        std::vector<scene::Tuft> tufts;
        if (!region_.may_hold(corner + 0.5F * kCell_m)) return tufts;
        // The places of a cell by turns, so that a prefix of its tufts is even over it.
        constexpr int kPlaces = kSide * kSide;
        constexpr int kStride = 37;  // has no divisor in common with the places
        static_assert(kPlaces % kStride != 0);
        for (int n = 0; n < kPlaces; ++n) {
            const int place = n * kStride % kPlaces;
            const glm::ivec2 at{place % kSide, place / kSide};
            base::RandomStream random{base::Seed{base::hash_of(seed_, std::lround(corner.x * 8) + at.x,
                                                               std::lround(corner.y * 8) + static_cast<long>(at.y))}};
            const float right = random.unit_f();
            const float down = random.unit_f();
            const glm::vec2 at_m = corner + kSpacing_m * (glm::vec2{at} + glm::vec2{right, down});
            scene::Tuft tuft;
            if (draw(tuft, at_m, maps, random)) tufts.push_back(tuft);
        }
        return tufts;
    }

    bool draw(scene::Tuft& tuft, glm::vec2 at_m, const Maps& maps, base::RandomStream& random) const {
        const float stay = random.unit_f();
        const float kind = random.unit_f();
        const float size = random.unit_f();
        const float hue = random.unit_f();
        tuft.yaw_rad = random.between(0, glm::radians(360.0F));
        if (!ground_.is_on_land(at_m)) return false;
        const View view = sight_.view_of(at_m);
        if (view.along_m < -2.0F || view.to_way_m > kReach_m || view.to_way_m < 1.2F) return false;
        // Farther on fewer and wider ones stand, about as many to a piece of the picture.
        const float stands_for = std::max(view.to_way_m / kAll_m, 1.0F);
        if (random.unit_f() * std::pow(stands_for, 1.7F) > 1) return false;
        if (!ground_.is_dry(at_m, kLowest_m)) return false;
        const scene::FieldPlot* field = crops_.at(at_m);
        if (field && stand_of(field->crop).height_m > 0)
            return drill(tuft, *field, at_m, {stay, size, hue, std::min(std::pow(stands_for, 0.8F), kWidest)});
        const bool is_meadow = field && field->crop == scene::Crop::Meadow;
        // On ground that people use grass is mown, and grows where it was painted green: on lawns and green fields.
        const bool is_used = scene::to_road_m(land_, at_m) <= 0.1F && !is_meadow;
        if (is_used && !is_green(albedo_at(land_, at_m))) return false;
        const glm::vec2 material = material_at(land_, at_m);
        // What is green there is watered, whatever the ground is.
        const float bears = is_used || is_meadow ? 1 : glm::smoothstep(0.28F, 0.72F, material.x);
        // Between patches it is short rather than none: a felt of colour alone is no grass near by.
        const float least = 0.25F + 0.5F * cover_.density;
        const Patches patches = maps.at(at_m);
        const float closed = std::clamp(cover_.density + 1.1F * patches.thin + 0.12F, least, 1.0F) * bears;
        tuft.root_m = {at_m.x, scene::ground_height_m(land_, at_m) - 0.03F, at_m.y};
        if (stay < closed) {
            // Far off it melts into the ground, whose colour is all there is beyond.
            grow(tuft, patches, {kind, size, hue, kLean / stands_for}, is_used);
            tuft.radius_m *= std::min(std::pow(stands_for, 0.8F), kWidest);
            return true;
        }
        if (is_used) return false;
        // Between what grows, and where nothing does, lie stones.
        // Sand has none.
        const float bare = glm::smoothstep(0.0F, 0.08F, material.y);
        const float stony = 0.06F * std::max(bears, bare) + bare * (0.40F * material.y + 0.24F * (1 - bears));
        if (stay > closed + stony * (1 - closed)) return false;
        tuft.kind = scene::CoverKind::Stone;
        tuft.height_m = 0.05F + 0.40F * std::pow(size, 5.0F);
        tuft.radius_m = 1.1F * tuft.height_m + 0.05F;
        if (tuft.height_m < kPebble_m && stands_for > 1.5F) return false;  // nobody sees it from here
        tuft.tint = glm::vec3{0.55F + 0.75F * hue};
        return true;
    }

    struct Sown {
        float stay, size, hue;
        float wide;  // times its width, where it stands for many
    };

    // What grows on a field, in its rows.
    bool drill(scene::Tuft& tuft, const scene::FieldPlot& field, glm::vec2 at_m, const Sown& sown) const {
        const Stand stand = stand_of(field.crop);
        const glm::vec2 root_m = in_row(field, stand.rows_m, at_m);
        tuft.root_m = {root_m.x, scene::ground_height_m(land_, root_m) - 0.03F, root_m.y};
        if (sown.stay > stand.closed * (1 - snow_at(land_, tuft.root_m))) return false;
        tuft.kind = stand.kind;
        tuft.height_m = stand.height_m * (0.85F + 0.3F * sown.size);
        tuft.radius_m = stand.radius_m * sown.wide;
        tuft.tint = stand.tint * (0.85F + 0.3F * sown.hue);
        return true;
    }

    struct Draw {
        float kind, size, hue;
        float lean;  // of the ground's colour toward the grass's
    };

    void grow(scene::Tuft& tuft, const Patches& patches, const Draw& draw, bool is_mown) const {
        const float flowers = cover_.flowers * std::clamp(0.15F + 4.0F * patches.blossoms, 0.0F, 1.6F) *
                              (1 - snow_at(land_, tuft.root_m));
        const float cushions = std::clamp(cover_.cushions + 2.2F * patches.kinds, 0.0F, 0.65F);
        // Lower where it is thin: patches end in short grass, not in a wall of it.
        const float tall = (0.55F + 0.75F * draw.size) * std::clamp(0.85F + 1.6F * patches.thin, 0.45F, 1.35F);
        tuft.radius_m = 0.34F + 0.18F * draw.size;
        if (is_mown) {
            tuft.height_m = std::min(kMown * cover_.height_m, kMown_m) * (0.7F + 0.6F * draw.size);
        } else if (draw.kind < flowers) {
            tuft.kind = scene::CoverKind::Flower;
            tuft.height_m = cover_.height_m * (0.8F + 0.5F * draw.size);
        } else if (draw.kind < flowers + cushions * (1 - flowers)) {
            tuft.kind = scene::CoverKind::Cushion;
            tuft.height_m = 0.10F + 0.30F * cover_.height_m * tall;
        } else {
            tuft.kind = scene::CoverKind::Grass;
            tuft.height_m = cover_.height_m * tall;
            tuft.radius_m += 0.25F * cover_.spread;
        }
        const glm::vec3 bare = albedo_at(land_, {tuft.root_m.x, tuft.root_m.z});
        const glm::vec3 own = bare * scene::withering_of(bare, cover_.withered);
        const float light = 0.78F + 0.40F * draw.hue;
        const float yellow = 0.10F * (draw.hue - 0.5F) + 0.35F * patches.kinds;
        const glm::vec3 leaned = scene::mix_colours(own, cover_.grass, (is_mown ? 0.25F : 1.0F) * draw.lean);
        tuft.tint = light * glm::vec3{1 + 0.5F * yellow, 1 + 0.15F * yellow, 1 - yellow} * leaned /
                    glm::max(own, glm::vec3{0.004F});
        tuft.tint = glm::clamp(tuft.tint, glm::vec3{0.35F}, glm::vec3{2.2F});
    }

    static void add(scene::Sward& sward, const std::vector<scene::Tuft>& tufts) {
        scene::Sward::Cell cell;
        cell.first = sward.tufts.size();
        cell.low_m = glm::vec3{1.0e6F};
        cell.high_m = glm::vec3{-1.0e6F};
        for (std::size_t kind = 0; kind < scene::kCoverKinds; ++kind) {
            for (const scene::Tuft& tuft : tufts) {
                if (static_cast<std::size_t>(tuft.kind) != kind) continue;
                sward.tufts.push_back(tuft);
                ++cell.counts[kind];
                const glm::vec3 about{tuft.radius_m, tuft.height_m, tuft.radius_m};
                cell.low_m = glm::min(cell.low_m, tuft.root_m - about);
                cell.high_m = glm::max(cell.high_m, tuft.root_m + about);
            }
        }
        sward.cells.push_back(cell);
    }

    const scene::Land& land_;
    const scene::Cover& cover_;
    float half_m_;
    base::Seed seed_;
    Sight sight_;
    Ground ground_;
    Crops crops_;
    Sight::Region region_;
    glm::vec2 low_{0};
    glm::vec2 high_{0};
};

}  // namespace

scene::Sward lay_sward(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight, base::Seed seed) {
    return Sower(land, flora, flight, seed).sow();
}

void light_sward(scene::Sward& sward, const scene::Land& land, const scene::Cover& cover,
                 const scene::BakedLight& light, float colour_seen) {
    if (light.ground.bytes.empty()) return;
    const int side = light.ground.width;
    oneapi::tbb::parallel_for(std::size_t{0}, sward.tufts.size(), [&](std::size_t i) {
        scene::Tuft& tuft = sward.tufts[i];
        const glm::vec2 at_m{tuft.root_m.x, tuft.root_m.z};
        const glm::vec2 place = (at_m / land.side_m() + 0.5F) * static_cast<float>(side) - 0.5F;
        const glm::vec2 inside = glm::clamp(place, glm::vec2{0}, glm::vec2{static_cast<float>(side) - 1.001F});
        const glm::ivec2 first{inside};
        const glm::vec2 share = inside - glm::vec2{first};
        const auto lit = [&](int x, int y) {
            const std::uint8_t* p = light.ground.pixel(first.x + x, first.y + y);
            return glm::vec3{p[0], p[1], p[2]} * (2.0F / 255);
        };
        const glm::vec3 falls =
            glm::mix(glm::mix(lit(0, 0), lit(1, 0), share.x), glm::mix(lit(0, 1), lit(1, 1), share.x), share.y);
        const glm::vec3 bare = albedo_at(land, at_m);
        tuft.sent =
            scene::seen_by_night(bare * scene::withering_of(bare, cover.withered) * tuft.tint, colour_seen) * falls;
        tuft.lit = scene::luminance(falls);
    });
}

}  // namespace quadrat::synthesis
