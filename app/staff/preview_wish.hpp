// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace quadrat::staff {

// Words that somebody wishes to see as the exhibit would draw them, before anybody else does.
struct PreviewWish {
    std::string language;                      // a code
    std::string prompt;                        // which of them is to be seen, a key of genome::kPrompts
    std::map<std::string, std::string> texts;  // by key; what is not there is the language's own
    friend bool operator==(const PreviewWish&, const PreviewWish&) = default;
};

// Whoever wishes writes this file in the runtime folder, and finds the picture beside it when it was drawn: in the next
// frame in which nobody plays.
inline constexpr const char* kPreviewAsked = "preview.asked";
inline constexpr const char* kPreview = "preview.png";

// Why it is not drawn yet, as long as it is not: "visitor", "dark".
inline constexpr const char* kPreviewWaits = "preview.waits";

std::string to_json(const PreviewWish& wish);

// Takes the file away. Nothing: there is none, or what is there is no wish.
std::optional<PreviewWish> take_preview_wish(const std::filesystem::path& runtime);

}  // namespace quadrat::staff
