// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/embedded_text.hpp"

namespace quadrat::genome {

std::span<const base::EmbeddedText> code_layout_texts();  // genome/code_layouts/*.txt

}  // namespace quadrat::genome
