// SPDX-License-Identifier: Apache-2.0
#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

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

// Where bytes lie until all of them do.
fs::path beside(const fs::path& path) {
    return folder_of(path) / fmt::format(".{}.{}{}", path.stem().string(), ::getpid(), path.extension().string());
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

void write_file_by(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path temporary = beside(path);
    try {
        write(temporary);
        flush(temporary, O_RDONLY);
        if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, "cannot replace");
        flush(folder_of(path), O_RDONLY | O_DIRECTORY);
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

void flush_file(const fs::path& path) { flush(path, O_RDONLY); }

void flush_folder(const fs::path& folder) { flush(folder, O_RDONLY | O_DIRECTORY); }

void require_writable(const fs::path& path) {
    constexpr int kMode = 0600;
    std::error_code error;
    if (path.filename().empty() || fs::is_directory(path, error))
        throw InputError(fmt::format("{}: is a directory, not a file", path.string()));
    if (fs::exists(path, error) && !fs::is_regular_file(path, error))
        throw InputError(fmt::format("{}: is not a file", path.string()));
    const fs::path temporary = beside(path);
    const OwnedDescriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kMode));
    if (!fd) fail(path, "cannot write");
    fs::remove(temporary, error);
}

void write_file(const fs::path& path, std::string_view bytes) {
    write_file_by(path, [&](const fs::path& temporary) {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        if (!file) fail(path, "cannot write");
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) fail(path, "cannot write");
    });
}

}  // namespace quadrat::base
