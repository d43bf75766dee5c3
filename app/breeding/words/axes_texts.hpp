// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/embedded_text.hpp"

namespace quadrat::breeding {

std::span<const base::EmbeddedText> axes_texts();  // breeding/words/axes/*.json

}  // namespace quadrat::breeding
