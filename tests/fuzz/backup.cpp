// SPDX-License-Identifier: Apache-2.0
// Any bytes as a backup, and as what a whole xz holds: a restore puts there what the next start takes, or leaves
// everything as it was.
#include "backup/backup.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>

#include "archive/state_file.hpp"
#include "base/error.hpp"

namespace fs = std::filesystem;

namespace {

// A folder under TMPDIR, gone when the program ends.
struct Scratch {
    fs::path folder;

    Scratch() {
        std::string name = (fs::temp_directory_path() / "quadrat-fuzz-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) std::abort();
        folder = name;
    }
    ~Scratch() { fs::remove_all(folder); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

void write(const fs::path& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// Checksums are nothing that a fuzzer finds.
void write_compressed(const fs::path& file, std::string_view bytes) {
    archive* const to = archive_write_new();
    archive_entry* const entry = archive_entry_new();
    archive_write_add_filter_xz(to);
    archive_write_set_filter_option(to, "xz", "compression-level", "0");
    archive_write_set_format_raw(to);
    archive_entry_set_filetype(entry, AE_IFREG);
    if (archive_write_open_filename(to, file.c_str()) != ARCHIVE_OK || archive_write_header(to, entry) != ARCHIVE_OK ||
        archive_write_data(to, bytes.data(), bytes.size()) != static_cast<la_ssize_t>(bytes.size()) ||
        archive_write_close(to) != ARCHIVE_OK)
        std::abort();
    archive_entry_free(entry);
    archive_write_free(to);
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        std::ifstream stream(entry.path(), std::ios::binary);
        files[entry.path().lexically_relative(folder).string()] =
            entry.is_directory() ? "" : std::string(std::istreambuf_iterator<char>(stream), {});
    }
    return files;
}

void restore_from(const fs::path& file, const fs::path& machine, quadrat::backup::Identity identity) {
    fs::remove_all(machine);
    fs::create_directories(machine / "state");
    write(machine / "state/words.json", "taught here");
    write(machine / "quadrat.toml", "[visit]\nrounds = 3\n");
    const auto before = files_in(machine);
    try {
        quadrat::backup::restore({machine / "state", machine / "quadrat.toml", quadrat::archive::WallTime{}}, file,
                                 {identity, {}}, [](const std::string&, double) {});
    } catch (const quadrat::base::InputError& error) {
        // A line for each mistake in the settings, and nothing of theirs that a terminal would obey.
        const std::string_view told = error.what();
        if (std::ranges::any_of(told, [](unsigned char c) { return c < 0x20 && c != '\n'; })) std::abort();
        if (told.find('\n') != std::string_view::npos && told.find("settings/quadrat.toml:") == std::string_view::npos)
            std::abort();
        if (files_in(machine) != before) std::abort();
        return;
    }
    const auto found = quadrat::archive::examine_state_file(machine / "state" / quadrat::archive::kStateFile).condition;
    if (found != quadrat::archive::Condition::Missing && found != quadrat::archive::Condition::Whole &&
        found != quadrat::archive::Condition::Older)
        std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const Scratch scratch;
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    const fs::path backup = scratch.folder / "backup.tar.xz";
    write(backup, text);
    restore_from(backup, scratch.folder / "machine", quadrat::backup::Identity::OfTheBackup);
    write_compressed(backup, text);
    restore_from(backup, scratch.folder / "machine",
                 size % 2 == 0 ? quadrat::backup::Identity::OfTheBackup : quadrat::backup::Identity::OfTheMachine);
    return 0;
}
