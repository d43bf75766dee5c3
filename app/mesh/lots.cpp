// SPDX-License-Identifier: Apache-2.0
#include "mesh/lots.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "mesh/clip.hpp"
#include "mesh/straight_skeleton.hpp"
#include "mesh/voronoi.hpp"

namespace quadrat::mesh {
namespace {

using Loop = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// The rectangle of least area round a shape has a side along one of its edges.
struct Axis {
    glm::dvec2 along{1, 0};
    double from = 0, to = 0;  // of the shape, along it
};

Axis longest_axis(const Loop& loop) {
    Axis best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 edge = loop[(i + 1) % loop.size()] - loop[i];
        if (!(glm::length(edge) > 0)) continue;
        const glm::dvec2 u = glm::normalize(edge);
        glm::dvec2 low(1.0e300);
        glm::dvec2 high(-1.0e300);
        for (const glm::dvec2& p : loop) {
            const glm::dvec2 at(glm::dot(p, u), cross(u, p));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const glm::dvec2 size = high - low;
        if (size.x * size.y >= least) continue;
        least = size.x * size.y;
        best = size.x >= size.y ? Axis{u, low.x, high.x} : Axis{{-u.y, u.x}, low.y, high.y};
    }
    return best;
}

// Both sides of the line dot(p, along) = at. A shape that is not convex may come apart into more than two.
class Splitter {
  public:
    Splitter(const Lot& lot, glm::dvec2 along, double at) : across_(-along.y, along.x) {
        const std::size_t count = lot.outline_m.size();
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec2 a = lot.outline_m[i];
            const glm::dvec2 b = lot.outline_m[(i + 1) % count];
            const double da = glm::dot(a, along) - at;
            const double db = glm::dot(b, along) - at;
            add(a, lot.is_street[i]);
            if ((da < 0) == (db < 0)) continue;
            cuts_.push_back(points_.size());
            add(glm::mix(a, b, da / (da - db)), lot.is_street[i]);
        }
        next_.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) next_[i] = (i + 1) % points_.size();
    }

    std::vector<Lot> pieces(int block) {
        std::sort(cuts_.begin(), cuts_.end(), [this](std::size_t i, std::size_t j) {
            return glm::dot(points_[i], across_) < glm::dot(points_[j], across_);
        });
        for (std::size_t k = 0; k + 1 < cuts_.size(); k += 2) link(cuts_[k], cuts_[k + 1]);
        std::vector<Lot> pieces;
        std::vector<bool> is_taken(points_.size(), false);
        for (std::size_t first = 0; first < points_.size(); ++first) {
            Lot lot;
            lot.block = block;
            for (std::size_t i = first; !is_taken[i]; i = next_[i]) {
                is_taken[i] = true;
                lot.outline_m.push_back(points_[i]);
                lot.is_street.push_back(is_street_[i]);
            }
            if (lot.outline_m.size() > 2) pieces.push_back(std::move(lot));
        }
        return pieces;
    }

  private:
    void add(glm::dvec2 p, bool is_street) {
        points_.push_back(p);
        is_street_.push_back(is_street);
    }
    // A chord, walked once each way: each end gets a twin that goes on along the outline.
    void link(std::size_t a, std::size_t b) {
        const std::size_t a2 = twin(a);
        const std::size_t b2 = twin(b);
        next_[a] = b2;
        next_[b] = a2;
        is_street_[a] = false;
        is_street_[b] = false;
    }
    std::size_t twin(std::size_t of) {
        add(points_[of], is_street_[of]);
        next_.push_back(next_[of]);
        return points_.size() - 1;
    }

    glm::dvec2 across_;
    std::vector<glm::dvec2> points_;
    std::vector<bool> is_street_;
    std::vector<std::size_t> cuts_, next_;
};

bool is_fit(const std::vector<Lot>& pieces, const LotRules& rules) {
    return pieces.size() > 1 && std::all_of(pieces.begin(), pieces.end(), [&rules](const Lot& lot) {
               return lot.area_m2() >= rules.smallest_m2 && lot.frontage_m() >= rules.least_frontage_m;
           });
}

