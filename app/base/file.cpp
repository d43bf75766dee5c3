// SPDX-License-Identifier: Apache-2.0
#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "base/error.hpp"
#include "base/owned.hpp"

namespace quadrat::base {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, std::string_view what) {
    throw InputError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

void flush(const fs::path& path, int flags) {
    const OwnedDescriptor fd(::open(path.c_str(), flags | O_CLOEXEC));
    // Some file systems cannot flush a directory; the rename is then as safe as they make it.
    if (fd && ::fsync(fd.get()) != 0 && errno != EINVAL) fail(path, "cannot flush to the disk");
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

// Where bytes lie until all of them do: a short name, as a long one of the user's may leave no room for more.
fs::path beside(const fs::path& path) {
    static std::atomic<unsigned> number{0};
    return folder_of(path) / fmt::format(".quadrat-{}-{}", ::getpid(), number++);
}

// A rename would put a file in place of a device or a pipe.
void require_file_or_nothing(const fs::path& path) {
    std::error_code error;
    if (path.filename().empty() || fs::is_directory(path, error))
        throw InputError(fmt::format("{}: is a directory, not a file", path.string()));
    if (fs::exists(path, error) && !fs::is_regular_file(path, error))
        throw InputError(fmt::format("{}: is not a file", path.string()));
}

void write_whole(const fs::path& temporary, const fs::path& path, std::string_view bytes) {
    constexpr int kMode = 0666;  // less what the umask takes
    const OwnedDescriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode));
    if (!fd) fail(path, "cannot write");
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd.get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path, "cannot write");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(fd.get()) != 0 && errno != EINVAL) fail(path, "cannot flush to the disk");
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t limit_bytes) {
    std::error_code error;
    if (fs::is_directory(path, error)) throw InputError(fmt::format("{}: is a directory, not a file", path.string()));
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "cannot read");
    std::string bytes;
    char chunk[1U << 16U];
    while (file.read(chunk, sizeof chunk) || file.gcount() > 0) {
        bytes.append(chunk, static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > limit_bytes)
            throw InputError(fmt::format("{}: larger than {} bytes", path.string(), limit_bytes));
    }
    if (file.bad()) fail(path, "cannot read");
    return bytes;
}

void require_writable(const fs::path& path) {
    constexpr int kMode = 0600;
    require_file_or_nothing(path);
    const fs::path temporary = beside(path);
    const OwnedDescriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kMode));
    if (!fd) fail(path, "cannot write");
    std::error_code error;
    fs::remove(temporary, error);
}

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

void require_ending(const fs::path& path, std::initializer_list<std::string_view> endings, std::string_view what) {
    require_file_or_nothing(path);
    if (std::ranges::find(endings, ending_of(path)) == endings.end())
        throw InputError(fmt::format("{}: {} is written as {}", path.string(), what, fmt::join(endings, " or ")));
    if (const fs::path folder = folder_of(path); !fs::is_directory(folder))
        throw InputError(fmt::format("{}: there is no folder {}", path.string(), folder.string()));
    require_writable(path);
}

void write_file(const fs::path& path, std::string_view bytes) {
    require_file_or_nothing(path);
    const fs::path temporary = beside(path);
    try {
        write_whole(temporary, path, bytes);
        if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, "cannot replace");
        flush_folder(folder_of(path));
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

void print_or_write_file(const fs::path& path, std::string_view bytes) {
    if (path == "-")
        std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    else
        write_file(path, bytes);
}

void flush_file(const fs::path& path) { flush(path, O_RDONLY); }

void flush_folder(const fs::path& folder) { flush(folder, O_RDONLY | O_DIRECTORY); }

void write_file_by(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    require_file_or_nothing(path);
    const fs::path temporary = beside(path);
    try {
        write(temporary);
        flush_file(temporary);
        if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, "cannot replace");
        flush_folder(folder_of(path));
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

}  // namespace quadrat::base
