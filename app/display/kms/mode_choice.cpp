// SPDX-License-Identifier: Apache-2.0
#include "display/kms/mode_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "display/kms/placement.hpp"

namespace quadrat::display {
namespace {

constexpr double kHighestHz = 60.5;  // 60 Hz modes are written with anything from 59.9 to 60.4
constexpr double kSlowestHz = 29.0;  // below, a picture of fewer lines is the better one
constexpr double kSameHz = 0.6;      // "60" also means the 59.94 that television calls 60
constexpr std::size_t kSmallerRungs = 2;
// What HDMI 2.0 carries, and what the display controllers of a Raspberry Pi 4 or 5 and of a PC scan out: 4096x2160 at
// 60 Hz. The kernel offers no mode that this port or this cable's other end cannot: a Pi 4 offers 3840x2160 at 30 Hz,
// unless its firmware is told hdmi_enable_4kp60=1.
constexpr double kMostPixels_per_s = 4096.0 * 2160.0 * kHighestHz;
constexpr double kMostDrawnPixels_per_s = 1920.0 * 1200.0 * kHighestHz;
constexpr long kMostUnscaled = 2560L * 1600;  // what a small GPU still fills where the plane does not scale

long area(Size size) { return static_cast<long>(size.width) * size.height; }
long area(const ScreenMode& mode) { return area(mode.size); }
double pixels_per_s(const ScreenMode& mode) { return static_cast<double>(area(mode)) * mode.refresh_hz; }

// What a screen of any shape may be driven at: no faster than we draw, and within what is carried.
bool is_carried(const ScreenMode& mode) {
    return !mode.is_interlaced && mode.refresh_hz <= kHighestHz && pixels_per_s(mode) <= kMostPixels_per_s &&
           std::max(mode.size.width, mode.size.height) <= kLargestSide;
}
bool is_drawn_whole(const ScreenMode& mode) { return is_carried(mode) && drawn_for(mode.size) == mode.size; }

template <typename Key>
std::optional<std::size_t> best_of(std::span<const ScreenMode> modes, Key key) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < modes.size(); ++i)
        if (const auto value = key(modes[i]); value && (!best || *value > *key(modes[*best]))) best = i;
    return best;
}

std::optional<std::size_t> configured(std::span<const ScreenMode> modes, const WantedMode& wanted) {
    return best_of(modes, [&wanted](const ScreenMode& mode) -> std::optional<std::tuple<bool, double, bool>> {
        if (mode.size != wanted.size) return std::nullopt;
        const double target_hz = wanted.refresh_hz > 0.0 ? wanted.refresh_hz : 60.0;
        const double off_hz = std::abs(mode.refresh_hz - target_hz);
        if (wanted.refresh_hz > 0.0 && off_hz > kSameHz) return std::nullopt;
        return std::tuple{!mode.is_interlaced, -off_hz, mode.is_preferred};
    });
}

using Modes = std::span<const ScreenMode>;

// The panel's own size, which is its wish; nothing when it has none.
std::optional<Size> native_size(Modes modes) {
    const auto native =
        std::find_if(modes.begin(), modes.end(), [](const ScreenMode& mode) { return mode.is_preferred; });
    return native == modes.end() ? std::nullopt : std::optional{native->size};
}

// A panel is sharp at its own size only, so that counts for more than 60 Hz: the fastest mode of that size up to 60,
// or, where all are faster, the slowest that is no more work than we draw.
std::optional<std::size_t> at_size(Modes modes, Size native) {
    return best_of(modes, [native](const ScreenMode& mode) -> std::optional<std::tuple<bool, double, bool>> {
        if (mode.size != native || mode.is_interlaced || mode.refresh_hz < kSlowestHz) return std::nullopt;
        const bool is_calm = is_carried(mode);
        if (!is_calm && pixels_per_s(mode) > kMostDrawnPixels_per_s) return std::nullopt;
        return std::tuple{is_calm, is_calm ? mode.refresh_hz : -mode.refresh_hz, mode.is_preferred};
    });
}

