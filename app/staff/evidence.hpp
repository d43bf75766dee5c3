// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "base/log.hpp"
#include "mesh/image.hpp"

namespace quadrat::staff {

using WallMoment = std::chrono::system_clock::time_point;

// A warning or an error, however often it came.
struct KeptFault {
    std::string text;
    WallMoment first, last;
    int count = 1;
    std::string picture;  // of the screen then, a file beside the list; "" without one
};
// "2026-11-26 11:20:33 UTC the text (17 times, until 2026-11-26 12:00:00 UTC; picture …)"
std::string to_line(const KeptFault& fault);

// What is kept in a state folder, oldest first; nothing where there is nothing that can be read.
std::vector<KeptFault> read_faults(const std::filesystem::path& state);

// The last faults, and pictures of the screen at some of them, kept in the state folder over reboots: few, small and
// seldom written, for the sake of the card. One thread.
class Evidence {
  public:
    static constexpr std::size_t kFaults = 40;
    static constexpr std::size_t kPictures = 4;
    static constexpr int kPictureWidth = 1000;  // pixels, at most
    static constexpr base::Instant kWriteEvery =
        std::chrono::minutes{1};  // of what was not there before; at once at first
    static constexpr base::Instant kCountEvery = std::chrono::hours{1};  // of what came again
    static constexpr std::chrono::hours kPictureEvery{1};

    explicit Evidence(const std::filesystem::path& state);
    // Writes what has not been written yet.
    ~Evidence();
    Evidence(const Evidence&) = delete;
    Evidence& operator=(const Evidence&) = delete;

    // Takes over the warnings that came since the last look, and writes them where that is due.
    void look(const base::RecentWarnings& recent, base::Instant now);
    // Of the screen at the last fault. Throws InputError where it cannot be written.
    void keep_picture(const mesh::Image& picture, WallMoment now);

    // Those of the runs before this one, a line each.
    const std::vector<std::string>& earlier() const { return earlier_; }

  private:
    void read();
    void note(const base::Warning& warning);
    void write();

    std::filesystem::path folder_;
    std::vector<KeptFault> faults_;
    std::vector<std::string> earlier_;
    std::size_t seen_ = 0;  // warnings of this run
    bool is_read_ = false;
    bool has_new_ = false, has_more_ = false;
    std::optional<base::Instant> written_at_;
};

}  // namespace quadrat::staff
