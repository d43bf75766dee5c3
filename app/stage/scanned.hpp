// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "exhibit/visit.hpp"

namespace quadrat::stage {

// How somebody plays with fewer than four buttons, or may, as it is shown.
struct Scanned {
    std::optional<exhibit::Choice> marked = {};  // framed; nothing while the mark rests
    std::string hint;                            // a key of genome::kPrompts, below the question; or ""
    bool offers_back = false;                    // Back is marked in its turn, and is shown
    float hold = 0;                              // how far a held button has got, 0 to 1; 0: none is
};

}  // namespace quadrat::stage
