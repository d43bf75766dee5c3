// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/embedded_text.hpp"

namespace quadrat::desk {

std::span<const base::EmbeddedText> language_texts();  // desk/languages/*.json
std::span<const base::EmbeddedText> web_files();       // desk/web/script.js, then desk/web/style.css

}  // namespace quadrat::desk
