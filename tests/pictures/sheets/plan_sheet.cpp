// SPDX-License-Identifier: Apache-2.0
// Roofs and towns over plans, to be looked at:
//     plan_sheet roofs FILE.svg      sixty roofs over the tests' plans, seen from the south-west
//     plan_sheet figures FILE.svg    figures 5 and 66 of Kelly's report: merged Voronoi blocks, and the same bay window
//                                    with the least and the most volume; and blocks of a region that is not convex
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "base/file.hpp"
#include "mesh/lots.hpp"
#include "mesh/straight_skeleton.hpp"
#include "mesh/voronoi.hpp"
#include "support/plans.hpp"

namespace {

using namespace quadrat;
using tests::Loop;

struct Box {
    double x, y, size;
};

// Scales what lies within low and high into a box, y up.
class Frame {
  public:
    Frame(const Box& box, glm::dvec2 low, glm::dvec2 high) : box_(box), low_(low), high_(high) {
        scale_ = 0.88 * box.size / std::max({high.x - low.x, high.y - low.y, 1.0e-9});
    }
    std::string path(const Loop& loop) const {
        std::string d;
        for (const glm::dvec2 p : loop) {
            const glm::dvec2 off = scale_ * (p - 0.5 * (low_ + high_));
            d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", box_.x + 0.5 * box_.size + off.x,
                             box_.y + 0.5 * box_.size - off.y);
        }
        return d + "Z";
    }

  private:
    Box box_;
    glm::dvec2 low_, high_;
    double scale_;
};

glm::dvec2 seen(glm::dvec3 p) { return {p.x + 0.45 * p.y, 0.62 * p.y + 0.85 * p.z}; }

struct Shown {
    Loop outline;
    double depth;
    double light;
};

std::vector<Shown> shown_faces(const mesh::Roof& roof) {
    std::vector<Shown> faces;
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-0.75, -0.45, 1));
    for (const mesh::RoofFace& face : roof.faces) {
        Shown shown{{}, 0, 0};
        glm::dvec3 area(0);
        const auto v = [&](std::size_t i) { return roof.vertices[face.outline[i]]; };
        for (std::size_t i = 2; i < face.outline.size(); ++i) area += glm::cross(v(i - 1) - v(0), v(i) - v(0));
        if (!(glm::length(area) > 0)) continue;
        const glm::dvec3 normal = glm::normalize(area);
        if (normal.y > 0.62 * normal.z + 0.3) continue;  // looks away
        for (const std::uint32_t i : face.outline) {
            shown.outline.push_back(seen(roof.vertices[i]));
            shown.depth += roof.vertices[i].y / static_cast<double>(face.outline.size());
        }
        shown.light = 0.45 + 0.55 * std::max(0.0, glm::dot(normal, sun));
        faces.push_back(std::move(shown));
    }
    std::sort(faces.begin(), faces.end(), [](const Shown& a, const Shown& b) { return a.depth > b.depth; });
    return faces;
}

std::string roof_svg(const mesh::Roof& roof, const Box& box, const std::string& name) {
    const std::vector<Shown> faces = shown_faces(roof);
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const Shown& face : faces)
        for (const glm::dvec2 p : face.outline) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    const Frame frame(box, low, high);
    std::string svg;
    for (const Shown& face : faces)
        svg += fmt::format("<path d=\"{}\" fill=\"rgb({:.0f},{:.0f},{:.0f})\"/>\n", frame.path(face.outline),
                           205 * face.light, 130 * face.light, 95 * face.light);
    return svg + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", box.x + 4, box.y + box.size - 3, name);
}

std::string framed(double width, double height, const std::string& inner) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#f6f3ea\"/>\n<g stroke=\"#3a352e\" stroke-width=\"0.8\" "
        "stroke-linejoin=\"round\" font-family=\"sans-serif\" font-size=\"12\">\n{2}</g>\n</svg>\n",
        width, height, inner);
}

