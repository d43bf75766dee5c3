// SPDX-License-Identifier: Apache-2.0
#include "backup/tar.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>

#include "base/error.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 16U;

struct FreeEntry {
    void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

std::string why(::archive* tar) {
    const char* text = archive_error_string(tar);
    return text != nullptr ? text : "it cannot be read";
}

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
    throw base::InputError(fmt::format("{}: {}", file.string(), what));
}

bool begins_as_xz(const fs::path& file) {
    std::array<char, 6> head{};
    std::ifstream(file, std::ios::binary).read(head.data(), head.size());
    return std::string_view(head.data(), head.size()) == std::string_view(
                                                             "\xfd"
                                                             "7zXZ\0",
                                                             head.size());
}

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

}  // namespace

Ownership ownership_of(const fs::path& file) {
    struct stat facts {};
    if (::stat(file.c_str(), &facts) != 0) return {};
    const passwd* user = ::getpwuid(facts.st_uid);
    const group* among = ::getgrgid(facts.st_gid);
    return {facts.st_mode & 0777U, user != nullptr ? user->pw_name : "", among != nullptr ? among->gr_name : ""};
}

void own_as(const fs::path& file, const Ownership& ownership) {
    constexpr mode_t kNeverOthersToWrite = 0755;
    const passwd* user = ::getpwnam(ownership.user.c_str());
    const group* among = ::getgrnam(ownership.group.c_str());
    // Who may not give it away keeps it.
    if (::geteuid() == 0 && user != nullptr && among != nullptr &&
        ::chown(file.c_str(), user->pw_uid, among->gr_gid) != 0)
        return;
    std::error_code ignored;
    fs::permissions(file, fs::perms(ownership.mode & kNeverOthersToWrite), ignored);
}

void TarWriter::Free::operator()(::archive* tar) const { archive_write_free(tar); }

TarWriter::TarWriter(const fs::path& file) : file_(file), tar_(archive_write_new()) {
    if (!tar_) refuse(file, "no memory for an archive");
    check(archive_write_add_filter_xz(tar_.get()));
    check(archive_write_set_filter_option(tar_.get(), "xz", "compression-level", "3"));
    check(archive_write_set_format_pax_restricted(tar_.get()));
    check(archive_write_open_filename(tar_.get(), file.c_str()));
}

void TarWriter::check(int code) {
    if (code < ARCHIVE_OK) refuse(file_, "cannot write: " + why(tar_.get()));
}

void TarWriter::begin_entry(const std::string& name, std::uint64_t size, const Ownership& ownership) {
    const std::unique_ptr<archive_entry, FreeEntry> entry(archive_entry_new());
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(size));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), ownership.mode);
    archive_entry_set_mtime(entry.get(), std::time(nullptr), 0);
    archive_entry_set_uname(entry.get(), ownership.user.c_str());
    archive_entry_set_gname(entry.get(), ownership.group.c_str());
    check(archive_write_header(tar_.get(), entry.get()));
}

void TarWriter::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const la_ssize_t count = archive_write_data(tar_.get(), bytes.data(), bytes.size());
        if (count <= 0) check(ARCHIVE_FATAL);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void TarWriter::add(const std::string& name, std::string_view bytes, const Ownership& ownership) {
    begin_entry(name, bytes.size(), ownership);
    write(bytes);
}

void TarWriter::add_file(const std::string& name, const fs::path& file,
                         const std::function<void(std::size_t bytes)>& packed) {
    std::ifstream stream(file, std::ios::binary);
    std::uint64_t left = fs::file_size(file);
    begin_entry(name, left, {});
    std::array<char, kPiece> piece{};
    while (left > 0) {
        stream.read(piece.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(left, piece.size())));
        const auto count = static_cast<std::size_t>(stream.gcount());
        if (count == 0) refuse(file, "cannot be read to its end");
        write({piece.data(), count});
        left -= count;
        if (packed) packed(count);
    }
}

void TarWriter::finish() { check(archive_write_close(tar_.get())); }

void TarReader::Free::operator()(::archive* tar) const { archive_read_free(tar); }

TarReader::TarReader(const fs::path& file) : file_(file), tar_(archive_read_new()) {
    if (!tar_) refuse(file, "no memory for an archive");
    archive_read_support_filter_xz(tar_.get());
    archive_read_support_format_tar(tar_.get());
    if (archive_read_open_filename(tar_.get(), file.c_str(), kPiece) != ARCHIVE_OK) fail();
}

void TarReader::fail() { refuse(file_, why(tar_.get())); }

std::optional<TarReader::Entry> TarReader::next() {
    archive_entry* entry = nullptr;
    const int code = archive_read_next_header(tar_.get(), &entry);
    if (code == ARCHIVE_EOF) return std::nullopt;
    if (code != ARCHIVE_OK) fail();
    const bool is_link = archive_entry_hardlink(entry) != nullptr || archive_entry_symlink(entry) != nullptr;
    return Entry{text_of(archive_entry_pathname(entry)),
                 static_cast<std::uint64_t>(archive_entry_size(entry)),
                 archive_entry_filetype(entry) == AE_IFREG && !is_link,
                 {archive_entry_perm(entry), text_of(archive_entry_uname(entry)), text_of(archive_entry_gname(entry))}};
}

std::size_t TarReader::read(char* to, std::size_t most) {
    const la_ssize_t count = archive_read_data(tar_.get(), to, most);
    if (count < 0) fail();
    return static_cast<std::size_t>(count);
}

std::string TarReader::bytes(std::size_t most) {
    std::string all;
    std::array<char, kPiece> piece{};
    while (const std::size_t count = read(piece.data(), piece.size())) {
        all.append(piece.data(), count);
        if (all.size() > most) refuse(file_, fmt::format("what is in it is larger than {} bytes", most));
    }
    return all;
}

void TarReader::extract_to(const fs::path& to) {
    std::ofstream stream(to, std::ios::binary | std::ios::trunc);
    std::array<char, kPiece> piece{};
    while (const std::size_t count = read(piece.data(), piece.size()))
        stream.write(piece.data(), static_cast<std::streamsize>(count));
    stream.close();
    if (!stream) refuse(to, std::string("cannot write: ") + std::strerror(errno));
}

void require_whole(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) refuse(file, "there is no such file");
    if (!fs::is_regular_file(file, error)) refuse(file, "is not a file");
    struct Free {
        void operator()(::archive* raw) const { archive_read_free(raw); }
    };
    // The stream of bytes within the compression: the reader of tar stops where the last file ends, before the
    // checksum.
    const std::unique_ptr<::archive, Free> raw(archive_read_new());
    archive_read_support_filter_xz(raw.get());
    archive_read_support_format_raw(raw.get());
    archive_entry* entry = nullptr;
    if (!begins_as_xz(file)) refuse(file, "is not a backup of Quadrat");
    bool is_open = archive_read_open_filename(raw.get(), file.c_str(), kPiece) == ARCHIVE_OK;
    is_open = is_open && archive_read_next_header(raw.get(), &entry) == ARCHIVE_OK;
    std::array<char, kPiece> piece{};
    la_ssize_t count = is_open && archive_filter_code(raw.get(), 0) == ARCHIVE_FILTER_XZ ? 1 : -1;
    while (count > 0) count = archive_read_data(raw.get(), piece.data(), piece.size());
    if (count < 0) refuse(file, fmt::format("is damaged or cut off ({}); nothing was changed", why(raw.get())));
}

}  // namespace quadrat::backup