// The largest that is drawn whole, else the largest that is carried; of the panel's shape, where one is given.
std::optional<std::size_t> largest(Modes modes, std::optional<Size> native) {
    return best_of(modes, [native](const ScreenMode& mode) -> std::optional<std::tuple<bool, long, double>> {
        if (!is_carried(mode) || (native && !is_same_shape(mode.size, *native))) return std::nullopt;
        return std::tuple{is_drawn_whole(mode), area(mode), mode.refresh_hz};
    });
}

std::optional<std::size_t> by_itself(Modes modes) {
    const auto native = native_size(modes);
    if (native)
        if (const auto found = at_size(modes, *native)) return found;
    if (native)
        if (const auto found = largest(modes, native)) return found;
    if (const auto found = largest(modes, std::nullopt)) return found;  // stretched by the panel is better than dark
    return best_of(modes, [](const ScreenMode& mode) -> std::optional<std::tuple<bool, long, double>> {
        return std::tuple{!mode.is_interlaced, -area(mode), -mode.refresh_hz};
    });
}

// The same size about half as fast, for a card or a cable that does not bear the fastest after all.
std::optional<std::size_t> slower(Modes modes, std::size_t start) {
    return best_of(modes, [&](const ScreenMode& mode) -> std::optional<double> {
        const bool is_it = mode.size == modes[start].size && is_carried(mode) && mode.refresh_hz >= kSlowestHz &&
                           mode.refresh_hz <= modes[start].refresh_hz * 0.75;
        return is_it ? std::optional{mode.refresh_hz} : std::nullopt;
    });
}

// The next smaller modes of the shape, each at most three quarters of the one before, so that two steps make a real
// difference.
std::vector<std::size_t> ever_smaller(Modes modes, std::size_t start, Size shape) {
    std::vector<std::size_t> found;
    for (long limit = area(modes[start]) * 3 / 4; found.size() < kSmallerRungs;) {
        const auto next = best_of(modes, [&](const ScreenMode& mode) -> std::optional<std::pair<long, double>> {
            const bool fits = area(mode) <= limit && is_drawn_whole(mode) && is_same_shape(mode.size, shape);
            return fits ? std::optional{std::pair{area(mode), mode.refresh_hz}} : std::nullopt;
        });
        if (!next) break;
        found.push_back(*next);
        limit = area(modes[*next]) * 3 / 4;
    }
    return found;
}

void add(std::vector<Rung>& rungs, const Rung& rung) {
    if (std::find(rungs.begin(), rungs.end(), rung) == rungs.end()) rungs.push_back(rung);
}

}  // namespace

ModeLadder mode_ladder(std::span<const ScreenMode> modes, const std::optional<WantedMode>& wanted, Size draw) {
    ModeLadder ladder;
    std::optional<std::size_t> first = wanted ? configured(modes, *wanted) : std::nullopt;
    if (!first) first = by_itself(modes);
    if (!first) return ladder;
    const auto size_of = [&modes](std::size_t mode) { return modes[mode].size; };
    if (wanted && !configured(modes, *wanted))
        ladder.warning =
            fmt::format("the screen does not offer the configured {}x{}{}; using {}x{}@{:.2f}", wanted->size.width,
                        wanted->size.height, wanted->refresh_hz > 0.0 ? fmt::format("@{:g}", wanted->refresh_hz) : "",
                        size_of(*first).width, size_of(*first).height, modes[*first].refresh_hz);
    const Size own = drawn_for(size_of(*first));
    const Size chosen = draw != Size{} ? draw : own;
    add(ladder.rungs, {*first, chosen});
    add(ladder.rungs, {*first, own});
    const auto slow = own == size_of(*first) ? std::nullopt : slower(modes, *first);
    if (slow) add(ladder.rungs, {*slow, chosen});
    const bool is_large = area(modes[*first]) > kMostUnscaled;
    if (!is_large) add(ladder.rungs, {*first, size_of(*first)});
    for (const std::size_t mode : ever_smaller(modes, *first, native_size(modes).value_or(size_of(*first))))
        add(ladder.rungs, {mode, size_of(mode)});
    if (is_large) add(ladder.rungs, {*first, size_of(*first)});
    return ladder;
}

}  // namespace quadrat::display
