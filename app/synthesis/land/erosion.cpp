// SPDX-License-Identifier: Apache-2.0
// Streams: J. Braun & S. Willett, "A very efficient O(n), implicit and parallel method to solve the stream power
// equation", 2013, with n = 1: h_i' = (h_i + f h_r') / (1 + f), f = K A^m dt / d, receivers first. Changed: the areas
// come from a flooded surface, so that closed hollows drain; what is worn is carried down and partly laid where it runs
// flat. Slides: Musgrave, Kolb & Mace 1989, made symmetric so that nothing is lost. Burrs: Chen & Shi 2011 lower the
// corner of a triangle that stands over both others, which eats every steep slope and only summits; changed: what each
// side's own slope leads to is ground.
#include "synthesis/land/erosion.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "synthesis/land/drainage.hpp"

namespace quadrat::synthesis::land {
namespace {

template <typename Row>
void for_rows(int first, int last, const Row& row) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(first, last, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) row(y);
    });
}

// Cuts from the outlets upward; returns how deep each cell was cut.
std::vector<float> cut(mesh::Field& h, const Drainage& d, const std::vector<float>& area_m2, float cell_m,
                       const StreamErosion& how) {
    std::vector<float> depth(h.samples.size(), 0.0F);
    std::vector<float> factor(h.samples.size());
    const int columns = h.columns;
    const float spring = std::sqrt(std::max(how.spring_m2, 0.0F));
    for_rows(0, h.rows, [&](int y) {
        for (int x = 0; x < columns; ++x) {
            const std::int32_t cell = y * columns + x;
            const bool is_straight = d.receiver[cell] % columns == x || d.receiver[cell] / columns == y;
            // m = 1/2; a hectare drained over a cell of two metres is the middle of the scale.
            const float run_m = cell_m * (is_straight ? 1.0F : 1.41421356F);
            factor[cell] = how.strength * 0.05F * std::max(std::sqrt(area_m2[cell]) - spring, 0.0F) / run_m;
        }
    });
    for (const std::int32_t cell : d.order) {
        const std::int32_t to = d.receiver[cell];
        const float below = h.samples[to];
        if (to == cell || h.samples[cell] <= below) continue;
        const float cut_to = (h.samples[cell] + factor[cell] * below) / (1.0F + factor[cell]);
        depth[cell] = h.samples[cell] - cut_to;
        h.samples[cell] = cut_to;
    }
    return depth;
}

constexpr float kFanSlope = 0.10F;  // rise over run

// A cone of what a stream carries, heaped where it comes out of the steep ground and filling only what lies lower.
// load: heights of one cell. Returns how much of it lies there.
float heap_fan(mesh::Field& h, std::int32_t apex, float load, float cell_m) {
    const float unit_slope = kFanSlope * cell_m;
    const float tall = std::min(std::cbrt(0.95F * unit_slope * unit_slope * load), 0.3F * cell_m);
    const int reach = static_cast<int>(tall / unit_slope);
    if (reach < 1) return 0;
    const int column = apex % h.columns;
    const int row = apex / h.columns;
    const float top = h.samples[apex] + tall;
    float heaped = 0;
    const auto over = [&](const auto& visit) {
        for (int y = std::max(1, row - reach); y <= std::min(h.rows - 2, row + reach); ++y) {
            for (int x = std::max(1, column - reach); x <= std::min(h.columns - 2, column + reach); ++x) {
                const auto squared = static_cast<float>((x - column) * (x - column) + (y - row) * (y - row));
                const float missing = top - unit_slope * std::sqrt(squared) - h.at(x, y);
                // A drop into deep water or off a cliff is no place for a fan.
                if (missing > 0) visit(h.at(x, y), std::min(missing, 1.5F * tall));
            }
        }
    };
    over([&](float&, float missing) { heaped += missing; });
    const float share = heaped > load ? load / heaped : 1.0F;
    over([&](float& height, float missing) { height += share * missing; });
    return share * heaped;
}

// Carries what was worn down the streams and lays some of it, no higher than keeps the stream running.
void lay(mesh::Field& h, const Drainage& d, std::vector<float> load_m, float cell_m, const StreamErosion& how,
         MovedEarth& moved) {
    const float cell_area_m2 = cell_m * cell_m;
    constexpr float kLeastLoad = 20;  // of a stream that makes a fan, heights of a cell in metres
    // As high as they have become: what is laid at the foot of a slope makes room for more before it, and a fan grows.
    std::vector<float> lowest_donor(h.samples.size(), 1.0e9F);
    for (std::size_t i = d.order.size(); i-- > 0;) {
        const std::int32_t cell = d.order[i];
        const std::int32_t to = d.receiver[cell];
        if (to == cell) {
            moved.carried_off_m3 += static_cast<double>(load_m[cell]) * cell_area_m2;
            continue;
        }
        const float fall = h.samples[cell] - h.samples[to];
        const float room = std::max(0.0F, 0.35F * (lowest_donor[cell] - h.samples[cell]));
        const float slow = how.deposit / (1.0F + 40.0F * std::max(fall, 0.0F));
        const float laid = lowest_donor[cell] < 1.0e8F ? std::min(slow * load_m[cell], room) : 0.0F;
        h.samples[cell] += laid;
        lowest_donor[to] = std::min(lowest_donor[to], h.samples[cell]);
        moved.laid_m3 += static_cast<double>(laid) * cell_area_m2;
        float left = load_m[cell] - laid;
        const float flat = 1.2F * kFanSlope * cell_m;
        if (left > kLeastLoad && fall < flat && lowest_donor[cell] - h.samples[cell] >= flat &&
            lowest_donor[cell] < 1.0e8F && h.samples[cell] > how.sea_m) {
            const float heaped = heap_fan(h, cell, how.fans * left, cell_m);
            moved.laid_m3 += static_cast<double>(heaped) * cell_area_m2;
            left -= heaped;
        }
        load_m[to] += left;
    }
}

