// SPDX-License-Identifier: Apache-2.0
#include "commands/desk_sources.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "backup/backup.hpp"
#include "backup/manifest.hpp"
#include "backup/staged.hpp"
#include "backup/state_hold.hpp"
#include "backup/tar.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/owned.hpp"
#include "benches/scratch.hpp"
#include "commands/ask_exhibit.hpp"
#include "commands/desk_curator.hpp"
#include "commands/examine.hpp"
#include "commands/staff_acts.hpp"
#include "commands/visits.hpp"
#include "desk/passphrase.hpp"
#include "desk/secrets.hpp"
#include "machine/journal.hpp"
#include "machine/version.hpp"
#include "report/writers.hpp"
#include "staff/evidence.hpp"
#include "staff/presence.hpp"
#include "staff/watch.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;
using std::chrono::system_clock;

constexpr const char* kKeptFile = "desk-restore.tar.xz";  // was brought and looked into
constexpr std::size_t kLogLines = 200;
constexpr std::size_t kNoteLines = 50;
constexpr std::size_t kMostPicture = 32U << 20U;

std::string date_of(system_clock::time_point at) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(system_clock::to_time_t(at)));
}

archive::WallTime now() { return std::chrono::time_point_cast<std::chrono::milliseconds>(system_clock::now()); }

std::optional<std::string> read_if_there(const fs::path& file, std::size_t most) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return std::nullopt;
    try {
        return base::read_file(file, most);
    } catch (const base::InputError&) {
        return std::nullopt;  // it went away meanwhile
    }
}

// The last lines of a file that may be long.
std::vector<std::string> tail_of(const fs::path& file, std::size_t most) {
    constexpr std::streamoff kRead = 256 * 1024;
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(0, std::ios::end);
    const std::streamoff size = stream.tellg();
    if (!stream || size <= 0) return {};
    stream.seekg(std::max<std::streamoff>(0, size - kRead));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    if (size > kRead) lines.erase(lines.begin());  // its beginning was not read
    if (lines.size() > most) lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(most));
    return lines;
}

// What an exhibit said that has ended since lies there too. Whoever asks has the next one made.
std::optional<std::string> health_in(const fs::path& runtime) {
    if (!staff::is_exhibit_present(runtime)) return std::nullopt;
    ask_by(runtime / staff::kHealthAsked);
    return read_if_there(runtime / "health.json", 1U << 20U);
}

// What the exhibit drew in the last seconds. Whoever asks gets what lies there, and has the next one made.
std::optional<std::string> glance(const fs::path& runtime) {
    if (!staff::is_exhibit_present(runtime)) return std::nullopt;
    constexpr std::chrono::seconds kOld{10};
    const fs::path file = runtime / staff::kGlance;
    std::error_code error;
    ask_by(runtime / staff::kGlanceAsked);
    const auto written = fs::last_write_time(file, error);
    if (error || fs::file_time_type::clock::now() - written > kOld) return std::nullopt;
    return read_if_there(file, kMostPicture);
}

std::vector<desk::Finding> findings_of(const DeskPlaces& places) {
    constexpr const char* kWords[]{"good", "doubtful", "bad"};
    std::vector<desk::Finding> findings;
    for (const doctor::Finding& one : examine_parts(places.named_configuration, places.named_state))
        findings.push_back({one.subject, kWords[static_cast<std::size_t>(one.health)], one.what, one.remedy});
    return findings;
}

std::vector<desk::Fault> faults_in(const fs::path& state) {
    std::vector<desk::Fault> faults;
    for (const staff::KeptFault& kept : staff::read_faults(state)) {
        std::string picture = fs::path(kept.picture).filename().string();
        std::error_code error;
        if (!fs::is_regular_file(kept.picture, error)) picture.clear();  // a newer one took its room
        faults.push_back({kept.text, date_of(kept.first), date_of(kept.last), kept.count, std::move(picture)});
    }
    std::ranges::reverse(faults);
    return faults;
}

// Only of what is listed: a name is no path.
std::optional<std::string> fault_picture_in(const fs::path& state, const std::string& name) {
    for (const staff::KeptFault& kept : staff::read_faults(state))
        if (!name.empty() && fs::path(kept.picture).filename() == name)
            return read_if_there(state / "faults" / name, kMostPicture);
    return std::nullopt;
}

std::vector<std::string> log_of(const DeskPlaces& places, const std::string& password_file) {
    std::vector<std::string> secrets;
    for (const fs::path& file : {fs::path(password_file), places.state / kPassphraseFile})
        if (const auto held = read_if_there(file, 1U << 16U)) secrets.push_back(held->substr(0, held->find('\n')));
    std::vector<std::string> lines =
        places.log.empty() ? machine::last_journal_lines("quadrat.service", kLogLines) : tail_of(places.log, kLogLines);
    for (std::string& line : lines) line = desk::without_secrets(line, secrets);
    return lines;
}

std::string backup_of(const DeskPlaces& places) {
    const benches::Scratch folder;
    const fs::path file = folder.path / "quadrat-backup.tar.xz";
    backup::write_backup({places.state, places.named_configuration, now()}, file, [](const std::string&, double) {});
    return base::read_file(file, std::size_t{512} << 20U);
}

