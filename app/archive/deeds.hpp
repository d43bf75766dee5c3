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
    friend bool operator==(const Deed&, const Deed&) = default;
};

// "BAD B-- 7+ 12-": trees, land and sky by letter, a hyphen where none was picked; a slider's number and its way.
std::string to_text(const std::vector<Deed>& deeds);
// Throws InputError naming what is no deed.
std::vector<Deed> deeds_from(std::string_view text);

}  // namespace quadrat::archive
