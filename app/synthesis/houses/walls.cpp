// SPDX-License-Identifier: Apache-2.0
// A façade's panels as the faces of a wall: with reveals and panes where it is near, with the larger panels and whole
// windows from some way off, with a wall and its windows from afar.
#include "synthesis/houses/walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <string_view>

#include "scene/colour.hpp"
#include "synthesis/houses/masses.hpp"

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
constexpr std::array<float, kLevels> kBefore_m{0, 0.05F, 0.10F};  // the wall, of windows that have no frames

using Outline = std::vector<glm::dvec2>;

bool is_glass(std::string_view symbol) { return symbol == "Glass" || symbol == "Dark" || symbol == "Light"; }

glm::vec3 linear_of(const glm::vec3& srgb) {
    return {scene::linear_from_srgb(srgb.r), scene::linear_from_srgb(srgb.g), scene::linear_from_srgb(srgb.b)};
}

struct Window {
    glm::dvec2 low, high;
    glm::vec3 colour;
    float lamp;
    float front = 0;
};

class Wall {
  public:
    Wall(scene::Building& to, const Design& design, const Side& side, base::Seed seed)
        : to_(to), design_(design), side_(side) {
        FacadeShape shape{side.width_m, side.height_m, side.gable_m - side.gable_cut_m, {}};
        const double half = 0.5 * side.width_m;
        if (!side.is_front) shape.covered.push_back({{half - 1.0, -1}, {half + 1.0, 0.55}});
        panels_ = derive_facade(*design.facade, shape, seed);
        find_fronts();
        find_windows(seed.child("lamps").child(
            static_cast<std::uint64_t>(std::lround(100 * (side.corner_m.x + 9 * side.corner_m.z + 999)))));
    }

    void add() {
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const FacadePanel& panel = panels_[i];
            const glm::dvec2 size = panel.high_m - panel.low_m;
            const bool is_large = size.x * size.y > kLarge_m2 && !is_glass(panel.symbol);
            add_front(i, 0, fronts_[i]);
            add_reveals(i, 0);
            if (i == 0) add_front(i, 2, 0);
            if (!is_large) continue;
            add_front(i, 1, i == 0 ? 0.0F : fronts_[i] + kStep_m);
            if (panel.depth_m > kBalcony_m) add_reveals(i, 1);
            if (i > 0 && size.x * size.y > kWall_m2) add_front(i, 2, fronts_[i] + kBefore_m[1]);
        }
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

    Outline clipped(glm::dvec2 low, glm::dvec2 high) const {
        Outline outline{low, {high.x, low.y}, high, {low.x, high.y}};
        if (side_.gable_m <= 0) return outline;
        const glm::dvec2 ridge{0.5 * side_.width_m, side_.height_m + side_.gable_m};
        outline = left_of(outline, {side_.width_m, side_.height_m}, ridge);
        outline = left_of(outline, ridge, {0, side_.height_m});
        const double top = ridge.y - side_.gable_cut_m;
        return left_of(outline, {side_.width_m, top}, {0, top});
    }

    // Under the eaves it is dark, at the foot a little.
    float shade_at(double y) const {
        const double below = side_.gable_m > 0 ? 9.0 : side_.height_m - y;
        const auto under = static_cast<float>(glm::smoothstep(0.0, 0.9, below));
        const auto over = static_cast<float>(glm::smoothstep(-0.3, 0.5, y));
        return (0.60F + 0.40F * under) * (0.80F + 0.20F * over);
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
        Outline left = clipped(panel.low_m, panel.high_m);
        scene::Masses& masses = to_.levels[level];
        const glm::dvec2 size = panel.high_m - panel.low_m;
        if (size.x * size.y > kWall_m2 && level < 2) {
            for (const double y : {0.5, side_.height_m - 0.85}) {
                add_outline(masses, left_of(left, {1, y}, {0, y}), look, out_m);
                left = left_of(left, {0, y}, {1, y});
            }
        }
        add_outline(masses, left, look, out_m, is_cut(panel) ? 0.62F : 1.0F);
    }

    static bool is_cut(const FacadePanel& panel) { return panel.depth_m < panel.depth_from_m - 0.02; }

    // What is cut into a wall is drawn on it, in its own shade: a wall has no holes.
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
    void add_reveals(std::size_t i, std::size_t level) {
        const FacadePanel& panel = panels_[i];
        const float front = fronts_[i];
        const auto back = front - static_cast<float>(panel.depth_m - panel.depth_from_m);
        const glm::dvec2 size = panel.high_m - panel.low_m;
        if (front - back < kSide_m || (size.x * size.y < kSides_m2 && front - back < 0.1F)) return;
        const Outline outline = clipped(panel.low_m, panel.high_m);
        Look look = look_of(panel);
        look.cladding = scene::Cladding::Plain;
        constexpr std::array<float, 4> kShades{0.7F, 0.7F, 0.8F, 0.8F};
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const glm::dvec2 p = outline[k];
            const glm::dvec2 q = outline[(k + 1) % outline.size()];
            add_face(to_.levels[level], std::array{at(p, back), at(q, back), at(q, front), at(p, front)}, look,
                     kShades);
        }
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
            windows_.push_back({panel.low_m, panel.high_m, linear_of(panel.colour), 0.02F + 0.98F * lamp, fronts_[i]});
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
};

}  // namespace

void add_side(scene::Building& to, const Design& design, const Side& side, base::Seed seed) {
    Wall(to, design, side, seed).add();
}

}  // namespace quadrat::synthesis::houses
