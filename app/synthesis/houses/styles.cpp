// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/styles.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "scene/colour.hpp"

namespace quadrat::synthesis::houses {
namespace {

using scene::Cladding;

// How a region builds. Metres, degrees, sRGB.
struct Region {
    std::string_view dwelling, townhouse;  // façades
    Cladding wall, lower;
    float wall_m;    // of the usual house
    float storey_m;  // one more, or one less where it is higher than two
    float pitch_deg, eave_m, verge_m, hipped;
    Cladding roof;
    std::array<std::uint32_t, 3> roofs;  // plainer, usual, warmer
    std::uint32_t plinth, wood;
    float depth_m, width_m;
    float plinth_m, chimneys;
};
constexpr std::array<Region, kRegions> kTable{{
    {"alpine",
     "alpine",
     Cladding::Boards,
     Cladding::Plaster,
     5.1F,
     2.5F,
     25,
     1.15F,
     1.25F,
     0.05F,
     Cladding::Slates,
     {0x6F6B66, 0x7B6A58, 0x8A5B44},
     0x9A938A,
     0x4A3626,
     8.6F,
     10.5F,
     0.4F,
     1},
    {"nordic",
     "nordic",
     Cladding::Planks,
     Cladding::Plaster,
     3.5F,
     2.7F,
     39,
     0.4F,
     0.35F,
     0.1F,
     Cladding::Tiles,
     {0x44474B, 0x584A46, 0x7C4A3C},
     0x7D7C79,
     0xE9E6DD,
     6.8F,
     10.0F,
     0.5F,
     1},
    {"mediterranean",
     "mediterranean",
     Cladding::Plaster,
     Cladding::Plaster,
     6.0F,
     3.0F,
     21,
     0.45F,
     0.25F,
     0.45F,
     Cladding::Tiles,
     {0xA08468, 0xA67560, 0xA86A54},
     0xB3A285,
     0x7A5A40,
     7.6F,
     9.2F,
     0.25F,
     0.7F},
    {"savanna",
     "savanna",
     Cladding::Plaster,
     Cladding::Plaster,
     2.5F,
     2.4F,
     43,
     0.75F,
     0.5F,
     0.9F,
     Cladding::Thatch,
     {0x8C7B5A, 0xA88F5E, 0xB79A5C},
     0x8A5A3A,
     0x5C4630,
     5.2F,
     6.4F,
     0.15F,
     0},
    {"timbered",
     "timbered",
     Cladding::Plaster,
     Cladding::Rubble,
     5.4F,
     2.7F,
     50,
     0.4F,
     0.3F,
     0.3F,
     Cladding::Tiles,
     {0x6B5147, 0x82513F, 0x935543},
     0x8F877B,
     0x4A3324,
     7.2F,
     9.6F,
     0.45F,
     1},
    {"cottage",
     "cottage",
     Cladding::Plaster,
     Cladding::Rubble,
     2.75F,
     2.5F,
     44,
     0.3F,
     0.12F,
     0.1F,
     Cladding::Slates,
     {0x50565E, 0x5F6166, 0x6E5F58},
     0x8C8780,
     0x5A544C,
     6.2F,
     10.8F,
     0.3F,
     1.6F},
}};
constexpr Region kThatched = {"cottage",
                              "cottage",
                              Cladding::Plaster,
                              Cladding::Rubble,
                              2.7F,
                              2.5F,
                              48,
                              0.55F,
                              0.3F,
                              0.5F,
                              Cladding::Thatch,
                              {0x7D6D50, 0x93805A, 0xA08A5C},
                              0x8C8780,
                              0x5A4A38,
                              6.0F,
                              10.4F,
                              0.3F,
                              1};

const std::map<std::string_view, FacadeGrammar>& grammars() {
    static const std::map<std::string_view, FacadeGrammar> kRead = [] {
        std::map<std::string_view, FacadeGrammar> read;
        for (const NamedFacade& type : facade_library()) read.emplace(type.name, read_facade(type.text, type.name));
        return read;
    }();
    return kRead;
}

int region_of(const scene::LandParameters& p) {
    return std::clamp(static_cast<int>(std::lround(p.settle_region)), 0, kRegions - 1);
}

struct Drawn {
    Use use;
    std::uint64_t number;
};

class Maker {
  public:
    Maker(const scene::LandParameters& p, base::Seed seed) : p_(p), seed_(seed) {
        const int region = region_of(p);
        base::RandomStream random{seed.child("roofs")};
        const bool is_thatched = region == kRegions - 1 && random.unit() < 0.35;
        region_ = is_thatched ? kThatched : kTable[static_cast<std::size_t>(region)];
    }

