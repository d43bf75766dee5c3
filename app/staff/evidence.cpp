// SPDX-License-Identifier: Apache-2.0
#include "staff/evidence.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "pictures/png_picture.hpp"
#include "staff/keepsakes.hpp"

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::system_clock;

constexpr std::size_t kLongestText = 300;  // bytes
constexpr std::size_t kLargestFile = std::size_t{1} << 20U;

fs::path folder_in(const fs::path& state) { return state / "faults"; }
fs::path file_in(const fs::path& folder) { return folder / "faults.json"; }

std::string date_of(WallMoment at) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(system_clock::to_time_t(at)));
}

std::int64_t seconds_of(WallMoment at) { return system_clock::to_time_t(at); }

std::string shortened(std::string text) {
    if (text.size() <= kLongestText) return text;
    std::size_t end = kLongestText;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;  // not within a letter
    return text.substr(0, end) + " …";
}

// Throws json::exception.
KeptFault fault_from(const json& read) {
    const auto at = [&](const char* key) { return system_clock::from_time_t(read.at(key).get<std::int64_t>()); };
    return {shortened(read.at("text")), at("first_s"), at("last_s"), read.at("count"), read.value("picture", "")};
}

// The pictures that there are, by their numbers: the lowest is the oldest, whatever the clock said.
std::map<int, fs::path> pictures_in(const fs::path& folder) {
    std::map<int, fs::path> pictures;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("fault-") || !name.ends_with(".png")) continue;
        if (const int number = std::atoi(name.c_str() + 6); number > 0) pictures[number] = entry.path();
    }
    return pictures;
}

bool is_recent(const fs::path& picture, WallMoment now) {
    std::error_code error;
    const auto age = fs::file_time_type::clock::from_sys(now) - fs::last_write_time(picture, error);
    // A clock that was set back says nothing.
    return !error && age >= age.zero() && age < Evidence::kPictureEvery;
}

}  // namespace

std::string to_line(const KeptFault& fault) {
    std::string line = fmt::format("{} {}", date_of(fault.first), fault.text);
    std::string more = fault.count > 1 ? fmt::format("{} times, until {}", fault.count, date_of(fault.last)) : "";
    if (!fault.picture.empty()) more += (more.empty() ? "picture " : "; picture ") + fault.picture;
    return more.empty() ? line : fmt::format("{} ({})", line, more);
}

std::vector<KeptFault> read_faults(const fs::path& state) {
    std::vector<KeptFault> faults;
    try {
        const json read = json::parse(base::read_file(file_in(folder_in(state)), kLargestFile));
        for (const json& one : read.at("faults")) faults.push_back(fault_from(one));
    } catch (const base::InputError&) {
        return faults;
    } catch (const json::exception&) {
        return faults;
    }
    return faults;
}

Evidence::Evidence(const fs::path& state) : folder_(folder_in(state)) {}

Evidence::~Evidence() {
    if (is_read_) look(base::recent_warnings(), written_at_.value_or(base::Instant{0}));
    if (has_new_ || has_more_) write();
}

void Evidence::read() {
    is_read_ = true;
    faults_ = read_faults(folder_.parent_path());
    for (const KeptFault& fault : faults_) earlier_.push_back(to_line(fault));
}

void Evidence::look(const base::RecentWarnings& recent, base::Instant now) {
    if (!is_read_) read();
    const std::size_t fresh = std::min(recent.count - std::min(seen_, recent.count), recent.warnings.size());
    for (std::size_t i = recent.warnings.size() - fresh; i < recent.warnings.size(); ++i) note(recent.warnings[i]);
    seen_ = recent.count;
    const auto is_due = [&](base::Instant every) { return !written_at_ || now - *written_at_ >= every; };
    if ((!has_new_ || !is_due(kWriteEvery)) && (!has_more_ || !is_due(kCountEvery))) return;
    written_at_ = now;
    write();
}

void Evidence::note(const base::Warning& warning) {
    const std::string text = shortened(warning.text);
    const auto known = std::ranges::find(faults_, text, &KeptFault::text);
    if (known != faults_.end()) {
        ++known->count;
        known->last = warning.at;
        std::rotate(known, known + 1, faults_.end());  // the last to come is the last to go
        has_more_ = true;
        return;
    }
    faults_.push_back({text, warning.at, warning.at, 1, ""});
    if (faults_.size() > kFaults) faults_.erase(faults_.begin());
    has_new_ = true;
}

void Evidence::keep_picture(const mesh::Image& picture, WallMoment now) {
    if (!is_read_) read();
    auto pictures = pictures_in(folder_);
    if (!pictures.empty() && is_recent(pictures.rbegin()->second, now)) return;
    mesh::Image small = picture;
    while (small.width > kPictureWidth) small = halved(small);
    const int number = pictures.empty() ? 1 : pictures.rbegin()->first + 1;
    const fs::path file = folder_ / fmt::format("fault-{}.png", number);
    std::error_code error;
    fs::create_directories(folder_, error);
    for (; pictures.size() >= kPictures; pictures.erase(pictures.begin())) fs::remove(pictures.begin()->second, error);
    pictures::write_png_quickly(file, small);
    if (faults_.empty()) return;
    faults_.back().picture = file.string();
    write();
}

// Where nothing can be kept, it is no fault that could be kept.
void Evidence::write() {
    has_new_ = has_more_ = false;
    json list = json::array();
    for (const KeptFault& fault : faults_)
        list.push_back({{"text", fault.text},
                        {"first_s", seconds_of(fault.first)},
                        {"last_s", seconds_of(fault.last)},
                        {"count", fault.count},
                        {"picture", fault.picture}});
    const json all{{"quadrat", "faults"}, {"version", 1}, {"faults", list}};
    std::error_code error;
    fs::create_directories(folder_, error);
    try {
        base::write_file(file_in(folder_), all.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
    } catch (const base::InputError& trouble) {
        base::log::debug("faults: {}", trouble.what());
    }
}

}  // namespace quadrat::staff
