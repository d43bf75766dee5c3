// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "archive/archive.hpp"

namespace quadrat::backup {

// What of a state folder goes into a backup, and comes out of one: what the site made and taught. All else in the
// folder is of this machine or of this moment.
std::vector<std::string> site_files();  // by their names from the folder: "words.json", "earlier/landscape-1.png"
// And what of it was chosen from visitors' landscapes, whose names tell which: "collection/0123456789abcdef.png".
bool is_of_a_collection(const std::string& name);
inline constexpr std::size_t kMostOfACollection = 256;
// Both, of a state folder: all of the former, and of the latter what is there.
std::vector<std::string> site_files_in(const std::filesystem::path& state);

// A restore that a pulled plug leaves either undone or to be completed: everything new lies in the folder "restoring"
// until it is whole and on the disk; then a note says so, and it takes the place of what was there, file by file.
class Staging {
  public:
    // Empties what an earlier one may have left. Throws InputError where the folder cannot be written.
    explicit Staging(const std::filesystem::path& state);
    // What was not committed is gone, and nothing has changed.
    ~Staging();
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;

    // Where a file is to be written; its folder is there.
    std::filesystem::path place(const std::string& name) const;

    // Of the site's files, those that are staged take the place of what was there and all others go; what was there
    // lies in the folder of this name then. Throws InputError; complete() then goes on.
    void commit(const std::string& before);

  private:
    std::filesystem::path state_;
};

// Completes a restore that was committed and interrupted; drops one that was not. True: there was one to complete.
// Whoever calls it holds the state's lock. Throws InputError naming the file that cannot be moved.
bool complete(const std::filesystem::path& state);
bool is_interrupted(const std::filesystem::path& state);  // and to be completed

// A name that no file in the folder has: "before-restore-20261126-112000", in UTC.
std::string dated_name(const std::filesystem::path& folder, std::string_view stem, archive::WallTime now,
                       std::string_view ending = "");

}  // namespace quadrat::backup
