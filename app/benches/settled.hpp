// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "benches/four_views.hpp"

namespace quadrat::benches {

// What settlements add to a frame: four settled landscapes, drawn with and without what people have built, in turns.
void settled(Results& results, FourViews& views);

}  // namespace quadrat::benches