    Design design(const Drawn& drawn) const {
        base::RandomStream random{seed_of(drawn)};
        Design d = usual(random);
        switch (drawn.use) {
            case Use::Dwelling:
                shape_dwelling(d, random);
                break;
            case Use::Townhouse:
                shape_townhouse(d, random);
                break;
            case Use::Barn:
                shape_barn(d, random);
                break;
            case Use::Chapel:
                shape_chapel(d);
                break;
            case Use::Mill:
                d.facade = &grammars().at("mill");
                d.wall = Cladding::Rubble;
                d.lower = Cladding::Rubble;
                d.wall_m = 5.4;
                d.plan = plan_of(9.5, 7.5);
                d.is_gable = {false, true, false, true};
                break;
            case Use::Lighthouse:
                shape_lighthouse(d);
                break;
        }
        return d;
    }
    base::Seed seed_of(const Drawn& drawn) const {
        return seed_.child(static_cast<std::uint64_t>(drawn.use)).child(drawn.number);
    }

  private:
    glm::vec3 roof_colour(base::RandomStream& random) const {
        const float at =
            std::clamp(1 + p_.settle_roof_hue + 0.45F * p_.settle_colourful * random.between(-1, 1), 0.0F, 2.0F);
        const auto low = std::min(static_cast<std::size_t>(at), std::size_t{1});
        const glm::vec3 colour =
            scene::mix_colours(scene::linear_from_srgb_hex(region_.roofs[low]),
                               scene::linear_from_srgb_hex(region_.roofs[low + 1]), at - static_cast<float>(low));
        return scene::shifted_colour(colour, p_.settle_roof_lightness * random.between(0.94F, 1.06F));
    }

    Design usual(base::RandomStream& random) const {
        Design d;
        d.facade = &grammars().at(region_.dwelling);
        d.pitch_deg = std::clamp(region_.pitch_deg * p_.settle_roof_pitch * random.between(0.96F, 1.04F), 14.0F, 58.0F);
        d.eave_m = region_.eave_m * p_.settle_overhang;
        d.verge_m = region_.verge_m * p_.settle_overhang;
        d.plinth_m = region_.plinth_m + random.between(0.0F, 0.15F);
        d.roof = {region_.roof, roof_colour(random)};
        d.plinth = {Cladding::Rubble, scene::linear_from_srgb_hex(region_.plinth)};
        d.wood = scene::linear_from_srgb_hex(region_.wood);
        d.wall = region_.wall;
        d.lower = region_.lower;
        d.wall_warmth = p_.settle_wall_warmth + 0.5F * p_.settle_colourful * random.between(-1, 1);
        d.wall_lightness = p_.settle_wall_lightness;
        const float hip = std::clamp(region_.hipped + p_.settle_hipped, 0.0F, 1.0F);
        const float drawn = random.unit_f();
        d.form = drawn < 0.6F * hip ? RoofForm::Hipped : drawn < hip ? RoofForm::HalfHipped : RoofForm::Gabled;
        const float chimneys = region_.chimneys * (region_.chimneys > 0 ? p_.settle_chimneys : 1);
        d.chimneys = static_cast<int>(chimneys + random.unit_f());
        d.wall_m = region_.wall_m;
        return d;
    }

    void shape_dwelling(Design& d, base::RandomStream& random) const {
        const float size = p_.settle_house_size * random.between(0.88F, 1.12F);
        const double width = region_.width_m * size;
        const double depth = region_.depth_m * (0.5F + 0.5F * size);
        const bool is_gable_front = region_.dwelling == "alpine" || random.unit() < p_.settle_gable_front;
        const bool has_wing = !is_gable_front && random.unit() < p_.settle_wings;
        if (has_wing) {
            d.plan = plan_of(width, depth, 0.55 * width, 0.45 * depth);
            d.is_gable = {false, false, true, false, false, true};
        } else if (is_gable_front) {
            d.plan = plan_of(depth * 1.05, width);
            d.is_gable = {true, false, true, false};
        } else {
            d.plan = plan_of(width, depth);
            d.is_gable = {false, true, false, true};
        }
        d.wall_m += storeys_more(random) * region_.storey_m;
        if (region_.wall_m > 1.8F * region_.storey_m && random.unit() < 0.4) d.wall_m -= region_.storey_m;
    }