void split(const Lot& lot, const LotRules& rules, base::Seed seed, std::vector<Lot>& done) {
    if (lot.area_m2() <= rules.largest_m2) {
        done.push_back(lot);
        return;
    }
    base::RandomStream chance(seed);
    const Axis axis = longest_axis(lot.outline_m);
    for (const bool is_crosswise : {false, true}) {
        const glm::dvec2 along = is_crosswise ? glm::dvec2(-axis.along.y, axis.along.x) : axis.along;
        double low = 1.0e300;
        double high = -1.0e300;
        for (const glm::dvec2& p : lot.outline_m) {
            low = std::min(low, glm::dot(p, along));
            high = std::max(high, glm::dot(p, along));
        }
        constexpr int kTries = 4;
        for (int k = 0; k < kTries; ++k) {
            const double share = 0.5 + rules.irregularity * (2 * chance.unit() - 1);
            const std::vector<Lot> pieces = Splitter(lot, along, low + share * (high - low)).pieces(lot.block);
            if (!is_fit(pieces, rules)) continue;
            for (std::size_t i = 0; i < pieces.size(); ++i) split(pieces[i], rules, seed.child(i), done);
            return;
        }
    }
    done.push_back(lot);
}

std::vector<std::vector<int>> groups_by_chance(const std::vector<VoronoiCell>& cells, double share, base::Seed seed) {
    std::vector<int> group(cells.size(), -1);
    std::vector<std::vector<int>> groups;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].arcs.empty() || group[i] >= 0) continue;
        group[i] = static_cast<int>(groups.size());
        groups.push_back({static_cast<int>(i)});
        base::RandomStream chance{seed.child(i)};
        if (chance.unit() >= share) continue;
        std::vector<int> free;
        for (const VoronoiArc& arc : cells[i].arcs)
            if (arc.neighbour >= 0 && group[static_cast<std::size_t>(arc.neighbour)] < 0) free.push_back(arc.neighbour);
        if (free.empty()) continue;
        const int other = free[chance.below(static_cast<std::uint32_t>(free.size()))];
        group[static_cast<std::size_t>(other)] = group[i];
        groups.back().push_back(other);
    }
    return groups;
}

std::vector<VoronoiSite> sites_by_chance(const Loop& region, const TownRules& rules, base::Seed seed) {
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const glm::dvec2& p : region) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double spacing = std::sqrt(std::abs(signed_area(region)) / rules.sites);
    std::vector<VoronoiSite> sites;
    base::RandomStream chance{seed};
    // Each of the best of some candidates (Mitchell 1991), so that no two crowd.
    constexpr int kCandidates = 6;
    for (int tries = 0; static_cast<int>(sites.size()) < rules.sites && tries < 100 * rules.sites; ++tries) {
        glm::dvec2 best(0);
        double farthest = -1;
        for (int k = 0; k < kCandidates; ++k) {
            const glm::dvec2 p = low + (high - low) * glm::dvec2(chance.unit(), chance.unit());
            if (!is_inside({region}, p)) continue;
            double nearest = 1.0e300;
            for (const VoronoiSite& other : sites) nearest = std::min(nearest, glm::distance(p, other.at_m));
            if (nearest > farthest) {
                farthest = nearest;
                best = p;
            }
        }
        if (farthest > 0) sites.push_back({best, 0.5 * rules.uneven * spacing * chance.unit()});
    }
    return sites;
}

}  // namespace

double Lot::area_m2() const { return signed_area(outline_m); }

double Lot::frontage_m() const {
    double length = 0;
    for (std::size_t i = 0; i < outline_m.size(); ++i)
        if (is_street[i]) length += glm::distance(outline_m[i], outline_m[(i + 1) % outline_m.size()]);
    return length;
}

