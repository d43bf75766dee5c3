// SPDX-License-Identifier: Apache-2.0
// A façade's panels as the faces of a wall: with panes set back in it where it is near, with the larger panels and
// whole windows from some way off, with a wall and its windows from afar.
#include "synthesis/houses/walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <string_view>
#include <utility>

#include "scene/colour.hpp"
#include "synthesis/houses/masses.hpp"
#include "synthesis/houses/recesses.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr double kLarge_m2 = 0.3;   // of a panel that is seen from some way off
constexpr double kWall_m2 = 3.0;    // of one that is shaded from its foot to the eaves
constexpr double kMullion_m = 0.2;  // between panes of one window, at most
constexpr float kStep_m = 4.0e-3F;
constexpr float kLeast_m = 8.0e-3F;  // of a panel before what it lies on
constexpr float kSide_m = 0.035F;    // a panel that stands out less shows no sides
constexpr double kSides_m2 = 0.25;   // nor does a smaller one
constexpr double kBalcony_m = 0.3;
constexpr double kDoor_m2 = 0.8;
constexpr float kThickReveal_m = 0.19F;  // of walls of stone and plaster,
constexpr float kThinReveal_m = 0.11F;   // and of wood
constexpr float kBehind_m = 0.35F;
constexpr float kUnderLintel = 0.62F;
constexpr std::array<float, kLevels> kBefore_m{0, 0.05F, 0.10F};  // the wall, of windows that have no frames

bool is_glass(std::string_view symbol) { return symbol == "Glass" || symbol == "Dark" || symbol == "Light"; }

glm::vec3 linear_of(const glm::vec3& srgb) {
    return {scene::linear_from_srgb(srgb.r), scene::linear_from_srgb(srgb.g), scene::linear_from_srgb(srgb.b)};
}

struct Window {
    glm::dvec2 low, high;
    glm::vec3 colour;
    float lamp;
    float front = 0;
    std::size_t panel = 0;  // its first pane
};

class Wall {
  public:
    Wall(scene::Building& to, const Design& design, const Side& side, base::Seed seed)
        : to_(to), design_(design), side_(side) {
        double top = 0;
        for (const glm::dvec2 p : side.gable) top = std::max(top, p.y - side.height_m);
        const FacadeShape shape{side.width_m, side.height_m, top, side.covered, side.is_front};
        panels_ = derive_facade(*design.facade, shape, seed);
        find_fronts();
        find_windows(seed.child("lamps").child(
            static_cast<std::uint64_t>(std::lround(100 * (side.corner_m.x + 9 * side.corner_m.z + 999)))));
        lose_shutters(seed.child("shutters"));
        set_back();
    }

