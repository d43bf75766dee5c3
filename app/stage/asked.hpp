// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <string>

namespace quadrat::stage {

// A slider as it is shown: the ends it goes between, and where it stands.
struct ShownSlider {
    std::string low;
    std::string high;
    float share = 0.5F;  // 0 at low, 1 at high
};

// What the four buttons mean while one landscape is described or turned.
struct Asked {
    std::string prompt;  // a key of genome::kPrompts
    std::array<std::string, 4> labels;
    std::optional<ShownSlider> slider;
};

}  // namespace quadrat::stage
