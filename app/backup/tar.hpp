// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct archive;
struct archive_entry;

// A tar within xz, by libarchive: whoever is curious looks into it with "tar tf" and tests it with "xz -t", and each
// bit of it is under a checksum. All throw InputError naming the archive or the file.
namespace quadrat::backup {

// Who may do what with a file, as tar tells it.
struct Ownership {
    mode_t mode = 0644;
    std::string user, group;  // by name; "" where that is not known
};

Ownership ownership_of(const std::filesystem::path& file);
// Gives a file the mode and, for root and as far as this machine knows them, the user and group.
void own_as(const std::filesystem::path& file, const Ownership& ownership);

class TarWriter {
  public:
    explicit TarWriter(const std::filesystem::path& file);
    void add(const std::string& name, std::string_view bytes, const Ownership& ownership = {});
    // A file as large as it may be, in pieces; `packed` hears of each how many bytes it had.
    void add_file(const std::string& name, const std::filesystem::path& file,
                  const std::function<void(std::size_t bytes)>& packed = {});
    void finish();

  private:
    struct Free {
        void operator()(::archive* tar) const;
    };
    void begin_entry(const std::string& name, std::uint64_t size, const Ownership& ownership);
    void write(std::string_view bytes);
    void check(int code);

    std::filesystem::path file_;
    std::unique_ptr<::archive, Free> tar_;
};

// Reads it to its very end: nothing is missing and no bit has changed. Throws otherwise.
void require_whole(const std::filesystem::path& file);

class TarReader {
  public:
    explicit TarReader(const std::filesystem::path& file);

    struct Entry {
        std::string name;
        std::uint64_t size = 0;
        bool is_file = true;  // not a folder, a link, a device
        Ownership ownership;
    };
    std::optional<Entry> next();

    // Of the entry that was told last. Throws when there is more than `most`.
    std::string bytes(std::size_t most);
    void extract_to(const std::filesystem::path& to);

  private:
    struct Free {
        void operator()(::archive* tar) const;
    };
    [[noreturn]] void fail();
    std::size_t read(char* to, std::size_t most);

    std::filesystem::path file_;
    std::unique_ptr<::archive, Free> tar_;
};

}  // namespace quadrat::backup
