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
    struct Landscape {
        genome::Recipe recipe = {};
        std::optional<genome::Description> words = {};  // what it was made of
    };
    Landscape own = {};
    std::optional<Landscape> other = {};     // described instead of it
    std::vector<genome::WordId> asked = {};  // one after another
    std::string take_home = "";              // where it can be had; "" where the site says nothing
    bool wants_postcard = false;             // and nobody has been told yet

    const Landscape& described() const { return other ? *other : own; }
};

// What the site wants of it.
struct Wanted {
    std::string take_home_url;  // "": nowhere
    bool describes_others = false;
};

}  // namespace quadrat::kiosk
