// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace quadrat::firmware_io {

// The boards (board_of) that hid: listens to, for evdev: to leave them alone: the kernel tells the same press both
// ways, at moments that differ, and with names that may differ too. One for all sources of an exhibit.
class HeardBoards {
  public:
    void begin(const std::string& board) { boards_.push_back(board); }
    void end(const std::string& board) {
        if (const auto found = std::find(boards_.begin(), boards_.end(), board); found != boards_.end())
            boards_.erase(found);
    }
    bool is_heard(const std::string& board) const {
        return std::find(boards_.begin(), boards_.end(), board) != boards_.end();
    }

  private:
    std::vector<std::string> boards_;  // a board once for each of its interfaces
};

}  // namespace quadrat::firmware_io
