// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <concepts>
#include <cstdlib>
#include <string_view>

namespace quadrat::tests {

#ifdef QUADRAT_SANITIZED
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

// How many of the `whole` cases of a sweep to try: all of them, or a tenth where a sanitizer makes each ten times as
// dear. Sanitizers look for faults on a path, not for rare numbers; the plain build goes through them all.
template <std::integral Count>
constexpr Count of(Count whole) {
    return !kIsSanitized ? whole : whole < 10 ? 1 : whole / 10;
}

// The same of a sweep that takes a minute: a quarter of the cases, the first ones, so that the tests stay short; with
// QUADRAT_SWEEPS=whole in the environment all of them.
template <std::integral Count>
Count sample_of(Count whole) {
    const char* const asked = std::getenv("QUADRAT_SWEEPS");
    return asked != nullptr && std::string_view(asked) == "whole" ? of(whole) : of(whole) / 4;
}

}  // namespace quadrat::tests
