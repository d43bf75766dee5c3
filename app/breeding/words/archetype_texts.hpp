// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/embedded_text.hpp"

namespace quadrat::breeding {

std::span<const base::EmbeddedText> archetype_texts();  // breeding/archetypes/*.json

}  // namespace quadrat::breeding
