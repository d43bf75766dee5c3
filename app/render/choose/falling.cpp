// SPDX-License-Identifier: Apache-2.0
#include "render/choose/falling.hpp"

#include <cmath>

namespace quadrat::render::choose {

std::size_t drops_of(const scene::Precipitation& what, float share) {
    constexpr float kFlakes = 0.5F;  // of them: a flake is seen whole, a drop as a stroke
    if (what.kind == scene::Precipitation::Kind::None) return 0;
    const float of_drops = what.kind == scene::Precipitation::Kind::Snow ? kFlakes : 1.0F;
    return static_cast<std::size_t>(std::lround(what.amount * share * of_drops * static_cast<float>(kDrops)));
}

}  // namespace quadrat::render::choose