// All of it in one: its names say nothing to anybody.
desk::Preview::File collection_in(const fs::path& state, const backup::Manifest& manifest) {
    desk::Preview::File all{"collection", std::nullopt, std::nullopt};
    for (const std::string& name : backup::site_files_in(state)) {
        std::error_code error;
        if (!backup::is_of_a_collection(name)) continue;
        if (const auto size = fs::file_size(state / name, error); !error) all.here = all.here.value_or(0) + size;
    }
    for (const auto& [name, size] : manifest.files)
        if (name.starts_with(backup::kStateFolder) &&
            backup::is_of_a_collection(name.substr(backup::kStateFolder.size())))
            all.there = all.there.value_or(0) + size;
    return all;
}

desk::Preview preview_of(const DeskPlaces& places, const fs::path& brought) {
    backup::require_whole(brought);
    const backup::Manifest manifest = backup::manifest_of(brought);
    desk::Preview preview{manifest.made_at, manifest.host, manifest.program, {}};
    for (const std::string& name : backup::site_files()) {
        std::error_code error;
        desk::Preview::File file{name, std::nullopt, std::nullopt};
        if (const auto size = fs::file_size(places.state / name, error); !error) file.here = size;
        // The newest of a database lies beside it.
        if (const auto size = fs::file_size(places.state / (name + "-wal"), error); !error && file.here)
            *file.here += size;
        const auto there = manifest.files.find(std::string(backup::kStateFolder) + name);
        if (there != manifest.files.end()) file.there = there->second;
        if (file.here || file.there) preview.files.push_back(std::move(file));
    }
    if (const auto chosen = collection_in(places.state, manifest); chosen.here || chosen.there)
        preview.files.push_back(chosen);
    fs::rename(brought, places.state / kKeptFile);
    return preview;
}

// The exhibit lets go of its state when it starts anew, and waits for it then, as for any tool that writes there.
archive::StateLock hold_beside_exhibit(const DeskPlaces& places) {
    constexpr std::chrono::seconds kPatience{30};
    if (staff::is_exhibit_present(places.runtime)) ask_by(places.runtime / staff::kRestartAsked);
    for (const auto until = std::chrono::steady_clock::now() + kPatience;;) {
        try {
            return backup::hold_state(places.state, "quadrat desk");
        } catch (const base::InputError&) {
            if (std::chrono::steady_clock::now() > until) throw;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
}

void restore(const DeskPlaces& places, desk::Identity identity) {
    const auto lock = hold_beside_exhibit(places);
    backup::RestoreOptions how;
    how.settings = backup::Settings::Leave;
    if (identity == desk::Identity::OfTheMachine) how.identity = backup::Identity::OfTheMachine;
    for (const std::string& line :
         backup::restore({places.state, {}, now()}, places.state / kKeptFile, how, [](const std::string&, double) {}))
        base::log::info("desk: {}", line);
    fs::remove(places.state / kKeptFile);
}

}  // namespace

desk::Sources desk_sources(const DeskPlaces& places, const site::Configuration& configuration) {
    desk::Sources sources;
    sources.exhibit = configuration.fleet.name;
    sources.version = std::string(machine::version());
    sources.health = [places] { return health_in(places.runtime); };
    sources.picture = [places] { return glance(places.runtime); };
    sources.full_picture = [places] { return picture_of_exhibit(places.runtime); };
    sources.faults = [places] { return faults_in(places.state); };
    sources.fault_picture = [places](const std::string& name) { return fault_picture_in(places.state, name); };
    sources.log = [places, file = configuration.fleet.password_file] { return log_of(places, file); };
    sources.notes = [places] { return tail_of(places.state / kActsNoted, kNoteLines); };
    sources.examine = [places] { return findings_of(places); };
    sources.report = [places, title = configuration.fleet.name](const std::string& back) {
        report::Heading heading = heading_of(title.empty() ? "Visitors of the exhibit" : title);
        heading.back = back;
        return report::html_of(count_visits(places.state, {}), heading);
    };
    sources.backup = [places] { return backup_of(places); };
    sources.preview = [places](const fs::path& brought) { return preview_of(places, brought); };
    sources.restore = [places](desk::Identity identity) { restore(places, identity); };
    sources.drop = [places] { fs::remove(places.state / kKeptFile); };
    sources.act = [places](desk::Act act) { do_act(places.runtime, act); };
    sources.note = [places](const std::string& what) { note_act(places.state, "desk", what); };
    // Read anew each time: it may be another since.
    sources.is_passphrase = [places](const std::string& passphrase) {
        const auto hash = read_if_there(places.state / kPassphraseFile, 1024);
        return hash && desk::is_passphrase(passphrase, hash->substr(0, hash->find('\n')));
    };
    sources.curator = curator_of(places);
    std::error_code ignored;  // what an earlier desk left
    fs::remove(places.state / kKeptFile, ignored);
    fs::remove(places.state / kBroughtFile, ignored);
    return sources;
}

}  // namespace quadrat::commands
