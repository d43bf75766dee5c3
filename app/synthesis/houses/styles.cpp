// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/styles.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <string_view>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/houses/regions.hpp"
#include "synthesis/houses/roofs.hpp"

namespace quadrat::synthesis::houses {
namespace {

using scene::Cladding;

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

// One house's design: its own seed draws what its region and the settlement's parameters leave open.
class Designer {
  public:
    Designer(const scene::LandParameters& p, const Region& region, base::Seed own)
        : p_(p), region_(region), random_(own), overgrown_(overgrown(p, own.child("climbers"))) {}

    Design of(Use use) {
        Design d = usual();
        switch (use) {
            case Use::Dwelling:
                shape_dwelling(d);
                break;
            case Use::Townhouse:
                shape_townhouse(d);
                break;
            case Use::Barn:
                shape_barn(d);
                break;
            case Use::Chapel:
                shape_chapel(d);
                break;
            case Use::Mill:
                shape_mill(d);
                break;
            case Use::Lighthouse:
                shape_lighthouse(d);
                break;
        }
        centre(d);
        return d;
    }

  private:
    bool chance(double share) { return random_.unit() < share; }
    double storey_m() const { return region_.storey_m; }
    bool is_savanna() const { return region_.dwelling == "savanna"; }

    glm::vec3 roof_colour() {
        const float at = std::clamp(
            1 + p_.settle_roof_hue + (0.15F + 0.5F * p_.settle_colourful) * random_.between(-1, 1), 0.0F, 2.0F);
        const auto low = std::min(static_cast<std::size_t>(at), std::size_t{1});
        const glm::vec3 colour =
            scene::mix_colours(scene::linear_from_srgb_hex(region_.roofs[low]),
                               scene::linear_from_srgb_hex(region_.roofs[low + 1]), at - static_cast<float>(low));
        return scene::shifted_colour(colour, p_.settle_roof_lightness * random_.between(0.86F, 1.1F));
    }

    Design usual() {
        Design d;
        d.facade = &grammars().at(region_.dwelling);
        d.pitch_deg = std::clamp(region_.pitch_deg * p_.settle_roof_pitch * random_.between(0.9F, 1.1F), 14.0F, 58.0F);
        d.eave_m = region_.eave_m * p_.settle_overhang * random_.between(0.85F, 1.15F);
        d.verge_m = region_.verge_m * p_.settle_overhang;
        d.plinth_m = region_.plinth_m + random_.between(0.0F, 0.25F);
        d.roof = {region_.roof, roof_colour()};
        d.plinth = {Cladding::Rubble, scene::linear_from_srgb_hex(region_.plinth) * random_.between(0.85F, 1.1F)};
        d.wood = scene::linear_from_srgb_hex(region_.wood);
        d.wall = region_.wall;
        d.lower = region_.lower;
        d.wall_warmth = p_.settle_wall_warmth + (0.1F + 0.5F * p_.settle_colourful) * random_.between(-1, 1);
        d.wall_lightness = p_.settle_wall_lightness * random_.between(0.93F, 1.05F);
        d.wear = wear();
        const float hip = std::clamp(region_.hipped + p_.settle_hipped, 0.0F, 1.0F);
        const float drawn = random_.unit_f();
        d.form = drawn < 0.6F * hip ? RoofForm::Hipped : drawn < hip ? RoofForm::HalfHipped : RoofForm::Gabled;
        const float chimneys = region_.chimneys * (region_.chimneys > 0 ? p_.settle_chimneys : 1);
        d.chimneys = static_cast<int>(chimneys + random_.unit_f());
        d.wall_m = region_.wall_m;
        d.overgrown = overgrown_;
        d.redness = p_.climber_redness;
        return d;
    }

    static float overgrown(const scene::LandParameters& p, base::Seed seed) {
        base::RandomStream random{seed};
        return random.unit_f() < p.climber_share ? (0.2F + 0.8F * p.climber_height) * random.between(0.7F, 1.0F) : 0.0F;
    }

    // Each is kept as its people can.
    float wear() { return std::clamp(p_.settle_wear + 0.22F * random_.normal(), 0.0F, 1.0F); }

    void shape_dwelling(Design& d) {
        const float size = p_.settle_house_size * random_.between(0.8F, 1.2F);
        const double width = region_.width_m * size;
        const double depth = region_.depth_m * (0.5F + 0.5F * size) * random_.between(0.92F, 1.05F);
        const bool is_gable_front = region_.dwelling == "alpine" || chance(p_.settle_gable_front);
        if (region_.dwelling == "timbered" && chance(0.2)) d.facade = &grammars().at("cottage");
        d.wall_m += storeys_more() * storey_m();
        if (region_.wall_m > 1.8F * region_.storey_m && chance(0.4)) d.wall_m -= storey_m();
        d.wall_m += 0.45 * region_.storey_m * random_.between(-0.15F, 0.5F);  // an attic's low wall
        if (chance(region_.broken)) break_roof(d);
        if (is_gable_front) {
            d.footprint = rectangle(depth * 1.05, width, true);
        } else {
            d.footprint = rectangle(width, depth);
            if (chance(p_.settle_wings)) add_wing(d, width, depth);
        }
        if (chance(is_savanna() ? 0.1 : 0.4)) add_lean_to(d);
        if (!is_savanna() && chance(d.form == RoofForm::Mansard ? 0.9 : 0.3))
            d.dormers = 1 + static_cast<int>(random_.below(3));
    }

