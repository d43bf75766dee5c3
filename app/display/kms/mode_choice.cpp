// SPDX-License-Identifier: Apache-2.0
#include "display/kms/mode_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace quadrat::display {
namespace {

constexpr double kHighestHz = 60.5;  // 60 Hz modes are written with anything from 59.9 to 60.4
constexpr double kSameHz = 0.6;      // "60" also means the 59.94 that television calls 60
constexpr std::size_t kSmallerRungs = 2;

long area(const ScreenMode& mode) { return static_cast<long>(mode.size.width) * mode.size.height; }

// Within full HD whichever way the panel stands.
bool is_modest(Size size) {
    const auto [shorter, longer] = std::minmax(size.width, size.height);
    return longer <= 1920 && shorter <= 1080;
}
bool is_modest(const ScreenMode& mode) {
    return is_modest(mode.size) && mode.refresh_hz <= kHighestHz && !mode.is_interlaced;
}
bool is_no_more_work_than_full_hd(const ScreenMode& mode) {
    return static_cast<double>(area(mode)) * mode.refresh_hz <= 1920.0 * 1080.0 * kHighestHz;
}

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

// A panel is sharp at its own size only, so that counts for more than 60 Hz: the fastest mode of that size up to 60,
// or, where all are faster, the slowest that is no more work than full HD.
std::optional<std::size_t> at_native_size(std::span<const ScreenMode> modes) {
    const auto native =
        std::find_if(modes.begin(), modes.end(), [](const ScreenMode& mode) { return mode.is_preferred; });
    if (native == modes.end() || !is_modest(native->size)) return std::nullopt;
    return best_of(modes, [&native](const ScreenMode& mode) -> std::optional<std::tuple<bool, double, bool>> {
        if (mode.size != native->size || mode.is_interlaced || !is_no_more_work_than_full_hd(mode)) return std::nullopt;
        const bool is_calm = mode.refresh_hz <= kHighestHz;
        return std::tuple{is_calm, is_calm ? mode.refresh_hz : -mode.refresh_hz, mode.is_preferred};
    });
}

std::optional<std::size_t> by_itself(std::span<const ScreenMode> modes) {
    if (const auto native = at_native_size(modes)) return native;
    const auto largest = best_of(modes, [](const ScreenMode& mode) -> std::optional<std::pair<long, double>> {
        return is_modest(mode) ? std::optional{std::pair{area(mode), mode.refresh_hz}} : std::nullopt;
    });
    if (largest) return largest;
    return best_of(modes, [](const ScreenMode& mode) -> std::optional<std::tuple<bool, long, double>> {
        return std::tuple{!mode.is_interlaced, -area(mode), -mode.refresh_hz};
    });
}

// The next smaller modes, each about half of the one before, so that two steps make a real difference.
std::vector<std::size_t> ever_smaller(std::span<const ScreenMode> modes, std::size_t start) {
    std::vector<std::size_t> found;
    for (long limit = area(modes[start]) * 3 / 4; found.size() < kSmallerRungs;) {
        const auto next = best_of(modes, [limit](const ScreenMode& mode) -> std::optional<std::pair<long, double>> {
            const bool fits = area(mode) <= limit && is_modest(mode);
            return fits ? std::optional{std::pair{area(mode), mode.refresh_hz}} : std::nullopt;
        });
        if (!next) break;
        found.push_back(*next);
        limit = area(modes[*next]) * 3 / 4;
    }
    return found;
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
    if (draw != Size{} && draw != size_of(*first)) ladder.rungs.push_back({*first, draw});
    ladder.rungs.push_back({*first, size_of(*first)});
    for (const std::size_t mode : ever_smaller(modes, *first)) ladder.rungs.push_back({mode, size_of(mode)});
    return ladder;
}

}  // namespace quadrat::display
