// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

namespace quadrat::firmware_io {

// Tells at once when a node whose name begins so comes, goes or may be opened by others than before (inotify). Where
// the folder cannot be watched it tells nothing: whoever waits looks once a second all the same.
class FolderWatch {
  public:
    FolderWatch(const std::filesystem::path& folder, std::string prefix);
    ~FolderWatch();
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;

    // Whether something happened since the last call. Never waits.
    bool take_news();

  private:
    std::string prefix_;
    int descriptor_ = -1;
};

}  // namespace quadrat::firmware_io
