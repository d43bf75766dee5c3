// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

namespace quadrat::hearing {

// How the sound is, for those who look after it.
struct Health {
    bool is_wanted = false;
    bool is_playing = false;      // on every card that the site names
    std::uint64_t underruns = 0;  // gaps, since the start
    std::uint64_t dropped = 0;    // what could not be told in time
    std::string trouble;          // why it is not heard, or not spoken; or ""
    friend bool operator==(const Health&, const Health&) = default;
};

}  // namespace quadrat::hearing
