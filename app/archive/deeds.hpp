// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "genome/offer.hpp"

namespace quadrat::archive {

struct SliderStep {
    int slider = 0;
    int direction = 1;  // 1 up, -1 down
    friend bool operator==(const SliderStep&, const SliderStep&) = default;
};

// What led from one offer to the next: picks, or a slider that was turned in their place. Breeding is exact, so a
// visit's seed and its deeds are all of it.
struct Deed {
    genome::Pick pick;
    std::optional<SliderStep> step;
    // The code of a landscape that the visit was bred on from: it stood among the first four, and was picked for all.
    std::string liked = {};
    friend bool operator==(const Deed&, const Deed&) = default;
};

// Of a visit that was bred on from that landscape ("": from none), and then by these picks; and back.
std::vector<Deed> deeds_of(const std::string& liked, const std::vector<genome::Pick>& picks);
std::vector<genome::Pick> picks_of(const std::vector<Deed>& deeds);

// "=CODE BAD B-- 7+ 12-": a landscape bred on from; trees, land and sky by letter, a hyphen where none was picked; a
// slider's number and its way.
std::string to_text(const std::vector<Deed>& deeds);
// Throws InputError naming what is no deed.
std::vector<Deed> deeds_from(std::string_view text);

}  // namespace quadrat::archive
