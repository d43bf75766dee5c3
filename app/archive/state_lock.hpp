// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "base/owned.hpp"

namespace quadrat::archive {

// Who writes to a state folder.
struct LockHolder {
    std::string what;        // "the exhibit", "quadrat words train"; "another process" where it has not said yet
    std::string process;     // its number
    std::string host;        // a folder may lie on another machine
    std::string since;       // "2026-11-26 11:20:00 UTC"
    std::string how_to_end;  // "systemctl stop quadrat"; "": it ends by itself
    friend bool operator==(const LockHolder&, const LockHolder&) = default;
};
// "the exhibit (process 1234 on foyer, since 2026-11-26 11:20:00 UTC)"
std::string to_text(const LockHolder& holder);

// One process at a time writes to a state folder: it holds a lock on the file "lock" in it, and the kernel lets go of
// that however the process ends. What the file says of its holder means nothing without the lock.
class StateLock {
  private:
    friend struct LockAttempt try_lock(const std::filesystem::path& directory, const LockHolder& self);
    explicit StateLock(base::OwnedDescriptor file) : file_(std::move(file)) {}
    base::OwnedDescriptor file_;
};

// One of the three.
struct LockAttempt {
    std::optional<StateLock> lock;
    std::optional<LockHolder> holder;  // who else has it
    std::string trouble;               // why nobody can: the folder is missing or closed to us
};

// Waits for nobody. Of `self`, what it is and how it is ended; the rest is filled in.
LockAttempt try_lock(const std::filesystem::path& directory, const LockHolder& self);

// The same for whoever cannot do without. Throws InputError: who holds it and how that is ended, or the trouble.
StateLock lock_or_refuse(const std::filesystem::path& directory, const LockHolder& self);

// Who holds it now; looks only.
std::optional<LockHolder> holder_of(const std::filesystem::path& directory);

// For a file or folder that root makes in somebody else's folder: it is the owner's of the folder then. Others than
// root cannot give anything away, and need not.
void give_to_owner_of(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace quadrat::archive
