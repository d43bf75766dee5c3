// SPDX-License-Identifier: Apache-2.0
// The table of kinds, from the files in kinds/ in their order: the build lists them in kinds.inc.
#include <algorithm>
#include <cassert>

#include "synthesis/trees/form.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr Kind kKinds[] = {
#include <kinds.inc>
};
constexpr int kCount = static_cast<int>(std::size(kKinds));

constexpr int place_of(std::string_view name) {
    for (int i = 0; i < kCount; ++i)
        if (name == kKinds[i].name) return i;
    return -1;
}

constexpr bool are_sound() {
    for (int i = 0; i < kCount; ++i) {
        if (place_of(kKinds[i].name) != i) return false;
        for (const char* companion : kKinds[i].companions)
            if (companion == nullptr || place_of(companion) < 0) return false;
    }
    return true;
}
static_assert(are_sound(), "each kind has a name of its own and eight companions that are kinds");

}  // namespace

int kind_count() { return kCount; }

const Kind& kind(int habit) {
    assert(habit >= 0 && habit < kCount);
    return kKinds[habit];
}

int habit_named(std::string_view name) { return place_of(name); }

}  // namespace quadrat::synthesis::trees