    void add_wing(Design& d, double width, double depth) {
        constexpr std::array kWings{Wing::BackCorner, Wing::Front, Wing::BackMiddle};
        const Wing wing = kWings[random_.below(3)];
        const double wide = std::min(0.62 * width, depth * random_.between(0.7F, 1.0F));
        d.footprint = with_wing(d.footprint, wing, wide, depth * random_.between(0.3F, 0.6F));
        if (chance(0.5)) d.footprint = mirrored(d.footprint);
    }

    // Steep below, flat above: room to live in under it.
    void break_roof(Design& d) {
        d.form = chance(0.25 + p_.settle_hipped) ? RoofForm::Mansard : RoofForm::Gambrel;
        d.pitch_deg = random_.between(63.0F, 69.0F);
        d.upper_pitch_deg = random_.between(21.0F, 30.0F);
        d.break_m = random_.between(2.2F, 2.5F);
        d.eave_m = std::min(d.eave_m, 0.28);
    }

    // At a side away from the street.
    void add_lean_to(Design& d) {
        const std::vector<glm::dvec2>& plan = d.footprint.plan;
        LeanTo shed;
        shed.side = 1 + random_.below(static_cast<std::uint32_t>(plan.size() - 1));
        const double length = glm::distance(plan[shed.side], plan[(shed.side + 1) % plan.size()]);
        // Not into another wing.
        const glm::dvec2 along = plan[(shed.side + 1) % plan.size()] - plan[shed.side];
        const auto turn = [&](std::size_t from) {
            const std::size_t n = plan.size();
            const glm::dvec2 a = plan[(from + 1) % n] - plan[from % n];
            const glm::dvec2 b = plan[(from + 2) % n] - plan[(from + 1) % n];
            return a.x * b.y - a.y * b.x;
        };
        if (length < 3.2 || along.x > 0.1 || turn(shed.side) < 0 || turn(shed.side + plan.size() - 1) < 0) return;
        shed.width_m = std::min(length, std::max(2.4, length * random_.between(0.4F, 1.0F)));
        shed.from_m = (length - shed.width_m) * (chance(0.5) ? 0 : 1);
        shed.depth_m = random_.between(1.7F, 2.6F);
        shed.high_m = std::min(d.wall_m - 0.25, static_cast<double>(random_.between(2.5F, 3.0F)));
        shed.low_m = shed.high_m - shed.depth_m * random_.between(0.22F, 0.4F);
        if (shed.low_m > 1.5) d.lean_tos.push_back(shed);
    }

    double storeys_more() {
        if (is_savanna()) return 0;  // earth bears no second floor
        return std::floor(std::max(0.0F, p_.settle_storeys - 1 + random_.between(-0.5F, 0.5F)));
    }

    void shape_townhouse(Design& d) {
        d.facade = &grammars().at(region_.townhouse);
        const float size = p_.settle_house_size * random_.between(0.82F, 1.12F);
        d.wall_m += storey_m() * (storeys_more() + (is_savanna() ? 0 : 1)) + random_.between(-0.3F, 0.4F);
        if (chance(1.4 * region_.broken)) break_roof(d);
        d.footprint = rectangle(0.84 * region_.width_m * size, 1.15 * region_.depth_m, chance(0.5));
        d.verge_m = std::min(d.verge_m, 0.25);
        if (!is_savanna() && chance(0.55)) d.dormers = 1 + static_cast<int>(random_.below(3));
    }

    void shape_barn(Design& d) {
        d.facade = &grammars().at(is_savanna() ? "savanna" : "barn");
        if (!is_savanna()) d.wall = Cladding::Planks;
        d.form = RoofForm::Gabled;
        d.wall_m = random_.between(3.2F, 3.9F) - (is_savanna() ? 1.0F : 0.0F);
        const double width = random_.between(8.0F, 12.0F);
        d.footprint = rectangle(width, random_.between(6.0F, 7.6F), chance(0.4));
        if (chance(1.3 * region_.broken)) {
            break_roof(d);
            d.form = RoofForm::Gambrel;
        }
        if (!is_savanna() && chance(0.45)) add_lean_to(d);
        d.chimneys = 0;
        d.plinth_m = 0.2;
        d.wall_warmth = 0;
    }

