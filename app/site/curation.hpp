// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "site/configuration.hpp"

// What the curator says at the desk: a file of its own over the site's, and the way back for thirty changes.
namespace quadrat::site {

struct EmptyTable {
    friend bool operator==(const EmptyTable&, const EmptyTable&) = default;
};
using CuratedValue =
    std::variant<EmptyTable, bool, std::int64_t, double, std::string, std::vector<std::string>, std::array<double, 2>>;

// One value of the curator's file, by its place: {"visit", "rounds"}.
struct Edit {
    std::vector<std::string> place;     // at least one
    std::optional<CuratedValue> value;  // nothing: it, or the table of that name, is taken out, so the site's counts
};

// A file with these edits, one after the other; "" where nothing is left in it. Throws InputError where `toml` is none,
// or an edit leads through what is no table.
std::string edited(const std::string& toml, const std::vector<Edit>& edits);

// What was changed, and what the file was before.
struct CuratedChange {
    std::chrono::sys_seconds at{};
    std::string who, what;
    std::string before;  // "": there was no file
};

class Curation {
  public:
    static constexpr std::size_t kMostChanges = 30;

    // `file` is the site's, "" for none. Files of the state folder are read anew at each call: others write there too.
    Curation(std::filesystem::path file, std::filesystem::path state)
        : file_(std::move(file)), state_(std::move(state)) {}

    // What holds now, as the exhibit would read it; the site's own is what would hold without the curator.
    CheckedConfiguration now() const { return check_with(read()); }
    CheckedConfiguration of_the_site() const { return check_with(""); }
    std::string read() const;                    // the curator's file; "" for none
    std::vector<CuratedChange> changes() const;  // that can be taken back, oldest first; none where they are damaged

    // Whole or not at all: what came of the edits was checked together with the site's file, and is on the disk when
    // it returns. False: nothing would be another. Throws SettingsError with all mistakes, or InputError where the
    // disk refuses; then nothing has changed.
    bool change(const std::vector<Edit>& edits, const CuratedChange& by) const;

    // Takes the last change back, and returns it; nothing where there is none left. Throws as change() does.
    std::optional<CuratedChange> undo() const;

  private:
    CheckedConfiguration check_with(const std::string& curated) const;
    void write(const std::string& curated, const std::vector<CuratedChange>& changes) const;

    std::filesystem::path file_, state_;
};

}  // namespace quadrat::site
