// SPDX-License-Identifier: Apache-2.0
#include "backup/backup.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "archive/state_file.hpp"
#include "archive/state_lock.hpp"
#include "backup/manifest.hpp"
#include "backup/staged.hpp"
#include "backup/tar.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/owned.hpp"
#include "machine/version.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;

// A file that goes as soon as nobody needs it.
class Scratch {
  public:
    explicit Scratch(fs::path file) : file_(std::move(file)) {}
    ~Scratch() {
        std::error_code ignored;
        for (const char* part : {"", "-journal", "-wal", "-shm"}) fs::remove(file_.string() + part, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& file() const { return file_; }

  private:
    fs::path file_;
};

struct Small {
    std::string bytes;
    Ownership ownership;
};

struct Contents {
    Manifest manifest;
    std::map<std::string, Small> small;  // all but the state file
    std::vector<std::string> said;
};

bool is_there(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
}

Small read_small(const fs::path& file) { return {base::read_file(file, kLargest), ownership_of(file)}; }

void add_state(const fs::path& state, Contents& contents) {
    for (const std::string& name : site_files_in(state))
        if (name != archive::kStateFile && is_there(state / name))
            contents.small[std::string(kStateFolder) + name] = {base::read_file(state / name, kLargest), {}};
}

// Beside the settings lies what goes with them; what they name elsewhere is somebody else's to keep.
void add_named(const Places& places, Contents& contents) {
    site::Configuration configuration;
    try {
        configuration = site::read_configuration(places.settings);
    } catch (const base::InputError& error) {
        contents.said.push_back(fmt::format("the settings are in it as they are: {}", error.what()));
        return;
    }
    const auto lies_in = [](const fs::path& file, const fs::path& folder) {
        std::error_code error;
        return fs::equivalent(fs::absolute(file).parent_path(), fs::absolute(folder), error);
    };
    for (const fs::path& file : files_named_in(configuration)) {
        if (lies_in(file, places.state) && file.filename() == "buttons.map") continue;
        if (is_there(file) && lies_in(file, fs::absolute(places.settings).parent_path()))
            contents.small[std::string(kSettingsFolder) + file.filename().string()] = read_small(file);
        else
            contents.said.push_back(
                fmt::format("not in it: {}, which the settings name; take it along by hand, or move it to {}",
                            file.string(), fs::absolute(places.settings).parent_path().string()));
    }
}

void add_settings(const Places& places, Contents& contents) {
    if (places.settings.empty()) {
        contents.said.emplace_back("not in it: settings; name them with --config");
        return;
    }
    contents.small[kSettings] = read_small(places.settings);
    add_named(places, contents);
}

std::string host_name() {
    std::array<char, 65> host{};
    ::gethostname(host.data(), host.size() - 1);
    return host.data();
}

Manifest manifest_for(const Contents& contents, const Places& places, const fs::path& state_file) {
    Manifest manifest{std::string(machine::version()), host_name(), "", {}};
    const auto at = std::chrono::floor<std::chrono::seconds>(places.now);
    manifest.made_at = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
    for (const auto& [name, small] : contents.small) manifest.files[name] = small.bytes.size();
    if (is_there(state_file))
        manifest.files[std::string(kStateFolder) + archive::kStateFile] = fs::file_size(state_file);
    return manifest;
}

// It holds a broker's password, perhaps.
void make_private(const fs::path& file) {
    constexpr mode_t kMode = 0600;
    const base::OwnedDescriptor fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kMode));
    if (!fd) throw base::InputError(fmt::format("{}: cannot be written", file.string()));
}

void pack(const fs::path& to, const Contents& contents, const fs::path& state_file, const Progress& progress) {
    TarWriter tar(to);
    tar.add(kManifest, to_json(contents.manifest));
    for (const auto& [name, small] : contents.small) tar.add(name, small.bytes, small.ownership);
    if (is_there(state_file)) {
        std::size_t packed = 0;
        const auto size = static_cast<double>(fs::file_size(state_file));
        tar.add_file(std::string(kStateFolder) + archive::kStateFile, state_file, [&](std::size_t bytes) {
            packed += bytes;
            progress("packing", static_cast<double>(packed) / size);
        });
    }
    tar.finish();
    require_whole(to);
}

// A slip of the finger must not replace the state file, say.
void require_replaceable(const fs::path& file) {
    base::require_writable(file);
    std::error_code error;
    if (!is_there(file) || fs::file_size(file, error) == 0) return;
    try {
        manifest_of(file);
    } catch (const base::InputError&) {
        throw base::InputError(
            fmt::format("{}: is no backup of Quadrat, and is not replaced by one; name another file", file.string()));
    }
}

}  // namespace

std::vector<std::string> write_backup(const Places& places, const fs::path& to, const Progress& progress) {
    std::error_code error;
    if (!fs::is_directory(places.state, error))
        throw base::InputError(fmt::format("{}: there is no such state folder", places.state.string()));
    require_replaceable(to);
    Contents contents;
    add_state(places.state, contents);
    add_settings(places, contents);
    base::write_file_by(to, [&](const fs::path& temporary) {
        make_private(temporary);
        archive::give_to_owner_of(fs::absolute(to).parent_path(), temporary);
        const Scratch copy(temporary.string() + ".db");
        if (is_there(places.state / archive::kStateFile))
            archive::copy_state(places.state, copy.file(), [&](double share) { progress("copying", share); });
        contents.manifest = manifest_for(contents, places, copy.file());
        if (contents.manifest.files.empty())
            throw base::InputError(fmt::format("{}: there is nothing to back up yet", places.state.string()));
        pack(temporary, contents, copy.file(), progress);
    });
    std::vector<std::string> lines;
    for (const auto& [name, bytes] : contents.manifest.files) lines.push_back(fmt::format("{}, {} bytes", name, bytes));
    lines.insert(lines.end(), contents.said.begin(), contents.said.end());
    return lines;
}

}  // namespace quadrat::backup
