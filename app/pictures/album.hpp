// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/worker.hpp"
#include "pictures/picture.hpp"

namespace quadrat::pictures {

// The pictures of a run, written beside the show: encoding takes longer than a frame. A picture that cannot be written
// is logged and left out. Its end waits for what is being written.
class Album {
  public:
    // Makes the folder. Throws InputError when it cannot be made or written in.
    explicit Album(std::filesystem::path folder);

    // NAME.png, replaced whole when it is there.
    void add(const std::string& name, mesh::Image pixels, const Picture& picture, const std::string& caption);
    // contact-sheet.png of the newest sixty that were added. Waits for them.
    void finish();

    const std::filesystem::path& folder() const { return folder_; }
    std::size_t count() const { return count_; }

  private:
    std::filesystem::path folder_;
    std::size_t count_ = 0;
    std::vector<SheetEntry> entries_;  // scaled down
    // Three at once, for their memory.
    base::Worker writing_{
        {.name = "album", .bound = 3, .when_full = base::WorkerOptions::WhenFull::Wait, .threads = 3}};
};

}  // namespace quadrat::pictures
