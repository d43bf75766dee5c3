// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "archive/sqlite.hpp"

// The state file as others look at it: beside a running exhibit, and without a change to it.
namespace quadrat::archive {

inline constexpr const char* kStateFile = "quadrat.db";

enum class Condition {
    Missing,
    Whole,
    Older,       // the next start brings it up to date
    Newer,       // the next start sets it aside
    Damaged,     // the next start sets it aside
    Unreadable,  // closed to us; what it is like is not known
};

struct StateReport {
    Condition condition = Condition::Missing;
    int version = 0;  // of its tables; of Whole and Older
    std::uintmax_t file_bytes = 0;
    std::uintmax_t log_bytes = 0;  // beside it (-wal): the newest of what is kept is there alone
    std::string what;              // one line; of what is neither Missing nor Whole
};

// The whole file is checked, as at a start.
StateReport examine_state_file(const std::filesystem::path& file);

// Throws SqliteError.
Connection open_to_read(const std::filesystem::path& file);

// A copy of the file in a folder, with all that its log holds, as one file that needs none. Throws InputError where it
// is missing, not whole, or where there is no room.
void copy_state(const std::filesystem::path& directory, const std::filesystem::path& to,
                const std::function<void(double share)>& copied = {});

// Takes out of a state file what belongs to one machine: visits, starts, messages that were not sent, presses. What
// was learnt from visitors, and of the GPU, stays. Throws InputError.
void forget_machine(const std::filesystem::path& file);

}  // namespace quadrat::archive
