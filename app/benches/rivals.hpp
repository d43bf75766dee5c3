// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/measurement.hpp"

namespace quadrat::benches {

// One of those that a figure is compared with.
struct Rival {
    struct Figure {
        double least = 0;
        double most = 0;
    };
    std::string text;              // "meshoptimizer 126-134"
    std::optional<Figure> figure;  // in the measurement's own unit; none where the text has no single one
};

// From a measurement's `others`: rivals are parted by "; ", and each has its figure after its name.
std::vector<Rival> rivals_of(std::string_view others);

// HTML: each with a bar of its figure, the measured one first. Empty for none.
std::string rivals_html(const machine::Measurement& measurement);

// A figure in as many digits as tell something.
std::string figure_text(double value);

}  // namespace quadrat::benches
