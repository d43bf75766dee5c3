// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

// What happens when starting again is not enough: three failures in ten minutes lead to safe mode, three more to a
// reboot; after three reboots without a good hour between them it is left at safe mode.
namespace quadrat::staff {

using Seconds = std::chrono::seconds;

// A start of the program, on the clock that begins with the machine and counts its sleep.
struct Start {
    Seconds at{0};
    bool has_ended_well = false;  // told to stop; not killed, not crashed, not given up
    friend bool operator==(const Start&, const Start&) = default;
};

enum class Mode {
    Usual,
    Safe,  // low detail, no captures, pictures of earlier landscapes
};
enum class Remedy { None, Reboot };

struct Rung {
    Mode mode = Mode::Usual;
    Remedy remedy = Remedy::None;
    int failures = 0;        // in the last ten minutes
    bool is_wished = false;  // safe mode, by staff
};

inline constexpr Seconds kLadderSpan{600};
inline constexpr int kFailuresToSafety = 3;
inline constexpr int kFailuresToReboot = 6;
inline constexpr int kMostReboots = 3;
inline constexpr Seconds kGoodRun{3600};  // after which reboots are forgotten, and safe mode is tried without

// The starts before this one, oldest first, and how many reboots there have been without a good hour since. A start
// that did not end well failed no later than the start after it.
Rung rung_of(const std::vector<Start>& before, Seconds now, int reboots);

// Starts, kept where a reboot forgets them (the runtime folder); reboots, kept where it does not (the state folder).
class Ladder {
  public:
    // Reads what was kept and notes this start. What cannot be read counts as nothing; where nothing can be kept, or no
    // runtime folder is named, it never climbs.
    Ladder(const std::filesystem::path& runtime_folder, const std::filesystem::path& state_folder, Seconds now);

    const Rung& rung() const { return rung_; }
    const std::vector<Start>& starts() const { return starts_; }  // the last ones, this one included

    // Notes a reboot that is about to be asked for. False: it could not be written down, so it must not be asked for.
    bool note_reboot();
    void note_good_run();  // forgets the reboots
    void note_end();       // this run ended well
    void keep_safe();      // as staff wish it, whatever failed
    void forgive();        // forgets what failed before this start

  private:
    bool write_starts() const;

    std::filesystem::path starts_file_, reboots_file_;
    std::vector<Start> starts_;
    int reboots_ = 0;
    Rung rung_;
};

}  // namespace quadrat::staff
