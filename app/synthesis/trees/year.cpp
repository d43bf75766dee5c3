// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/year.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "synthesis/trees/grammar.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kSpring = 3;          // steps of the grammar; then five a season
constexpr int kHighSummer = 10;     // the last without a turned leaf
constexpr int kAllLeavesGrown = 6;  // the first without a bud
constexpr float kStepsAYear = 15;
constexpr float kStillHanging = 0.1F;  // of fruits, on bare trees

int step_of(float season) {
    return kSpring + static_cast<int>(std::lround(kStepsAYear * std::clamp(season, 0.0F, 1.0F)));
}

Organ organ_of(char letter) {
    switch (letter) {
        case 'L':
        case 'E':
            return Organ::Leaf;
        case 'Y':
            return Organ::YoungLeaf;
        case 'T':
            return Organ::TurnedLeaf;
        case 'K':
            return Organ::Flower;
        default:
            return Organ::None;
    }
}

// Flowers and fruits that a plant has by its genes, whatever the season.
Organ in_its_time(Organ own, Organ year, bool is_spring, float chance) {
    if (own == Organ::Flower) return is_spring || year == Organ::Leaf ? own : year;
    if (is_spring) return year;
    return year == Organ::None && chance >= kStillHanging ? year : own;
}

}  // namespace

std::vector<Organ> organs_in(const Year& year) {
    const std::array<Redefinition, 2> own{{{"sheds", year.sheds}, {"flowers", year.flowers}}};
    Grammar grammar = library_grammar("year", own);
    grammar.axiom = {};
    for (int i = 0; i < kBuds; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) / kBuds;
        // The golden section's multiples are evenly spread and go with nothing else.
        const float v = glm::fract(0.61803399F * static_cast<float>(i));
        grammar.axiom.add('A', {u, v});
    }
    DeriveOptions options;
    options.steps = step_of(year.season);
    const Derivation derived = derive(grammar, options);
    std::vector<Organ> organs;
    for (const Word::Symbol& symbol : derived.word.symbols)
        organs.push_back(organ_of(static_cast<char>(symbol.letter)));
    return organs;
}

float pass_year(TreeSkeleton& skeleton, const Year& year, base::Seed seed) {
    const int step = step_of(year.season);
    if ((step >= kAllLeavesGrown && step <= kHighSummer) || skeleton.sites.empty()) return 0;
    const bool is_spring = step < kAllLeavesGrown;
    const std::vector<Organ> organs = organs_in(year);
    float gone = 0;
    float all = 0;
    for (std::size_t i = 0; i < skeleton.sites.size(); ++i) {
        Site& site = skeleton.sites[i];
        const std::uint64_t chance = base::hash_of(seed, static_cast<std::int64_t>(i), 0);
        const Organ now = organs[chance % organs.size()];
        const bool is_leaf = site.organ == Organ::Leaf;
        site.organ = is_leaf ? now : in_its_time(site.organ, now, is_spring, base::unit_of(chance));
        all += site.weight;
        if (site.organ == Organ::None) gone += site.weight;
    }
    return all > 0 ? gone / all : 0;
}

Meadow meadow_in(float season) {
    constexpr std::array<Meadow, 4> kSeasons{
        {{-0.2F, 0.75F, 1.3F, 0.1F}, {}, {0.3F, 0.95F, 0.35F, 0.6F}, {0.6F, 0.6F, 0, 0.95F}}};
    const float at = 3 * std::clamp(season, 0.0F, 1.0F);
    const auto i = std::min(static_cast<std::size_t>(at), kSeasons.size() - 2);
    // A parameter of a third is rounded: it is midsummer all the same.
    const float t = std::abs(at - 1) < 0.01F ? (i == 0 ? 1.0F : 0.0F) : at - static_cast<float>(i);
    const Meadow& a = kSeasons[i];
    const Meadow& b = kSeasons[i + 1];
    return {glm::mix(a.dryness, b.dryness, t), glm::mix(a.height, b.height, t), glm::mix(a.flowers, b.flowers, t),
            glm::mix(a.withered, b.withered, t)};
}

}  // namespace quadrat::synthesis::trees
