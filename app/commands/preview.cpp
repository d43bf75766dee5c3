// SPDX-License-Identifier: Apache-2.0
#include "commands/preview.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "genome/speech.hpp"
#include "staff/presence.hpp"

namespace quadrat::commands {

namespace fs = std::filesystem;

void ask_preview(const fs::path& runtime, const staff::PreviewWish& wish) {
    if (std::ranges::find(genome::kPrompts, wish.prompt) == genome::kPrompts.end())
        throw base::InputError("there is no such text");
    if (!staff::is_exhibit_present(runtime)) throw base::InputError("no exhibit runs here that could draw it");
    std::error_code ignored;
    for (const char* of_the_last : {staff::kPreview, staff::kPreviewWaits}) fs::remove(runtime / of_the_last, ignored);
    base::write_file(runtime / staff::kPreviewAsked, to_json(wish));
}

std::optional<std::string> preview_in(const fs::path& runtime) {
    constexpr std::size_t kMost = 32U << 20U;
    std::error_code error;
    if (!fs::is_regular_file(runtime / staff::kPreview, error)) return std::nullopt;
    try {
        return base::read_file(runtime / staff::kPreview, kMost);
    } catch (const base::InputError&) {
        return std::nullopt;  // it went away meanwhile
    }
}

std::string why_preview_waits(const fs::path& runtime) {
    constexpr std::size_t kMost = 64;
    if (!staff::is_exhibit_present(runtime)) return "gone";
    try {
        std::string why = base::read_file(runtime / staff::kPreviewWaits, kMost);
        if (why == "visitor" || why == "dark") return why;
    } catch (const base::InputError&) {
        // It does not wait.
    }
    return "soon";
}

}  // namespace quadrat::commands