    double storeys_more(base::RandomStream& random) const {
        return std::floor(std::max(0.0F, p_.settle_storeys - 1 + random.between(-0.35F, 0.35F)));
    }

    // To the front and the back, or to both sides.
    static void turn_gables(Design& d, bool to_front) { d.is_gable = {to_front, !to_front, to_front, !to_front}; }

    void shape_townhouse(Design& d, base::RandomStream& random) const {
        d.facade = &grammars().at(region_.townhouse);
        const float size = p_.settle_house_size * random.between(0.9F, 1.1F);
        d.plan = plan_of(0.84 * region_.width_m * size, 1.15 * region_.depth_m);
        turn_gables(d, random.unit() < 0.5);
        d.verge_m = std::min(d.verge_m, 0.25);
        d.wall_m += region_.storey_m * (storeys_more(random) + (region_.dwelling == "savanna" ? 0 : 1));
    }

    void shape_barn(Design& d, base::RandomStream& random) const {
        d.facade = &grammars().at(region_.dwelling == "savanna" ? "savanna" : "barn");
        if (region_.dwelling != "savanna") d.wall = Cladding::Planks;
        d.form = RoofForm::Gabled;
        d.wall_m = random.between(3.2F, 3.9F);
        d.plan = plan_of(random.between(8.5F, 11.5F), random.between(6.4F, 7.4F));
        turn_gables(d, random.unit() < 0.4);
        d.chimneys = 0;
        d.plinth_m = 0.2;
        d.wall_warmth = 0;
    }

    void shape_chapel(Design& d) const {
        d.facade = &grammars().at("chapel");
        d.wall = Cladding::Plaster;
        d.form = RoofForm::Gabled;
        d.pitch_deg = std::max(d.pitch_deg, 42.0);
        d.wall_m = 6;
        d.plan = plan_of(8.2, 16);
        d.is_gable = {true, false, true, false};
        d.chimneys = 0;
        d.tower_m = 14.5;
        d.wall_warmth = 0;
        d.plinth_m = 0.5;
        d.eave_m = 0.4;
        d.verge_m = 0.25;
    }

    void shape_lighthouse(Design& d) const {
        d.facade = &grammars().at("lighthouse");
        d.wall = Cladding::Plaster;
        d.form = RoofForm::Hipped;
        d.pitch_deg = 38;
        d.eave_m = 0.35;
        d.wall_m = 14;
        d.plan.clear();
        for (int i = 0; i < 8; ++i) {
            const double turn = 0.785398163 * (i - 2.5);
            d.plan.emplace_back(2.3 * std::cos(turn), 2.3 * std::sin(turn));
        }
        d.is_gable.assign(8, false);
        d.chimneys = 0;
        d.roof = {Cladding::Plain, scene::linear_from_srgb_hex(0x9A3328)};
        d.wall_warmth = 0;
        d.plinth_m = 0.6;
    }

    scene::LandParameters p_;
    base::Seed seed_;
    Region region_{};
};

}  // namespace

std::vector<std::uint32_t> Stock::of(Use use) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < uses.size(); ++i)
        if (uses[i] == use) found.push_back(i);
    return found;
}

Stock make_stock(const scene::LandParameters& parameters, base::Seed seed) {
    const Maker maker(parameters, seed);
    std::vector<Drawn> drawn;
    constexpr std::array<std::pair<Use, int>, 6> kNumbers{{{Use::Dwelling, 7},
                                                           {Use::Townhouse, 4},
                                                           {Use::Barn, 2},
                                                           {Use::Chapel, 1},
                                                           {Use::Mill, 1},
                                                           {Use::Lighthouse, 1}}};
    for (const auto& [use, many] : kNumbers)
        for (int i = 0; i < many; ++i) drawn.push_back({use, static_cast<std::uint64_t>(i)});
    Stock stock;
    stock.buildings.resize(drawn.size());
    for (const Drawn& one : drawn) stock.uses.push_back(one.use);
    oneapi::tbb::parallel_for(std::size_t{0}, drawn.size(), [&](std::size_t i) {
        stock.buildings[i] = build(maker.design(drawn[i]), maker.seed_of(drawn[i]));
    });
    return stock;
}

}  // namespace quadrat::synthesis::houses
