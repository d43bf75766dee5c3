// SPDX-License-Identifier: Apache-2.0
// The landscapes and cameras that both sides show.
#pragma once
#include <cstdint>

#include "bench/peers/peers.hpp"

namespace quadrat::peers {

inline constexpr std::uint64_t kSeedOfFour = 11;

inline int frames_of(const Options& how) { return how.is_quick ? 3 : 12; }

// Thirty frames a second of a flight at its mean speed, from its tenth second on.
inline float seconds_of_frame(int frame) { return 10 + static_cast<float>(frame) / 30; }

}  // namespace quadrat::peers
