// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "base/clock.hpp"
#include "genome/aspect.hpp"

namespace quadrat::stage {

// What a ghost does at a moment to show how it is played: it asks a question and presses a button for it.
struct Ghost {
    genome::Aspect question;
    std::size_t button;  // a quarter
    float press;         // 0: the finger is up, 1: the button is down
    float strength;      // 0 to 1: it comes and goes softly
};

// Nothing while it rests: for eight seconds after the last visitor, and for half a minute between two times.
std::optional<Ghost> ghost_at(base::Instant since_attract);

}  // namespace quadrat::stage
