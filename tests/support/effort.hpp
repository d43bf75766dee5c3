// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <concepts>

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

}  // namespace quadrat::tests
