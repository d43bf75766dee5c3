// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "genome/recipe.hpp"
#include "genome/words.hpp"

namespace quadrat::kiosk {

// A landscape that was bred, while it is asked about.
struct Bred {
    genome::Recipe recipe;
    std::optional<genome::Description> words;
    std::vector<genome::WordId> asked;  // one after another
    std::string take_home;              // where it can be had; "" where the site says nothing
    bool wants_postcard = false;        // and nobody has been told yet
};

}  // namespace quadrat::kiosk
