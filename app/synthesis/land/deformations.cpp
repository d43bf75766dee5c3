// SPDX-License-Identifier: Apache-2.0
// After Stachniak & Stuerzlinger, "An algorithm for automated fractal terrain deformation", 2005: a random terrain is
// bent to a mask by a set of deformations that a search finds. Where they walk at random and keep what helps, each of
// our tries has the amount that least squares give it, and the best of several is kept.
#include "synthesis/land/deformations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "synthesis/land/erosion.hpp"
#include "synthesis/land/masks.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr int kTries = 48;       // weighed for each that is made
constexpr int kCoarsest = 129;   // samples a side that the search looks at
constexpr double kLevelled = 2;  // a levelled place must win twice what a raised one would: it costs detail

// 1 in the middle, 0 with no slope at its reach.
float bell(float squared) {
    const float t = std::max(0.0F, 1.0F - squared);
    return t * t;
}

template <typename Each>
void each_within(const mesh::Field& field, const Deformation& d, const Each& each) {
    const int left = std::max(0, static_cast<int>(std::ceil(d.column - d.reach)));
    const int right = std::min(field.columns - 1, static_cast<int>(std::floor(d.column + d.reach)));
    const int top = std::max(0, static_cast<int>(std::ceil(d.row - d.reach)));
    const int bottom = std::min(field.rows - 1, static_cast<int>(std::floor(d.row + d.reach)));
    const float scale = 1.0F / (d.reach * d.reach);
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const float dx = static_cast<float>(x) - d.column;
            const float dy = static_cast<float>(y) - d.row;
            const float share = bell((dx * dx + dy * dy) * scale);
            if (share > 0) each(field.index(x, y), share);
        }
    }
}

void make(mesh::Field& height, const Deformation& d) {
    each_within(height, d, [&](std::size_t i, float share) {
        float& h = height.samples[i];
        h += d.kind == Deformation::Kind::Raise ? share * d.amount : share * (d.amount - h);
    });
}

// The land as the search sees it: means, at a tenth of the samples, and how far they are from what is wished.
struct Coarse {
    mesh::Field height;
    mesh::Field left;          // wished less height
    std::vector<double> sums;  // of squares left, from the first sample on

    void sum_up() {
        sums.resize(left.samples.size());
        double sum = 0;
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] = sum += static_cast<double>(left.samples[i]) * static_cast<double>(left.samples[i]);
    }
    double cost() const { return std::sqrt(sums.back() / static_cast<double>(sums.size())); }
};

// Gives a try the amount that least squares ask for; returns how much of the sum of squares it takes off.
double weigh(const Coarse& coarse, Deformation& d) {
    double weights = 0;
    double wish = 0;
    double before = 0;
    const bool is_raise = d.kind == Deformation::Kind::Raise;
    each_within(coarse.left, d, [&](std::size_t i, float share) {
        const double w = static_cast<double>(share);
        const double e = static_cast<double>(coarse.left.samples[i]);
        weights += w * w;
        wish += w * (is_raise ? e : e + w * static_cast<double>(coarse.height.samples[i]));
        before += e * e;
    });
    if (!(weights > 1.0e-9)) return 0;
    d.amount = static_cast<float>(wish / weights);
    double after = 0;
    each_within(coarse.left, d, [&](std::size_t i, float share) {
        const float moved = is_raise ? share * d.amount : share * (d.amount - coarse.height.samples[i]);
        const double e = static_cast<double>(coarse.left.samples[i] - moved);
        after += e * e;
    });
    return before - after;
}

// Where the land is far from the mask more are tried.
Deformation tried(const Coarse& coarse, float least_reach, base::RandomStream& random) {
    const double at = random.unit() * coarse.sums.back();
    const auto found = std::lower_bound(coarse.sums.begin(), coarse.sums.end(), at);
    const auto i = static_cast<int>(
        std::min<std::ptrdiff_t>(found - coarse.sums.begin(), static_cast<std::ptrdiff_t>(coarse.sums.size()) - 1));
    const float most = 0.75F * static_cast<float>(std::max(coarse.left.columns, coarse.left.rows));
    Deformation d;
    d.kind = random.unit() < 0.75 ? Deformation::Kind::Raise : Deformation::Kind::Level;
    d.column = static_cast<float>(i % coarse.left.columns) + random.between(-0.5F, 0.5F);
    d.row = static_cast<float>(i / coarse.left.columns) + random.between(-0.5F, 0.5F);
    d.reach = least_reach * std::pow(std::max(most / least_reach, 1.0F), random.unit_f());
    return d;
}

