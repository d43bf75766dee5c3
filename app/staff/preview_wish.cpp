// SPDX-License-Identifier: Apache-2.0
#include "staff/preview_wish.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargest = 256U << 10U;
constexpr std::size_t kLongestText = 1000;  // bytes; the settings have the limit that counts

PreviewWish wish_from(const std::string& text) {
    const json read = json::parse(text);
    PreviewWish wish{read.at("language"), read.at("prompt"), read.at("texts")};
    if (std::ranges::any_of(wish.texts, [](const auto& one) { return one.second.size() > kLongestText; }))
        throw base::InputError("a text is too long to be drawn");
    return wish;
}

}  // namespace

std::string to_json(const PreviewWish& wish) {
    return json{{"language", wish.language}, {"prompt", wish.prompt}, {"texts", wish.texts}}.dump(
               1, ' ', false, json::error_handler_t::replace) +
           "\n";
}

std::optional<PreviewWish> take_preview_wish(const fs::path& runtime) {
    const fs::path file = runtime / kPreviewAsked;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return std::nullopt;
    std::optional<PreviewWish> wish;
    try {
        wish = wish_from(base::read_file(file, kLargest));
    } catch (const std::exception& trouble) {
        base::log::debug("preview: {}", trouble.what());
    }
    fs::remove(file, error);
    return wish;
}

}  // namespace quadrat::staff
