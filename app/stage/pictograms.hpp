// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string_view>

#include "render/pictogram.hpp"

namespace quadrat::stage {

// What says a prompt, a key of genome::kPrompts, without words: in the order in which it is done. Nothing for what
// staff read alone, and for no prompt.
std::span<const render::Pictogram> pictograms_for(std::string_view key);

}  // namespace quadrat::stage