std::vector<Lot> lots_of_block(const Loop& block, int number, const LotRules& rules, base::Seed seed) {
    Lot whole{block, std::vector<bool>(block.size(), true), number};
    if (block.size() < 3) return {};
    if (whole.area_m2() < 0) std::reverse(whole.outline_m.begin(), whole.outline_m.end());
    std::vector<Lot> lots;
    split(whole, rules, seed, lots);
    return lots;
}

std::vector<Loop> behind_streets(const std::vector<Loop>& block, double half_street_m) {
    if (!(half_street_m > 0)) return block;
    Plan plan{block.front(), {block.begin() + 1, block.end()}};
    RoofOptions options;
    options.height_m = half_street_m;  // at 45 degrees a metre of height is one inward
    const Roof roof = straight_skeleton(plan, options);
    std::vector<Loop> pieces;
    for (const auto& top : roof.tops) {
        Loop loop;
        for (const std::uint32_t v : top) loop.emplace_back(roof.vertices[v]);
        pieces.push_back(std::move(loop));
    }
    return pieces;
}

namespace {

bool is_convex(const Loop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (cross(loop[(i + 1) % loop.size()] - loop[i], loop[(i + 2) % loop.size()] - loop[i]) < 0) return false;
    return true;
}

// Well around it, so that no cell's edge runs along one of the region's.
Loop box_around(const Loop& region) {
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const glm::dvec2& p : region) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec2 more = 0.21 * (high - low);
    low -= more;
    high += more;
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

// Nothing where the diagram cannot be clipped for certain; then others sites may.
std::optional<std::vector<std::vector<Loop>>> blocks_of(const Loop& region, const TownRules& rules, base::Seed seed,
                                                        base::Seed merging) {
    const bool is_plain = is_convex(region);
    const std::vector<VoronoiSite> sites = sites_by_chance(region, rules, seed);
    const std::vector<VoronoiCell> cells = voronoi_cells(sites, is_plain ? region : box_around(region));
    const double tolerance_m = 0.02 * std::sqrt(signed_area(region) / std::max(rules.sites, 1));
    std::vector<std::vector<Loop>> blocks;
    for (const std::vector<int>& group : groups_by_chance(cells, rules.merged, merging)) {
        std::vector<Loop> block = merged_outline(sites, cells, group, tolerance_m);
        if (block.empty()) continue;
        if (!is_plain) {
            const std::optional<std::vector<Loop>> within = common_area(block, {region});
            if (!within) return std::nullopt;
            for (std::vector<Loop>& shape : sorted_into_shapes(*within)) blocks.push_back(std::move(shape));
            continue;
        }
        std::sort(block.begin(), block.end(),
                  [](const Loop& a, const Loop& b) { return signed_area(a) > signed_area(b); });
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}  // namespace

TownPlan plan_town(const Loop& region, const TownRules& rules, base::Seed seed) {
    Loop turned = region;
    if (signed_area(turned) < 0) std::reverse(turned.begin(), turned.end());
    constexpr std::uint64_t kTries = 8;
    std::optional<std::vector<std::vector<Loop>>> blocks =
        blocks_of(turned, rules, seed.child("sites"), seed.child("merged"));
    for (std::uint64_t again = 1; !blocks && again < kTries; ++again)
        blocks = blocks_of(turned, rules, seed.child("sites").child(again), seed.child("merged"));
    if (!blocks) throw PlanError("the region's edges lie so near each other that cells cannot be told apart");
    TownPlan town;
    for (std::vector<Loop>& block : *blocks) {
        const auto number = static_cast<int>(town.blocks.size());
        for (const Loop& land : behind_streets(block, 0.5 * rules.street_m)) {
            if (signed_area(land) <= 0) continue;
            const std::vector<Lot> lots =
                lots_of_block(land, number, rules.lots, seed.child("lots").child(town.lots.size()));
            town.lots.insert(town.lots.end(), lots.begin(), lots.end());
        }
        town.blocks.push_back(std::move(block));
    }
    return town;
}

}  // namespace quadrat::mesh