// Returns what crept over the border, whose samples stand still: the sum of heights that is gone.
double creep(mesh::Field& h, mesh::Field& scratch, float rate) {
    double gone = 0;
    const auto over = [&](int x, int y, int border_x, int border_y) {
        gone += static_cast<double>(rate) * (static_cast<double>(h.at(x, y)) - h.at(border_x, border_y));
    };
    for (int x = 1; x < h.columns - 1; ++x) {
        over(x, 1, x, 0);
        over(x, h.rows - 2, x, h.rows - 1);
    }
    for (int y = 1; y < h.rows - 1; ++y) {
        over(1, y, 0, y);
        over(h.columns - 2, y, h.columns - 1, y);
    }
    for_rows(1, h.rows - 1, [&](int y) {
        for (int x = 1; x < h.columns - 1; ++x) {
            const float around = h.at(x - 1, y) + h.at(x + 1, y) + h.at(x, y - 1) + h.at(x, y + 1);
            scratch.at(x, y) = h.at(x, y) + rate * (around - 4.0F * h.at(x, y));
        }
    });
    for_rows(1, h.rows - 1, [&](int y) {
        for (int x = 1; x < h.columns - 1; ++x) h.at(x, y) = scratch.at(x, y);
    });
    return gone;
}

}  // namespace

MovedEarth erode_by_streams(mesh::Field& height_m, float cell_m, const StreamErosion& how) {
    MovedEarth moved;
    if (height_m.samples.empty()) return moved;
    const float cell_area_m2 = cell_m * cell_m;
    mesh::Field scratch(height_m.columns, height_m.rows);
    for (int step = 0; step < how.steps; ++step) {
        const Drainage d = drain(height_m, how.sea_m, static_cast<std::uint32_t>(step));
        const std::vector<float> area_m2 = drained_area_m2(d, cell_m);
        std::vector<float> worn = cut(height_m, d, area_m2, cell_m, how);
        for (const float w : worn) moved.worn_m3 += static_cast<double>(w) * cell_area_m2;
        lay(height_m, d, std::move(worn), cell_m, how, moved);
        if (how.hillslope > 0) moved.crept_off_m3 += cell_area_m2 * creep(height_m, scratch, how.hillslope);
    }
    return moved;
}

void carve_valleys(mesh::Field& height_m, float cell_m, const StreamErosion& how) {
    for (const int stride : {4, 2}) {
        mesh::Field coarse((height_m.columns - 1) / stride + 1, (height_m.rows - 1) / stride + 1);
        for (int y = 0; y < coarse.rows; ++y)
            for (int x = 0; x < coarse.columns; ++x) coarse.at(x, y) = height_m.at(x * stride, y * stride);
        const mesh::Field before = coarse;
        if (stride == 4) {
            const Drainage d = drain(coarse, how.sea_m);
            for (std::size_t i = 0; i < coarse.samples.size(); ++i)
                coarse.samples[i] += 0.8F * (d.spill_m.samples[i] - coarse.samples[i]);
        }
        StreamErosion at = how;
        at.steps = stride == 4 ? how.steps : (how.steps + 3) / 4;
        erode_by_streams(coarse, cell_m * static_cast<float>(stride), at);
        for (std::size_t i = 0; i < coarse.samples.size(); ++i) coarse.samples[i] -= before.samples[i];
        smooth(coarse, 1);
        const float per_sample = 1.0F / static_cast<float>(stride);
        for_rows(0, height_m.rows, [&](int y) {
            for (int x = 0; x < height_m.columns; ++x)
                height_m.at(x, y) +=
                    mesh::sample(coarse, static_cast<float>(x) * per_sample, static_cast<float>(y) * per_sample);
        });
    }
}

