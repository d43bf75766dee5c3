// SPDX-License-Identifier: Apache-2.0
#include "backup/staged.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <system_error>

#include "archive/state_file.hpp"
#include "archive/state_lock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNote = "ready";
constexpr std::string_view kCollection = "collection/";

fs::path folder_in(const fs::path& state) { return state / "restoring"; }
fs::path note_in(const fs::path& state) { return folder_in(state) / kNote; }

// The first line: the folder of what was there; then the names of what is staged.
struct Note {
    std::string before;
    std::vector<std::string> staged;
};

std::string to_text(const Note& note) {
    std::string text = note.before + "\n";
    for (const std::string& name : note.staged) text += name + "\n";
    return text;
}

Note note_from(const std::string& text) {
    std::istringstream lines(text);
    Note note;
    std::getline(lines, note.before);
    for (std::string name; std::getline(lines, name);) note.staged.push_back(name);
    // It names a folder that is made beside it, and none elsewhere.
    if (note.before.empty() || note.before.find('/') != std::string::npos || note.before.starts_with('.'))
        throw base::InputError(fmt::format("restoring/{} is damaged; delete the folder restoring", kNote));
    return note;
}

void make_folder(const fs::path& state, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw base::InputError(fmt::format("{}: {}", folder.string(), error.message()));
    archive::give_to_owner_of(state, folder);
}

void move(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) throw base::InputError(fmt::format("{}: cannot be moved: {}", from.string(), error.message()));
}

void move_if_there(const fs::path& state, const std::string& name, const fs::path& before) {
    std::error_code error;
    if (!fs::exists(state / name, error)) return;
    make_folder(state, (before / name).parent_path());
    move(state / name, before / name);
}

// Each step may be the last before the plug is pulled, and may be done already.
void carry_out(const fs::path& state, const Note& note) {
    const fs::path before = state / note.before;
    std::error_code error;
    std::vector<std::string> names = site_files_in(state);
    for (const std::string& name : note.staged)
        if (is_of_a_collection(name)) names.push_back(name);  // moved there already, or new: it is looked at twice
    for (const std::string& name : names) {
        const bool is_staged = std::ranges::find(note.staged, name) != note.staged.end();
        if (is_staged && !fs::exists(folder_in(state) / name, error)) continue;
        if (name == archive::kStateFile)
            for (const char* part : {"-wal", "-shm"}) move_if_there(state, name + part, before);
        move_if_there(state, name, before);
        if (!is_staged) continue;
        make_folder(state, (state / name).parent_path());
        move(folder_in(state) / name, state / name);
    }
    base::flush_folder(state);
    fs::remove(note_in(state), error);
    fs::remove_all(folder_in(state), error);
}

}  // namespace

std::vector<std::string> site_files() {
    return {archive::kStateFile,
            "words.json",
            "words.previous.json",
            "taste.json",
            "taste.previous.json",
            "buttons.map",
            "desk.toml",
            "desk.changes.json",
            "desk.passphrase",
            "earlier/landscape-1.png",
            "earlier/landscape-2.png",
            "earlier/landscape-3.png"};
}

bool is_of_a_collection(const std::string& name) {
    constexpr std::size_t kDigits = 16;
    if (!name.starts_with(kCollection)) return false;
    const std::string file = name.substr(kCollection.size());
    const std::string ending = file.substr(std::min(kDigits, file.size()));
    return (ending == ".png" || ending == ".code") && file.find_first_not_of("0123456789abcdef") == kDigits;
}

std::vector<std::string> site_files_in(const fs::path& state) {
    std::vector<std::string> names = site_files(), chosen;
    std::error_code error;
    for (fs::directory_iterator file(state / kCollection, error), end; !error && file != end; file.increment(error)) {
        std::string name = std::string(kCollection) + file->path().filename().string();
        if (is_of_a_collection(name)) chosen.push_back(std::move(name));
    }
    std::ranges::sort(chosen);
    chosen.resize(std::min(chosen.size(), kMostOfACollection));
    names.insert(names.end(), chosen.begin(), chosen.end());
    return names;
}

Staging::Staging(const fs::path& state) : state_(state) {
    std::error_code ignored;
    fs::remove_all(folder_in(state), ignored);
    make_folder(state, folder_in(state));
}

Staging::~Staging() {
    std::error_code ignored;
    if (!is_interrupted(state_)) fs::remove_all(folder_in(state_), ignored);
}

fs::path Staging::place(const std::string& name) const {
    make_folder(state_, (folder_in(state_) / name).parent_path());
    return folder_in(state_) / name;
}

void Staging::commit(const std::string& before) {
    Note note{before, {}};
    std::error_code error;
    for (const std::string& name : site_files_in(folder_in(state_))) {
        const fs::path file = folder_in(state_) / name;
        if (!fs::exists(file, error)) continue;
        base::flush_file(file);
        archive::give_to_owner_of(state_, file);
        note.staged.push_back(name);
    }
    base::write_file(note_in(state_), to_text(note));
    carry_out(state_, note);
}

bool is_interrupted(const fs::path& state) {
    std::error_code error;
    return fs::exists(note_in(state), error);
}

bool complete(const fs::path& state) {
    std::error_code error;
    if (!is_interrupted(state)) {
        fs::remove_all(folder_in(state), error);
        return false;
    }
    carry_out(state, note_from(base::read_file(note_in(state))));
    return true;
}

std::string dated_name(const fs::path& folder, std::string_view stem, archive::WallTime now, std::string_view ending) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
    const std::string name =
        fmt::format("{}-{:%Y%m%d-%H%M%S}", stem, fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
    std::error_code ignored;
    if (!fs::exists(folder / (name + std::string(ending)), ignored)) return name + std::string(ending);
    for (int i = 2;; ++i)
        if (std::string next = fmt::format("{}-{}{}", name, i, ending); !fs::exists(folder / next, ignored))
            return next;
}

}  // namespace quadrat::backup
