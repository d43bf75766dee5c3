// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>

#include "site/hours.hpp"

// What time it is on site, and whether that can be believed.
namespace quadrat::site {

// The last time that could be trusted, in a file of the state folder: a clock that shows an earlier one has lost its
// time. Nothing here throws: a folder that cannot be read or written knows of none.
class LastTimeSeen {
  public:
    // `state` may be empty: then no time was ever seen, and none is kept.
    explicit LastTimeSeen(const std::filesystem::path& state);

    std::optional<std::time_t> read() const;
    // To be told each time that can be trusted; written once an hour, to spare the disk, or where it went back.
    void note(std::time_t now);
    const std::filesystem::path& file() const { return file_; }  // "" for none

  private:
    std::filesystem::path file_;
    std::chrono::steady_clock::time_point next_try_{};
};

// Trusted if the kernel says that it is synchronised; or if a real-time clock agrees with it within a minute and it is
// not before the last time seen. In each case it must show a year that can be. That the kernel once took its time from
// a real-time clock says nothing: such a clock without its battery counts from 1970, or from when it was made.
WallClock read_wall_clock(const LastTimeSeen& seen, const std::filesystem::path& sys = "/sys");
// The same of a time that is given, with the kernel's word on it.
WallClock judge_clock(std::time_t now, bool is_synchronised, std::optional<std::time_t> last_seen,
                      const std::filesystem::path& sys);

// "2026-11-26 12:08 Europe/Berlin (CET, UTC+01:00)".
std::string time_text(const WallClock& wall);

// From now on the hours are meant in this zone, "Europe/Berlin"; "": in the machine's. Call it before there are
// threads.
void use_zone(const std::string& name);

// Follows the site's time zone while the program runs: /etc/localtime, which `timedatectl set-timezone` replaces, or
// the file that TZ names. The C library alone reads it once for localtime_r. One thread.
class ZoneWatch {
  public:
    explicit ZoneWatch(const std::filesystem::path& zoneinfo = "/usr/share/zoneinfo");
    void look();

  private:
    struct Stamp {
        std::uint64_t device = 0, inode = 0;
        std::int64_t written_ns = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    Stamp stamp() const;

    std::filesystem::path file_;  // that TZ names; "" where it names none
    Stamp stamp_;
    bool is_respelled_ = false;
};

}  // namespace quadrat::site
