// SPDX-License-Identifier: Apache-2.0
#include "tempo/memory.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace quadrat::tempo {

namespace {

constexpr std::string_view kSmooth = "x4";  // behind the periods: with four samples a pixel

}  // namespace

std::string to_text(const DetailGovernor& governor, std::string_view gpu) {
    return fmt::format("{}{} {:.4f} {}", governor.periods(), governor.samples() > 1 ? kSmooth : "", governor.settled(),
                       gpu);
}

std::string to_text(const GpuProfile& profile, std::string_view gpu) {
    return std::string(gpu) + ": " + to_text(profile);
}

bool is_profile_of(std::string_view remembered, std::string_view gpu) {
    return remembered.starts_with(std::string(gpu) + ": ");
}

GovernorOptions options_for(float most, std::string_view remembered, std::string_view gpu) {
    GovernorOptions all;
    all.most = all.start = most;
    GovernorOptions options = all;
    const char* const end = remembered.data() + remembered.size();
    const auto first = std::from_chars(remembered.data(), end, options.periods);
    if (first.ec != std::errc{} || options.periods < 1 || options.periods > GovernorOptions::kMostPeriods) return all;
    std::string_view rest(first.ptr, static_cast<std::size_t>(end - first.ptr));
    if (rest.starts_with(kSmooth)) {
        options.samples = 4;
        rest.remove_prefix(kSmooth.size());
    }
    if (!rest.starts_with(' ')) return all;
    const auto second = std::from_chars(rest.data() + 1, end, options.start);
    if (second.ec != std::errc{} || second.ptr == end || !std::isfinite(options.start) || options.start <= 0)
        return all;
    const std::string_view renderer(second.ptr + 1, static_cast<std::size_t>(end - second.ptr - 1));
    return renderer == gpu ? options : all;
}

}  // namespace quadrat::tempo
