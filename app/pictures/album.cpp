// SPDX-License-Identifier: Apache-2.0
#include "pictures/album.hpp"

#include <fmt/format.h>

#include <system_error>

#include "base/error.hpp"
#include "base/log.hpp"

namespace quadrat::pictures {
namespace {

constexpr int kSheetEntryPx = 480;
constexpr int kSheetColumns = 3;
constexpr std::size_t kSheetEntries = 60;

void write_or_log(const std::filesystem::path& path, const mesh::Image& pixels, const std::string& json) {
    try {
        write_picture(path, pixels, json);
    } catch (const base::InputError& error) {
        base::log::warn("a picture is left out: {}", error.what());
    }
}

}  // namespace

Album::Album(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error || !std::filesystem::is_directory(folder_))
        throw base::InputError(
            fmt::format("{}: cannot make this folder for pictures: {}", folder_.string(), error.message()));
}

void Album::add(const std::string& name, mesh::Image pixels, const Picture& picture, const std::string& caption) {
    // Only the newest are kept for the sheet: a run can go on for months.
    if (entries_.size() >= kSheetEntries) entries_.erase(entries_.begin());
    entries_.push_back({scaled_to(pixels, kSheetEntryPx), caption});
    ++count_;
    writing_.send([path = folder_ / (name + ".png"), pixels = std::move(pixels), json = to_json(picture)] {
        write_or_log(path, pixels, json);
    });
}

void Album::finish() {
    writing_.finish();
    if (entries_.empty()) return;
    write_image(folder_ / "contact-sheet.png", contact_sheet(entries_, kSheetColumns, kSheetEntryPx));
}

}  // namespace quadrat::pictures
