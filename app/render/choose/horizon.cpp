// SPDX-License-Identifier: Apache-2.0
// A floating horizon (Wright 1973), by azimuth instead of by column of the picture, of bounds instead of lines: an
// interval of azimuth is raised only by ground that fills all of it, by no more than the least that this can hide.
#include "render/choose/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace quadrat::render::choose {
namespace {

constexpr float kNearest_m = 4;  // nearer ground is neither hidden nor hides: it lies about the eye, or before the view
constexpr float kLowest = -1e9F;
constexpr float kMargin_bins = 1e-3F;  // for rounding
constexpr float kRingGrowth = 1.4F;
constexpr int kQuarter = Horizon::kBins / 4;

// Once around is 0 to kBins, by the diamond angle: as good an order as the angle's own, without its cost.
float bin_of(glm::vec2 way) {
    const float share = way.y / (std::abs(way.x) + std::abs(way.y));
    const float quarters = way.x < 0 ? 2 - share : way.y < 0 ? 4 + share : share;
    return quarters * kQuarter;
}

int around_once(int bin) { return bin & (Horizon::kBins - 1); }

// A line to the border between two bins: how long it is for a metre east, and for a metre south. Along an axis one of
// them is so large that it never comes into question.
using Lengths = std::array<glm::vec2, Horizon::kBins>;
Lengths lengths_of_borders() {
    Lengths lengths;
    for (int bin = 0; bin < Horizon::kBins; ++bin) {
        const float quarters = static_cast<float>(bin) / kQuarter;
        const float x = std::abs(quarters - 2) - 1;
        const float y = quarters <= 2 ? 1 - std::abs(quarters - 1) : std::abs(quarters - 3) - 1;
        const float length = std::hypot(x, y);
        const auto inverse = [&](float along) {
            return length / std::copysign(std::max(std::abs(along), 1e-6F), along);
        };
        lengths[static_cast<std::size_t>(bin)] = {inverse(x), inverse(y)};
    }
    return lengths;
}

const glm::vec2& length_a_metre(int bin) {
    static const Lengths lengths = lengths_of_borders();
    return lengths[static_cast<std::size_t>(around_once(bin))];
}

}  // namespace

// A square on the map as the eye sees it.
struct Horizon::Plan {
    glm::vec2 low_m, high_m;  // from the eye

    float nearest_m() const { return glm::length(glm::clamp(glm::vec2{0}, low_m, high_m)); }
    float farthest_m() const { return glm::length(glm::max(glm::abs(low_m), glm::abs(high_m))); }

    // The corners between which it is seen, the way that bins are counted. The eye is outside.
    glm::vec2 first_corner() const {
        return {low_m.y > 0    ? high_m.x
                : high_m.y < 0 ? low_m.x
                               : nearer(low_m.x, high_m.x),
                low_m.x > 0    ? low_m.y
                : high_m.x < 0 ? high_m.y
                               : nearer(low_m.y, high_m.y)};
    }
    glm::vec2 last_corner() const {
        return {low_m.y > 0    ? low_m.x
                : high_m.y < 0 ? high_m.x
                               : nearer(low_m.x, high_m.x),
                low_m.x > 0    ? high_m.y
                : high_m.x < 0 ? low_m.y
                               : nearer(low_m.y, high_m.y)};
    }
    // Where the line to a border of bins meets it, and where it leaves it.
    float enters_m(glm::vec2 length_a_metre) const {
        const glm::vec2 at_m = glm::min(low_m * length_a_metre, high_m * length_a_metre);
        return std::max(at_m.x, at_m.y);
    }
    float leaves_m(glm::vec2 length_a_metre) const {
        const glm::vec2 at_m = glm::max(low_m * length_a_metre, high_m * length_a_metre);
        return std::min(at_m.x, at_m.y);
    }

  private:
    static float nearer(float low, float high) { return low > 0 ? low : high; }
};

void Horizon::begin(glm::vec3 eye_m, float moved_m, float sunk) {
    eye_m_ = eye_m;
    moved_m_ = moved_m;
    sunk_ = sunk;
    reach_m_ = 0;
    next_ring_m_ = 2 * kNearest_m;
    bins_.fill(kLowest);
    ring_reaches_m_.clear();
    rings_.clear();
}

Horizon::Plan Horizon::around(glm::vec3 low_m, glm::vec3 high_m, float wider_m) const {
    const glm::vec2 eye{eye_m_.x, eye_m_.z};
    return {glm::vec2{low_m.x, low_m.z} - eye - wider_m, glm::vec2{high_m.x, high_m.z} - eye + wider_m};
}