float slide_to_repose(mesh::Field& height_m, float cell_m, float repose_slope, int passes) {
    constexpr std::array<std::array<int, 2>, 8> kNeighbours{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    const float straight_m = repose_slope * cell_m;
    const float across_m = straight_m * 1.41421356F;
    // Slides stop a little under the angle, so that they come to an end.
    constexpr float kUnder = 0.98F;
    mesh::Field next = height_m;
    const int last_column = height_m.columns - 1;
    const float most_straight = kUnder * straight_m;
    const float most_across = kUnder * across_m;
    const auto excess = [](float difference, float most) {
        return difference - std::min(std::max(difference, -most), most);
    };
    for (int pass = 0; pass < passes; ++pass) {
        for_rows(0, height_m.rows, [&](int y) {
            // Beyond the border a row stands for itself, and nothing slides.
            const float* on = &height_m.at(0, y);
            const float* above = y > 0 ? on - height_m.columns : on;
            const float* below = y + 1 < height_m.rows ? on + height_m.columns : on;
            float* out = &next.at(0, y);
            const float up = y > 0 ? 1.0F : 0.0F;
            const float down = y + 1 < height_m.rows ? 1.0F : 0.0F;
            const auto moved = [&](int x, int w, int e, float west, float east) {
                const float h = on[x];
                const float level = west * excess(on[w] - h, most_straight) + east * excess(on[e] - h, most_straight);
                const float over = excess(above[x] - h, most_straight) + west * excess(above[w] - h, most_across) +
                                   east * excess(above[e] - h, most_across);
                const float under = excess(below[x] - h, most_straight) + west * excess(below[w] - h, most_across) +
                                    east * excess(below[e] - h, most_across);
                return h + 0.11F * (level + up * over + down * under);
            };
            out[0] = moved(0, 0, 1, 0, 1);
            for (int x = 1; x < last_column; ++x) out[x] = moved(x, x - 1, x + 1, 1, 1);
            out[last_column] = moved(last_column, last_column - 1, last_column, 1, 0);
        });
        std::swap(height_m.samples, next.samples);
    }
    float steepest = 0;
    for (int y = 0; y < height_m.rows; ++y) {
        for (int x = 0; x < height_m.columns; ++x) {
            for (const std::size_t k : {0U, 2U, 4U, 5U}) {
                const int nx = x + kNeighbours[k][0];
                const int ny = y + kNeighbours[k][1];
                if (!height_m.is_inside(nx, ny)) continue;
                const float run_m = cell_m * (k < 4 ? 1.0F : 1.41421356F);
                steepest = std::max(steepest, std::abs(height_m.at(nx, ny) - height_m.at(x, y)) / run_m);
            }
        }
    }
    return steepest;
}

void remove_burrs(mesh::Field& h, float threshold_m, int sweeps) {
    constexpr std::array<std::array<int, 2>, 8> kWays{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    constexpr std::size_t kFewest = 5;  // ways, at the border
    constexpr std::size_t kHeld = 3;    // so many must hold a sample for it to be ground: a burr may be two long
    mesh::Field next = h;
    const auto evened = [&](int x, int y) {
        const float here = h.at(x, y);
        std::array<float, 8> over{};   // what each side's slope leads one to expect here, the higher
        std::array<float, 8> under{};  // and the lower
        std::size_t ways = 0;
        float sum = 0;
        for (const auto& [dx, dy] : kWays) {
            if (!h.is_inside(x + dx, y + dy)) continue;
            const float near = h.at(x + dx, y + dy);
            const float led = h.is_inside(x + 2 * dx, y + 2 * dy) ? 2 * near - h.at(x + 2 * dx, y + 2 * dy) : near;
            over[ways] = std::max(near, led);
            under[ways] = std::min(near, led);
            sum += near;
            ++ways;
        }
        if (ways < kFewest) return here;
        const auto last = static_cast<std::ptrdiff_t>(ways);
        std::nth_element(over.begin(), over.begin() + (kHeld - 1), over.begin() + last, std::greater<>());
        std::nth_element(under.begin(), under.begin() + (kHeld - 1), under.begin() + last);
        const bool is_burr = here > over[kHeld - 1] + threshold_m || here < under[kHeld - 1] - threshold_m;
        return is_burr ? sum / static_cast<float>(ways) : here;
    };
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for_rows(0, h.rows, [&](int y) {
            for (int x = 0; x < h.columns; ++x) next.at(x, y) = evened(x, y);
        });
        std::swap(h.samples, next.samples);
    }
}

void smooth(mesh::Field& h, int reach) {
    if (reach <= 0 || h.samples.empty()) return;
    const auto along = [reach](const float* in, float* out, int n, int stride) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < std::min(reach, n); ++i, ++count) sum += in[i * stride];
        for (int i = 0; i < n; ++i) {
            if (i + reach < n) {
                sum += in[(i + reach) * stride];
                ++count;
            }
            if (i - reach - 1 >= 0) {
                sum -= in[(i - reach - 1) * stride];
                --count;
            }
            out[i * stride] = static_cast<float>(sum / count);
        }
    };
    mesh::Field half(h.columns, h.rows);
    for_rows(0, h.rows, [&](int y) { along(&h.at(0, y), &half.at(0, y), h.columns, 1); });
    for_rows(0, h.columns, [&](int x) { along(&half.at(x, 0), &h.at(x, 0), h.rows, h.columns); });
}

}  // namespace quadrat::synthesis::land
