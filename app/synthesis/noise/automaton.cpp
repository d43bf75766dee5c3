// SPDX-License-Identifier: Apache-2.0
// Gardner, "The fantastic combinations of John Conway's new solitaire game Life" (1970). The forest is that of Drossel
// & Schwabl, "Self-organized critical forest-fire model" (Physical Review Letters 1992), whose cells are bare, bear a
// tree or burn. Our trees have an age: only old ones seed, and the old burn better than the young, so that fires end
// where one was before and patches of several ages remain.
#include "synthesis/noise/automaton.hpp"

#include <algorithm>

namespace quadrat::synthesis::noise {
namespace {

constexpr std::uint8_t kBurning = 255;
constexpr std::uint8_t kOld = 60;     // years
constexpr std::uint8_t kSeeding = 7;  // years
constexpr int kYears = 150;           // until the beginning is forgotten
constexpr int kBurns = 11;            // cells that a fire takes until rain puts it out
constexpr float kStrikes = 0.24F;     // a year at most

using Years = mesh::Grid<std::uint8_t>;

bool is_alight(std::uint8_t years) { return years == kBurning; }
bool is_seeding(std::uint8_t years) { return years >= kSeeding; }

// A year without fire: trees grow, and what is bare beside old ones is sown.
Years grown(const Years& years, base::Seed year) {
    return next_generation(years, [year](const Years& c, int column, int row) -> std::uint8_t {
        const std::uint8_t own = c.at(column, row);
        if (own > 0) return std::min<std::uint8_t>(own + 1, kOld);
        const int sown = neighbours(c, column, row, is_seeding);
        if (sown == 0) return 0;
        return base::unit_of(base::hash_of(year, column, row)) < 0.12F * static_cast<float>(sown) ? 1 : 0;
    });
}

// A fire goes on from the cells that are alight; what has burnt is bare.
Years burnt(const Years& years, base::Seed moment) {
    return next_generation(years, [moment](const Years& c, int column, int row) -> std::uint8_t {
        const std::uint8_t own = c.at(column, row);
        if (own == 0 || own == kBurning) return 0;
        const int alight = neighbours(c, column, row, is_alight);
        if (alight == 0) return own;
        const float burns = 0.04F + 0.5F * static_cast<float>(own) / kOld;
        return base::unit_of(base::hash_of(moment, column, row)) < burns * static_cast<float>(std::min(alight, 3))
                   ? kBurning
                   : own;
    });
}

void strike(Years& years, base::Seed seed) {
    base::RandomStream random{seed};
    const auto side = static_cast<std::uint32_t>(years.columns);
    const auto column = static_cast<int>(random.below(side));
    const auto row = static_cast<int>(random.below(side));
    if (years.at(column, row) == 0) return;
    years.at(column, row) = kBurning;
    for (std::uint64_t moment = 0; moment < kBurns; ++moment) years = burnt(years, seed.child(moment));
    for (std::uint8_t& cell : years.samples)
        if (cell == kBurning) cell = 0;
}

}  // namespace

mesh::Grid<std::uint8_t> lived(const mesh::Grid<std::uint8_t>& cells) {
    return next_generation(cells, [](const mesh::Grid<std::uint8_t>& c, int column, int row) -> std::uint8_t {
        const int alive = neighbours(c, column, row, [](std::uint8_t state) { return state != 0; });
        return alive == 3 || (alive == 2 && c.at(column, row) != 0) ? 1 : 0;
    });
}

mesh::Field forest_ages(int side, float fires, base::Seed seed) {
    Years years(side, side, kOld);
    for (std::uint64_t year = 0; year < kYears && fires > 0; ++year) {
        years = grown(years, seed.child("year").child(year));
        const base::Seed lightning = seed.child("lightning").child(year);
        if (base::unit_of(lightning.value) < kStrikes * fires) strike(years, lightning);
    }
    mesh::Field ages(side, side);
    for (std::size_t i = 0; i < ages.samples.size(); ++i) ages.samples[i] = static_cast<float>(years.samples[i]) / kOld;
    return ages;
}

}  // namespace quadrat::synthesis::noise