    static void shape_chapel(Design& d) {
        d.facade = &grammars().at("chapel");
        d.wall = Cladding::Plaster;
        d.form = RoofForm::Gabled;
        d.pitch_deg = std::max(d.pitch_deg, 42.0);
        d.wall_m = 6;
        d.footprint = rectangle(8.2, 16, true);
        d.chimneys = 0;
        d.tower_m = 14.5;
        d.wall_warmth = 0;
        d.plinth_m = 0.5;
        d.eave_m = 0.4;
        d.verge_m = 0.25;
        d.wear *= 0.5F;
    }

    static void shape_mill(Design& d) {
        d.facade = &grammars().at("mill");
        d.wall = Cladding::Rubble;
        d.lower = Cladding::Rubble;
        d.wall_m = 5.4;
        d.footprint = rectangle(9.5, 7.5);
    }

    static void shape_lighthouse(Design& d) {
        d.facade = &grammars().at("lighthouse");
        d.wall = Cladding::Plaster;
        d.form = RoofForm::Hipped;
        d.pitch_deg = 38;
        d.eave_m = 0.35;
        d.wall_m = 14;
        for (int i = 0; i < 8; ++i) {
            const double turn = 0.785398163 * (i - 2.5);
            d.footprint.plan.emplace_back(2.3 * std::cos(turn), 2.3 * std::sin(turn));
        }
        d.footprint.is_gable.assign(8, false);
        d.chimneys = 0;
        d.roof = {Cladding::Plain, scene::linear_from_srgb_hex(0x9A3328)};
        d.wall_warmth = 0;
        d.plinth_m = 0.6;
        d.wear *= 0.5F;
    }

    // The rectangle round walls and sheds lies about the origin.
    static void centre(Design& d) {
        glm::dvec2 low{1.0e9};
        glm::dvec2 high{-1.0e9};
        std::vector<glm::dvec2>& plan = d.footprint.plan;
        const auto hold = [&](glm::dvec2 p) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        };
        for (const glm::dvec2 p : plan) hold(p);
        for (const LeanTo& shed : d.lean_tos) {
            const glm::dvec2 along = glm::normalize(plan[(shed.side + 1) % plan.size()] - plan[shed.side]);
            hold(plan[shed.side] + shed.from_m * along + shed.depth_m * glm::dvec2{along.y, -along.x});
        }
        for (glm::dvec2& p : plan) p -= 0.5 * (low + high);
    }

    const scene::LandParameters& p_;
    const Region& region_;
    base::RandomStream random_;
    float overgrown_;
};

}  // namespace

std::size_t Stock::most_of(Use use) {
    constexpr std::array<std::size_t, kUses> kMost{40, 16, 8, 1, 1, 1};
    return kMost[static_cast<std::size_t>(use)];
}

Stock::Stock(const scene::LandParameters& parameters, base::Seed seed)
    : parameters_(parameters), seed_(seed), of_use_(kUses) {}

Design Stock::design(Use use, base::Seed seed) const {
    const int number = region_of(parameters_);
    base::RandomStream random{seed_.child("roofs")};
    const bool is_thatched = number == kRegions - 1 && random.unit() < 0.35;
    return Designer(parameters_, is_thatched ? thatched_region() : region(number), seed).of(use);
}

Stock::Offer Stock::draw(Use use, base::Seed own) const {
    const std::vector<std::uint32_t>& all = of_use_[static_cast<std::size_t>(use)];
    if (all.size() < most_of(use)) return {use, design(use, own), own.child("walls"), -1};
    const std::uint32_t like = all[base::RandomStream{own}.below(static_cast<std::uint32_t>(all.size()))];
    Offer offer = designs_[like];
    offer.like = static_cast<int>(like);
    return offer;
}

std::uint32_t Stock::take(Offer offer) {
    if (offer.like >= 0) return static_cast<std::uint32_t>(offer.like);
    const auto number = static_cast<std::uint32_t>(designs_.size());
    scene::Building shell;
    shell.half_m = half_of(offer.design);
    buildings_.push_back(std::move(shell));
    uses_.push_back(offer.use);
    of_use_[static_cast<std::size_t>(offer.use)].push_back(number);
    designs_.push_back(std::move(offer));
    return number;
}

void Stock::raise() {
    oneapi::tbb::parallel_for(std::size_t{0}, designs_.size(), [&](std::size_t i) {
        if (buildings_[i].levels.empty()) buildings_[i] = build(designs_[i].design, designs_[i].seed);
    });
}

Stock sample_stock(const scene::LandParameters& parameters, base::Seed seed, std::size_t of_each) {
    Stock stock(parameters, seed);
    for (std::size_t use = 0; use < kUses; ++use)
        for (std::size_t i = 0; i < std::min(of_each, Stock::most_of(static_cast<Use>(use))); ++i)
            stock.take(stock.draw(static_cast<Use>(use), seed.child(use).child(i)));
    stock.raise();
    return stock;
}

}  // namespace quadrat::synthesis::houses