std::string roofs() {
    constexpr int kColumns = 10;
    constexpr std::size_t kRoofs = 60;
    constexpr double kCell = 190;
    const std::vector<tests::NamedPlan> plans = tests::degenerate_plans();
    std::string inner;
    for (std::size_t i = 0; i < kRoofs; ++i) {
        // Every seventh, so that there are some of every shape, and turned ones.
        const tests::NamedPlan& one = plans[(7 * i) % plans.size()];
        const Box box{kCell * static_cast<double>(i % kColumns), kCell * static_cast<double>(i / kColumns), kCell};
        inner += roof_svg(mesh::straight_skeleton(one.plan), box, one.name);
    }
    return framed(kColumns * kCell, kCell * kRoofs / kColumns, inner);
}

// The wall, then the eaves' slope; the bay's own slopes make its sides parallel to the wall's in the end.
std::string bay_windows(const Box& first) {
    const mesh::Plan bay{{{0, 6}, {0, 0}, {4, 0}, {4.5, -1}, {5.5, -1}, {6, 0}, {10, 0}, {10, 6}}, {}};
    mesh::RoofOptions options;
    options.profiles.clear();
    for (const double slope : {45.0, 45.0, 60.0, 30.0, 60.0, 45.0, 45.0, 45.0}) {
        options.profile_of_edge.push_back(static_cast<int>(options.profiles.size()));
        options.profiles.push_back({{{0, 90}, {3, slope}}});
    }
    std::string inner = roof_svg(mesh::straight_skeleton(bay, options), first, "bay window, least volume");
    options.ambiguity = mesh::Ambiguity::MostVolume;
    const Box second{first.x + first.size, first.y, first.size};
    return inner + roof_svg(mesh::straight_skeleton(bay, options), second, "bay window, most volume");
}

std::string blocks(const Box& box, const Loop& region, const mesh::TownRules& rules, bool with_lots,
                   const std::string& name) {
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const glm::dvec2 p : region) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const Frame frame(box, low, high);
    const mesh::TownPlan town = mesh::plan_town(region, rules, base::Seed{5});
    std::string inner = fmt::format("<path d=\"{}\" fill=\"#cbc4b4\"/>\n", frame.path(region));
    const auto add = [&](const Loop& loop, int number) {
        constexpr const char* kFills[] = {"#b9c79a", "#d9c99a", "#c7b08a", "#a9bd9d", "#d6bfa6"};
        inner += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", frame.path(loop),
                             kFills[static_cast<std::size_t>(number) % std::size(kFills)]);
    };
    if (with_lots)
        for (const mesh::Lot& lot : town.lots) add(lot.outline_m, lot.block);
    else
        for (std::size_t i = 0; i < town.blocks.size(); ++i)
            for (const Loop& piece : mesh::behind_streets(town.blocks[i], 0.5 * rules.street_m))
                add(piece, static_cast<int>(i));
    return inner + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", box.x + 4, box.y + box.size - 3, name);
}

std::string figures() {
    constexpr double kCell = 480;
    const Loop square = tests::rectangle(0, 0, 400, 400);
    const Loop bent{{0, 0},     {170, 30},  {200, 150}, {230, 30},  {400, 0}, {400, 400},
                    {260, 400}, {240, 300}, {160, 300}, {140, 400}, {0, 400}};
    mesh::TownRules rules;
    rules.sites = 60;
    rules.merged = 0;
    std::string inner = blocks({0, 0, kCell}, square, rules, false, "figure 5: cells");
    rules.merged = 0.5;
    inner += blocks({kCell, 0, kCell}, square, rules, false, "figure 5: half of them merged");
    rules.uneven = 0.8;
    inner += blocks({2 * kCell, 0, kCell}, square, rules, true, "with head starts, and lots");
    rules.uneven = 0;
    rules.merged = 0.2;
    inner += blocks({0, kCell, kCell}, bent, rules, true, "a region that is not convex");
    return framed(3 * kCell, 2 * kCell, inner + bay_windows({kCell, kCell, kCell}));
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc == 3 ? argv[1] : "";
    if (what != "roofs" && what != "figures") {
        fmt::print(stderr, "usage: plan_sheet roofs|figures FILE.svg\n");
        return 2;
    }
    base::write_file(argv[2], what == "roofs" ? roofs() : figures());
    return 0;
}