    void add() {
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const FacadePanel& panel = panels_[i];
            const glm::dvec2 size = panel.high_m - panel.low_m;
            const bool is_large = size.x * size.y > kLarge_m2 && !is_glass(panel.symbol);
            if (is_lost_[i]) continue;
            add_near(i);
            add_sides(i, 0, near_fronts_[i]);
            if (i == 0) add_front(i, 2, 0);
            if (!is_large) continue;
            add_front(i, 1, i == 0 ? 0.0F : fronts_[i] + kStep_m);
            if (panel.depth_m > kBalcony_m) add_sides(i, 1, fronts_[i]);
            if (i > 0 && size.x * size.y > kWall_m2) add_front(i, 2, fronts_[i] + kBefore_m[1]);
        }
        for (const Recess& recess : recesses_) add_recess(recess);
        for (const Window& window : windows_) {
            add_window(window, 1);
            add_window(window, 2);
        }
    }

  private:
    glm::vec3 at(glm::dvec2 p, float out_m) const {
        return side_.corner_m + side_.along * static_cast<float>(p.x) + glm::vec3{0, static_cast<float>(p.y), 0} +
               side_.out * out_m;
    }

    Outline under_roof(Outline outline) const {
        if (side_.gable.empty()) return outline;
        glm::dvec2 from{side_.width_m, side_.height_m};
        for (std::size_t i = 0; i <= side_.gable.size(); ++i) {
            const glm::dvec2 to = i < side_.gable.size() ? side_.gable[i] : glm::dvec2{0, side_.height_m};
            outline = left_of(outline, from, to);
            from = to;
        }
        return outline;
    }
    static Outline rectangle(glm::dvec2 low, glm::dvec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }
    Outline clipped(glm::dvec2 low, glm::dvec2 high) const { return under_roof(rectangle(low, high)); }

    // Under the eaves it is dark, at the foot a little.
    float shade_at(double y) const {
        const double below = !side_.gable.empty() ? 9.0 : side_.height_m - y;
        const auto under = static_cast<float>(glm::smoothstep(0.0, 0.9, below));
        const auto over = static_cast<float>(glm::smoothstep(-0.3, 0.5, y));
        return (0.60F + 0.40F * under) * (1 - (0.20F + 0.28F * design_.wear) * (1 - over));
    }

    Look look_of(const FacadePanel& panel) const {
        Look look{linear_of(panel.colour), scene::Cladding::Plain, 0};
        const bool is_base = &panel == panels_.data();
        if (is_base) look.cladding = design_.wall;
        if (panel.symbol == "Stone") look.cladding = design_.lower;
        if (panel.symbol == "Foot") look.cladding = scene::Cladding::Rubble;
        const glm::dvec2 size = panel.high_m - panel.low_m;
        if (is_base || (size.x * size.y > kWall_m2 && panel.symbol != "Foot")) {
            const glm::vec3 toward = scene::linear_from_srgb_hex(design_.wall_warmth > 0 ? 0xD9A866 : 0xB9C4CE);
            look.colour = scene::mix_colours(look.colour, toward, 0.45F * std::abs(design_.wall_warmth));
            // Limewash and paint on a wall are darker than a swatch of them.
            look.colour = scene::shifted_colour(look.colour, 0.94F * design_.wall_lightness);
            look.colour = scene::mix_colours(look.colour, scene::linear_from_srgb_hex(0x8B8271), 0.4F * design_.wear);
        }
        return look;
    }

    // top: of the light at its upper edge, where a lintel shades it.
    void add_outline(scene::Masses& masses, const Outline& outline, const Look& look, float out_m,
                     float top = 1) const {
        std::vector<glm::vec3> corners;
        std::vector<float> shades;
        double low = 1.0e9;
        double high = -1.0e9;
        for (const glm::dvec2 p : outline) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
        }
        for (const glm::dvec2 p : outline) {
            corners.push_back(at(p, out_m));
            const auto up = static_cast<float>((p.y - low) / std::max(high - low, 1.0e-6));
            shades.push_back(shade_at(p.y) * (1 + up * (top - 1)));
        }
        add_face(masses, corners, look, shades);
    }

    void add_front(std::size_t i, std::size_t level, float out_m) {
        const FacadePanel& panel = panels_[i];
        Look look = look_of(panel);
        if (is_glass(panel.symbol)) look.lamp = lamps_[i];
        const Outline left = clipped(panel.low_m, panel.high_m);
        scene::Masses& masses = to_.levels[level];
        if (is_shaded(panel) && level < 2) {
            for (const Outline& piece : without(left, {}, shading_cuts())) add_outline(masses, piece, look, out_m);
            return;
        }
        add_outline(masses, left, look, out_m, is_cut(panel) ? kUnderLintel : 1.0F);
    }

    static bool is_shaded(const FacadePanel& panel) {
        const glm::dvec2 size = panel.high_m - panel.low_m;
        return size.x * size.y > kWall_m2;
    }
    std::vector<double> shading_cuts() const { return {0.5, side_.height_m - 0.85}; }

    // With holes where windows and doors are set back. Behind the wall there is another, so that no light comes through
    // where its pieces meet.
    void add_near(std::size_t i) {
        const FacadePanel& panel = panels_[i];
        std::vector<Opening> holes;
        for (const Recess& recess : recesses_)
            if (i < recess.opening.panel && !is_glass(panel.symbol) && holds(panel, recess.opening))
                holes.push_back(recess.opening);
        if (holes.empty()) return add_front(i, 0, near_fronts_[i]);
        const Outline left = clipped(panel.low_m, panel.high_m);
        const Look look = look_of(panel);
        const std::vector<double> cuts = is_shaded(panel) ? shading_cuts() : std::vector<double>{};
        for (const Outline& piece : without(left, holes, cuts))
            add_outline(to_.levels[0], piece, look, near_fronts_[i]);
        if (i == 0) add_outline(to_.levels[0], left, look, -kBehind_m, 0.6F);
    }

    void add_recess(const Recess& recess) {
        const Opening& opening = recess.opening;
        const float front = near_fronts_[recess.in];
        const float back = floor_of(recess);
        Look look = look_of(panels_[recess.in]);
        look.cladding = scene::Cladding::Plain;
        const Outline outline = rectangle(opening.low_m, opening.high_m);
        if (!opening.is_panel) add_outline(to_.levels[0], outline, look, back, kUnderLintel);
        constexpr std::array<float, 4> kLight{1.0F, 0.72F, 0.5F, 0.72F};  // of the sill, a side, the lintel, a side
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec2 p = outline[k];
            const glm::dvec2 q = outline[(k + 1) % 4];
            const float light = kLight[k] * shade_at(p.y);
            add_face(to_.levels[0], std::array{at(q, back), at(p, back), at(p, front), at(q, front)}, look,
                     std::array{0.8F * light, 0.8F * light, light, light});
        }
    }

    float floor_of(const Recess& recess) const {
        const bool is_thick = design_.wall == scene::Cladding::Plaster || design_.wall == scene::Cladding::Rubble;
        return std::min(near_fronts_[recess.in], 0.02F) - (is_thick ? kThickReveal_m : kThinReveal_m);
    }

    // An old house has lost some.
    void lose_shutters(base::Seed seed) {
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const bool is_shutter = panels_[i].symbol == "Leaf" && panels_[i].depth_m > 0 && panels_[i].low_m.y > 0.5;
            const float chance = base::unit_of(base::hash_of(seed, static_cast<std::int64_t>(i), side_.is_front));
            is_lost_.push_back(is_shutter && chance < 0.5F * (design_.wear - 0.5F));
        }
    }

    // What is cut in, and what lies in it, as far back as the wall is thick.
    void set_back() {
        near_fronts_ = fronts_;
        std::vector<Opening> openings;
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const glm::dvec2 size = panels_[i].high_m - panels_[i].low_m;
            if (is_cut(panels_[i]) && !is_glass(panels_[i].symbol) && size.x * size.y > kDoor_m2 &&
                panels_[i].symbol != "Reveal")
                openings.push_back({panels_[i].low_m, panels_[i].high_m, true, i});
        }
        for (const Window& window : windows_)
            openings.push_back({window.low - 0.02, window.high + 0.02, false, window.panel});
        std::erase_if(openings, [this](const Opening& opening) {
            return under_roof(rectangle(opening.low_m, opening.high_m)) != rectangle(opening.low_m, opening.high_m);
        });
        recesses_ = recesses_of(panels_, openings);
        for (const Recess& recess : recesses_) {
            const float by = floor_of(recess) - fronts_[recess.in];
            for (std::size_t i = recess.in + 1; i < panels_.size(); ++i)
                if (glm::all(glm::lessThanEqual(recess.opening.low_m, panels_[i].low_m + 1.0e-6)) &&
                    glm::all(glm::greaterThanEqual(recess.opening.high_m, panels_[i].high_m - 1.0e-6)))
                    near_fronts_[i] += by;
        }
    }

    static bool is_cut(const FacadePanel& panel) { return panel.depth_m < panel.depth_from_m - 0.02; }

    // What is cut into a wall is drawn on it, in its own shade: from some way off a wall has no holes.
    void find_fronts() {
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const FacadePanel& panel = panels_[i];
            float parent = 0;
            for (std::size_t k = i; k-- > 0;) {
                const FacadePanel& other = panels_[k];
                const bool holds = other.depth_m == panel.depth_from_m &&
                                   glm::all(glm::lessThanEqual(other.low_m, panel.low_m + 1.0e-6)) &&
                                   glm::all(glm::greaterThanEqual(other.high_m, panel.high_m - 1.0e-6));
                if (!holds) continue;
                parent = fronts_[k];
                break;
            }
            const auto out = static_cast<float>(panel.depth_m - panel.depth_from_m);
            fronts_.push_back(i == 0 ? 0.0F : parent + std::max(out, kLeast_m));
        }
    }

    // The sides of what stands out.
    void add_sides(std::size_t i, std::size_t level, float front) {
        const FacadePanel& panel = panels_[i];
        const auto back = front - static_cast<float>(panel.depth_m - panel.depth_from_m);
        const glm::dvec2 size = panel.high_m - panel.low_m;
        if (front - back < kSide_m || (size.x * size.y < kSides_m2 && front - back < 0.1F)) return;
        const Outline outline = clipped(panel.low_m, panel.high_m);
        Look look = look_of(panel);
        look.cladding = scene::Cladding::Plain;
        constexpr std::array<float, 4> kShades{0.7F, 0.7F, 0.8F, 0.8F};
        const bool is_balcony = level == 0 && panel.depth_m - panel.depth_from_m > kBalcony_m;
        if (is_balcony) add_balcony_inside(panel, {back, front}, look);
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const glm::dvec2 p = outline[k];
            const glm::dvec2 q = outline[(k + 1) % outline.size()];
            if (is_balcony && p.y == panel.high_m.y && q.y == panel.high_m.y) continue;
            add_face(to_.levels[level], std::array{at(p, back), at(q, back), at(q, front), at(p, front)}, look,
                     kShades);
        }
    }

    // It is open above: its floor, and what its rails show to the house.
    void add_balcony_inside(const FacadePanel& panel, glm::vec2 from_to_m, const Look& look) {
        constexpr float kBoards_m = 0.05F;
        scene::Masses& masses = to_.levels.front();
        const auto corner = [&](double x, double y, float out_m) { return at({x, y}, out_m); };
        const float back = from_to_m.x;
        const float in = from_to_m.y - kBoards_m;
        const double left = panel.low_m.x + kBoards_m;
        const double right = panel.high_m.x - kBoards_m;
        const double low = panel.low_m.y + kBoards_m;
        const double high = panel.high_m.y;
        const std::array<float, 4> dark{0.55F, 0.55F, 0.55F, 0.55F};
        add_face(masses,
                 std::array{corner(left, low, in), corner(right, low, in), corner(right, low, back),
                            corner(left, low, back)},
                 look, dark);
        // Seen from the house: right, front, left.
        const std::array<std::pair<double, float>, 4> along{{{right, back}, {right, in}, {left, in}, {left, back}}};
        for (std::size_t k = 0; k + 1 < along.size(); ++k) {
            const auto [x0, z0] = along[k];
            const auto [x1, z1] = along[k + 1];
            add_face(masses,
                     std::array{corner(x0, low, z0), corner(x1, low, z1), corner(x1, high, z1), corner(x0, high, z0)},
                     look, dark);
        }
        // The rail's own thickness, seen from above.
        for (const auto& [x0, x1, y0, y1] : {std::array<double, 4>{panel.low_m.x, panel.high_m.x, in, from_to_m.y},
                                             std::array<double, 4>{panel.low_m.x, left, back, in},
                                             std::array<double, 4>{right, panel.high_m.x, back, in}})
            add_face(masses,
                     std::array{corner(x0, high, static_cast<float>(y1)), corner(x1, high, static_cast<float>(y1)),
                                corner(x1, high, static_cast<float>(y0)), corner(x0, high, static_cast<float>(y0))},
                     look);
    }

    // Panes side by side are one window, behind which there is one lamp.
    void find_windows(base::Seed seed) {
        lamps_.assign(panels_.size(), 0);
        std::vector<int> of(panels_.size(), -1);
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const FacadePanel& panel = panels_[i];
            if (!is_glass(panel.symbol)) continue;
            const auto touches = [&](const Window& w) {
                return panel.low_m.x < w.high.x + kMullion_m && w.low.x < panel.high_m.x + kMullion_m &&
                       panel.low_m.y < w.high.y + kMullion_m && w.low.y < panel.high_m.y + kMullion_m;
            };
            const auto found = std::find_if(windows_.begin(), windows_.end(), touches);
            if (found != windows_.end()) {
                of[i] = static_cast<int>(found - windows_.begin());
                found->low = glm::min(found->low, panel.low_m);
                found->high = glm::max(found->high, panel.high_m);
                continue;
            }
            of[i] = static_cast<int>(windows_.size());
            const float lamp = base::unit_of(base::hash_of(seed, of[i], 0));
            windows_.push_back(
                {panel.low_m, panel.high_m, linear_of(panel.colour), 0.02F + 0.98F * lamp, fronts_[i], i});
        }
        for (std::size_t i = 0; i < panels_.size(); ++i)
            if (of[i] >= 0) lamps_[i] = windows_[static_cast<std::size_t>(of[i])].lamp;
    }

    void add_window(const Window& window, std::size_t level) {
        // From afar a lit window shines beyond its frame.
        const glm::dvec2 more = (level == 2 ? 0.12 : 0.0) * (window.high - window.low);
        const Outline outline = clipped(window.low - more, window.high + more);
        const float front = level == 1 ? window.front + kBefore_m[0] : 0.0F;
        add_outline(to_.levels[level], outline, {window.colour, scene::Cladding::Plain, window.lamp},
                    std::max(front + 2 * kStep_m, kBefore_m[level]), 0.8F);
    }

    scene::Building& to_;
    const Design& design_;
    const Side& side_;
    std::vector<FacadePanel> panels_;
    std::vector<Window> windows_;
    std::vector<float> lamps_;
    std::vector<float> fronts_;  // of each panel, before the wall
    std::vector<float> near_fronts_;
    std::vector<bool> is_lost_;
    std::vector<Recess> recesses_;
};

}  // namespace

void add_side(scene::Building& to, const Design& design, const Side& side, base::Seed seed) {
    Wall(to, design, side, seed).add();
}

}  // namespace quadrat::synthesis::houses
