// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "staff/preview_wish.hpp"

namespace quadrat::commands {

// Asks a running exhibit to draw words, in place of what was asked for before. Throws InputError: none runs, or there
// is no such prompt.
void ask_preview(const std::filesystem::path& runtime, const staff::PreviewWish& wish);
// PNG; nothing: it was not drawn yet.
std::optional<std::string> preview_in(const std::filesystem::path& runtime);
// Until then: as desk::Curator says it.
std::string why_preview_waits(const std::filesystem::path& runtime);

}  // namespace quadrat::commands
