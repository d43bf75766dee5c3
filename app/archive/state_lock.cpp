// SPDX-License-Identifier: Apache-2.0
#include "archive/state_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <sstream>

#include "base/error.hpp"

namespace quadrat::archive {
namespace {

namespace fs = std::filesystem;

fs::path file_in(const fs::path& directory) { return directory / "lock"; }

// The whole file. Of an open file description, not of the process: a library that opens and closes the file lets go of
// nothing.
struct flock lock_of_kind(short kind) {
    struct flock lock {};
    lock.l_type = kind;
    lock.l_whence = SEEK_SET;
    return lock;
}

std::string host_name() {
    std::array<char, 65> host{};
    ::gethostname(host.data(), host.size() - 1);
    return host.data();
}

// A line each; what is missing is "".
std::string written(const LockHolder& holder) {
    return fmt::format("{}\n{}\n{}\n{}\n{}\n", holder.what, holder.process, holder.host, holder.since,
                       holder.how_to_end);
}

LockHolder read_holder(int file) {
    std::array<char, 1024> bytes{};
    const ssize_t count = ::pread(file, bytes.data(), bytes.size(), 0);
    std::istringstream lines(std::string(bytes.data(), static_cast<std::size_t>(count > 0 ? count : 0)));
    LockHolder holder;
    for (std::string* line : {&holder.what, &holder.process, &holder.host, &holder.since, &holder.how_to_end})
        std::getline(lines, *line);
    if (holder.what.empty()) holder.what = "another process";
    return holder;
}

std::optional<LockHolder> holder_of_file(int file) {
    struct flock lock = lock_of_kind(F_WRLCK);
    if (::fcntl(file, F_OFD_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) return std::nullopt;
    return read_holder(file);
}

// Nobody depends on what is said there: a disk that is full says nothing.
void say_who(int file, const LockHolder& self) {
    LockHolder now = self;
    now.process = fmt::format("{}", ::getpid());
    now.host = host_name();
    now.since = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
    const std::string text = written(now);
    if (::ftruncate(file, 0) != 0 || ::pwrite(file, text.data(), text.size(), 0) < 0) return;
}

}  // namespace

std::string to_text(const LockHolder& holder) {
    if (holder.process.empty()) return holder.what;
    return fmt::format("{} (process {} on {}, since {})", holder.what, holder.process, holder.host, holder.since);
}

LockAttempt try_lock(const fs::path& directory, const LockHolder& self) {
    constexpr int kMode = 0644;
    base::OwnedDescriptor file(::open(file_in(directory).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode));
    if (!file) return {{}, {}, fmt::format("{}: {}", file_in(directory).string(), std::strerror(errno))};
    give_to_owner_of(directory, file_in(directory));
    struct flock lock = lock_of_kind(F_WRLCK);
    if (::fcntl(file.get(), F_OFD_SETLK, &lock) != 0) {
        if (errno == EAGAIN || errno == EACCES) return {{}, read_holder(file.get()), ""};
        return {{}, {}, fmt::format("{}: cannot be locked: {}", file_in(directory).string(), std::strerror(errno))};
    }
    say_who(file.get(), self);
    return {StateLock(std::move(file)), {}, ""};
}

StateLock lock_or_refuse(const fs::path& directory, const LockHolder& self) {
    LockAttempt attempt = try_lock(directory, self);
    if (attempt.lock) return std::move(*attempt.lock);
    if (!attempt.holder) throw base::InputError(attempt.trouble);
    const std::string& how = attempt.holder->how_to_end;
    throw base::InputError(fmt::format("{} is in use by {}{}", directory.string(), to_text(*attempt.holder),
                                       how.empty() ? "; wait until it is done" : "; end that first: " + how));
}

std::optional<LockHolder> holder_of(const fs::path& directory) {
    const base::OwnedDescriptor file(::open(file_in(directory).c_str(), O_RDONLY | O_CLOEXEC));
    return file ? holder_of_file(file.get()) : std::nullopt;
}

void give_to_owner_of(const fs::path& folder, const fs::path& file) {
    struct stat owner {};
    if (::geteuid() != 0 || ::stat(folder.c_str(), &owner) != 0) return;
    // Where even root may not, a drive without owners say, everybody may use it.
    if (::lchown(file.c_str(), owner.st_uid, owner.st_gid) != 0) return;
}

}  // namespace quadrat::archive