float Horizon::nearest_m(glm::vec2 eye_m, glm::vec3 low_m, glm::vec3 high_m) {
    const glm::vec2 low{low_m.x, low_m.z};
    const glm::vec2 high{high_m.x, high_m.z};
    return glm::length(eye_m - glm::clamp(eye_m, low, high));
}

void Horizon::cover(glm::vec3 low_m, glm::vec3 high_m) {
    const Plan plan = around(low_m, high_m, -moved_m_);
    const float near_m = plan.nearest_m();
    if (near_m < kNearest_m) return;
    keep_ring(near_m);
    reach_m_ = std::max(reach_m_, plan.farthest_m());
    const float from = bin_of(plan.first_corner());
    const float width = bin_of(plan.last_corner()) - from;
    const float to = from + (width < 0 ? width + kBins : width);
    const int first = static_cast<int>(std::ceil(from + kMargin_bins));
    const int last = static_cast<int>(std::floor(to - kMargin_bins));
    // What rises above the eye hides most where a line of sight meets it, the rest where the line leaves it.
    // The plan's corners were moved by 1.4 times as much, and the eye may have gone away from them.
    const float steep_m = std::max(std::abs(low_m.y - eye_m_.y), std::abs(high_m.y - eye_m_.y));
    const float away_m = glm::length(glm::vec2{plan.farthest_m(), steep_m}) + 2.5F * moved_m_;
    const float rise_m = low_m.y - eye_m_.y - moved_m_ - sunk_ * away_m;
    const auto line_m = [&](int border) {
        return rise_m > 0 ? plan.enters_m(length_a_metre(border)) : plan.leaves_m(length_a_metre(border));
    };
    float before_m = line_m(first);
    for (int bin = first; bin < last; ++bin) {
        const float after_m = line_m(bin + 1);
        const float surely_m = rise_m > 0 ? std::max(before_m, after_m) : std::min(before_m, after_m);
        float& tangent = bins_[static_cast<std::size_t>(around_once(bin))];
        tangent = std::max(tangent, rise_m / surely_m);
        before_m = after_m;
    }
}

void Horizon::keep_ring(float near_m) {
    if (near_m < next_ring_m_) return;
    ring_reaches_m_.push_back(reach_m_);
    rings_.push_back(bins_);
    next_ring_m_ = kRingGrowth * near_m;
}

bool Horizon::hides_box(glm::vec3 low_m, glm::vec3 high_m) const {
    const Plan plan = around(low_m, high_m, moved_m_);
    const float near_m = plan.nearest_m();
    if (near_m < kNearest_m) return false;
    const float rise_m = high_m.y - eye_m_.y + moved_m_;
    const float tangent = rise_m / (rise_m > 0 ? near_m : plan.farthest_m());
    const float from = bin_of(plan.first_corner());
    const float width = bin_of(plan.last_corner()) - from;
    const float to = from + (width < 0 ? width + kBins : width);
    for (int bin = static_cast<int>(std::floor(from - kMargin_bins)); static_cast<float>(bin) <= to + kMargin_bins;
         ++bin)
        if (bins_[static_cast<std::size_t>(around_once(bin))] <= tangent) return false;
    return true;
}

const Horizon::Bins* Horizon::bins_within(float reach_m) const {
    if (reach_m_ <= reach_m) return &bins_;
    const auto ring = std::ranges::upper_bound(ring_reaches_m_, reach_m);
    if (ring == ring_reaches_m_.begin()) return nullptr;
    return &rings_[static_cast<std::size_t>(ring - ring_reaches_m_.begin()) - 1];
}

bool Horizon::hides_standing(glm::vec2 foot_m, float radius_m, float top_m) const {
    const glm::vec2 way_m = foot_m - glm::vec2{eye_m_.x, eye_m_.z};
    const float away_m = glm::length(way_m);
    const float wide_m = radius_m + moved_m_;
    const float near_m = away_m - wide_m;
    if (near_m < kNearest_m) return false;
    const Bins* bins = bins_within(near_m);
    if (!bins) return false;
    const float rise_m = top_m - eye_m_.y + moved_m_;
    const float tangent = rise_m / (rise_m > 0 ? near_m : away_m + wide_m);
    // No angle is larger than its tangent, and no diamond's larger than the angle.
    const float half_bins = wide_m / near_m * kQuarter + kMargin_bins;
    const float middle = bin_of(way_m);
    for (int bin = static_cast<int>(std::floor(middle - half_bins)); static_cast<float>(bin) <= middle + half_bins;
         ++bin)
        if ((*bins)[static_cast<std::size_t>(around_once(bin))] <= tangent) return false;
    return true;
}

}  // namespace quadrat::render::choose