Coarse seen(const mesh::Field& height, const mesh::Field& mask, int reach) {
    const int columns = std::min(height.columns, kCoarsest);
    const int rows = std::min(height.rows, kCoarsest);
    mesh::Field means = height;
    smooth(means, reach);
    mesh::Field wished = resampled(mask, height.columns, height.rows);
    smooth(wished, reach);
    Coarse coarse{resampled(means, columns, rows), resampled(wished, columns, rows), {}};
    for (std::size_t i = 0; i < coarse.left.samples.size(); ++i) coarse.left.samples[i] -= coarse.height.samples[i];
    coarse.sum_up();
    return coarse;
}

void make(Coarse& coarse, const Deformation& d) {
    each_within(coarse.left, d, [&](std::size_t i, float share) {
        const float moved =
            d.kind == Deformation::Kind::Raise ? share * d.amount : share * (d.amount - coarse.height.samples[i]);
        coarse.height.samples[i] += moved;
        coarse.left.samples[i] -= moved;
    });
    coarse.sum_up();
}

std::optional<Deformation> best_of_tries(const Coarse& coarse, float least_reach, base::RandomStream& random,
                                         int& tried_so_far) {
    std::optional<Deformation> best;
    double most = 1.0e-9 * coarse.sums.back();
    for (int i = 0; i < kTries; ++i) {
        Deformation d = tried(coarse, least_reach, random);
        const double gain = weigh(coarse, d) / (d.kind == Deformation::Kind::Level ? kLevelled : 1.0);
        if (gain <= most) continue;
        most = gain;
        best = d;
    }
    tried_so_far += kTries;
    return best;
}

Deformation scaled(Deformation d, float scale) {
    d.column *= scale;
    d.row *= scale;
    d.reach *= scale;
    return d;
}

double mean_distance(const mesh::Field& a, const mesh::Field& b) {
    const double sum = std::transform_reduce(a.samples.begin(), a.samples.end(), b.samples.begin(), 0.0, std::plus<>{},
                                             [](float x, float y) { return static_cast<double>(std::abs(x - y)); });
    return sum / static_cast<double>(a.samples.size());
}

}  // namespace

void deform(mesh::Field& height, const std::vector<Deformation>& deformations) {
    for (const Deformation& d : deformations) make(height, d);
}

Bent bend_to_mask(mesh::Field& height, const mesh::Field& mask, const DeformationSearch& search, base::Seed seed,
                  const std::function<void(int)>& at) {
    Bent bent;
    if (height.samples.empty()) return bent;
    const mesh::Field before = height;
    Coarse coarse = seen(height, mask, search.reach);
    bent.cost_before = coarse.cost();
    const float scale =
        static_cast<float>(height.columns - 1) / static_cast<float>(std::max(coarse.left.columns - 1, 1));
    // A bell felt less far than the means reach would be lost in them.
    const float least_reach = std::max(2.0F, 2.0F * static_cast<float>(search.reach) / scale);
    base::RandomStream random{seed};
    std::size_t made = 0;  // of the deformations, on the land itself
    for (;;) {
        const bool is_enough = coarse.cost() <= static_cast<double>(search.wished_cost) ||
                               static_cast<int>(bent.deformations.size()) >= search.most;
        const auto next = is_enough ? std::nullopt : best_of_tries(coarse, least_reach, random, bent.tried);
        if (next) {
            make(coarse, *next);
            bent.deformations.push_back(scaled(*next, scale));
            if (at) at(static_cast<int>(bent.deformations.size()));
            continue;
        }
        if (made == bent.deformations.size()) break;
        // The means of a bent land are not quite its bent means: look again, and go on from there.
        for (; made < bent.deformations.size(); ++made) make(height, bent.deformations[made]);
        coarse = seen(height, mask, search.reach);
    }
    bent.moved = mean_distance(before, height);
    bent.cost = coarse.cost();
    return bent;
}

}  // namespace quadrat::synthesis::land
